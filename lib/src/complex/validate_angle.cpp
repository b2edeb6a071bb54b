#include <cmath>

#include "complex/planar_arrangement.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

/// Angle between two directions in degrees, 0 to 180: twice the arc tangent of |u/|u| - v/|v|| /
/// |u/|u| + v/|v|| (Kahan), which is accurate for small and for straight angles. A few units in the
/// last place.
double angle_degrees(const Point2& u, const Point2& v) {
  const double lu = std::sqrt(u.x * u.x + u.y * u.y), lv = std::sqrt(v.x * v.x + v.y * v.y);
  const double ax = u.x * lv, ay = u.y * lv, bx = v.x * lu, by = v.y * lu;
  const double difference = std::sqrt((ax - bx) * (ax - bx) + (ay - by) * (ay - by));
  const double sum = std::sqrt((ax + bx) * (ax + bx) + (ay + by) * (ay + by));
  constexpr double kTwiceDegrees = 114.59155902616465;  // 360 / pi
  if (difference == sum) return 90;
  if (difference < sum) return kTwiceDegrees * elementary::atan(difference / sum);
  return 180 - kTwiceDegrees * elementary::atan(sum / difference);
}

}  // namespace

double smallest_angle_degrees(const Complex& complex) {
  double smallest = 180;
  if (complex.dimension != 2) return smallest;
  const PlanarView view(complex, {});
  const PlanarStars stars(view);
  const auto direction = [&](std::uint32_t p, std::uint32_t h) {
    const auto& s = view.segments[h / 2];
    const Point2& q = view.points[h & 1 ? s.lo : s.hi];
    return Point2{q.x - view.points[p].x, q.y - view.points[p].y};
  };
  for (std::uint32_t p = 0; p < view.points.size(); ++p) {
    const std::uint32_t first = stars.first[p], last = stars.first[p + 1];
    if (last - first < 2) continue;
    for (std::uint32_t k = first; k < last; ++k) {  // the smallest is between neighbors of the star
      const std::uint32_t j = k + 1 < last ? k + 1 : first;
      const double a =
          angle_degrees(direction(p, stars.outgoing[k]), direction(p, stars.outgoing[j]));
      if (a < smallest) smallest = a;
    }
  }
  return smallest;
}

}  // namespace circumball
