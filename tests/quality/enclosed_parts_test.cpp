#include "quality/enclosed_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "circumball/io.h"
#include "circumball/verify.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::Random;
using testing::Rotation;
using testing::SolidBuilder;

void expect_volume(const Complex& complex, double volume, const std::string& what) {
  for (const Defect& d : check(complex)) ASSERT_TRUE(d.warning) << what << ": " << d.message;
  const EnclosedParts parts(complex);
  EXPECT_TRUE(parts.known()) << what;
  EXPECT_NEAR(parts.volume(), volume, 1e-9 * std::max(volume, 1.0)) << what;
}

TEST(EnclosedParts, HaveTheVolumesOfSolidsAnywhereInSpace) {
  for (const testing::Solid& solid : testing::solids()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      Random random(seed);
      const Rotation turn(&random);
      SolidBuilder b({1, seed > 0 ? &turn : nullptr, {0.1, 7, -3}});
      solid.build(&b);
      expect_volume(b.complex(), solid.volume, solid.name);
    }
  }
}

TEST(EnclosedParts, NestByParityAndBySeed) {
  for (int shells = 1; shells <= 5; ++shells) {
    SolidBuilder b({1, nullptr, {0, 0, 0}});
    double parity = 0;
    const auto cube = [](double a) { return a * a * a; };
    for (int k = shells; k-- > 0;) {  // the innermost first
      b.box({1.0 * k, 1.0 * k, 1.0 * k}, {11.0 - k, 11.0 - k, 11.0 - k});
    }
    for (int k = 0; k < shells; ++k) parity += (k % 2 == 0 ? 1 : -1) * cube(11 - 2 * k);
    expect_volume(b.complex(), parity, "parity");
    for (int hole = 0; hole < shells; ++hole) {
      SolidBuilder with = b;
      with.holes.push_back({hole + 0.5, hole + 0.4, hole + 0.3});
      const double inner = hole + 1 < shells ? cube(9 - 2 * hole) : 0;
      expect_volume(with.complex(), cube(11) - cube(11 - 2 * hole) + inner, "seed");
    }
  }
}

TEST(EnclosedParts, AreFoundAmongManyCavitiesBesideEachOther) {
  Random random(3);
  const Rotation turn(&random);
  SolidBuilder b({1, &turn, {0, 0, 0}});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        const Point3 low = {i + 0.2, j + 0.3, k + 0.1};
        b.box(low, {low.x + 0.5, low.y + 0.5, low.z + 0.5});
        if ((i + j + k) % 2)  // a solid in the cavity
          b.box({low.x + 0.1, low.y + 0.1, low.z + 0.1}, {low.x + 0.4, low.y + 0.4, low.z + 0.4});
      }
  b.box({0, 0, 0}, {4, 4, 4});
  b.box({5, 0, 0}, {6, 1, 1});  // another one beside it
  expect_volume(b.complex(), 64 - 64 * 0.125 + 32 * 0.027 + 1, "cavities");
}

/// What dangles encloses nothing; neither does a box without one of its sides.
TEST(EnclosedParts, AreNoneWhereFacesLeaveAGap) {
  SolidBuilder b({1, nullptr, {0, 0, 0}});
  b.box({0, 0, 0}, {1, 1, 1});
  Complex open = b.complex();
  open.faces.pop_back();
  expect_volume(open, 0, "open box");
  b.builder().face(b.square(2, 3, 0));
  b.builder().face(b.square(0.25, 0.75, 0.5));
  expect_volume(b.complex(), 1, "dangling faces");
}

/// An empty mesh, or one of the hull, is told from the domain.
TEST(EnclosedParts, TellAMeshOfTheHullFromOneOfTheDomain) {
  SolidBuilder b({1, nullptr, {0, 0, 0}});
  b.prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
  Options options = testing::options_of("delaunay");
  const auto run = testing::finish(b.complex(), options);
  ASSERT_TRUE(run);
  VerifyOptions asked;
  asked.checks = {"volume"};
  asked.domain = "closed";
  const auto results = verify(run->mesh(), b.complex(), asked);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_FALSE(results[0].ok);
  EXPECT_NEAR(*results[0].bound, 3, 1e-12);
  EXPECT_NEAR(*results[0].observed, 3.5, 1e-12);
}

}  // namespace
}  // namespace circumball
