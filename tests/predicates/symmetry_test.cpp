// Laws that exact predicates obey on every input, however degenerate.

#include <gtest/gtest.h>

#include <algorithm>

#include "circumball/predicates.h"
#include "predicates/support.h"

namespace circumball::testing {
namespace {

constexpr int kInputs = 4000;

Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

/// Degenerate and nearly degenerate input of all kinds.
Points points_of_any_kind(Random& random) {
  Points points;
  const int kind = random.below(4);
  if (kind == 0) return mixed_points(random);
  for (Point3& p : points) {
    p = kind == 1   ? lattice_point(random)
        : kind == 2 ? integer_sphere_point(random)
                    : sphere_point({1, 2, 3}, 1, random);
  }
  perturb(points, random);
  return points;
}

/// Calls f(permuted points, whether the permutation is odd) for every permutation of the first n
/// points.
template <class F>
void for_each_permutation(const Points& points, int n, F f) {
  int order[] = {0, 1, 2, 3, 4};
  do {
    bool odd = false;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) odd ^= order[j] > order[i];
    }
    Points permuted = points;
    for (int i = 0; i < n; ++i) permuted[i] = points[order[i]];
    f(permuted, odd);
  } while (std::next_permutation(order, order + n));
}

Sign orient2d(const Points& p) { return circumball::orient2d(xy(p[0]), xy(p[1]), xy(p[2])); }
Sign orient3d(const Points& p) { return circumball::orient3d(p[0], p[1], p[2], p[3]); }
Sign incircle(const Points& p) {
  return circumball::incircle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]));
}
Sign insphere(const Points& p) { return circumball::insphere(p[0], p[1], p[2], p[3], p[4]); }
Sign segment_ball2(const Points& p) { return in_diametral_ball(xy(p[0]), xy(p[1]), xy(p[2])); }
Sign segment_ball3(const Points& p) { return in_diametral_ball(p[0], p[1], p[2]); }
Sign triangle_ball(const Points& p) { return in_diametral_ball(p[0], p[1], p[2], p[3]); }
Sign compare_distance(const Points& p) {
  return circumball::compare_distance(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]));
}

using Predicate = Sign (*)(const Points&);

struct Permuted {
  Predicate predicate;
  int points;       ///< the first ones may change places
  bool alternates;  ///< odd permutations flip the sign
};

TEST(Symmetry, PermutationsFlipOrKeepTheSign) {
  // In-ball predicates keep their sign, because the ball does not depend on the order of the points
  // that span it.
  const Permuted all[] = {{orient2d, 3, true},       {orient3d, 4, true},
                          {incircle, 4, true},       {insphere, 5, true},
                          {segment_ball2, 2, false}, {segment_ball3, 2, false},
                          {triangle_ball, 3, false}};
  Random random(11);
  for (int i = 0; i < kInputs; ++i) {
    const Points points = points_of_any_kind(random);
    for (const Permuted& q : all) {
      const Sign s = q.predicate(points);
      for_each_permutation(points, q.points, [&](const Points& permuted, bool odd) {
        ASSERT_EQ(q.predicate(permuted), odd && q.alternates ? -s : s);
      });
    }
  }
}

TEST(Symmetry, DistancesExchanged) {
  Random random(12);
  for (int i = 0; i < kInputs; ++i) {
    const Points p = points_of_any_kind(random);
    const Sign s = compare_distance(p);
    EXPECT_EQ(compare_distance({p[2], p[3], p[0], p[1]}), -s);
    EXPECT_EQ(compare_distance({p[1], p[0], p[2], p[3]}), s);
  }
}

constexpr Predicate kAll[] = {orient2d,      orient3d,      incircle,      insphere,
                              segment_ball2, segment_ball3, triangle_ball, compare_distance};

TEST(Symmetry, PowersOfTwoLeaveTheSign) {
  Random random(13);
  for (int i = 0; i < kInputs; ++i) {
    const Points points = points_of_any_kind(random);
    Points scaled = points;
    rescale(scaled, random);
    for (const Predicate f : kAll) ASSERT_EQ(f(scaled), f(points));
  }
}

TEST(Symmetry, ExactTranslationsLeaveTheSign) {
  // Multiples of 2^-30 below 2^10, moved by multiples of 2^-30 below 2^20: every sum is a double.
  Random random(14);
  const auto dyadic = [&](int bits) { return random.between(-(1 << bits), 1 << bits) * 0x1p-30; };
  for (int i = 0; i < kInputs; ++i) {
    Points points;
    for (Point3& p : points) {
      p = random.below(2) == 0 ? lattice_point(random) : integer_sphere_point(random);
    }
    coordinate(points[random.below(5)], random.below(3)) += dyadic(2);
    const double x = dyadic(30) * 1024, y = dyadic(30) * 1024, z = dyadic(30) * 1024;
    Points moved = points;
    for (Point3& p : moved) p = p + Point3{x, y, z};
    for (const Predicate f : kAll) ASSERT_EQ(f(moved), f(points));
  }
}

TEST(Symmetry, ReflectionsFlipOrientation) {
  Random random(15);
  for (int i = 0; i < kInputs; ++i) {
    const Points points = points_of_any_kind(random);
    Points mirrored = points;
    for (Point3& p : mirrored) p.x = -p.x;
    for (const Predicate f : {orient2d, orient3d, incircle, insphere}) {
      ASSERT_EQ(f(mirrored), -f(points));
    }
    for (const Predicate f : {segment_ball2, segment_ball3, triangle_ball, compare_distance}) {
      ASSERT_EQ(f(mirrored), f(points));
    }
  }
}

TEST(Orientation, IsAsTheHeaderSays) {
  EXPECT_EQ(circumball::orient2d({0, 0}, {1, 0}, {0, 1}), Sign::kPositive);
  // Counter-clockwise seen from above, and d below.
  EXPECT_EQ(circumball::orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Sign::kPositive);
  EXPECT_EQ(circumball::incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), Sign::kPositive);
  EXPECT_EQ(circumball::incircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), Sign::kZero);
  EXPECT_EQ(circumball::incircle({0, 0}, {1, 0}, {0, 1}, {2, 1}), Sign::kNegative);
  EXPECT_EQ(circumball::insphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0.1, 0.1, -0.1}),
            Sign::kPositive);
  EXPECT_EQ(in_diametral_ball(Point2{0, 0}, Point2{2, 0}, Point2{1, 0.5}), Sign::kPositive);
  EXPECT_EQ(in_diametral_ball(Point2{0, 0}, Point2{2, 0}, Point2{1, 1}), Sign::kZero);
  EXPECT_EQ(in_diametral_ball(Point2{0, 0}, Point2{2, 0}, Point2{3, 0}), Sign::kNegative);
  EXPECT_EQ(circumball::compare_distance({0, 0}, {2, 0}, {5, 5}, {5, 6}), Sign::kPositive);
}

TEST(TriangleBall, OfCollinearPointsIsZeroEverywhere) {
  Random random(16);
  for (int i = 0; i < 1000; ++i) {
    const Point3 a = lattice_point(random), d = lattice_point(random);
    const Point3 b = a + random.between(-3, 3) * d, c = a + random.between(-3, 3) * d;
    EXPECT_EQ(in_diametral_ball(a, b, c, random_point(random)), Sign::kZero);
  }
}

}  // namespace
}  // namespace circumball::testing
