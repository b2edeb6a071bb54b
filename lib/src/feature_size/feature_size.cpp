#include "feature_size/feature_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "complex/planar_sweep.h"

namespace circumball {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

FeatureSizes::FeatureSizes(const Complex& complex, const Filter& filter) {
  const PlanarView view(complex, {});
  points_ = view.points;
  std::vector<Box2> boxes;
  for (std::uint32_t p = 0; p < points_.size(); ++p) {
    if (filter && !filter({FeatureKind::kVertex, view.vertex[p]})) continue;
    vertices_.push_back({p, p});
    boxes.push_back(Box2::of(points_[p]));
  }
  vertex_tree_ = BoxTree(boxes);
  features_ = vertices_;
  for (const auto& s : view.segments) {
    if (filter && !filter({FeatureKind::kSegment, s.segment})) continue;
    features_.push_back({s.lo, s.hi});
    boxes.push_back(Box2::of(points_[s.lo], points_[s.hi]));
  }
  feature_tree_ = BoxTree(std::move(boxes));
}

double FeatureSizes::distance2(const Point2& x, const Item& item) const {
  const Point2 &a = points_[item.a], &b = points_[item.b];
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

double FeatureSizes::local(const Point2& x, int i) const {
  const std::vector<Item>& items = i == 0 ? vertices_ : features_;
  std::vector<Item> nearer;
  double result = kInfinity;
  (i == 0 ? vertex_tree_ : feature_tree_)
      .nearest(
          x, [&](std::uint32_t f) { return distance2(x, items[f]); },
          [&](std::uint32_t f, double d2) {
            for (const Item& g : nearer) {
              if (!disjoint(items[f], g)) continue;
              result = std::sqrt(d2);  // all nearer features meet each other
              return false;
            }
            nearer.push_back(items[f]);
            return true;
          });
  return result;
}

double FeatureSizes::mesh(const Point2& x, int i) const {
  const std::vector<Item>& items = i == 0 ? vertices_ : features_;
  int count = 0;
  double result = kInfinity;
  (i == 0 ? vertex_tree_ : feature_tree_)
      .nearest(
          x, [&](std::uint32_t f) { return distance2(x, items[f]); },
          [&](std::uint32_t, double d2) {
            if (++count < 2) return true;
            result = std::sqrt(d2);
            return false;
          });
  return result;
}

double FeatureSizes::local_by_brute_force(const Point2& x, int i) const {
  const std::vector<Item>& items = i == 0 ? vertices_ : features_;
  double best2 = kInfinity;  // the definition: over all pairs, the farther of the two
  for (std::size_t f = 0; f < items.size(); ++f) {
    const double f2 = distance2(x, items[f]);
    if (!(f2 < best2)) continue;
    for (std::size_t g = 0; g < items.size(); ++g)
      if (disjoint(items[f], items[g]))
        best2 = std::min(best2, std::max(f2, distance2(x, items[g])));
  }
  return std::sqrt(best2);
}

double FeatureSizes::mesh_by_brute_force(const Point2& x, int i) const {
  const std::vector<Item>& items = i == 0 ? vertices_ : features_;
  double first = kInfinity, second = kInfinity;
  for (const Item& item : items) {
    const double d2 = distance2(x, item);
    if (d2 < first) {
      second = first;
      first = d2;
    } else {
      second = std::min(second, d2);
    }
  }
  return std::sqrt(second);
}

double nearest_neighbor(const BoxTree& points, const Point2& x, std::uint32_t self) {
  int wanted = self == kNoIndex ? 2 : 1;
  double result = kInfinity;
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
