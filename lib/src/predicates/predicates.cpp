#include "circumball/predicates.h"

#include "predicates/fast.h"

namespace circumball {

namespace internal {
StageCounters stage_counters[kPredicateCount];
}  // namespace internal

namespace {

Sign sign_of(double value) { return static_cast<Sign>((value > 0) - (value < 0)); }

PredicateCounters snapshot(internal::Predicate p) {
  const internal::StageCounters& c = internal::counters_of(p);
  return {c.filter.value(), c.adaptive.value(), c.exact.value()};
}

}  // namespace

Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of(orient2d_filtered(a.x, a.y, b.x, b.y, c.x, c.y));
}

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(orient3d_filtered(a, b, c, d));
}

Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(incircle_filtered(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y));
}

Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return sign_of(insphere_filtered(a, b, c, d, e));
}

Sign in_diametral_ball(const Point2& a, const Point2& b, const Point2& p) {
  return sign_of(in_segment_ball_filtered(a.x, a.y, b.x, b.y, p.x, p.y));
}

Sign in_diametral_ball(const Point3& a, const Point3& b, const Point3& p) {
  return sign_of(in_segment_ball_filtered(a, b, p));
}

Sign in_diametral_ball(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return sign_of(in_triangle_ball_filtered(a, b, c, p));
}

Sign compare_distance(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(compare_distance_filtered(a, b, c, d));
}

AllPredicateCounters predicate_counters() {
  using P = internal::Predicate;
  return {snapshot(P::kOrient2d),    snapshot(P::kOrient3d),     snapshot(P::kIncircle),
          snapshot(P::kInsphere),    snapshot(P::kSegmentBall2), snapshot(P::kSegmentBall3),
          snapshot(P::kTriangleBall)};
}

void reset_predicate_counters() {
  for (internal::StageCounters& c : internal::stage_counters) {
    c.filter.reset();
    c.adaptive.reset();
    c.exact.reset();
  }
}

}  // namespace circumball
