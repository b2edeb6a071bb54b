#include "feature_size/piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace circumball {

using Table = FeatureSizes::Table;

Approach approach(const Table& table, const Piece& piece, const Table::Item& item) {
  const Point2 &a = piece.a, &b = piece.b;
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  Approach best{0, table.distance2(a, item)};
  const auto consider = [&](double t) {
    if (!(t > 0)) return;  // the first candidate; or not a number, where the piece is a point
    const double clamped = std::min(t, 1.0);
    const double d2 = table.distance2(piece.at(clamped), item);
    if (d2 < best.distance2) best = {clamped, d2};
  };
  // Least at an end of the piece, where an end of the item is projected, or where they cross.
  consider(1);
  const Point2 &p = table.points[item.a], &q = table.points[item.b];
  consider(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2);
  if (item.a == item.b) return best;
  consider(((q.x - a.x) * dx + (q.y - a.y) * dy) / length2);
  const double ex = q.x - p.x, ey = q.y - p.y;
  const double from = (a.x - p.x) * ey - (a.y - p.y) * ex;
  const double to = (b.x - p.x) * ey - (b.y - p.y) * ex;
  if ((from < 0) != (to < 0)) consider(from / (from - to));
  return best;
}

Approach least_larger(const Table& table, const Piece& piece, const Table::Item& f,
                      const Approach& nearest_f, const Table::Item& g, const Approach& nearest_g) {
  if (table.distance2(piece.at(nearest_f.t), g) <= nearest_f.distance2) return nearest_f;
  if (table.distance2(piece.at(nearest_g.t), f) <= nearest_g.distance2) return nearest_g;
  double f_nearer = nearest_f.t, g_nearer = nearest_g.t;
  const auto larger = [&](double t) {
    const Point2 x = piece.at(t);
    return Approach{t, std::max(table.distance2(x, f), table.distance2(x, g))};
  };
  for (;;) {
    const double t = 0.5 * (f_nearer + g_nearer);
    const Point2 x = piece.at(t);
    if (x == piece.at(f_nearer) || x == piece.at(g_nearer)) break;
    const double f2 = table.distance2(x, f), g2 = table.distance2(x, g);
    if (f2 == g2) return {t, f2};
    (f2 < g2 ? f_nearer : g_nearer) = t;
  }
  const Approach one = larger(f_nearer), other = larger(g_nearer);
  return one.distance2 <= other.distance2 ? one : other;
}

double box_bound2(const Piece& piece, const Box2& box) {
  const Box2 around = Box2::of(piece.a, piece.b);
  const double x = std::max({around.lo_x - box.hi_x, box.lo_x - around.hi_x, 0.0});
  const double y = std::max({around.lo_y - box.hi_y, box.lo_y - around.hi_y, 0.0});
  const double dx = piece.b.x - piece.a.x, dy = piece.b.y - piece.a.y;
  const double length2 = dx * dx + dy * dy;
  double bound2 = x * x + y * y;
  if (length2 > 0) {
    const double cx = 0.5 * (box.lo_x + box.hi_x) - piece.a.x, hx = 0.5 * (box.hi_x - box.lo_x);
    const double cy = 0.5 * (box.lo_y + box.hi_y) - piece.a.y, hy = 0.5 * (box.hi_y - box.lo_y);
    // What rounding may add is taken off: a bound must not exceed the distance.
    const double rounding =
        16 * std::numeric_limits<double>::epsilon() * (std::fabs(cx * dy) + std::fabs(cy * dx));
    const double across =
        std::fabs(cx * dy - cy * dx) - (hx * std::fabs(dy) + hy * std::fabs(dx)) - rounding;
    if (across > 0) bound2 = std::max(bound2, across * (across / length2));
  }
  return bound2 * (1 - 8 * std::numeric_limits<double>::epsilon());
}

}  // namespace circumball
