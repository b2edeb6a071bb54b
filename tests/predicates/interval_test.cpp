// Intervals contain what they must, and not much more.

#include "predicates/interval.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "predicates/elementary.h"
#include "predicates/support.h"

namespace circumball::testing {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using internal::kInfinity;

constexpr int kSamples = 3000;

Interval random_interval(Random& random) {
  const double a = random.below(3) == 0 ? random.between(-4, 4) : random.any_magnitude(-8, 4);
  const double width = random.below(4) == 0 ? 0 : std::fabs(random.any_magnitude(-12, 3));
  return {a, a + width};
}

/// An end of the interval, or a point between.
double point_of(const Interval& a, Random& random) {
  switch (random.below(4)) {
    case 0:
      return a.lo;
    case 1:
      return a.hi;
    default: {
      const double x = a.lo + (a.hi - a.lo) * std::fabs(random.uniform());
      return x > a.hi ? a.hi : x;
    }
  }
}

void expect_inside(const Real& value, const Interval& a) {
  EXPECT_TRUE(Real(a.lo) <= value && value <= Real(a.hi))
      << value << " is not in [" << a.lo << ", " << a.hi << "]";
}

TEST(Interval, ArithmeticContainsEveryResult) {
  Random random(1);
  for (int i = 0; i < kSamples; ++i) {
    const Interval a = random_interval(random), b = random_interval(random);
    const double x = point_of(a, random), y = point_of(b, random);
    const Real rx(x), ry(y);
    expect_inside(rx + ry, a + b);
    expect_inside(rx - ry, a - b);
    expect_inside(rx * ry, a * b);
    if (y != 0) expect_inside(rx / ry, a / b);
    expect_inside(-rx, -a);
    EXPECT_TRUE(abs(a).contains(std::fabs(x)));
    EXPECT_TRUE(min(a, b).contains(x < y ? x : y));
    EXPECT_TRUE(max(a, b).contains(x < y ? y : x));
    if (x >= 0) expect_inside(sqrt(rx), sqrt(a));
    for (int n = 0; n <= 7; ++n) {
      Real power = 1;
      for (int k = 0; k < n; ++k) power *= rx;
      expect_inside(power, pow(a, n));
      if (x != 0) expect_inside(1 / power, pow(a, -n));
    }
  }
}

TEST(Interval, FunctionsContainEveryResult) {
  Random random(2);
  for (int i = 0; i < kSamples; ++i) {
    const Interval a = random_interval(random);
    const double x = point_of(a, random);
    const Real rx(x);
    expect_inside(exp(rx), exp(a));
    if (x > 0) expect_inside(log(rx), log(a));
    expect_inside(sin(rx), sin(a));
    expect_inside(cos(rx), cos(a));
  }
}

TEST(Interval, ExtremaOfSineAndCosineAreFound) {
  const double pi = elementary::kPi;
  EXPECT_EQ(sin(Interval(1, 2)).hi, 1);
  EXPECT_EQ(sin(Interval(4, 5)).lo, -1);
  EXPECT_EQ(cos(Interval(-1, 1)).hi, 1);
  EXPECT_EQ(cos(Interval(3, 4)).lo, -1);
  EXPECT_LT(sin(Interval(0, 1)).hi, 0.85);
  EXPECT_LT(sin(Interval(2, 4)).hi, 0.91);
  for (int k = -20; k <= 20; ++k) {
    // Two turns, one turn, and almost one turn from one extremum to before the next of its kind.
    EXPECT_EQ(sin(Interval(k, k + 4 * pi)).lo, -1);
    const Interval most = sin(Interval((2 * k + 0.5) * pi + 0.01, (2 * k + 2.5) * pi - 0.01));
    EXPECT_EQ(most.lo, -1);
    EXPECT_LT(most.hi, 1);
    EXPECT_GT(most.hi, 0.9999);
    const Interval all = cos(Interval(k * pi - 0.01, (k + 2) * pi + 0.01));
    EXPECT_EQ(all.lo, -1);
    EXPECT_EQ(all.hi, 1);
  }
}

TEST(Interval, PointsStayNarrow) {
  // Of a point, the bounds are a few doubles apart: at most 2 + 2 and what the rounding took.
  Random random(3);
  const auto expect_narrow = [](const Interval& a, int doubles) {
    EXPECT_LE(a.hi, step(a.lo, doubles)) << a.lo << " " << a.hi;
  };
  for (int i = 0; i < kSamples; ++i) {
    const double x = random.any_magnitude(-8, 4), y = random.any_magnitude(-8, 4);
    expect_narrow(Interval(x) + Interval(y), 2);
    expect_narrow(Interval(x) * Interval(y), 2);
    expect_narrow(Interval(x) / Interval(y), 2);
    expect_narrow(exp(Interval(x)), 4);
    expect_narrow(sin(Interval(x)), 4);
  }
}

TEST(Interval, EvenPowersDoNotForgetThatTheirFactorsAreTheSame) {
  EXPECT_GE(pow(Interval(-1, 2), 2).lo, 0);
  EXPECT_LE(pow(Interval(-1, 2), 2).hi, 4.0001);
  EXPECT_LE(pow(Interval(-1, 2), 3).lo, -1);
  EXPECT_GT(pow(Interval(-1, 2), 3).lo, -1.0001);
  EXPECT_GT(pow(Interval(-1, 2), -2).lo, 0.2499);
}

TEST(Interval, DomainsAreRespected) {
  EXPECT_TRUE(sqrt(Interval(-2, -1)).is_empty());
  EXPECT_EQ(sqrt(Interval(-2, 4)).lo, 0);
  EXPECT_TRUE(log(Interval(-2, 0)).is_empty());
  EXPECT_EQ(log(Interval(0, 1)).lo, -kInfinity);
  EXPECT_TRUE((Interval(1) / Interval(0)).is_empty());
  EXPECT_EQ((Interval(1) / Interval(-1, 1)).lo, -kInfinity);
  EXPECT_EQ((Interval(1) / Interval(0, 1)).hi, kInfinity);
  EXPECT_GT((Interval(1) / Interval(0, 1)).lo, 0.999);
  EXPECT_TRUE((Interval::empty() + Interval(1)).is_empty());
  EXPECT_TRUE(sin(Interval::empty()).is_empty());
  // Past the end of the doubles the bounds still hold.
  const Interval huge = Interval(1e308) * Interval(10);
  EXPECT_EQ(huge.hi, kInfinity);
  EXPECT_GE(huge.lo, 1e308);
  EXPECT_LT(huge.lo, kInfinity);
}

}  // namespace
}  // namespace circumball::testing
