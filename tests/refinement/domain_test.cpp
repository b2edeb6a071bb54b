#include <gtest/gtest.h>

#include <cmath>

#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::add_square;
using testing::finish;
using testing::options_of;
using testing::polygon;

double area_of(const Mesh& mesh) {
  double twice = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3) {
    const Point3 &p = mesh.vertices[mesh.cells[c]], &q = mesh.vertices[mesh.cells[c + 1]],
                 &r = mesh.vertices[mesh.cells[c + 2]];
    twice += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return 0.5 * twice;
}

Check check_of(const Run& run, const std::string& name, const char* domain) {
  VerifyOptions options;
  options.checks = {name};
  options.domain = domain;
  return verify(run.mesh(), run.complex(), options).at(0);
}

/// Spokes at one vertex, far below 60 degrees, and the polygon around them.
Complex wheel(std::uint32_t spokes) {
  Complex c;
  c.vertices.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double angle = 6.283185307179586 * i / spokes;
    c.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    c.segments.push_back({0, i + 1});
    c.segments.push_back({i + 1, (i + 1) % spokes + 1});
  }
  return c;
}

TEST(Domain, IsNotLostWhereRefusedSubsegmentsAreMissing) {
  for (const std::uint32_t spokes : {100u, 600u, 1500u}) {
    Options options = options_of("ruppert");
    options.limits.min_edge = 2e-3;
    const auto run = finish(wheel(spokes), options);
    EXPECT_EQ(run->limit(), Reason::kLimitMinEdge);
    ASSERT_FALSE(run->unresolved().empty());
    const double turn = 6.283185307179586 / spokes;
    EXPECT_NEAR(area_of(run->mesh()), 0.5 * spokes * std::sin(turn), 1e-9) << spokes;
  }
}

TEST(Domain, OfSegmentsGivenTwiceTheSecondIsIgnoredThoughTheyAreNoEdges) {
  Complex c = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (const Point2& p : {Point2{2, 5}, Point2{8, 5}, Point2{5, 5.5}, Point2{5, 4.5}}) {
    c.vertices.push_back(xyz(p));
  }
  c.segments.push_back({4, 5});
  c.segments.push_back({5, 4});
  for (const char* algorithm : {"ruppert", "chew"}) {
    const auto run = finish(c, options_of(algorithm));
    EXPECT_EQ(run->status(), Status::kComplete) << algorithm;
    EXPECT_TRUE(run->unresolved().empty()) << algorithm;
    const Check check = check_of(*run, "input-segments", "closed");
    EXPECT_TRUE(check.ok) << check.detail;
  }
}

TEST(Domain, AHoleSeedOnASegmentRemovesNothing) {
  Complex c = polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  add_square(&c, 2, 2, 4);
  c.holes = {{2, 4, 0}};
  const auto run = finish(c, options_of("ruppert"));
  EXPECT_NEAR(area_of(run->mesh()), 64, 1e-9);
  const Check check = check_of(*run, "area", "closed");
  EXPECT_TRUE(check.ok) << check.detail;
}

TEST(Domain, ASeedFarAwayIsNoPartOfTheHull) {
  Complex c = polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  c.holes = {{100, 100, 0}};
  Options options = options_of("ruppert");
  options.domain = Domain::kHull;
  const auto run = finish(c, options);
  const Check check = check_of(*run, "area", "hull");
  EXPECT_TRUE(check.ok) << check.detail;
  EXPECT_DOUBLE_EQ(*check.bound, 64);
}

TEST(Domain, ABoxOfASingleVertexFarAwayHasFourCorners) {
  Complex c;
  c.vertices = {{1e20, 0, 0}};
  const auto run = finish(c, options_of("ruppert"));
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_GT(run->mesh().cell_count(), 0u);
}

TEST(Domain, ABoxBeyondTheRangeOfCoordinatesIsRefused) {
  Complex c;
  c.vertices = {{9e54, 9e54, 0}, {-9e54, 9e54, 0}, {0, -9e54, 0}};
  c.segments = {{0, 1}};
  std::vector<Defect> defects;
  std::string error;
  EXPECT_EQ(Run::create(c, options_of("ruppert"), nullptr, &defects, &error), nullptr);
  EXPECT_NE(error.find("box"), std::string::npos) << error;
}

}  // namespace
}  // namespace circumball
