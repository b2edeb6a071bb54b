#include "feature_size/nearest_neighbor.h"

#include <cmath>
#include <limits>

namespace circumball {

double nearest_neighbor(const BoxTree& points, const Point2& x, std::uint32_t self) {
  int wanted = self == kNoIndex ? 2 : 1;
  double result = std::numeric_limits<double>::infinity();
  points.nearest(
      x, [&](std::uint32_t p) { return points.box(p).distance2(x); },
      [&](std::uint32_t p, double d2) {
        if (p == self) return true;
        if (--wanted > 0) return true;
        result = std::sqrt(d2);
        return false;
      });
  return result;
}

}  // namespace circumball
