#ifndef CIRCUMBALL_PREDICATES_H_
#define CIRCUMBALL_PREDICATES_H_

#include <cstdint>

#include "circumball/types.h"

/// Geometric predicates whose signs are never wrong, for coordinates that are zero or of magnitude
/// 1e-45 to 1e55. A static filter decides nearly always; otherwise floating-point expansions do.
/// Needs round-to-nearest doubles without contraction to FMA (-ffp-contract=off); `self_test` fails
/// otherwise.
namespace circumball {

enum class Sign : int { kNegative = -1, kZero = 0, kPositive = 1 };

/// Positive if a, b, c make a left turn (counter-clockwise), negative for a right turn, zero if
/// collinear.
Sign orient2d(const Point2& a, const Point2& b, const Point2& c);
/// Positive if a, b, c, seen from d, are clockwise: d is below the plane of a counter-clockwise
/// (seen from above) a, b, c.
Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
/// Positive if d is inside the circle through counter-clockwise a, b, c; the sign flips for
/// clockwise a, b, c.
Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
/// Positive if e is inside the sphere through a, b, c, d with orient3d(a, b, c, d) positive; flips
/// with orientation.
Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);
/// Positive if p is inside the ball on diameter ab, zero on its boundary: the sign of (a - p) . (p
/// - b).
Sign in_diametral_ball(const Point2& a, const Point2& b, const Point2& p);
Sign in_diametral_ball(const Point3& a, const Point3& b, const Point3& p);
/// Positive if p is inside the smallest ball with a, b, c on its boundary (centred in their plane);
/// zero on it. a, b, c must not be collinear (then: zero).
Sign in_diametral_ball(const Point3& a, const Point3& b, const Point3& c, const Point3& p);
/// Sign of |a-b| - |c-d|, compared exactly.
Sign compare_distance(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// How often each stage decided, since the last reset. Counting is exact for stages after the
/// filter; calls decided by the filter are counted only in builds with CIRCUMBALL_COUNT_FILTER (it
/// would cost what the filter costs).
struct PredicateCounters {
  std::uint64_t filter = 0, adaptive = 0, exact = 0;
};
struct AllPredicateCounters {
  PredicateCounters orient2d, orient3d, incircle, insphere, segment_ball2, segment_ball3,
      triangle_ball;
};
AllPredicateCounters predicate_counters();
void reset_predicate_counters();

/// Empty if the arithmetic of this build is what the predicates need; else a sentence that says
/// what is wrong (contraction to FMA, extended precision, another rounding mode).
const char* predicate_self_test();

}  // namespace circumball

#endif  // CIRCUMBALL_PREDICATES_H_
