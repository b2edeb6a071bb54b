#include "circumball/verify.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "circumball/predicates.h"
#include "quality/verify_test_util.h"

namespace circumball {
namespace {

using namespace testing;

// What is right passes.

TEST(Verify, AcceptsMeshesOfTheRefinementAndTheSameWithoutLabels) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Complex complex = random_grid(seed, seed % 2 ? 0.3 : 0);
    for (const Domain domain :
         {Domain::kBox, Domain::kDefault}) {  // closed where it encloses something
      Subject s = refined(complex, domain);
      s.options.checks = {"topology", "delaunay",    "input-vertices",  "input-segments",
                          "area",     "radius-edge", "nearest-neighbor"};
      EXPECT_EQ(s.verified().size(), 7u);
      EXPECT_TRUE(s.failing().empty()) << "seed " << seed << "\n" << failures(s.verified());
      const Subject f = s.foreign();
      EXPECT_TRUE(f.failing().empty()) << "seed " << seed << ", foreign\n"
                                       << failures(f.verified());
    }
  }
}

TEST(Verify, AcceptsLargeOffsetsAndSmallFeatures) {
  for (const double offset : {1e6, -3e8}) {
    Complex c = unit_square();
    add_square(&c, 0.25, 0.25, 0.5);
    for (Point3& p : c.vertices) p = {offset + 0x1p-10 * p.x, 0.5 * offset + 0x1p-10 * p.y, 0};
    const Subject s = refined(c);
    EXPECT_GT(s.mesh.cell_count(), 0u);
    EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
    EXPECT_EQ(*s.check("area").bound, 0.75 * 0x1p-20);
  }
}

TEST(Verify, SaysTheSameAtEveryScale) {
  Subject s = square_with_hole();
  s.options.checks = {"topology", "delaunay",    "input-vertices", "input-segments",
                      "area",     "radius-edge", "min-angle",      "nearest-neighbor"};
  for (const bool broken : {false, true}) {
    if (broken) {  // not Delaunay, not in place, too thin
      s.options.tau = 1;
      s.mesh.vertices[6].x += 0x1p-20;
      const auto t = cell_vertices(s.mesh, 60);
      flip(&s.mesh, t[0], t[1]);
    }
    for (const double scale :
         {0x1p-120, 0x1p170}) {  // the least coordinates that are not 0 are about 2^-4
      Subject scaled = s;
      for (Point3& p : scaled.complex.vertices) p = {scale * p.x, scale * p.y, 0};
      for (Point3& p : scaled.mesh.vertices) p = {scale * p.x, scale * p.y, 0};
      const auto expected = s.verified(), found = scaled.verified();
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].ok, expected[i].ok) << found[i].name << ": " << found[i].detail;
        EXPECT_EQ(found[i].worst, expected[i].worst) << found[i].name;
      }
    }
  }
}

TEST(Verify, RunsTheChecksThatApplyInOrder) {
  Subject s = square_with_hole();
  const auto names = [&] {
    std::string text;
    for (const Check& c : s.verified()) text += c.name + " ";
    return text;
  };
  EXPECT_EQ(names(), "topology delaunay input-vertices input-segments area radius-edge ");
  s.options.size = 1;
  s.options.tau.reset();
  EXPECT_EQ(names(), "topology delaunay input-vertices input-segments area size ");
  s.options.checks = {"nearest-neighbor", "min-angle", "topology",
                      "radius-edge"};  // the last without a bound
  EXPECT_EQ(names(), "topology min-angle nearest-neighbor ");
}

TEST(Verify, ReportsEulersCharacteristicAndTheArea) {
  const Subject s = square_with_hole();
  EXPECT_NE(s.check("topology").detail.find("Euler characteristic 0"), std::string::npos)
      << s.check("topology").detail;
  EXPECT_NEAR(*s.check("area").observed, 0.91, 1e-12);
  EXPECT_NEAR(*s.check("area").bound, 0.91, 1e-12);
}

TEST(Verify, NoCellsAreRightForCollinearVerticesOnly) {
  Subject s;
  s.complex.vertices = {{0, 0, 0}, {1, 1, 0}, {3, 3, 0}};
  s.mesh.vertices = s.complex.vertices;
  s.mesh.input_vertices = 3;
  s.options.domain = "hull";
  EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
  s.complex.vertices[1].y = s.mesh.vertices[1].y = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(s.failing().count("delaunay"));
}

TEST(Verify, TheRestIsSilentlyRobustAgainstAnEmptyMesh) {
  Subject s = square_with_hole();
  s.mesh = Mesh{};
  EXPECT_EQ(s.failing(), (std::set<std::string>{"input-vertices", "input-segments", "area"}));
  s.complex = Complex{};
  EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
}

// The empty circumdisk of every cell, by brute force: Definition 2.1.1.
bool delaunay_by_brute_force(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* c = mesh.cell(i);
    for (const Point3& p : mesh.vertices) {
      if (incircle(xy(mesh.vertices[c[0]]), xy(mesh.vertices[c[1]]), xy(mesh.vertices[c[2]]),
                   xy(p)) == Sign::kPositive)
        return false;
    }
  }
  return true;
}

TEST(VerifyDelaunay, AgreesWithBruteForceWhateverIsFlipped) {
  int right = 0, wrong = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    Complex c;
    const std::uint32_t n = 4 + random.below(20);
    for (std::uint32_t i = 0; i < n;
         ++i) {  // cocircular points abound: flips may leave it Delaunay
      const double x = seed % 2 ? random.below(7) : random.unit();
      const double y = seed % 2 ? random.below(7) : random.unit();
      const Point3 p{x, y, 0};
      if (std::find(c.vertices.begin(), c.vertices.end(), p) == c.vertices.end())
        c.vertices.push_back(p);
    }
    const auto run = finish(c, options_of("delaunay"));
    ASSERT_TRUE(run);
    Subject s;
    s.complex = c;
    s.mesh = run->mesh();
    for (int flips = 0; flips < 3; ++flips) {
      s.options.domain = flips % 2 ? "closed" : "hull";
      const bool expected = delaunay_by_brute_force(s.mesh);
      ASSERT_EQ(s.check("delaunay").ok, expected)
          << "seed " << seed << ": " << s.check("delaunay").detail;
      ++(expected ? right : wrong);
      if (s.mesh.cell_count() == 0) break;
      const auto t =
          cell_vertices(s.mesh, random.below(static_cast<std::uint32_t>(s.mesh.cell_count())));
      Mesh flipped = s.mesh;
      if (!flip(&flipped, t[0], t[1])) continue;
      bool convex = true;
      for (std::size_t i = 0; i < flipped.cell_count(); ++i) {
        const std::uint32_t* v = flipped.cell(i);
        convex = convex && orient2d(xy(flipped.vertices[v[0]]), xy(flipped.vertices[v[1]]),
                                    xy(flipped.vertices[v[2]])) == Sign::kPositive;
      }
      if (convex) s.mesh = flipped;
    }
  }
  EXPECT_GT(right, 200);
  EXPECT_GT(wrong, 100);
}

TEST(VerifyDelaunay, LocallyDelaunayIsNotEnoughForAClosedDomain) {
  // two triangles that touch nowhere; a corner of one lies in the circumdisk of the other
  Subject s;
  s.complex = polygon({{0, 0}, {4, 0}, {2, 0.5}});
  const Complex other = polygon({{2, -1}, {1.5, -20}, {2.5, -20}});
  for (const Point3& p : other.vertices) s.complex.vertices.push_back(p);
  for (const auto& e : other.segments) s.complex.segments.push_back({e[0] + 3, e[1] + 3});
  s.mesh.vertices = s.complex.vertices;
  s.mesh.cells = {0, 1, 2, 3, 4, 5};
  EXPECT_EQ(s.failing(), (std::set<std::string>{"delaunay"})) << failures(s.verified());
  EXPECT_EQ(s.check("delaunay").worst, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  // slivers, whose circumcenters are rounded beyond use, are searched as exactly
  s.complex.vertices[2] = s.mesh.vertices[2] = {2, 1e-16, 0};
  EXPECT_EQ(s.failing(), (std::set<std::string>{"delaunay"}));
  EXPECT_NE(s.check("delaunay").observed, 0);
}

TEST(VerifyArea, TheOtherSquaresOfACheckerboardAreNotTheDomain) {
  // four unit squares in a frame, two of them holes: on the other two the area and the segments are
  // the same
  Complex c = polygon({{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) c.vertices.push_back({x + 0.0, y + 0.0, 0});
  for (const auto& e : {std::array<std::uint32_t, 2>{0, 1},
                        {1, 2},
                        {3, 4},
                        {4, 5},
                        {6, 7},
                        {7, 8},
                        {0, 3},
                        {3, 6},
                        {1, 4},
                        {4, 7},
                        {2, 5},
                        {5, 8}})
    c.segments.push_back({e[0] + 4, e[1] + 4});
  c.holes = {{0.5, 0.5, 0}, {1.5, 1.5, 0}};
  Subject s = refined(c);
  EXPECT_TRUE(s.failing().empty()) << failures(s.verified());
  EXPECT_NE(s.check("topology").detail.find("touches itself at 1 vertex"), std::string::npos);
  s.complex.holes = {{1.5, 0.5, 0}, {0.5, 1.5, 0}};
  EXPECT_EQ(s.failing(), (std::set<std::string>{"area"})) << failures(s.verified());
  EXPECT_EQ(s.check("area").observed, s.check("area").bound);
  EXPECT_FALSE(s.check("area").worst.empty());
}

TEST(VerifyArea, CountsAdjacentPartsDanglingSegmentsAndIslands) {
  // two squares side by side, a dangling segment in one, in the other a ring with an island
  Complex c = polygon({{0, 0}, {4, 0}, {8, 0}, {8, 4}, {4, 4}, {0, 4}});
  c.segments.push_back({1, 4});
  c.vertices.push_back({2, 2, 0});
  c.segments.push_back({0, 6});
  c.vertices.push_back({1, 3, 0});  // alone
  add_square(&c, 5, 1, 2);
  add_square(&c, 5.5, 1.5, 1);
  const Subject parity = refined(c);
  EXPECT_TRUE(parity.failing().empty()) << failures(parity.verified());
  EXPECT_EQ(*parity.check("area").bound, 16 + 16 - 4 + 1);
  c.holes = {{6, 2, 0}};
  const Subject seeds = refined(c);
  EXPECT_TRUE(seeds.failing().empty()) << failures(seeds.verified());
  EXPECT_EQ(*seeds.check("area").bound, 16 + 16 - 1);
}

TEST(Measure, KnowsItsTriangles) {
  Mesh m;
  m.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {3, 4, 0}};
  m.cells = {0, 1, 2, 1, 3, 2};
  const Quality q = measure(m);
  EXPECT_DOUBLE_EQ(q.min_angle_degrees, std::atan2(3, 4) * 180 / std::acos(-1.0));
  EXPECT_DOUBLE_EQ(q.max_angle_degrees, 90);
  EXPECT_DOUBLE_EQ(q.max_radius_edge, 2.5 / 3);
  EXPECT_EQ(q.shortest_edge, 3);
  EXPECT_EQ(q.area, 12);
  EXPECT_EQ(measure(Mesh{}).area, 0);
}

TEST(Measure, AThinTriangleFarOutIsMeasuredRight) {
  Mesh m;  // height 2^-30 over a base of 1, at an offset of 2^20
  const double x = 0x1p20;
  m.vertices = {{x, x, 0}, {x + 1, x, 0}, {x + 0.5, x + 0x1p-30, 0}};
  m.cells = {0, 1, 2};
  const Quality q = measure(m);
  EXPECT_EQ(q.area, 0x1p-31);
  EXPECT_NEAR(q.max_radius_edge / 0x1p28, 1, 1e-8);  // R = 1 / (8 h), the shorter sides are 1/2
  EXPECT_NEAR(q.min_angle_degrees * std::acos(-1.0) / 180 / 0x1p-29, 1, 1e-9);
}

}  // namespace
}  // namespace circumball
