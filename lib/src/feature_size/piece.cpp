#include "feature_size/piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace circumball {
namespace {
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
double gap(double lo, double hi, double other_lo, double other_hi) {
  return std::max({lo - other_hi, other_lo - hi, 0.0});
}
}  // namespace

double box_bound2(const Piece<Point2>& piece, const Box2& box) {
  const Box2 around = Box2::of(piece.a, piece.b);
  const double x = gap(around.lo_x, around.hi_x, box.lo_x, box.hi_x);
  const double y = gap(around.lo_y, around.hi_y, box.lo_y, box.hi_y);
  const double dx = piece.b.x - piece.a.x, dy = piece.b.y - piece.a.y;
  const double length2 = dx * dx + dy * dy;
  double bound2 = x * x + y * y;
  if (length2 > 0) {
    const double cx = 0.5 * (box.lo_x + box.hi_x) - piece.a.x, hx = 0.5 * (box.hi_x - box.lo_x);
    const double cy = 0.5 * (box.lo_y + box.hi_y) - piece.a.y, hy = 0.5 * (box.hi_y - box.lo_y);
    // What rounding may add is taken off: a bound must not exceed the distance.
    const double rounding = 16 * kEpsilon * (std::fabs(cx * dy) + std::fabs(cy * dx));
    const double across =
        std::fabs(cx * dy - cy * dx) - (hx * std::fabs(dy) + hy * std::fabs(dx)) - rounding;
    if (across > 0) bound2 = std::max(bound2, across * (across / length2));
  }
  return bound2 * (1 - 8 * kEpsilon);
}

double box_bound2(const Piece<Point3>& piece, const Box3& box) {
  const Box3 around = Box3::of(piece.a, piece.b);
  const double x = gap(around.lo_x, around.hi_x, box.lo_x, box.hi_x);
  const double y = gap(around.lo_y, around.hi_y, box.lo_y, box.hi_y);
  const double z = gap(around.lo_z, around.hi_z, box.lo_z, box.hi_z);
  double bound2 = x * x + y * y + z * z;
  const Point3 half = {0.5 * (box.hi_x - box.lo_x), 0.5 * (box.hi_y - box.lo_y),
                       0.5 * (box.hi_z - box.lo_z)};
  const Point3 center = {box.lo_x + half.x, box.lo_y + half.y, box.lo_z + half.z};
  const Point3 d = piece.b - piece.a, u = center - piece.a, v = center - piece.b;
  const double length2 = dot(d, d);
  double away2 = dot(u, u);  // of the center from the piece
  if (length2 > 0 && dot(u, d) > 0) away2 = dot(v, d) >= 0 ? dot(v, v) : cross2(u, d) / length2;
  // Coordinates of the center are off by an ulp of the box's; the rest is relative to u.
  const double size = std::fabs(box.lo_x) + std::fabs(box.hi_x) + std::fabs(box.lo_y) +
                      std::fabs(box.hi_y) + std::fabs(box.lo_z) + std::fabs(box.hi_z);
  const double rounding = 16 * kEpsilon * (std::sqrt(dot(u, u)) + size);
  const double beyond = std::sqrt(away2) - std::sqrt(dot(half, half)) - rounding;
  if (beyond > 0) bound2 = std::max(bound2, beyond * beyond);
  return bound2 * (1 - 8 * kEpsilon);
}

}  // namespace circumball
