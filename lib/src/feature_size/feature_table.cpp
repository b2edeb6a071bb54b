#include "feature_size/feature_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "complex/planar_sweep.h"

namespace circumball {

using Table = FeatureTable<Point2>;

Table::FeatureTable(const Complex& complex, const FeatureSizes::Filter& filter) {
  const PlanarView view(complex, {});
  points = view.points;
  std::vector<Box2> boxes;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    const Feature vertex{FeatureKind::kVertex, view.vertex[p]};
    if (filter && !filter(vertex)) continue;
    vertices.push_back({p, p, vertex});
    boxes.push_back(Box2::of(points[p]));
  }
  vertex_tree = BoxTree(boxes);
  features = vertices;
  for (const auto& s : view.segments) {
    const Feature segment{FeatureKind::kSegment, s.segment};
    if (filter && !filter(segment)) continue;
    features.push_back({s.lo, s.hi, segment});
    boxes.push_back(Box2::of(points[s.lo], points[s.hi]));
  }
  feature_tree = BoxTree(std::move(boxes));
}

double Table::distance2(const Point2& x, const Item& item) const {
  const Point2 &a = points[item.a], &b = points[item.b];
  const Point2 u = x - a;
  if (item.a == item.b) return dot(u, u);
  const Point2 d = b - a;
  const double along = dot(u, d), length2 = dot(d, d);
  if (along <= 0) return dot(u, u);
  if (along >= length2) return dot(x - b, x - b);
  const double cross = u.x * d.y - u.y * d.x;
  return cross * (cross / length2);
}

Point2 Table::nearest_point(const Point2& x, const Item& item) const {
  const Point2 &a = points[item.a], &b = points[item.b];
  if (item.a == item.b) return a;
  const Point2 d = b - a;
  const double along = dot(x - a, d), length2 = dot(d, d);
  if (along <= 0) return a;
  if (along >= length2) return b;
  return circumball::along(a, along / length2, d);
}

Approach Table::approach(const Piece<Point2>& piece, const Item& item) const {
  const Point2 &a = piece.a, &b = piece.b;
  const Point2 d = b - a;
  const double length2 = dot(d, d);
  Approach best{0, distance2(a, item)};
  const auto consider = [&](double t) {
    if (!(t > 0)) return;  // the first candidate; or not a number, where the piece is a point
    const double clamped = std::min(t, 1.0);
    const double d2 = distance2(piece.at(clamped), item);
    if (d2 < best.distance2) best = {clamped, d2};
  };
  // Least at an end of the piece, where an end of the item is projected, or where they cross.
  consider(1);
  const Point2 &p = points[item.a], &q = points[item.b];
  consider(dot(p - a, d) / length2);
  if (item.a == item.b) return best;
  consider(dot(q - a, d) / length2);
  const Point2 e = q - p;
  const double from = (a.x - p.x) * e.y - (a.y - p.y) * e.x;
  const double to = (b.x - p.x) * e.y - (b.y - p.y) * e.x;
  if ((from < 0) != (to < 0)) consider(from / (from - to));
  return best;
}

}  // namespace circumball
