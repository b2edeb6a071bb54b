#include "predicates/interval.h"

#include "predicates/elementary.h"

namespace circumball {
namespace {

using internal::greatest;
using internal::kInfinity;
using internal::least;

/// elementary::exp, log, sin and cos are within 1 ulp, which is less than two doubles away even
/// across a power of two.
constexpr int kElementaryDoubles = 2;
/// tan, asin, acos, atan and atan2 are within 4 ulp, which is at most eight doubles.
constexpr int kInverseDoubles = 8;
/// An upper bound of pi.
constexpr double kPiUp = 0x1.921fb54442d19p+1;

/// Lower and upper bound of x^n for x >= 0, n >= 1, by repeated squaring with outward steps.
Interval power_of_non_negative(double x, unsigned n) {
  Interval result(1), square(x);
  bool first = true;
  for (;; square = square * square, square.lo = greatest(square.lo, 0)) {
    if (n & 1) {
      result = first ? square : result * square;
      result.lo = greatest(result.lo, 0);
      first = false;
    }
    n >>= 1;
    if (n == 0) return result;
  }
}

Interval positive_power(const Interval& a, unsigned n) {
  const bool even = n % 2 == 0;
  const Interval size = abs(a);
  if (even || a.lo >= 0 || a.hi <= 0) {
    const Interval r = {power_of_non_negative(size.lo, n).lo, power_of_non_negative(size.hi, n).hi};
    return even || a.lo >= 0 ? r : -r;
  }
  return {-power_of_non_negative(-a.lo, n).hi, power_of_non_negative(a.hi, n).hi};
}

/// The image of a under sine, if `shift` is 0, or under cosine, if it is 1 (cos x = sin(x + pi/2)).
Interval sine(const Interval& a, int shift) {
  if (a.is_empty()) return a;
  // Below a whole turn. Two quarter turns of equal number are the same one or almost a whole turn
  // apart; 4 lies well between
  // pi/2 and 3 pi/2.
  if (!(a.hi - a.lo < 6.283)) return {-1, 1};
  const int from = elementary::quarter_turn(a.lo), to = elementary::quarter_turn(a.hi);
  int turns = (to - from) & 3;
  if (turns == 0 && a.hi - a.lo > 4) turns = 4;
  const auto f = [&](double x) { return shift == 0 ? elementary::sin(x) : elementary::cos(x); };
  const double at_lo = f(a.lo), at_hi = f(a.hi);
  Interval r = Interval(least(at_lo, at_hi), greatest(at_lo, at_hi)).widened(kElementaryDoubles);
  for (int boundary = from + 1; boundary <= from + turns; ++boundary) {
    // Between quarter turns `boundary - 1` and `boundary` the sine has its maximum at 1, its
    // minimum at 3 (modulo 4).
    const int extremum = (boundary + shift) & 3;
    if (extremum == 1) r.hi = 1;
    if (extremum == 3) r.lo = -1;
  }
  return {greatest(r.lo, -1), least(r.hi, 1)};
}

}  // namespace

Interval pow(const Interval& a, int n) {
  if (a.is_empty()) return a;
  if (n == 0) return 1;
  if (n < 0) return Interval(1) / positive_power(a, 0u - static_cast<unsigned>(n));
  return positive_power(a, static_cast<unsigned>(n));
}

Interval exp(const Interval& a) {
  if (a.is_empty()) return a;
  const Interval r =
      Interval(elementary::exp(a.lo), elementary::exp(a.hi)).widened(kElementaryDoubles);
  // The exponential function is positive; from a finite lower end it never is infinite.
  return {greatest(r.lo, 0), r.hi};
}

Interval log(const Interval& a) {
  if (!(a.hi > 0)) return Interval::empty();
  const double lo = a.lo > 0 ? elementary::log(a.lo) : -kInfinity;
  return Interval(lo, elementary::log(a.hi)).widened(kElementaryDoubles);
}

Interval sin(const Interval& a) { return sine(a, 0); }
Interval cos(const Interval& a) { return sine(a, 1); }

Interval tan(const Interval& a) {
  if (a.is_empty()) return a;
  // Poles are where odd quarter turns begin; in between the tangent increases.
  if (!(a.hi - a.lo < 3.14)) return Interval::everything();
  const int from = elementary::quarter_turn(a.lo), to = elementary::quarter_turn(a.hi);
  const bool pole = from % 2 == 0 ? to != from : (to != from && to != ((from + 1) & 3));
  if (pole) return Interval::everything();
  return Interval(elementary::tan(a.lo), elementary::tan(a.hi)).widened(kInverseDoubles);
}

Interval asin(const Interval& a) {
  if (!(a.hi >= -1 && a.lo <= 1)) return Interval::empty();
  return Interval(elementary::asin(greatest(a.lo, -1)), elementary::asin(least(a.hi, 1)))
      .widened(kInverseDoubles);
}

Interval acos(const Interval& a) {
  if (!(a.hi >= -1 && a.lo <= 1)) return Interval::empty();
  return Interval(elementary::acos(least(a.hi, 1)), elementary::acos(greatest(a.lo, -1)))
      .widened(kInverseDoubles);
}

Interval atan(const Interval& a) {
  if (a.is_empty()) return a;
  return Interval(elementary::atan(a.lo), elementary::atan(a.hi)).widened(kInverseDoubles);
}

Interval atan2(const Interval& y, const Interval& x) {
  if (y.is_empty() || x.is_empty()) return Interval::empty();
  // The box meets the cut from both sides.
  if (x.lo < 0 && y.lo < 0 && y.hi >= 0) return {-kPiUp, kPiUp};
  // For fixed y the angle is monotonic in x, for fixed x in y: its extrema are at corners.
  const Interval r = internal::hull(elementary::atan2(y.lo, x.lo), elementary::atan2(y.lo, x.hi),
                                    elementary::atan2(y.hi, x.lo), elementary::atan2(y.hi, x.hi))
                         .widened(kInverseDoubles);
  return {greatest(r.lo, -kPiUp), least(r.hi, kPiUp)};
}

}  // namespace circumball
