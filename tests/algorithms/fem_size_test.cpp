#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/equal_lengths.h"
#include "circumball/predicates.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/acute.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;

double length_between(const Point2& a, const Point2& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// The sizing functions that the theorem is tested with: constant, smooth, discontinuous.
const char* sizing(std::uint64_t seed) {
  constexpr const char* kSizes[] = {"", "0.3", "0.05 + 0.3*x^2", "x < 0.4 ? 0.1 : 2",
                                    "0.1 + 0.2*abs(x - y)"};
  return kSizes[seed % 5];
}

void expect_theorem7_13(const Complex& complex, const std::string& size, const std::string& what) {
  Options options = options_of("fem-size");
  options.size = size;
  options.limits.max_vertices = 300000;
  const auto run = finish(complex, options);
  ASSERT_TRUE(run) << what;
  EXPECT_EQ(run->status(), Status::kComplete) << what;
  EXPECT_TRUE(run->unresolved().empty()) << what;
  const std::vector<Check> checks = verify(run->mesh(), run->complex(), promised_checks(*run));
  EXPECT_EQ(checks.size(), 8u);
  for (const Check& c : checks) EXPECT_TRUE(c.ok) << what << ", " << c.name << ": " << c.detail;
}

TEST(Theorem7_13, HoldsOnAcuteComplexesOfAllKinds) {
  for (std::uint64_t seed = 0; seed < testing::cases(60); ++seed) {
    expect_theorem7_13(testing::acute_complex(seed), sizing(seed), "seed " + std::to_string(seed));
  }
}

TEST(Theorem7_13, HoldsOnFansOfDozensOfSegmentsAtAHundredthOfADegree) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    expect_theorem7_13(testing::dense_fan(seed, 20 + 5 * static_cast<std::uint32_t>(seed), 0.01),
                       sizing(seed), "fan " + std::to_string(seed));
  }
}

TEST(Theorem7_13, HoldsWithoutAcuteAngles) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    expect_theorem7_13(testing::random_grid(seed, seed % 2 ? 0.3 : 0), sizing(seed),
                       "grid " + std::to_string(seed));
  }
}

TEST(Theorem7_13, HoldsFarFromTheOrigin) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Complex c = testing::dense_fan(seed, 12, 3);
    for (Point3& p : c.vertices) p = {1e6 + 1e-2 * p.x, -1e6 + 1e-2 * p.y, 0};
    expect_theorem7_13(c, "", "fan " + std::to_string(seed));
  }
}

TEST(Theorem7_13, HoldsForIsolatedVerticesAndASingleOne) {
  Complex c;
  c.vertices = {{0, 0, 0}};
  expect_theorem7_13(c, "", "a vertex");
  c.vertices = {{0, 0, 0}, {1e-6, 0, 0}, {0.3, 0.7, 0}};
  expect_theorem7_13(c, "0.1", "three vertices");
}

/// The lower bound as printed asks for R_t >= 1/2 min(h(t), lfs(t)) everywhere; on segments only 1
/// / (2 sqrt 2) of h holds. Here h is constant; of the triangles at the tip of a wedge, which no
/// disjoint features are near to, some are smaller than printed.
TEST(Theorem7_13, ThePrintedConstantFailsOnSegments) {
  double least = 1;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    testing::Random random(seed);
    const double degrees = 2 + 10 * random.unit();
    const Point2 tip = testing::polar(0, 0, 1, degrees);
    const Complex wedge = testing::polygon({{0, 0}, {1, 0}, tip});
    Options options = options_of("fem-size");
    options.domain = Domain::kBox;  // circumcenters beside the wedge yield to its sides
    const double h = 0.05 + 0.1 * random.unit();
    options.size = std::to_string(h);
    const auto run = finish(wedge, options);
    const Mesh mesh = run->mesh();
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
      const std::uint32_t* t = mesh.cell(i);
      if (t[0] != 0 && t[1] != 0 && t[2] != 0) continue;  // the tip is 1 away from what is disjoint
      const Point2 a = xy(mesh.vertices[t[0]]), b = xy(mesh.vertices[t[1]]),
                   c = xy(mesh.vertices[t[2]]);
      const double area2 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      const double radius =
          length_between(a, b) * length_between(b, c) * length_between(c, a) / (2 * area2);
      least = std::min(least, radius / h);
    }
  }
  EXPECT_LT(least, 0.5);
  EXPECT_GT(least, 0.5 / std::sqrt(2.0));
}

/// h is small in one spot of a fan only, and large within (1 + sqrt 2) r_q of far vertices: splits
/// go from segment to segment all the same. So the ball of the theorem must reach around the fan.
TEST(Theorem7_13, SplitsGoAroundAFanFarFromWhereTheSizeIsSmall) {
  Complex fan;
  fan.vertices.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < 43; ++i) {
    fan.vertices.push_back(xyz(testing::polar(0, 0, 1, 2 * i)));
    fan.segments.push_back({0, i + 1});
  }
  Options options = options_of("fem-size");
  options.size = "max(abs(x - 0.3), abs(y)) < 0.02 ? 0.01 : 10";
  const auto run = finish(fan, options);
  const Mesh mesh = run->mesh();
  double least = 10;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* t = mesh.cell(i);
    const Point2 a = xy(mesh.vertices[t[0]]), b = xy(mesh.vertices[t[1]]),
                 c = xy(mesh.vertices[t[2]]);
    if (std::min({a.y, b.y, c.y}) < 0.2) continue;
    const double area2 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    least = std::min(
        least, length_between(a, b) * length_between(b, c) * length_between(c, a) / (2 * area2));
  }
  EXPECT_LT(least, 0.01);  // h is 10 there, and no two disjoint features are nearer than 0.2
  for (const Check& k : verify(mesh, run->complex(), promised_checks(*run))) {
    EXPECT_TRUE(k.ok) << k.name << ": " << k.detail;
  }
}

TEST(FemSize, EndsWithFewVerticesWhereAnglesAreTiny) {
  // Ruppert's disks alone would ask for about 1 / angle pieces a segment.
  const Complex fan = testing::dense_fan(1, 40, 0.01);
  const auto run = finish(fan, options_of("fem-size"));
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_LT(run->mesh().vertices.size(), 1000u);
}

TEST(FemSize, HonorsTheBoundsOfRegionsAndVerifiesWithThem) {
  Complex c = testing::unit_square();
  c.regions.push_back({{0.5, 0.5, 0}, 1, 1e-3});
  const auto run = finish(c, options_of("fem-size"));
  EXPECT_GT(run->mesh().cell_count(), 1000u);
  for (const Check& k : verify(run->mesh(), run->complex(), promised_checks(*run))) {
    EXPECT_TRUE(k.ok) << k.name << ": " << k.detail;
  }
}

TEST(FemSize, TheDefaultIsATenthOfTheDiameter) {
  const auto run = finish(testing::unit_square(), options_of("fem-size"));
  EXPECT_NEAR(std::stod(run->options().size), 0.1 * std::sqrt(2.0), 1e-15);
}

TEST(FemSize, AMeshThatIsFinerThanItsSizesIsToldOf) {
  Options options = options_of("fem-size");
  options.size = "0.02";
  const auto run = finish(testing::unit_square(), options);
  VerifyOptions given = promised_checks(*run);
  given.size.reset();
  given.checks = {"sizing", "sizing-lower"};
  for (const char* size : {"0.02", "0.01", "0.1"}) {
    given.sizing = size;
    const std::vector<Check> checks = verify(run->mesh(), run->complex(), given);
    ASSERT_EQ(checks.size(), 2u);
    EXPECT_EQ(checks[0].ok, std::string(size) != "0.01") << checks[0].detail;
    EXPECT_EQ(checks[1].ok, std::string(size) != "0.1") << checks[1].detail;
  }
}

// Step 1.

TEST(EqualLengths, PiecesAtAcuteVerticesAreEqualModuloPowersOfTwo) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Complex c = testing::acute_complex(seed);
    const auto divisions = equal_division(c);
    struct Piece {
      Point2 tip;
      double length;
    };
    std::vector<std::vector<Piece>> at(c.vertices.size());
    for (std::size_t s = 0; s < c.segments.size(); ++s) {
      const Point2 ends[2] = {xy(c.vertices[c.segments[s][0]]), xy(c.vertices[c.segments[s][1]])};
      const double length = length_between(ends[0], ends[1]);
      double last = 0;
      for (const Division& d : divisions[s]) {  // in order, inside, no crumbs
        const double from_first = d.end == 0 ? d.distance : length - d.distance;
        EXPECT_GT(from_first, last) << "seed " << seed;
        EXPECT_LT(from_first, length) << "seed " << seed;
        last = from_first;
      }
      for (int end = 0; end < 2; ++end) {
        double piece = length;
        for (const Division& d : divisions[s]) {
          piece = std::min(piece, d.end == end ? d.distance : length - d.distance);
        }
        at[c.segments[s][static_cast<std::size_t>(end)]].push_back({ends[1 - end], piece});
      }
    }
    for (std::size_t v = 0; v < at.size(); ++v) {
      for (const Piece& p : at[v]) {
        for (const Piece& q : at[v]) {
          if (in_diametral_ball(p.tip, q.tip, xy(c.vertices[v])) != Sign::kNegative) continue;
          EXPECT_TRUE(equal_modulo_powers_of_two(p.length, q.length))
              << "seed " << seed << ", vertex " << v << ": " << p.length << " and " << q.length;
        }
      }
    }
  }
}

TEST(EqualLengths, WhatIsEqualAlreadyIsLeftAlone) {
  // An equilateral triangle but for rounding, and 1, 2 and 4 at one vertex.
  const Complex triangle = testing::polygon({{0, 0}, {1, 0}, testing::polar(0, 0, 1, 60)});
  for (const auto& d : equal_division(triangle)) EXPECT_TRUE(d.empty());
  Complex fan;
  fan.vertices = {
      {0, 0, 0}, {1, 0, 0}, xyz(testing::polar(0, 0, 2, 20)), xyz(testing::polar(0, 0, 4, 70))};
  fan.segments = {{0, 1}, {0, 2}, {0, 3}};
  for (const auto& d : equal_division(fan)) EXPECT_TRUE(d.empty());
  // Right angles are not acute.
  for (const auto& d : equal_division(testing::polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}}))) {
    EXPECT_TRUE(d.empty());
  }
}

TEST(EqualLengths, TheLongerOfTwoIsSplitAtTheLengthOfTheShorter) {
  Complex wedge;
  wedge.vertices = {{0, 0, 0}, {3, 0, 0}, xyz(testing::polar(0, 0, 2, 30))};
  wedge.segments = {{0, 1}, {0, 2}};
  const auto divisions = equal_division(wedge);
  ASSERT_EQ(divisions[0].size(), 1u);
  EXPECT_EQ(divisions[0][0].end, 0);
  EXPECT_NEAR(divisions[0][0].distance, 2, 1e-15);
  EXPECT_TRUE(divisions[1].empty());
}

TEST(EqualLengths, PowersOfTwoAreTold) {
  EXPECT_TRUE(equal_modulo_powers_of_two(3, 3));
  EXPECT_TRUE(equal_modulo_powers_of_two(3, 96));
  EXPECT_TRUE(equal_modulo_powers_of_two(96 * (1 - 1e-11), 3));
  EXPECT_FALSE(equal_modulo_powers_of_two(3, 96.001));
  EXPECT_FALSE(equal_modulo_powers_of_two(1, 3));
  EXPECT_TRUE(equal_modulo_powers_of_two(1e-45, 1e-45 * 0x1p300));
}

}  // namespace
}  // namespace circumball
