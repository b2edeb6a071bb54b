#include <gtest/gtest.h>

#include "circumball/registry.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::add_square;
using testing::finish;
using testing::options_of;
using testing::random_grid;
using testing::unit_square;

/// Every check that the registry promises for the run.
void expect_promises(const Run& run, const std::string& what) {
  for (const Check& c : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(c.ok) << what << ", " << c.name << ": " << c.detail;
  }
}

// Input angles of 72 and 90 degrees, tau just above sqrt 2 and larger: Theorems 2.2 and 2.3, and
// the remark after them.
TEST(Theorem2_2, RuppertEndsAndKeepsItsPromises) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Complex complex = random_grid(seed, seed % 3 == 0 ? 0.3 : 0);
    Options options = options_of("ruppert");
    options.tau = seed % 2 ? 1.4145 : 2.0;
    options.domain = seed % 5 == 0 ? Domain::kBox : Domain::kDefault;
    options.limits.max_vertices = 200000;
    const auto run = finish(complex, options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->status(), Status::kComplete) << "seed " << seed;
    EXPECT_TRUE(run->unresolved().empty()) << "seed " << seed;
    expect_promises(*run, "seed " + std::to_string(seed));
  }
}

TEST(Ruppert, TheDiagonalOfASquareIsAnEdgeAlthoughItsCircleIsATie) {
  for (const bool other : {false, true}) {
    Complex complex = unit_square();
    complex.segments.push_back(other ? std::array<std::uint32_t, 2>{0, 2}
                                     : std::array<std::uint32_t, 2>{1, 3});
    const auto run = finish(complex, options_of("ruppert"));
    EXPECT_EQ(run->status(), Status::kComplete);
    expect_promises(*run, "diagonal");
  }
}

TEST(Ruppert, HonorsTheSizeBound) {
  Options options = options_of("ruppert");
  options.size = "0.05";
  const auto run = finish(unit_square(), options);
  EXPECT_EQ(run->status(), Status::kComplete);
  expect_promises(*run, "size");
  EXPECT_GT(run->mesh().vertices.size(), 200u);
}

TEST(Ruppert, HonorsTheAreaBoundOfARegion) {
  Complex complex = unit_square();
  add_square(&complex, 0.25, 0.25, 0.5);
  complex.regions.push_back({{0.5, 0.5, 0}, 7, 1e-3});
  complex.regions.push_back({{0.1, 0.1, 0}, 3, 0});
  const auto run = finish(complex, options_of("ruppert"));
  const Mesh mesh = run->mesh();
  ASSERT_EQ(mesh.cell_regions.size(), mesh.cell_count());
  double area[2] = {0, 0};
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const Point3 &a = mesh.vertices[mesh.cell(i)[0]], &b = mesh.vertices[mesh.cell(i)[1]],
                 &c = mesh.vertices[mesh.cell(i)[2]];
    const double size = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (mesh.cell_regions[i] == 7) {
      EXPECT_LE(size, 1e-3);
      area[0] += size;
    } else {
      EXPECT_EQ(mesh.cell_regions[i], 3);
      area[1] += size;
    }
  }
  EXPECT_NEAR(area[0], 0.25, 1e-12);
  EXPECT_NEAR(area[1], 0.75, 1e-12);
}

double meshed_area(const Complex& complex) {
  const auto run = finish(complex, options_of("ruppert"));
  expect_promises(*run, "holes");
  return measure(run->mesh()).area;
}

TEST(Domain, NestedLoopsAreHolesByParityAndBySeed) {
  Complex complex = unit_square();
  add_square(&complex, 0.25, 0.25, 0.5);
  add_square(&complex, 0.375, 0.375, 0.25);
  EXPECT_NEAR(meshed_area(complex), 1 - 0.25 + 0.0625, 1e-12);
  complex.hole_rule = HoleRule::kSeeds;
  EXPECT_NEAR(meshed_area(complex), 1, 1e-12);
  complex.holes = {{0.5, 0.5, 0}};
  EXPECT_NEAR(meshed_area(complex), 1 - 0.0625, 1e-12);
  complex.holes = {{0.3, 0.5, 0}};
  EXPECT_NEAR(meshed_area(complex), 1 - 0.25 + 0.0625, 1e-12);
}

TEST(Domain, NeighboringLoopsThatShareASegmentAreBothInside) {
  Complex complex = unit_square();
  complex.vertices.push_back({2, 0, 0});
  complex.vertices.push_back({2, 1, 0});
  complex.segments.push_back({1, 4});
  complex.segments.push_back({4, 5});
  complex.segments.push_back({5, 2});
  EXPECT_NEAR(meshed_area(complex), 2, 1e-12);
}

TEST(Domain, TheBoxIsThreeTimesTheInput) {
  Options options = options_of("ruppert");
  options.domain = Domain::kBox;
  const auto run = finish(unit_square(), options);
  const Mesh mesh = run->mesh();
  EXPECT_EQ(mesh.box_vertices, 4u);
  EXPECT_EQ(mesh.vertices[4], (Point3{-1, -1, 0}));
  EXPECT_EQ(mesh.vertices[6], (Point3{2, 2, 0}));
  EXPECT_NEAR(measure(mesh).area, 9, 1e-12);
  expect_promises(*run, "box");
}

TEST(Domain, CollinearInputIsAMeshWithoutTrianglesOrABoxOfThem) {
  Complex line;
  for (int i = 0; i < 5; ++i) line.vertices.push_back({i * 1.0, i * 2.0, 0});
  line.segments = {{0, 1}, {1, 2}, {3, 4}};
  const auto hull = finish(line, options_of("delaunay"));
  EXPECT_EQ(hull->mesh().cell_count(), 0u);
  Options options = options_of("ruppert");
  const auto box = finish(line, options);
  EXPECT_EQ(box->domain(), Domain::kBox);
  expect_promises(*box, "line in a box");
  options.domain = Domain::kHull;
  const auto chain = finish(line, options);
  EXPECT_EQ(chain->status(), Status::kComplete);
  expect_promises(*chain, "line in its hull");
}

TEST(Numbers, OffsetsAndScalesAreNormalInput) {
  for (const double scale : {1e-40, 1e-9, 1.0, 1e9, 1e40}) {
    Complex complex = unit_square();
    add_square(&complex, 0.25, 0.25, 0.125);
    for (Point3& p : complex.vertices) p = {p.x * scale, p.y * scale, 0};
    const auto run = finish(complex, options_of("ruppert"));
    EXPECT_EQ(run->status(), Status::kComplete) << scale;
    expect_promises(*run, "scale " + std::to_string(scale));
  }
  Complex complex = unit_square();
  add_square(&complex, 0.25, 0.25, 0.001);
  for (Point3& p : complex.vertices) p = {p.x + 1e6, p.y - 1e6, 0};
  const auto run = finish(complex, options_of("ruppert"));
  EXPECT_EQ(run->status(), Status::kComplete);
  expect_promises(*run, "offset");
}

TEST(Numbers, PowersOfTwoScaleTheMeshAlike) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Complex complex = random_grid(seed, 0);
    Complex scaled = complex;
    for (Point3& p : scaled.vertices) p = {p.x * 0x1p-20, p.y * 0x1p-20, 0};
    const Mesh mesh = finish(complex, options_of("ruppert"))->mesh();
    const Mesh small = finish(scaled, options_of("ruppert"))->mesh();
    ASSERT_EQ(mesh.cells, small.cells);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      EXPECT_EQ(mesh.vertices[i].x * 0x1p-20, small.vertices[i].x);
      EXPECT_EQ(mesh.vertices[i].y * 0x1p-20, small.vertices[i].y);
    }
  }
}

TEST(Mesh, MarkersAndAttributesReachTheMesh) {
  Complex complex = unit_square();
  complex.segment_markers = {1, 2, 3, 4};
  complex.vertex_markers = {10, 11, 12, 13};
  complex.attributes_per_vertex = 1;
  complex.vertex_attributes = {0, 1, 2, 3};
  Options options = options_of("ruppert");
  options.size = "0.2";
  const Mesh mesh = finish(complex, options)->mesh();
  ASSERT_EQ(mesh.edge_markers.size(), mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    EXPECT_EQ(mesh.edge_markers[i], static_cast<int>(mesh.edges[i].segment) + 1);
  }
  for (std::size_t i = 4; i < mesh.vertices.size(); ++i) {
    const Feature& f = mesh.vertex_features[i];
    if (f.kind == FeatureKind::kSegment) {
      EXPECT_EQ(mesh.vertex_markers[i], static_cast<int>(f.index) + 1);
      if (f.index == 0) {
        EXPECT_DOUBLE_EQ(mesh.vertex_attributes[i], mesh.vertices[i].x);
      }
    } else {
      EXPECT_EQ(mesh.vertex_markers[i], 0);
    }
  }
}

}  // namespace
}  // namespace circumball
