// Elementary functions against 50 decimal digits: errors in units in the last place, and special
// values.

#include "predicates/elementary.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "predicates/double_bits.h"
#include "predicates/support.h"

namespace circumball::testing {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using internal::kInfinity;
using internal::kNaN;

constexpr int kSamples = 4000;  // for each function and range

/// |result - exact| in units of the last place of the exact value.
double ulps(double result, const Real& exact) {
  if (exact == 0) return result == 0 ? 0 : kInfinity;
  const double nearest = std::fabs(static_cast<double>(exact));
  const double unit = internal::next_up(nearest) - nearest;
  return static_cast<double>(abs(Real(result) - exact) / unit);
}

/// The greatest error of `f` on samples of `argument`.
template <class F, class Exact, class Argument>
double worst(F f, Exact exact, Argument argument, std::uint64_t seed) {
  Random random(seed);
  double greatest = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = argument(random);
    const double error = ulps(f(x), exact(Real(x)));
    if (!(error <= greatest)) greatest = error;
  }
  return greatest;
}

template <int kScale>
double uniform(Random& random) {
  return kScale * random.uniform();
}

double tiny_or_moderate(Random& random) { return random.any_magnitude(-300, 3); }

TEST(Elementary, ExpIsWithinOneUlp) {
  const auto exact = [](const Real& x) -> Real { return exp(x); };
  EXPECT_LE(worst(elementary::exp, exact, uniform<1>, 1), 1);
  EXPECT_LE(worst(elementary::exp, exact, uniform<700>, 2), 1);
  EXPECT_LE(worst(elementary::exp, exact, tiny_or_moderate, 3), 1);
}

TEST(Elementary, LogIsWithinOneUlp) {
  const auto exact = [](const Real& x) -> Real { return log(x); };
  EXPECT_LE(worst(
                elementary::log, exact, [](Random& r) { return 1 + r.uniform() / 2; }, 4),
            1);
  EXPECT_LE(worst(
                elementary::log, exact, [](Random& r) { return 1 + 1e-6 * r.uniform(); }, 5),
            1);
  EXPECT_LE(worst(
                elementary::log, exact,
                [](Random& r) { return std::fabs(r.any_magnitude(-1022, 1023)); }, 6),
            1);
}

TEST(Elementary, SineAndCosineAreWithinOneUlpEverywhere) {
  const auto exact_sin = [](const Real& x) -> Real { return sin(x); };
  const auto exact_cos = [](const Real& x) -> Real { return cos(x); };
  EXPECT_LE(worst(elementary::sin, exact_sin, uniform<1>, 7), 1);
  EXPECT_LE(worst(elementary::sin, exact_sin, uniform<1000>, 8), 1);
  EXPECT_LE(worst(elementary::sin, exact_sin, tiny_or_moderate, 9), 1);
  EXPECT_LE(worst(elementary::cos, exact_cos, uniform<1>, 10), 1);
  EXPECT_LE(worst(elementary::cos, exact_cos, uniform<1000>, 11), 1);
  // Near multiples of pi/2, where everything cancels.
  const auto near_zeros = [](Random& r) {
    return step(r.between(-9999, 9999) * (elementary::kPi / 2), r.between(-2, 2));
  };
  EXPECT_LE(worst(elementary::sin, exact_sin, near_zeros, 12), 1);
  EXPECT_LE(worst(elementary::cos, exact_cos, near_zeros, 13), 1);
}

TEST(Elementary, ReductionIsExactForHugeArguments) {
  // More digits than any double needs: 2^1024 has 309, and 30 remain.
  using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>>;
  const Wide half_pi = boost::math::constants::half_pi<Wide>();
  Random random(14);
  for (int i = 0; i < 200; ++i) {
    const double x = random.any_magnitude(30, 1023);
    const Wide turns = Wide(x) / half_pi;
    const Wide whole = floor(turns);
    const Real r = static_cast<Real>(Wide((turns - whole) * half_pi));
    const int quadrant = static_cast<int>(static_cast<Wide>(whole - 4 * floor(whole / 4)));
    EXPECT_EQ(elementary::quarter_turn(x), quadrant);
    const Real s = sin(r), c = cos(r);
    const Real expected[] = {s, c, Real(-s), Real(-c)};
    EXPECT_LE(ulps(elementary::sin(x), expected[quadrant]), 1) << x;
    EXPECT_LE(ulps(elementary::cos(x), expected[(quadrant + 1) & 3]), 1) << x;
  }
  // The double that is closest to a multiple of pi/2 (Muller, Elementary Functions, section 11.1).
  EXPECT_NEAR(elementary::cos(0x1.6ac5b262ca1ffp+849) / -4.6871659242546277e-19, 1, 1e-15);
}

TEST(Elementary, InverseFunctionsAreWithinTheirBounds) {
  const auto exact_asin = [](const Real& x) -> Real { return asin(x); };
  const auto exact_acos = [](const Real& x) -> Real { return acos(x); };
  const auto exact_atan = [](const Real& x) -> Real { return atan(x); };
  const auto near_one = [](Random& r) { return 1 - std::fabs(r.any_magnitude(-52, -2)); };
  const auto near_minus_one = [near_one](Random& r) { return -near_one(r); };
  const auto tiny = [](Random& r) { return r.any_magnitude(-300, -1); };
  EXPECT_LE(worst(elementary::asin, exact_asin, uniform<1>, 15), 4);
  EXPECT_LE(worst(elementary::asin, exact_asin, near_one, 16), 4);
  EXPECT_LE(worst(elementary::asin, exact_asin, tiny, 17), 4);
  EXPECT_LE(worst(elementary::acos, exact_acos, uniform<1>, 18), 4);
  EXPECT_LE(worst(elementary::acos, exact_acos, near_one, 19), 4);
  EXPECT_LE(worst(elementary::acos, exact_acos, near_minus_one, 20), 4);
  EXPECT_LE(worst(elementary::atan, exact_atan, uniform<2>, 21), 2);
  EXPECT_LE(worst(elementary::atan, exact_atan, uniform<100>, 22), 2);
  EXPECT_LE(
      worst(
          elementary::atan, exact_atan, [](Random& r) { return r.any_magnitude(-300, 300); }, 23),
      2);
}

TEST(Elementary, TangentAndTheAngleOfAPointAreWithinFourUlp) {
  const auto exact_tan = [](const Real& x) -> Real { return tan(x); };
  EXPECT_LE(worst(elementary::tan, exact_tan, uniform<2>, 24), 4);
  EXPECT_LE(worst(elementary::tan, exact_tan, uniform<100>, 25), 4);
  Random random(26);
  double greatest = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double y = random.uniform(), x = random.uniform() * (i % 2 == 0 ? 1 : 1e-3);
    greatest = std::fmax(greatest, ulps(elementary::atan2(y, x), atan2(Real(y), Real(x))));
  }
  EXPECT_LE(greatest, 4);
  EXPECT_EQ(elementary::atan2(0, 0), 0);
  EXPECT_EQ(elementary::atan2(-0.0, -1), elementary::kPi);
  EXPECT_EQ(elementary::atan2(1, 0), elementary::kPi / 2);
  EXPECT_EQ(elementary::atan2(-1, 0), -elementary::kPi / 2);
  EXPECT_EQ(elementary::atan2(-kInfinity, kInfinity), -elementary::kPi / 4);
  EXPECT_TRUE(std::isnan(elementary::atan2(kNaN, 1)));
}

TEST(Elementary, PowIsWithinOneUlp) {
  Random random(24);
  for (int i = 0; i < kSamples; ++i) {
    const double x = std::fabs(random.any_magnitude(-40, 40)), y = 15 * random.uniform();
    EXPECT_LE(ulps(elementary::pow(x, y), pow(Real(x), Real(y))), 1) << x << " " << y;
    const double base = 1 + random.uniform() / 1024, exponent = 1e5 * random.uniform();
    EXPECT_LE(ulps(elementary::pow(base, exponent), pow(Real(base), Real(exponent))), 1);
  }
}

TEST(Elementary, PowIsExactWhereTheResultIsADouble) {
  for (int x = -30; x <= 30; ++x) {
    double product = 1;
    for (int n = 0; n <= 10; ++n) {
      EXPECT_EQ(elementary::pow(x, n), product) << x << "^" << n;
      product *= x;
    }
    EXPECT_EQ(elementary::pow(x * x, 0.5), std::abs(x));
  }
  for (int k = -1074; k <= 1023; ++k) {
    EXPECT_EQ(elementary::pow(2, k), internal::scale(1, k));
  }
}

/// Equal, NaN to NaN, and zeros with their signs.
void expect_same(double a, double b) {
  if (b != b) {
    EXPECT_NE(a, a);
  } else {
    EXPECT_EQ(internal::to_bits(a), internal::to_bits(b)) << a << " is not " << b;
  }
}

TEST(Elementary, SpecialValuesAreThoseOfC) {
  const double special[] = {0,   -0.0, 1,         -1,         0.5,   -0.5,   2,
                            -2,  3,    -3,        4,          1e9,   -1e9,   1e20,
                            745, -745, kInfinity, -kInfinity, 1e300, -1e300, kNaN};
  // What C prescribes exactly (annex F.10), in its own words by the library at hand.
  for (const double x : special) {
    if (x == 0 || !(std::fabs(x) < kInfinity)) {
      expect_same(elementary::exp(x), std::exp(x));
      expect_same(elementary::log(x), std::log(x));
      expect_same(elementary::sin(x), std::sin(x));
      expect_same(elementary::cos(x), std::cos(x));
      expect_same(elementary::atan(x), std::atan(x));
      expect_same(elementary::asin(x), std::asin(x));
    }
    for (const double y : special) {
      const double expected = std::pow(x, y);
      const bool special_result = expected == 0 || !(std::fabs(expected) < kInfinity);
      if (special_result || std::fabs(x) == 1 || y == 0) {
        SCOPED_TRACE(::testing::Message() << x << " ^ " << y);
        expect_same(elementary::pow(x, y), expected);
      }
    }
  }
  expect_same(elementary::log(-1), kNaN);
  expect_same(elementary::asin(1.5), kNaN);
  expect_same(elementary::acos(-1.5), kNaN);
  expect_same(elementary::acos(1), 0);
  expect_same(elementary::acos(-1), elementary::kPi);
  expect_same(elementary::asin(1), elementary::kPi / 2);
  expect_same(elementary::atan(1), elementary::kPi / 4);
  expect_same(elementary::exp(710), kInfinity);
  expect_same(elementary::exp(-746), 0);
  EXPECT_EQ(elementary::exp(-745), internal::from_bits(1));
}

}  // namespace
}  // namespace circumball::testing
