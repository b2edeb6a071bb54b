#ifndef CIRCUMBALL_PREDICATES_INTERVAL_H_
#define CIRCUMBALL_PREDICATES_INTERVAL_H_

#include <cmath>

#include "predicates/double_bits.h"

/// Interval arithmetic with certain bounds: the result of an operation contains every value that
/// the operation has on points of its operands (the fundamental theorem of interval arithmetic:
/// Moore, Interval Analysis, 1966). Results are rounded to nearest and then one or two doubles
/// outward, so that no rounding mode is touched and the bounds are the same everywhere.
namespace circumball {

/// The closed interval [lo, hi]; bounds may be infinite. An interval without points, which comes of
/// taking a function outside its domain, has NaN for both bounds, and passes through every
/// operation.
struct Interval {
  double lo = 0, hi = 0;

  Interval() = default;
  Interval(double point) : lo(point), hi(point) {}  // NOLINT: a number is an interval
  Interval(double lower, double upper) : lo(lower), hi(upper) {}

  static Interval empty() { return {internal::kNaN, internal::kNaN}; }
  static Interval everything() { return {-internal::kInfinity, internal::kInfinity}; }
  bool is_empty() const { return !(lo <= hi); }
  bool contains(double x) const { return lo <= x && x <= hi; }

  /// [lo, hi], `doubles` further on both sides.
  Interval widened(int doubles = 1) const {
    Interval r = *this;
    for (int i = 0; i < doubles; ++i) r = {internal::next_down(r.lo), internal::next_up(r.hi)};
    return r;
  }
};

namespace internal {
/// A product of bounds, where zero times infinity is zero: no point of an interval is infinite.
inline double multiply_bounds(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
inline double least(double a, double b) { return b < a ? b : a; }
inline double greatest(double a, double b) { return b > a ? b : a; }
/// The smallest interval around four numbers.
inline Interval hull(double a, double b, double c, double d) {
  return {least(least(a, b), least(c, d)), greatest(greatest(a, b), greatest(c, d))};
}
}  // namespace internal

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }

inline Interval operator+(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return Interval(a.lo + b.lo, a.hi + b.hi).widened();
}

inline Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }

inline Interval operator*(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  using internal::multiply_bounds;
  return internal::hull(multiply_bounds(a.lo, b.lo), multiply_bounds(a.lo, b.hi),
                        multiply_bounds(a.hi, b.lo), multiply_bounds(a.hi, b.hi))
      .widened();
}

/// a / b. Where zero is inside b the quotient is everything; where it is an end of b, one bound is
/// infinite; b = 0 leaves nothing.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty() || (b.lo == 0 && b.hi == 0)) return Interval::empty();
  if (b.lo < 0 && b.hi > 0) return Interval::everything();
  if (b.lo == 0 || b.hi == 0) {
    // 1/b is [1/hi, inf) or (-inf, 1/lo].
    const Interval inverse = b.lo == 0
                                 ? Interval(internal::next_down(1 / b.hi), internal::kInfinity)
                                 : Interval(-internal::kInfinity, internal::next_up(1 / b.lo));
    return a * inverse;
  }
  const auto divide = [](double x, double y) {
    return x == 0 || std::fabs(y) == internal::kInfinity ? 0 : x / y;
  };
  return internal::hull(divide(a.lo, b.lo), divide(a.lo, b.hi), divide(a.hi, b.lo),
                        divide(a.hi, b.hi))
      .widened();
}

inline Interval abs(const Interval& a) {
  if (a.lo >= 0 || a.is_empty()) return a;
  if (a.hi <= 0) return -a;
  return {0, internal::greatest(-a.lo, a.hi)};
}

inline Interval min(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return {internal::least(a.lo, b.lo), internal::least(a.hi, b.hi)};
}

inline Interval max(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return {internal::greatest(a.lo, b.lo), internal::greatest(a.hi, b.hi)};
}

/// Square roots of the part of a that is not negative.
inline Interval sqrt(const Interval& a) {
  if (!(a.hi >= 0)) return Interval::empty();
  const double lo = a.lo > 0 ? internal::next_down(std::sqrt(a.lo)) : 0;
  return {internal::greatest(lo, 0), internal::next_up(std::sqrt(a.hi))};
}

/// a^n for an integer n; a^0 is 1. For negative n as 1 / a^-n.
Interval pow(const Interval& a, int n);

/// Monotonic functions, widened by what predicates/elementary.h says of their accuracy, and kept in
/// their range.
Interval exp(const Interval& a);
/// Logarithms of the part of a that is positive.
Interval log(const Interval& a);

/// Periodic functions: the extrema inside a are found by exact quarter turns.
Interval sin(const Interval& a);
Interval cos(const Interval& a);
/// Everything where a pole may be inside.
Interval tan(const Interval& a);
/// Of the part of a that is in [-1, 1].
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
/// The angle of (x, y) in (-pi, pi], as elementary::atan2 has it.
Interval atan2(const Interval& y, const Interval& x);

}  // namespace circumball

#endif  // CIRCUMBALL_PREDICATES_INTERVAL_H_
