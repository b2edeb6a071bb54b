#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/protect.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/acute.h"

namespace circumball {
namespace {

using testing::finish;
using testing::least_angle;
using testing::options_of;
using testing::polygon;
using testing::random_fans;

TEST(Theorem3_3, NearestNeighborsEstimateFeatureSizesWhateverTheAngles) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
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
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
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
