#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "circumball/predicates.h"
#include "quality/verify_test_util.h"

// A mesh that is right is broken in each way there is: the right check fails, and names the right
// offender.

namespace circumball {
namespace {

using namespace testing;
using Names = std::set<std::string>;

/// The mesh as made, and without its labels: what breaks one breaks the other.
std::vector<Subject> both(const Subject& s) { return {s, s.foreign()}; }

bool legal(const Mesh& m) {
  for (std::size_t i = 0; i < m.cell_count(); ++i) {
    const std::uint32_t* c = m.cell(i);
    if (orient2d(xy(m.vertices[c[0]]), xy(m.vertices[c[1]]), xy(m.vertices[c[2]])) !=
        Sign::kPositive)
      return false;
  }
  return true;
}

TEST(BrokenMesh, AFlippedEdgeIsNotDelaunay) {
  for (const Domain domain : {Domain::kClosed, Domain::kBox}) {
    const Subject whole = square_with_hole(domain);
    int flipped = 0;
    for (std::size_t i = 0; i < whole.mesh.cell_count(); i += 7) {
      const auto t = cell_vertices(whole.mesh, i);
      if (is_subsegment(whole.mesh, t[0], t[1])) continue;
      Subject s = whole;
      int apex = 0;
      const std::size_t other = find_cell(s.mesh, t[1], t[0], &apex);
      if (other == s.mesh.cell_count()) continue;
      const std::uint32_t d = s.mesh.cell(other)[apex];
      const auto at = [&](std::uint32_t v) { return xy(s.mesh.vertices[v]); };
      if (incircle(at(t[0]), at(t[1]), at(t[2]), at(d)) == Sign::kZero)
        continue;  // either diagonal will do
      ASSERT_TRUE(flip(&s.mesh, t[0], t[1]));
      if (!legal(s.mesh)) continue;
      s.options.tau.reset();
      for (const Subject& each : both(s)) {
        EXPECT_EQ(each.failing(), Names{"delaunay"}) << failures(each.verified());
        EXPECT_EQ(sorted(each.check("delaunay").worst), sorted({t[0], t[1], t[2], d}));
      }
      ++flipped;
    }
    EXPECT_GT(flipped, 15);
  }
}

TEST(BrokenMesh, AFlippedSubsegmentIsMissing) {
  Complex c = unit_square();
  c.segments.push_back({0, 2});
  const Subject whole = refined(c, Domain::kClosed, 0.1);
  for (const MeshEdge& e : whole.mesh.edges) {
    if (e.segment != 4) continue;
    Subject s = whole;
    ASSERT_TRUE(flip(&s.mesh, e.a, e.b));
    if (!legal(s.mesh)) continue;
    for (const Subject& each : both(s)) {
      EXPECT_TRUE(each.failing().count("input-segments"));
      EXPECT_FALSE(each.failing().count("topology"));
      const Check check = each.check("input-segments");
      EXPECT_NE(check.detail.find("input segment 4 "), std::string::npos) << check.detail;
      EXPECT_TRUE(std::count(check.worst.begin(), check.worst.end(), e.a) ||
                  std::count(check.worst.begin(), check.worst.end(), e.b))
          << check.detail;
    }
  }
}

TEST(BrokenMesh, AMissingCellLeavesAHoleInTheArea) {
  for (const Domain domain : {Domain::kClosed, Domain::kBox}) {
    const Subject whole = square_with_hole(domain);
    for (std::size_t i = 0; i < whole.mesh.cell_count(); i += 11) {
      Subject s = whole;
      remove_cell(&s.mesh, i);
      for (const Subject& each : both(s)) {
        EXPECT_TRUE(each.failing().count("area")) << "cell " << i;
        EXPECT_LT(*each.check("area").observed, *each.check("area").bound);
        // a hole in a box shows as a boundary that is not convex, or has several parts
        EXPECT_EQ(each.failing().count("delaunay"), domain == Domain::kBox ? 1u : 0u);
      }
    }
  }
}

TEST(BrokenMesh, AMissingPartOfTheDomainIsMissed) {
  Complex c = unit_square();
  add_square(&c, 5, 5, 0.01);  // an island, small beside the rest
  const Subject whole = refined(c, Domain::kClosed);
  EXPECT_TRUE(whole.failing().empty()) << failures(whole.verified());
  Subject s = whole;
  for (std::size_t i = s.mesh.cell_count(); i-- > 0;) {
    if (s.mesh.vertices[s.mesh.cell(i)[0]].x > 2) remove_cell(&s.mesh, i);
  }
  for (const Subject& each : both(s)) {
    EXPECT_EQ(each.failing(), (Names{"area", "input-segments", "input-vertices"}));
    EXPECT_EQ(each.check("input-vertices").worst, std::vector<std::uint32_t>{4});
  }
}

TEST(BrokenMesh, ARepeatedCellIsNamed) {
  const Subject whole = square_with_hole();
  for (std::size_t i = 0; i < whole.mesh.cell_count(); i += 29) {
    Subject s = whole;
    const auto t = cell_vertices(s.mesh, i);
    s.mesh.cells.insert(s.mesh.cells.end(), {t[1], t[2], t[0]});
    EXPECT_TRUE(s.failing().count("topology"));
    EXPECT_EQ(s.check("topology").worst, sorted(t));
    EXPECT_TRUE(s.failing().count("area"));
  }
}

TEST(BrokenMesh, AnInvertedCellIsNamed) {
  const Subject whole = square_with_hole();
  for (std::size_t i = 0; i < whole.mesh.cell_count(); i += 29) {
    Subject s = whole;
    std::swap(s.mesh.cells[3 * i], s.mesh.cells[3 * i + 1]);
    EXPECT_TRUE(s.failing().count("topology"));
    EXPECT_EQ(s.check("topology").worst, cell_vertices(s.mesh, i));
  }
}

TEST(BrokenMesh, AnInputVertexThatMovedByTheLeastBitIsNamed) {
  Subject s = square_with_hole();
  s.mesh.vertices[5].x = std::nextafter(s.mesh.vertices[5].x, 1.0);
  EXPECT_TRUE(s.failing().count("input-vertices"));
  EXPECT_EQ(s.check("input-vertices").worst, std::vector<std::uint32_t>{5});
  EXPECT_NE(s.check("input-vertices").detail.find("moved"), std::string::npos);
  EXPECT_NE(s.foreign().check("input-vertices").detail.find("not in the mesh"), std::string::npos);
  s = square_with_hole();
  s.mesh.vertices[0].x = -0.0;
  EXPECT_FALSE(s.check("input-vertices").ok) << "bit for bit";
  EXPECT_TRUE(s.foreign().check("input-vertices").ok) << "by coordinates";
}

TEST(BrokenMesh, AFreeVertexThatMovedIsNamed) {
  const Subject whole = square_with_hole();
  int moved = 0;
  for (std::uint32_t v = 0; v < whole.mesh.vertices.size(); ++v) {
    if (whole.mesh.vertex_features[v].kind != FeatureKind::kFree) continue;
    Subject s = whole;
    s.mesh.vertices[v].x += 0.15;  // a few edges
    s.options.tau.reset();
    for (const Subject& each : both(s)) {
      const Check topology = each.check("topology"), delaunay = each.check("delaunay");
      const bool used = std::count(whole.mesh.cells.begin(), whole.mesh.cells.end(), v) > 0;
      ASSERT_TRUE(!used || !topology.ok || !delaunay.ok) << "vertex " << v;
      if (!topology.ok) {
        EXPECT_TRUE(std::count(topology.worst.begin(), topology.worst.end(), v)) << topology.detail;
        ++moved;
      }
    }
  }
  EXPECT_GT(moved, 10);
}

TEST(BrokenMesh, ALabelThatIsMissingLeavesAGap) {
  const Subject whole = square_with_hole();
  for (std::size_t i = 0; i < whole.mesh.edges.size(); i += 3) {
    Subject s = whole;
    const MeshEdge gone = s.mesh.edges[i];
    s.mesh.edges.erase(s.mesh.edges.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(s.failing().count("input-segments"), 1u);
    const Check check = s.check("input-segments");
    EXPECT_NE(check.detail.find("input segment " + std::to_string(gone.segment) + " "),
              std::string::npos)
        << check.detail;
    EXPECT_TRUE(std::count(check.worst.begin(), check.worst.end(), gone.a) ||
                std::count(check.worst.begin(), check.worst.end(), gone.b));
  }
}

TEST(BrokenMesh, LabelsThatLieAreFoundOut) {
  const Subject whole = square_with_hole();
  Subject s = whole;
  s.mesh.edges[0].segment = (s.mesh.edges[0].segment + 1) % 4;  // a subsegment of another side
  EXPECT_FALSE(s.check("input-segments").ok);
  s = whole;
  s.mesh.edges.push_back(s.mesh.edges[0]);  // twice
  EXPECT_NE(s.check("input-segments").detail.find("overlap"), std::string::npos);
  s = whole;
  s.mesh.edges[0].a = 1000000;
  EXPECT_NE(s.check("input-segments").detail.find("not there"), std::string::npos);
  for (std::uint32_t v = 0; v < whole.mesh.vertices.size(); ++v) {
    if (whole.mesh.vertex_features[v].kind != FeatureKind::kSegment) continue;
    s = whole;
    s.mesh.vertex_features[v] = Feature{};
    EXPECT_EQ(s.check("input-segments").worst, std::vector<std::uint32_t>{v});
  }
}

TEST(BrokenMesh, WithoutLabelsAVertexIsOnASegmentWithinTheTolerance) {
  Subject s;
  s.complex = unit_square();
  s.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 1e-12, 0}};
  s.mesh.cells = {0, 4, 3, 4, 2, 3, 4, 1, 2};
  s.options.tau.reset();
  EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
  EXPECT_NE(s.check("input-segments").detail.find("within 1e-9 of the diameter"),
            std::string::npos);
  s.mesh.vertices[4].y = 1e-7;
  EXPECT_EQ(s.failing(), (Names{"input-segments", "area"})) << failures(s.verified());
  EXPECT_EQ(s.check("input-segments").worst, (std::vector<std::uint32_t>{0, 1}));
}

TEST(BrokenMesh, AnotherMeshIsNotAMeshOfThis) {
  Subject s = square_with_hole();
  Complex other = unit_square();
  add_square(&other, 0.3, 0.3, 0.2);
  s.mesh = refined(other, Domain::kClosed, 0.07).mesh;
  for (const Subject& each : both(s)) {
    const Names failing = each.failing();
    EXPECT_TRUE(failing.count("input-vertices"));
    EXPECT_TRUE(failing.count("input-segments"));
    EXPECT_TRUE(failing.count("area"));
    EXPECT_EQ(each.check("input-vertices").worst, std::vector<std::uint32_t>{4});
  }
}

TEST(BrokenMesh, AHoleThatIsFilledIsOutsideTheDomain) {
  const Subject hole = square_with_hole();
  Subject s = hole;
  s.complex.hole_rule = HoleRule::kSeeds;  // no seeds: nothing is a hole
  const Subject filled = refined(s.complex, Domain::kClosed, 0.07);
  EXPECT_TRUE(filled.failing().empty()) << failures(filled.verified());
  s = filled;
  s.complex.hole_rule = HoleRule::kParity;
  for (const Subject& each : both(s)) {
    EXPECT_EQ(each.failing(), Names{"area"});
    const Check check = each.check("area");
    ASSERT_EQ(check.worst.size(), 3u);
    for (const std::uint32_t v : check.worst) {
      EXPECT_GE(each.mesh.vertices[v].x, 0.3);
      EXPECT_LE(each.mesh.vertices[v].x, 0.6 + 1e-15);
    }
  }
}

TEST(BrokenMesh, NonsenseIsNamedAndHarmsNothing) {
  const Subject whole = square_with_hole();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int kind = 0; kind < 5; ++kind) {
    Subject s = whole;
    s.options.checks = {"topology",    "delaunay",  "input-vertices", "input-segments",  "area",
                        "radius-edge", "min-angle", "size",           "nearest-neighbor"};
    s.options.size = 1;
    const auto t = cell_vertices(s.mesh, 17);
    if (kind == 0) s.mesh.cells[3 * 17] = 0xfffffff0u;
    if (kind == 1) s.mesh.cells[3 * 17] = t[1];
    if (kind == 2) s.mesh.vertices[t[0]].x = nan;
    if (kind == 3) s.mesh.cells.pop_back();
    if (kind == 4) s.mesh.dimension = 3;
    for (const Subject& each : both(s)) {
      EXPECT_EQ(each.verified().size(), 9u);
      EXPECT_TRUE(each.failing().count("topology")) << "kind " << kind;
    }
    if (kind < 2) {
      EXPECT_EQ(s.check("topology").worst, cell_vertices(s.mesh, 17));
    }
  }
}

TEST(BrokenMesh, AVertexThatCellsGoAroundTwiceIsNamed) {
  Subject s;  // a fan of ten triangles over 720 degrees
  s.mesh.vertices.push_back({0, 0, 0});
  for (int k = 0; k < 10; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / 5, r = k < 5 ? 1 : 1.5;
    s.mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  for (std::uint32_t k = 0; k < 10; ++k)
    s.mesh.cells.insert(s.mesh.cells.end(), {0, 1 + k, 1 + (k + 1) % 10});
  EXPECT_TRUE(legal(s.mesh));
  EXPECT_FALSE(s.check("topology").ok);
  EXPECT_EQ(s.check("topology").worst, std::vector<std::uint32_t>{0});
}

TEST(BrokenMesh, AnEdgeOfThreeCellsIsNamed) {
  Subject s;
  s.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 2, 0}};
  s.mesh.cells = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  EXPECT_FALSE(s.check("topology").ok);
  EXPECT_EQ(s.check("topology").worst, (std::vector<std::uint32_t>{0, 1}));
}

TEST(BrokenMesh, AVertexThatNoCellUsesCountsForCircumdisks) {
  for (const Domain domain : {Domain::kClosed, Domain::kBox}) {
    Subject s = square_with_hole(domain);
    const auto extra = static_cast<std::uint32_t>(s.mesh.vertices.size());
    s.mesh.vertices.push_back({0.111, 0.123, 0});
    s.mesh.vertex_features.push_back({});
    EXPECT_EQ(s.failing(), Names{"delaunay"});
    EXPECT_EQ(s.check("delaunay").worst.back(), extra);
  }
}

TEST(BrokenMesh, AHullWithADentOrABoundaryTwiceAroundIsNotATiling) {
  Subject s;
  s.options.domain = "hull";
  s.mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}};
  s.complex.vertices = s.mesh.vertices;
  s.mesh.cells = {1, 2, 4, 2, 3, 4, 3, 0, 4};  // the cell at the bottom is missing
  EXPECT_FALSE(s.check("delaunay").ok);
  EXPECT_EQ(s.check("delaunay").worst[1], 4u);
  EXPECT_FALSE(s.check("area").ok);
}

// Quality.

TEST(BrokenQuality, TheWorstCellIsNamedAndBoundsAreMet) {
  Subject s = square_with_hole();
  s.options.size = 10;
  const Check ratio = s.check("radius-edge"), size = s.check("size");
  ASSERT_TRUE(ratio.ok && size.ok);
  s.options.tau = *ratio.observed;  // exactly met is met
  s.options.size = *size.observed;
  EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
  s.options.tau = *ratio.observed * (1 - 1e-9);
  s.options.size = *size.observed * (1 - 1e-9);
  EXPECT_EQ(s.failing(), (Names{"radius-edge", "size"}));
  EXPECT_EQ(s.check("radius-edge").worst, ratio.worst);
  EXPECT_EQ(s.check("size").worst, size.worst);
  EXPECT_EQ(*s.check("radius-edge").observed, *ratio.observed);
  EXPECT_NEAR(measure(s.mesh).max_radius_edge, *ratio.observed, 1e-12);
}

TEST(BrokenQuality, ExcusedCellsDoNotCountButAreTold) {
  Subject s = square_with_hole();
  const Check ratio = s.check("radius-edge");
  s.options.tau = *ratio.observed * (1 - 1e-9);
  const std::size_t bad = static_cast<std::size_t>(std::stoul(s.check("radius-edge").detail));
  s.options.excused = {sorted(ratio.worst)};
  const Check excused = s.check("radius-edge");
  EXPECT_NE(excused.detail.find("1 cell above it excused"), std::string::npos) << excused.detail;
  EXPECT_EQ(excused.ok, bad == 1);
  EXPECT_NE(excused.worst, ratio.worst);
}

TEST(BrokenQuality, ChewsThirtyDegrees) {
  Subject s;
  s.mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 0.6, 0}, {1, -0.5, 0}};
  s.mesh.cells = {0, 1, 2};
  EXPECT_TRUE(s.check("min-angle").ok);  // atan 0.6 = 30.96 degrees
  EXPECT_NEAR(*s.check("min-angle").observed, 30.96375653, 1e-6);
  s.mesh.cells = {0, 1, 2, 1, 0, 3};  // atan 0.5 = 26.57 degrees
  EXPECT_FALSE(s.check("min-angle").ok);
  EXPECT_EQ(*s.check("min-angle").bound, 30);
  EXPECT_NEAR(*s.check("min-angle").observed, 26.56505118, 1e-6);
  EXPECT_EQ(s.check("min-angle").worst, (std::vector<std::uint32_t>{1, 0, 3}));
}

TEST(BrokenQuality, Theorem2_3FailsWhereASegmentIsEncroached) {
  Subject s;  // a vertex just above the middle of a segment that nobody split
  s.complex.vertices = {{0, 0, 0}, {10, 0, 0}, {5, 0.5, 0}};
  s.complex.segments = {{0, 1}};
  s.options.domain = "hull";
  s.mesh.vertices = s.complex.vertices;
  s.mesh.cells = {0, 1, 2};
  const Check check = s.check("nearest-neighbor");
  EXPECT_FALSE(check.ok);
  EXPECT_EQ(check.worst, std::vector<std::uint32_t>{2});
  EXPECT_NEAR(*check.observed, std::sqrt(25.25) / 0.5, 1e-12);
  EXPECT_EQ(*check.bound, std::sqrt(2.0));
}

}  // namespace
}  // namespace circumball
