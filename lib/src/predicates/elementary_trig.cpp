// sin, cos, tan and their inverses.

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

constexpr TwoDoubles kHalfPi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// An angle as quadrant * pi/2 + r, with |r| <= pi/4.
struct Reduced {
  TwoDoubles r;
  int quadrant;  ///< modulo 4
};

/// 2/pi = sum of w[i] 2^-(32 (i + 1)), to 1,280 bits.
constexpr std::uint32_t kTwoOverPi[] = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d};

/// A natural number of 288 bits.
struct Bits {
  static constexpr int kLimbs = 9;
  std::uint32_t limb[kLimbs] = {};  // the lowest first

  int bit(int i) const { return static_cast<int>(limb[i / 32] >> (i % 32)) & 1; }
  /// Bits [top - 52, top], as a number; those below bit 0 are zero.
  double leading(int top) const {
    std::uint64_t value = 0;
    for (int i = top; i > top - 53; --i) value = 2 * value + (i >= 0 ? bit(i) : 0);
    return static_cast<double>(value);
  }
};

/// Payne and Hanek's reduction (Radian reduction for trigonometric functions, 1983): of x = m 2^e,
/// the product of m with seven words of 2/pi, from the first one that is not a multiple of 4 / m.
/// They hold 190 bits and more below the point; no double is closer to a multiple of pi/2 than
/// 2^-62 of it (Muller, Elementary Functions, table 11.1), so the fraction has at least 120 good
/// bits. x must be finite and not zero.
Reduced reduce(double x) {
  const internal::Decoded d(x);
  const int first = d.exponent < 2 ? 0 : (d.exponent - 2) / 32;
  constexpr int kWords = 7;
  // product = m * words; its point stands `point` bits from the right.
  Bits product;
  const std::uint32_t m[] = {static_cast<std::uint32_t>(d.mantissa),
                             static_cast<std::uint32_t>(d.mantissa >> 32)};
  for (int j = 0; j < 2; ++j) {
    std::uint64_t carry = 0;
    for (int i = 0; i < kWords; ++i) {
      const std::uint32_t word = kTwoOverPi[first + kWords - 1 - i];
      carry += std::uint64_t{m[j]} * word + product.limb[i + j];
      product.limb[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    product.limb[kWords + j] = static_cast<std::uint32_t>(carry);
  }
  const int point = 32 * (first + kWords) - d.exponent;

  int quadrant = product.bit(point) + 2 * product.bit(point + 1);
  bool negative =
      product.bit(point - 1) != 0;  // a fraction of 1/2 and more: from the next quadrant, backwards
  if (negative) {
    ++quadrant;
    std::uint64_t carry = 1;
    for (std::uint32_t& l : product.limb) {
      carry += static_cast<std::uint32_t>(~l);
      l = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  int top = point - 1;
  while (top > 0 && product.bit(top) == 0) --top;
  const double high = internal::scale(product.leading(top), top - 52 - point);
  const double low = internal::scale(product.leading(top - 53), top - 105 - point);
  const TwoDoubles p = two_product(high, kHalfPi.high);
  TwoDoubles r = fast_two_sum(p.high, p.low + (high * kHalfPi.low + low * kHalfPi.high));
  if (d.negative) {
    quadrant = -quadrant;
    negative = !negative;
  }
  if (negative) r = {-r.high, -r.low};
  return {r, quadrant & 3};
}

/// Sine on [-pi/4, pi/4]: r + r^3 S(r^2), by Taylor's terms to r^17 (the next is below 1e-19),
/// within 1 ulp because all but the first is below 1/10 of it.
double sin_reduced(TwoDoubles r) {
  constexpr double kCoefficients[] = {
      // 1/17! down to -1/3!, alternating
      1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
      1 / 362880.0,          -1 / 5040.0,          1 / 120.0,        -1 / 6.0};
  const double z = r.high * r.high;
  double p = 0;
  for (const double c : kCoefficients) p = p * z + c;
  return r.high + (r.low * (1 - 0.5 * z) + r.high * z * p);
}

/// Cosine on [-pi/4, pi/4]: 1 - r^2/2 in two parts, and r^4 C(r^2) by Taylor's terms to r^18 (the
/// next is below 1e-20).
double cos_reduced(TwoDoubles r) {
  constexpr double kCoefficients[] = {
      // -1/18! up to 1/4!, alternating
      -1 / 6402373705728000.0, 1 / 20922789888000.0, -1 / 87178291200.0, 1 / 479001600.0,
      -1 / 3628800.0,          1 / 40320.0,          -1 / 720.0,         1 / 24.0};
  const TwoDoubles z = two_product(r.high, r.high);
  double p = 0;
  for (const double c : kCoefficients) p = p * z.high + c;
  const TwoDoubles s = fast_two_sum(1.0, -0.5 * z.high);
  return s.high + (s.low + (z.high * z.high * p - (0.5 * z.low + r.high * r.low)));
}

double sin_in_quadrant(const Reduced& x, int quadrant) {
  switch (quadrant & 3) {
    case 0:
      return sin_reduced(x.r);
    case 1:
      return cos_reduced(x.r);
    case 2:
      return -sin_reduced(x.r);
    default:
      return -cos_reduced(x.r);
  }
}

Reduced reduce_any(double x) {
  if (std::fabs(x) <= kHalfPi.high / 2) return {{x, 0}, 0};
  return reduce(x);
}

}  // namespace

double sin(double x) {
  if (!(std::fabs(x) < kInfinity)) return kNaN;
  if (x == 0) return x;  // with its sign
  const Reduced r = reduce_any(x);
  return sin_in_quadrant(r, r.quadrant);
}

double cos(double x) {
  if (!(std::fabs(x) < kInfinity)) return kNaN;
  const Reduced r = reduce_any(x);
  return sin_in_quadrant(r, r.quadrant + 1);
}

int quarter_turn(double x) {
  const Reduced r = reduce_any(x);
  return (r.r.high < 0 ? r.quadrant + 3 : r.quadrant) & 3;
}

double atan(double x) {
  // atan(k/8), in two parts.
  constexpr TwoDoubles kAtan[] = {{0, 0},
                                  {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                  {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                  {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                  {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                  {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                  {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                  {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                  {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
  if (x != x) return kNaN;
  const double size = std::fabs(x);
  const bool inverted = size > 1;  // atan x = pi/2 - atan 1/x
  const double t = inverted ? 1 / size : size;
  // atan t = atan c + atan((t - c) / (1 + t c)), c = k/8 the nearest: the quotient is at most 1/16,
  // and the terms of its series end at u^15, below 2^-64 of it. For k > 0 the rounding of the
  // quotient is 1/2 of the result's at most.
  const int k = static_cast<int>(8 * t + 0.5);
  const double c = k * 0.125;
  const double u = (t - c) / (1 + t * c);
  const double z = u * u;
  double p = 0;
  for (int i = 15; i >= 3; i -= 2) p = 1.0 / i - p * z;
  const double correction = kAtan[k].low - u * z * p;
  double result;
  if (inverted) {
    const TwoDoubles base = two_sum(kHalfPi.high, -kAtan[k].high);
    const TwoDoubles s = two_sum(base.high, -u);
    result = s.high + (s.low + (base.low + (kHalfPi.low - correction)));
  } else {
    const TwoDoubles s = two_sum(kAtan[k].high, u);
    result = s.high + (s.low + correction);
  }
  if (x == 0) return x;  // with its sign
  return x < 0 ? -result : result;
}

// 1 ulp each of sine and cosine, and the rounding of the quotient.
double tan(double x) { return sin(x) / cos(x); }

// The rounding of the quotient is at most half an ulp of the angle, since t atan'(t) <= atan t.
double atan2(double y, double x) {
  if (x != x || y != y) return kNaN;
  const double sx = std::fabs(x), sy = std::fabs(y);
  double angle;  // of (|x|, |y|), then of (x, |y|)
  if (sy == 0) {
    angle = 0;
  } else if (sx == kInfinity && sy == kInfinity) {
    angle = kHalfPi.high / 2;
  } else {
    angle = atan(sy / sx);
  }
  if (x < 0) {
    const TwoDoubles s = two_sum(2 * kHalfPi.high, -angle);
    angle = s.high + (s.low + 2 * kHalfPi.low);
  }
  return y < 0 ? -angle : angle;
}

// (1 - x)(1 + x) loses nothing near 1, and a relative error of its argument enters atan's result at
// most once.
double asin(double x) { return std::fabs(x) <= 1 ? atan(x / std::sqrt((1 - x) * (1 + x))) : kNaN; }

double acos(double x) { return std::fabs(x) <= 1 ? 2 * atan(std::sqrt((1 - x) / (1 + x))) : kNaN; }

}  // namespace circumball::elementary
