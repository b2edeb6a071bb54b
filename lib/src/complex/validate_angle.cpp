#include "complex/kahan_angle.h"
#include "complex/planar_arrangement.h"
#include "complex/validate_space.h"

namespace circumball {
double smallest_angle_degrees(const Complex& complex) {
  if (complex.dimension == 3) return smallest_angle_in_space(complex);
  double smallest = 180;
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
