#include <gtest/gtest.h>

#include <cmath>

#include "circumball/registry.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "delaunay/constructions.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::Random;

// Üngör 2004: the new triangle over the shortest edge has the radius-edge ratio tau; the point lies
// in the circumdisk, no farther than the circumcenter.
TEST(OffCenter, MakesATriangleThatIsJustGoodEnough) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Point2 p{random.unit(), random.unit()}, q{random.unit(), random.unit()};
    const double tau = 0.8 + 2 * random.unit();
    const Point2 o = off_center(p, q, tau);
    const TriangleShape shape = shape_of(p, q, o);
    EXPECT_FALSE(shape.radius_edge_exceeds(tau));
    EXPECT_NEAR(shape.radius_edge(), tau, 1e-8 * tau);
    // Of a triangle over pq whose third vertex is far: the off-center is in its disk, if it is bad.
    const double height = (1 + 5 * random.unit()) * 2 * tau, slide = random.unit() - 0.5;
    const double dx = q.x - p.x, dy = q.y - p.y;
    const Point2 r{p.x + (0.5 + slide) * dx - height * dy, p.y + (0.5 + slide) * dy + height * dx};
    const TriangleShape big = shape_of(p, q, r);
    const Point2 c = circumcenter(p, q, r);
    const Point2 m = midpoint(p, q);
    EXPECT_EQ(big.circumcenter_is_beyond_off_center(tau), distance(m, c) > distance(m, o));
    if (big.circumcenter_is_beyond_off_center(tau)) {
      EXPECT_TRUE(big.radius_edge_exceeds(tau));
      EXPECT_LT(distance(c, o), big.circumradius());
    }
  }
}

Options with(const std::string& algorithm, const char* steiner, double degrees) {
  Options options = options_of(algorithm);
  options.parameters["steiner"] = steiner;
  options.min_angle_degrees = degrees;
  options.limits.max_vertices = 200000;
  return options;
}

/// Isolated vertices in a square, and some close pairs: thin triangles in plenty.
Complex scattered(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  testing::add_square(&c, 0, 0, 1);
  for (int i = 0; i < 40; ++i) {
    const double x = 0.1 + 0.8 * random.unit(), y = 0.1 + 0.8 * random.unit();
    c.vertices.push_back({x, y, 0});
    if (i % 4 == 0) c.vertices.push_back({x + 1e-4 * random.unit(), y + 1e-4, 0});
  }
  return c;
}

// The guarantee is that of circumcenters; the number of vertices is what off-centers are for.
TEST(OffCenter, KeepsThePromisesOfRuppertWithFewerVertices) {
  for (const double degrees : {20.7, 30.0}) {
    std::size_t circumcenters = 0, off_centers = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Complex complex = seed % 2 ? scattered(seed) : testing::random_grid(seed, 0);
      for (const char* steiner : {"circumcenter", "off-center"}) {
        const auto run = finish(complex, with("ruppert", steiner, degrees));
        ASSERT_TRUE(run);
        ASSERT_EQ(run->status(), Status::kComplete) << seed << " " << steiner << " " << degrees;
        for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
          EXPECT_TRUE(c.ok) << "seed " << seed << ", " << c.name << ": " << c.detail;
        }
        (steiner[0] == 'o' ? off_centers : circumcenters) += run->mesh().vertices.size();
      }
    }
    RecordProperty(degrees < 25 ? "ratio_20.7" : "ratio_30",
                   std::to_string(1.0 * off_centers / circumcenters));
    EXPECT_LT(off_centers, (degrees < 25 ? 0.97 : 0.85) * circumcenters) << degrees;
  }
}

TEST(OffCenter, IsAnActionOfEveryAlgorithmOfThePlaneWithARadiusEdgeThreshold) {
  for (const AlgorithmInfo& info : registry()) {
    if (info.dimension != 2) continue;
    bool has_tau = false, has_steiner = false;
    for (const ParameterInfo& p : info.parameters) {
      has_tau = has_tau || p.name == "tau";
      has_steiner = has_steiner || p.name == "steiner";
    }
    EXPECT_EQ(has_tau, has_steiner) << info.id;
    if (!has_steiner) continue;
    Trace trace;
    const auto run = finish(scattered(1), with(info.id, "off-center", 25), &trace);
    ASSERT_TRUE(run) << info.id;
    std::size_t off_centers = 0;
    for (const Event& e : trace.events) off_centers += e.reason == Reason::kOffCenter;
    EXPECT_GT(off_centers, 10u) << info.id;
    EXPECT_EQ(run->status(), Status::kComplete);
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(c.ok) << info.id << ", " << c.name << ": " << c.detail;
    }
  }
}

TEST(OffCenter, SizeBoundsAloneGetCircumcenters) {
  Options options = with("ruppert", "off-center", 20.7);
  options.size = "0.05";
  Trace trace;
  const auto run = finish(testing::unit_square(), options, &trace);
  EXPECT_EQ(run->status(), Status::kComplete);
  for (const Event& e : trace.events) EXPECT_NE(e.reason, Reason::kOffCenter);
}

}  // namespace
}  // namespace circumball
