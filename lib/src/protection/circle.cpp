#include "protection/circle.h"

#include <cmath>

#include "circumball/predicates.h"
#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// How far it is from a counter-clockwise to b.
enum class Turn { kUpToAQuarter, kUpToAHalf, kMore, kWhole };

Turn turn(const Point2& center, const Point2& a, const Point2& b) {
  if (a == b) return Turn::kWhole;
  if (orient2d(center, a, b) == Sign::kNegative) return Turn::kMore;
  // A quarter turn has the center on the border of its diametral disk, but for rounding.
  return in_diametral_disk_of_chord(a, b, center) ? Turn::kUpToAHalf : Turn::kUpToAQuarter;
}

/// The middle of the arc from a counter-clockwise to b. The difference of the radii, turned by a
/// right angle, points there, and is well conditioned near half a turn; the sum, or its opposite,
/// elsewhere.
Point2 middle(const Point2& center, double radius, const Point2& a, const Point2& b, Turn turn) {
  if (turn == Turn::kWhole) return {center.x - (a.x - center.x), center.y - (a.y - center.y)};
  const double sx = (a.x - center.x) + (b.x - center.x), sy = (a.y - center.y) + (b.y - center.y);
  double x = b.y - a.y, y = a.x - b.x;
  if (sx * sx + sy * sy > x * x + y * y) {
    x = turn == Turn::kMore ? -sx : sx;
    y = turn == Turn::kMore ? -sy : sy;
  }
  const double scale = radius / std::sqrt(x * x + y * y);
  return {center.x + scale * x, center.y + scale * y};
}

void cut(const Point2& center, double radius, const Point2& a, const Point2& b,
         std::vector<Point2>* points) {
  const Turn how_far = turn(center, a, b);
  if (how_far == Turn::kUpToAQuarter) return;
  const Point2 m = middle(center, radius, a, b, how_far);
  if (m == a || m == b) return;  // no room for it in double precision
  cut(center, radius, a, m, points);
  points->push_back(m);
  cut(center, radius, m, b, points);
}

}  // namespace

std::vector<Point2> quarter_turns(const Point2& center, double radius, const Point2& a,
                                  const Point2& b) {
  std::vector<Point2> points;
  cut(center, radius, a, b, &points);
  return points;
}

Point2 tangent_corner(const Point2& center, const Point2& a, const Point2& b) {
  // center + (u + v) / (1 + cos) for radii u, v of one length; at most a quarter turn apart.
  const double ux = a.x - center.x, uy = a.y - center.y, vx = b.x - center.x, vy = b.y - center.y;
  const double u2 = ux * ux + uy * uy, dot = ux * vx + uy * vy;
  const double scale = u2 / (u2 + dot);
  return {center.x + scale * (ux + vx), center.y + scale * (uy + vy)};
}

}  // namespace circumball
