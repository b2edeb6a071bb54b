#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/predicates.h"

namespace circumball {
namespace {

struct Random {  // splitmix64
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

Complex make(const std::vector<Point2>& points,
             const std::vector<std::array<std::uint32_t, 2>>& segments) {
  Complex c;
  for (const Point2& p : points) c.vertices.push_back(xyz(p));
  c.segments = segments;
  return c;
}
Complex square() {
  return make({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

std::vector<Defect> named(const std::vector<Defect>& all, const std::string& name) {
  std::vector<Defect> some;
  for (const Defect& d : all)
    if (d.name == name) some.push_back(d);
  return some;
}
bool valid(const std::vector<Defect>& all) {
  return std::all_of(all.begin(), all.end(), [](const Defect& d) { return d.warning; });
}
std::string list(const std::vector<Defect>& all) {
  std::string text;
  for (const Defect& d : all) text += d.name + ": " + d.message + "\n";
  return text;
}
using Pair = std::array<std::uint32_t, 2>;
/// (name, features) of every defect of crossing, touching, overlap.
std::set<std::pair<std::string, Pair>> meetings(const std::vector<Defect>& all) {
  std::set<std::pair<std::string, Pair>> set;
  for (const Defect& d : all) {
    if (d.name != "segments-cross" && d.name != "segments-overlap" && d.name != "vertex-on-segment")
      continue;
    EXPECT_EQ(d.features.size(), 2u) << d.message;
    if (d.features.size() == 2) {
      EXPECT_TRUE(set.insert({d.name, {d.features[0].index, d.features[1].index}}).second)
          << d.message;
    }
  }
  return set;
}

/// The same by looking at all pairs. Vertices must be distinct points, segments distinct pairs.
std::set<std::pair<std::string, Pair>> meetings_by_brute_force(const Complex& c) {
  std::set<std::pair<std::string, Pair>> set;
  const auto at = [&](std::uint32_t v) { return xy(c.vertices[v]); };
  const auto between = [&](const Point2& a, const Point2& b, const Point2& p) {
    return orient2d(a, b, p) == Sign::kZero && p != a && p != b && std::min(a.x, b.x) <= p.x &&
           p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  };
  for (std::uint32_t i = 0; i < c.segments.size(); ++i) {
    const Point2 a = at(c.segments[i][0]), b = at(c.segments[i][1]);
    for (std::uint32_t v = 0; v < c.vertices.size(); ++v)
      if (between(a, b, at(v))) set.insert({"vertex-on-segment", {v, i}});
    for (std::uint32_t j = i + 1; j < c.segments.size(); ++j) {
      const Point2 p = at(c.segments[j][0]), q = at(c.segments[j][1]);
      const int op = static_cast<int>(orient2d(a, b, p)), oq = static_cast<int>(orient2d(a, b, q));
      const int oa = static_cast<int>(orient2d(p, q, a)), ob = static_cast<int>(orient2d(p, q, b));
      if (op * oq < 0 && oa * ob < 0) set.insert({"segments-cross", {i, j}});
      if (op == 0 && oq == 0) {
        const bool share =
            between(a, b, p) || between(a, b, q) || between(p, q, a) || between(p, q, b);
        if (share) set.insert({"segments-overlap", {i, j}});
      }
    }
  }
  return set;
}

TEST(Check, FindsNothingInASquare) { EXPECT_TRUE(check(square()).empty()); }

TEST(Check, AcceptsWhateverIsALegalComplex) {
  EXPECT_TRUE(check(make({{3, 4}}, {})).empty());
  EXPECT_TRUE(check(make({{0, 0}, {1, 1}, {2, 2}, {7, 7}}, {{0, 1}, {1, 2}})).empty());
  EXPECT_TRUE(check(make({{0, 0}, {0, 1}, {0, 2}, {0, -1}}, {{0, 1}, {3, 0}})).empty())
      << "vertical";
  // adjacent squares, a dangling segment inside, an isolated vertex, an island
  Complex c = make(
      {{0, 0},
       {1, 0},
       {2, 0},
       {2, 1},
       {1, 1},
       {0, 1},
       {.5, .5},
       {1.5, .2},
       {1.2, .4},
       {1.8, .4},
       {1.5, .8}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}, {0, 6}, {8, 9}, {9, 10}, {10, 8}});
  EXPECT_TRUE(check(c).empty()) << list(check(c));
}

TEST(Check, ACrossingIsNamedWithItsPlace) {
  const auto d = check(make({{0, 0}, {4, 2}, {0, 2}, {4, 0}}, {{0, 1}, {2, 3}}));
  ASSERT_EQ(d.size(), 1u) << list(d);
  EXPECT_EQ(d[0].name, "segments-cross");
  EXPECT_FALSE(d[0].warning);
  ASSERT_EQ(d[0].features.size(), 2u);
  EXPECT_EQ(d[0].features[0], (Feature{FeatureKind::kSegment, 0}));
  EXPECT_EQ(d[0].features[1], (Feature{FeatureKind::kSegment, 1}));
  ASSERT_EQ(d[0].at.size(), 1u);
  EXPECT_EQ(d[0].at[0], (Point3{2, 1, 0}));
  EXPECT_NE(d[0].message.find("(2, 1)"), std::string::npos) << d[0].message;
}

TEST(Check, AVertexOnASegmentIsExact) {
  const double y = 0.1 + 0.2;  // the neighbours of a point on the line are not on it
  EXPECT_EQ(named(check(make({{0, 0}, {2, 2}, {y, y}}, {{0, 1}})), "vertex-on-segment").size(), 1u);
  EXPECT_TRUE(valid(check(make({{0, 0}, {2, 2}, {y, std::nextafter(y, 1.0)}}, {{0, 1}}))));
  EXPECT_TRUE(valid(check(make({{0, 0}, {2, 2}, {y, std::nextafter(y, 0.0)}}, {{0, 1}}))));
}

TEST(Check, TellsAllDefectsAtOnce) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  Complex c = make({{0, 0},
                    {4, 2},
                    {0, 2},
                    {4, 0},
                    {nan, 1},
                    {inf, 0},
                    {1e60, 0},
                    {1e-50, 0},
                    {4, 2},
                    {2, 0},
                    {1, 0},
                    {3, 0}},
                   {{0, 1}, {2, 3}, {0, 99}, {4, 1}, {3, 3}, {1, 8}, {1, 0}, {0, 3}, {10, 11}});
  const auto d = check(c);
  EXPECT_EQ(named(d, "not-finite").size(), 2u);
  EXPECT_EQ(named(d, "magnitude").size(), 2u);
  EXPECT_EQ(named(d, "index-out-of-range").size(), 1u);
  EXPECT_EQ(named(d, "zero-length-segment").size(), 2u);
  EXPECT_EQ(named(d, "duplicate-vertices").size(), 1u);
  EXPECT_EQ(named(d, "duplicate-segments").size(), 1u);
  EXPECT_TRUE(named(d, "duplicate-segments")[0].warning);
  EXPECT_EQ(named(d, "segments-cross").size(), 1u);
  EXPECT_EQ(named(d, "segments-overlap").size(), 1u);
  EXPECT_EQ(named(d, "vertex-on-segment").size(), 4u)
      << list(d);  // 9, 10, 11 on segment 7; 9 on segment 8
}

TEST(Check, NegativeZeroIsZero) {
  const auto d = check(make({{0.0, 1}, {-0.0, 1}, {2, -0.0}, {2, 0.0}}, {}));
  EXPECT_EQ(named(d, "duplicate-vertices").size(), 2u) << list(d);
}

TEST(Check, CountsWhatItDoesNotList) {
  Complex c;
  for (int i = 0; i < 50; ++i) c.vertices.push_back({1, 2, 0});
  const auto d = named(check(c, 10), "duplicate-vertices");
  ASSERT_EQ(d.size(), 11u);
  EXPECT_NE(d.back().message.find("39 more"), std::string::npos) << d.back().message;
  EXPECT_FALSE(d.back().warning);
}

TEST(Check, AnEmptyComplexHasTooFewVertices) {
  const auto d = check(Complex{});
  ASSERT_EQ(d.size(), 1u);
  EXPECT_EQ(d[0].name, "too-few-vertices");
}

TEST(Check, WarnsOfNearDuplicatesOnly) {
  const auto d = check(make({{0, 0}, {1, 0}, {1 + 1e-10, 0}, {0, 1}}, {}));
  ASSERT_EQ(d.size(), 1u) << list(d);
  EXPECT_EQ(d[0].name, "near-duplicate-vertices");
  EXPECT_TRUE(d[0].warning);
  EXPECT_TRUE(check(make({{0, 0}, {1, 0}, {1 + 1e-8, 0}, {0, 1}}, {})).empty());
}

TEST(Check, SeedsOutsideDrawWarnings) {
  Complex c = square();
  c.holes = {{0.5, 0.5, 0}, {2, 0.5, 0}, {0.5, 1, 0}, {1, 1, 0}};
  c.regions.push_back({{-1, 0.5, 0}, 1, 0});
  c.regions.push_back({{0.5, 0.25, 0}, 1, 0});
  const auto d = check(c);
  EXPECT_TRUE(valid(d));
  EXPECT_EQ(named(d, "hole-outside").size(), 3u) << list(d);  // outside, on a segment, on a vertex
  EXPECT_EQ(named(d, "region-outside").size(), 1u);
}

TEST(Check, ASeedInANotchIsOutside) {
  // a U; the seed lies in its convex hull, not in it
  Complex c = make({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
                   {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 0}});
  c.holes = {{1.5, 2, 0}};
  EXPECT_EQ(named(check(c), "hole-outside").size(), 1u);
  c.holes = {{1.5, 0.5, 0}};
  EXPECT_TRUE(check(c).empty());
}

// The sweep against all pairs, where points, collinear runs and several crossings at one place
// abound.
TEST(Check, AgreesWithBruteForceOnSmallLattices) {
  Random random{7};
  for (int round = 0; round < 4000; ++round) {
    const std::uint32_t side = 2 + random.below(6);
    std::vector<Point2> points;
    std::set<std::pair<double, double>> used;
    const std::uint32_t n = 2 + random.below(12);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = random.below(side), y = random.below(side);
      if (used.insert({x, y}).second) points.push_back({x, y});
    }
    std::vector<std::array<std::uint32_t, 2>> segments;
    std::set<Pair> seen;
    const std::uint32_t m = random.below(12), k = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < m && k > 1; ++i) {
      const std::uint32_t a = random.below(k), b = random.below(k);
      if (a != b && seen.insert({std::min(a, b), std::max(a, b)}).second)
        segments.push_back({a, b});
    }
    const Complex c = make(points, segments);
    ASSERT_EQ(meetings(check(c)), meetings_by_brute_force(c)) << "round " << round;
  }
}

TEST(Check, AgreesWithBruteForceOnRandomSegments) {
  Random random{11};
  for (int round = 0; round < 300; ++round) {
    std::vector<Point2> points;
    std::vector<std::array<std::uint32_t, 2>> segments;
    const double reach = round % 3 == 0 ? 0.05 : round % 3 == 1 ? 0.3 : 2;
    const double offset = round % 2 ? 1e6 : 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const Point2 p{offset + random.unit(), offset + random.unit()};
      const double dx = random.unit() - 0.5;
      const double dy = random.unit() - 0.5;
      points.push_back(p);
      points.push_back({p.x + reach * dx, p.y + reach * dy});
      segments.push_back({2 * i, 2 * i + 1});
    }
    const Complex c = make(points, segments);
    ASSERT_EQ(meetings(check(c)), meetings_by_brute_force(c)) << "round " << round;
  }
}

TEST(Check, FindsTheSameAtTheEndsOfTheMagnitudesAllowed) {
  Random random{13};
  for (int round = 0; round < 300; ++round) {
    Complex c;
    for (std::uint32_t i = 0; i < 12; ++i) {
      for (int end = 0; end < 2; ++end) {
        const double x = 1 + random.below(5);
        const double y = 1 + random.below(5);
        c.vertices.push_back({x, y, 0});
      }
      c.segments.push_back({2 * i, 2 * i + 1});
    }
    const auto names = [&](double scale) {
      Complex scaled = c;
      for (Point3& p : scaled.vertices) p = {scale * p.x, -scale * p.y, 0};
      std::vector<std::pair<std::string, std::vector<std::uint32_t>>> all;
      for (const Defect& d : check(scaled)) {
        all.push_back({d.name, {}});
        for (const Feature& f : d.features) all.back().second.push_back(f.index);
      }
      return all;
    };
    const auto expected = names(1);
    ASSERT_EQ(names(0x1p-149), expected) << "round " << round;  // 1.4e-45
    ASSERT_EQ(names(0x1p180), expected) << "round " << round;   // up to 8e54
  }
}

TEST(Check, ManyLongSegmentsAreNoTrouble) {
  Complex c;  // 50,000 long parallel diagonals, whose boxes all overlap, and one short segment
              // across two of them
  const std::uint32_t n = 50000;
  for (std::uint32_t i = 0; i < n; ++i) {
    c.vertices.push_back({i * 1e-5, 0, 0});
    c.vertices.push_back({1 + i * 1e-5, 1, 0});
    c.segments.push_back({2 * i, 2 * i + 1});
  }
  EXPECT_TRUE(check(c).empty());
  c.vertices.push_back({0.5 + 0.5e-5, 0.5, 0});
  c.vertices.push_back({0.5 + 2.5e-5, 0.5, 0});
  c.segments.push_back({2 * n, 2 * n + 1});
  EXPECT_EQ(named(check(c), "segments-cross").size(), 2u);
}

TEST(Check, ClustersAreNoTrouble) {
  Random random{3};
  Complex c;  // 100,000 short segments within 1e-9, and two far vertices
  const std::uint32_t rows = 316;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      const std::uint32_t v = static_cast<std::uint32_t>(c.vertices.size());
      c.vertices.push_back({1 + i * 3e-12, 1 + j * 3e-12, 0});
      c.vertices.push_back({1 + i * 3e-12 + 1e-12, 1 + j * 3e-12 + 1e-12 * random.unit(), 0});
      c.segments.push_back({v, v + 1});
    }
  }
  c.vertices.push_back({0, 0, 0});
  c.vertices.push_back({2, 2, 0});
  const auto d = check(c, 10);
  EXPECT_TRUE(valid(d)) << list(d);
  EXPECT_EQ(named(d, "near-duplicate-vertices").size(), 11u);
}

TEST(Check, EveryLineCrossingEveryOtherIsCounted) {
  Complex c;
  const std::uint32_t n = 400;
  for (std::uint32_t i = 0; i < n; ++i) {
    c.vertices.push_back({i + 0.5, -1, 0});
    c.vertices.push_back({i + 0.5, n + 1.0, 0});
    c.segments.push_back({4 * i, 4 * i + 1});
    c.vertices.push_back({-1, i + 0.25, 0});
    c.vertices.push_back({n + 1.0, i + 0.25, 0});
    c.segments.push_back({4 * i + 2, 4 * i + 3});
  }
  const auto d = named(check(c, 100), "segments-cross");
  ASSERT_EQ(d.size(), 101u);
  EXPECT_NE(d.back().message.find(std::to_string(n * n - 100) + " more"), std::string::npos)
      << d.back().message;
}

TEST(SmallestAngle, IsThatBetweenNeighboringSegments) {
  EXPECT_EQ(smallest_angle_degrees(square()), 90);
  EXPECT_EQ(smallest_angle_degrees(make({{0, 0}, {1, 0}}, {{0, 1}})), 180);
  EXPECT_EQ(smallest_angle_degrees(make({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}})), 180);
  EXPECT_DOUBLE_EQ(smallest_angle_degrees(make({{0, 0}, {1, 0}, {1, 1}}, {{0, 1}, {0, 2}})), 45);
  EXPECT_DOUBLE_EQ(
      smallest_angle_degrees(make({{0, 0}, {1, 0}, {-1, -1}, {-1, 1}}, {{0, 1}, {0, 2}, {0, 3}})),
      90);
  EXPECT_NEAR(
      smallest_angle_degrees(make({{0, 0}, {2, 0}, {1, std::sqrt(3.0)}}, {{0, 1}, {1, 2}, {2, 0}})),
      60, 1e-12);
  EXPECT_DOUBLE_EQ(smallest_angle_degrees(make({{0, 0}, {1, 0}, {1, 1e-9}}, {{0, 1}, {0, 2}})),
                   std::atan(1e-9) * 180 / 3.14159265358979323846);
}

TEST(SmallestAngle, AgreesWithTheArcTangentOfTheLibrary) {
  Random random{5};
  for (int i = 0; i < 20000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(100)) - 50);
    const Point2 u{random.unit() - 0.5, random.unit() - 0.5},
        v{random.unit() - 0.5, random.unit() - 0.5};
    const double expected =
        std::fabs(std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y)) * 57.295779513082321;
    const Complex c = make({{0, 0}, {scale * u.x, scale * u.y}, {v.x, v.y}}, {{0, 1}, {0, 2}});
    ASSERT_NEAR(smallest_angle_degrees(c), expected, 1e-12 * (1 + expected)) << i;
  }
}

}  // namespace
}  // namespace circumball
