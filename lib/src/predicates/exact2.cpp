// The stages after the filter for the predicates of the plane.

#include "predicates/expansion.h"
#include "predicates/fast.h"

namespace circumball::internal {
namespace {

/// Differences as expansions. Most differences of nearby coordinates are exact (Sterbenz): then the
/// second component is missing, and the arithmetic below is as short as if it had been written for
/// single doubles. The counters tell the two cases apart.
template <int N>
bool all_exact(const Expansion<2> (&d)[N]) {
  for (const Expansion<2>& e : d) {
    if (e.size == 2) return false;
  }
  return true;
}

void count(Predicate p, bool differences_were_exact) {
  StageCounters& c = counters_of(p);
  (differences_were_exact ? c.adaptive : c.exact).add_one();
}

}  // namespace

double orient2d_exact(double ax, double ay, double bx, double by, double cx, double cy) {
  const Expansion<2> d[] = {difference(ax, cx), difference(by, cy), difference(ay, cy),
                            difference(bx, cx)};
  count(Predicate::kOrient2d, all_exact(d));
  return (d[0] * d[1] - d[2] * d[3]).sign();
}

double incircle_exact(double ax, double ay, double bx, double by, double cx, double cy, double dx,
                      double dy) {
  const Expansion<2> d[] = {difference(ax, dx), difference(ay, dy), difference(bx, dx),
                            difference(by, dy), difference(cx, dx), difference(cy, dy)};
  count(Predicate::kIncircle, all_exact(d));
  const Expansion<2>&a = d[0], &a_y = d[1], &b = d[2], &b_y = d[3], &c = d[4], &c_y = d[5];
  return ((square(a) + square(a_y)) * (b * c_y - c * b_y) +
          (square(b) + square(b_y)) * (c * a_y - a * c_y) +
          (square(c) + square(c_y)) * (a * b_y - b * a_y))
      .sign();
}

double segment_ball2_exact(double ax, double ay, double bx, double by, double px, double py) {
  const Expansion<2> d[] = {difference(ax, px), difference(px, bx), difference(ay, py),
                            difference(py, by)};
  count(Predicate::kSegmentBall2, all_exact(d));
  return (d[0] * d[1] + d[2] * d[3]).sign();
}

double compare_distance_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return (square(difference(a.x, b.x)) + square(difference(a.y, b.y)) -
          (square(difference(c.x, d.x)) + square(difference(c.y, d.y))))
      .sign();
}

}  // namespace circumball::internal
