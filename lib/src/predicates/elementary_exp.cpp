// exp, log and pow. Results are computed as a sum of two doubles and rounded at the end.

#include <cmath>

#include "predicates/double_bits.h"
#include "predicates/elementary.h"
#include "predicates/expansion.h"

namespace circumball::elementary {
namespace {

using internal::fast_two_sum;
using internal::kInfinity;
using internal::kNaN;
using internal::two_product;
using internal::two_sum;
using internal::TwoDoubles;

// ln 2 to 107 bits; and as a part of 32 bits, whose product with an exponent is exact, and the
// rest.
constexpr double kLn2High = 0x1.62e42fefa39efp-1, kLn2Low = 0x1.abc9e3b39803fp-56;
constexpr double kLn2Short = 0x1.62e42ffp-1;
constexpr double kLn2RestHigh = -0x1.718432a1b0e26p-35, kLn2RestLow = -0x1.9ff0342542fc3p-90;
constexpr double kLog2E = 0x1.71547652b82fep+0;

/// (a.high + a.low) (b.high + b.low), with a relative error of about 2^-104 (Dekker 1971, mul2).
TwoDoubles multiply(TwoDoubles a, TwoDoubles b) {
  const TwoDoubles p = two_product(a.high, b.high);
  return fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// a + b for |a| > |b|, with a relative error of about 2^-104 where nothing cancels (Dekker 1971,
/// add2).
TwoDoubles add(TwoDoubles a, TwoDoubles b) {
  const TwoDoubles s = two_sum(a.high, b.high);
  return fast_two_sum(s.high, s.low + (a.low + b.low));
}

/// e^(x.high + x.low), rounded once at the end: within 1/2 ulp and 2^-2 more.
/// x = n ln 2 + r with |r| <= 0.35, and e^r = 1 + r + r^2 (1/2 + r (1/6 + ...)) with Taylor's terms
/// to r^13, the next of which is below 5e-18 = 2^-57.
double exp_of_sum(TwoDoubles x) {
  if (x.high > 710) return kInfinity;
  if (x.high < -746) return 0;
  const double scaled = x.high * kLog2E;
  const int n = static_cast<int>(scaled + (scaled < 0 ? -0.5 : 0.5));
  // n * kLn2Short is exact (11 + 32 bits), and so is the rest's difference but for 2^-100.
  const TwoDoubles a = two_sum(x.high, -n * kLn2Short);
  const TwoDoubles b = two_product(-n, kLn2RestHigh);
  const TwoDoubles s = two_sum(a.high, b.high);
  const double tail = s.low + (a.low + (b.low + (x.low - n * kLn2RestLow)));
  const TwoDoubles r = fast_two_sum(s.high, tail);

  constexpr double kInverseFactorials[] = {
      // 1/13! down to 1/2!
      1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0, 1 / 40320.0,
      1 / 5040.0,       1 / 720.0,       1 / 120.0,      1 / 24.0,      1 / 6.0,      1 / 2.0};
  double p = 0;
  for (const double c : kInverseFactorials) p = p * r.high + c;
  const TwoDoubles t = fast_two_sum(1.0, r.high);
  const double result = t.high + (t.low + (r.high * r.high * p + (r.low + r.low * r.high)));
  return internal::scale(result, n);
}

/// log(x) for positive finite x, as a sum: with a relative error below 2^-66.
/// x = 2^k m with m in [sqrt(1/2), sqrt(2)]; with s = (m - 1) / (m + 1), z = s^2 <= 0.0295,
/// log m = 2 atanh s = 2 s (1 + z/3 + z^2/5 + ...) to z^13. The first two coefficients have two
/// parts.
TwoDoubles log_as_sum(double x) {
  internal::Decoded d(x);
  int k = d.exponent + 52;
  while (d.mantissa < std::uint64_t{1} << 52) {  // subnormal
    d.mantissa <<= 1;
    --k;
  }
  double m = static_cast<double>(d.mantissa) * 0x1p-52;
  if (m > 0x1.6a09e667f3bcdp+0) {  // sqrt(2)
    m *= 0.5;
    ++k;
  }
  const double f = m - 1;  // exact
  const TwoDoubles g = two_sum(m, 1);
  const double s_high = f / g.high;
  const TwoDoubles back = two_product(s_high, g.high);
  const TwoDoubles s = {s_high, (((f - back.high) - back.low) - s_high * g.low) / g.high};

  const TwoDoubles z = multiply(s, s);
  double p = 0;
  for (int i = 27; i >= 7; i -= 2) p = p * z.high + 1.0 / i;
  constexpr TwoDoubles kThird = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
  constexpr TwoDoubles kFifth = {0x1.999999999999ap-3, -0x1.999999999999ap-57};
  const TwoDoubles t = multiply(z, add(kThird, multiply(z, add(kFifth, two_product(z.high, p)))));
  const TwoDoubles twice_s = {2 * s.high, 2 * s.low};
  const TwoDoubles log_m = add(twice_s, multiply(twice_s, t));
  if (k == 0) return log_m;
  return add(multiply({kLn2High, kLn2Low}, {static_cast<double>(k), 0}), log_m);
}

bool is_integer(double y) {
  const internal::Decoded d(y);
  return d.mantissa == 0 || d.exponent >= 0 ||
         (d.exponent > -53 && (d.mantissa & ((std::uint64_t{1} << -d.exponent) - 1)) == 0);
}

/// For an integer y.
bool is_odd(double y) {
  const internal::Decoded d(y);
  return d.exponent <= 0 && d.exponent > -53 && ((d.mantissa >> -d.exponent) & 1) != 0;
}

}  // namespace

double exp(double x) {
  if (x != x) return kNaN;
  return exp_of_sum({x, 0});
}

double log(double x) {
  if (x == 0) return -kInfinity;
  if (!(x > 0)) return kNaN;
  if (x == kInfinity) return x;
  return log_as_sum(x).high;
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y) return kNaN;
  const bool y_infinite = std::fabs(y) == kInfinity;
  const bool odd = !y_infinite && is_integer(y) && is_odd(y);
  const bool negate = (internal::to_bits(x) >> 63) != 0 && odd;
  const double size = std::fabs(x);
  if (size == 0 || size == kInfinity) {
    const double result = (size == 0) == (y < 0) ? kInfinity : 0;
    return negate ? -result : result;
  }
  if (size == 1 && y_infinite) return 1;
  if (x < 0 && !y_infinite && !is_integer(y)) return kNaN;
  const TwoDoubles l = log_as_sum(size);
  double result;
  if (std::fabs(y) > 0x1p70) {
    // |log| is at least 2^-53 or zero: the result is out of range, or one.
    result = l.high == 0 ? 1 : (l.high > 0) == (y > 0) ? kInfinity : 0;
  } else {
    result = exp_of_sum(multiply(l, {y, 0}));
  }
  return negate ? -result : result;
}

}  // namespace circumball::elementary
