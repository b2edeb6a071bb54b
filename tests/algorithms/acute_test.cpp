#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/protect.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::polygon;
using testing::Random;

/// Adds segments from a common vertex in the disk of radius 1 about (x, y): angles between `least`
/// degrees and a few times as much, or anything; some only a needle's width apart.
void add_fan(Complex* c, Random* random, double x, double y, double least) {
  const auto hub = static_cast<std::uint32_t>(c->vertices.size());
  c->vertices.push_back({x, y, 0});
  const std::uint32_t count = 2 + random->below(8);
  double angle = 360 * random->unit();
  double turned = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double radians = angle * (elementary::kPi / 180);
    const double length = 0.1 + 0.85 * random->unit();
    const auto tip = static_cast<std::uint32_t>(c->vertices.size());
    c->vertices.push_back(
        {x + length * elementary::cos(radians), y + length * elementary::sin(radians), 0});
    c->segments.push_back({hub, tip});
    const double step =
        random->below(2) ? least * (1 + random->unit()) : least + 60 * random->unit();
    angle += step;
    turned += step;
    if (turned + least + 60 > 360) break;
  }
}

/// Some fans far enough apart not to cross, with isolated vertices between; within a square, if
/// `closed`.
Complex random_fans(std::uint64_t seed, double least, bool closed) {
  Random random(seed);
  Complex c;
  const std::uint32_t n = 1 + random.below(3);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      if (random.below(4) == 0) {
        c.vertices.push_back({2.0 * i + 0.3 * random.unit(), 2.0 * j, 0});
      } else {
        add_fan(&c, &random, 2.0 * i, 2.0 * j, least);
      }
    }
  }
  if (closed) testing::add_square(&c, -1.5, -1.5, 2.0 * n + 1);
  return c;
}

/// Two segments at an angle of theta are split to about theta times the distance from their vertex:
/// 1 / theta pieces. So the smallest angles come rarely.
double least_angle(std::uint64_t seed) {
  return seed % 50 == 0 ? 0.01 : seed % 10 == 1 ? 0.3 : seed % 2 ? 3 : 20;
}

TEST(Theorem3_3, NearestNeighborsEstimateFeatureSizesWhateverTheAngles) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const double least = least_angle(seed);
    const Complex complex = random_fans(seed, least, seed % 2 == 0);
    const auto run = finish(complex, options_of("feature-size"));
    ASSERT_TRUE(run) << "seed " << seed;
    ASSERT_EQ(run->status(), Status::kComplete) << "seed " << seed;
    EXPECT_TRUE(run->unresolved().empty());
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(c.ok) << "seed " << seed << ", " << c.name << ": " << c.detail;
    }
  }
}

TEST(Theorem3_2, TheLowerBoundHoldsThroughout) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Complex complex = random_fans(seed, seed % 2 ? 5 : 25, true);
    const auto run = testing::start(complex, options_of("feature-size"));
    ASSERT_TRUE(run);
    VerifyOptions options = promised_checks(*run);
    options.checks = {"nearest-neighbor-lower"};
    do {
      for (const Check& c : verify(run->mesh(), run->complex(), options))
        EXPECT_TRUE(c.ok) << c.detail;
    } while (run->advance(1) == Status::kRunning);
  }
}

TEST(Theorem5_7, CollarsEndConformAndConfineBadTriangles) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const double least = least_angle(seed);
    const Complex complex = random_fans(seed, least, seed % 4 != 0);
    Options options = options_of("collar");
    options.tau = seed % 5 == 0 ? 2.0 : 1.4145;
    options.limits.max_vertices = 400000;
    const auto run = finish(complex, options);
    ASSERT_TRUE(run) << "seed " << seed;
    ASSERT_EQ(run->status(), Status::kComplete) << "seed " << seed << ", least angle " << least;
    for (const Unresolved& u : run->unresolved()) EXPECT_EQ(u.reason, "protected");
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(c.ok) << "seed " << seed << ", " << c.name << ": " << c.detail;
    }
  }
}

TEST(Theorem5_7, ANeedleIsMeshedWithFewVertices) {
  const Complex needle = polygon({{0, 0}, {1, 0}, {0.996194698091746, 0.0871557427476582}});
  const auto run = finish(needle, options_of("collar"));
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_LT(run->mesh().vertices.size(), 200u);
}

TEST(Collar, IsRuppertWhereNoAngleIsAcute) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Complex complex = testing::random_grid(seed, 0);
    EXPECT_EQ(fingerprint(finish(complex, options_of("collar"))->mesh()),
              fingerprint(finish(complex, options_of("ruppert"))->mesh()));
  }
}

TEST(Collar, ProtectsAllVerticesOnRequest) {
  Options options = options_of("collar");
  options.parameters["protect"] = "all";
  const auto run = finish(testing::unit_square(), options);
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_GE(run->mesh().vertices.size(), 12u);
  options.parameters["protect"] = "none";
  EXPECT_FALSE(testing::start(testing::unit_square(), options));
}

TEST(AcuteVertices, ARightAngleIsNotAcute) {
  EXPECT_EQ(acute_vertices(testing::unit_square()), std::vector<bool>(4, false));
  const Complex triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(acute_vertices(triangle), (std::vector<bool>{false, true, true}));
}

}  // namespace
}  // namespace circumball
