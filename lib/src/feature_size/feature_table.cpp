#include "feature_size/feature_table.h"

#include <cmath>

#include "complex/planar_sweep.h"

namespace circumball {

FeatureSizes::Table::Table(const Complex& complex, const Filter& filter) {
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

double FeatureSizes::Table::distance2(const Point2& x, const Item& item) const {
  const Point2 &a = points[item.a], &b = points[item.b];
  const double ux = x.x - a.x, uy = x.y - a.y;
  if (item.a == item.b) return ux * ux + uy * uy;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = ux * dx + uy * dy, length2 = dx * dx + dy * dy;
  if (along <= 0) return ux * ux + uy * uy;
  if (along >= length2) {
    const double vx = x.x - b.x, vy = x.y - b.y;
    return vx * vx + vy * vy;
  }
  const double cross = ux * dy - uy * dx;
  return cross * (cross / length2);
}

Point2 FeatureSizes::Table::nearest_point(const Point2& x, const Item& item) const {
  const Point2 &a = points[item.a], &b = points[item.b];
  if (item.a == item.b) return a;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = (x.x - a.x) * dx + (x.y - a.y) * dy, length2 = dx * dx + dy * dy;
  if (along <= 0) return a;
  if (along >= length2) return b;
  const double t = along / length2;
  return {a.x + t * dx, a.y + t * dy};
}

FeatureBall FeatureSizes::Table::ball(const Point2& x, const Item& nearer, const Item& farther,
                                      double d2) const {
  FeatureBall result;
  result.radius = std::sqrt(d2);
  result.center = x;
  result.witness = {FeatureWitness{nearer.feature, nearest_point(x, nearer)},
                    FeatureWitness{farther.feature, nearest_point(x, farther)}};
  return result;
}

}  // namespace circumball
