#include <cmath>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/by_definition.h"
#include "feature_size/common_points.h"
#include "feature_size/feature_table.h"
#include "feature_size/infimum.h"

namespace circumball {

template <class Point>
BasicFeatureSizes<Point>::BasicFeatureSizes(const Complex& complex, const Filter& filter)
    : table_(std::make_unique<const FeatureTable<Point>>(complex, filter)) {}
template <class Point>
BasicFeatureSizes<Point>::~BasicFeatureSizes() = default;
template <class Point>
BasicFeatureSizes<Point>::BasicFeatureSizes(BasicFeatureSizes&&) noexcept = default;
template <class Point>
BasicFeatureSizes<Point>& BasicFeatureSizes<Point>::operator=(BasicFeatureSizes&&) noexcept =
    default;

template <class Point>
auto BasicFeatureSizes<Point>::local(const Point& x, int i) const -> Ball {
  const FeatureTable<Point>& table = *table_;
  const auto& items = table.items(i);
  std::vector<std::uint32_t> nearer;  // items so far: any two of them meet
  CommonPoints common;
  Ball result = by_definition::none_at(x);
  if (!table.measurable(x)) return result;
  table.tree(i).nearest(
      x, [&](std::uint32_t f) { return table.distance2(x, items[f]); },
      [&](std::uint32_t f, double d2) {
        if (common.add(table.points_of(items[f]))) {
          for (const std::uint32_t g : nearer) {
            if (!table.disjoint(items[f], items[g])) continue;
            result = ball_at(table, x, items[g], items[f], d2);
            return false;
          }
        }
        nearer.push_back(f);
        return true;
      });
  return result;
}

template <class Point>
auto BasicFeatureSizes<Point>::mesh(const Point& x, int i) const -> Ball {
  const FeatureTable<Point>& table = *table_;
  const auto& items = table.items(i);
  std::uint32_t first = kNoIndex;
  Ball result = by_definition::none_at(x);
  if (!table.measurable(x)) return result;
  table.tree(i).nearest(
      x, [&](std::uint32_t f) { return table.distance2(x, items[f]); },
      [&](std::uint32_t f, double d2) {
        if (first == kNoIndex) {
          first = f;
          return true;
        }
        if (table.same(items[first], items[f])) return true;  // two triangles of one face
        result = ball_at(table, x, items[first], items[f], d2);
        return false;
      });
  return result;
}

template <class Point>
auto BasicFeatureSizes<Point>::local(const std::vector<Point>& polyline, int i) const -> Ball {
  return infimum(*this, *table_, true, polyline, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::mesh(const std::vector<Point>& polyline, int i) const -> Ball {
  return infimum(*this, *table_, false, polyline, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::local(const Point& a, const Point& b, int i) const -> Ball {
  return local({a, b}, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::mesh(const Point& a, const Point& b, int i) const -> Ball {
  return mesh({a, b}, i);
}

template <class Point>
bool BasicFeatureSizes<Point>::is_input_vertex(const Point& x) const {
  using Box = typename FeatureTable<Point>::Box;
  bool found = false;
  table_->vertex_tree.query([&](const Box& box) { return box.meets(Box::of(x)); },
                            [&](std::uint32_t) {
                              found = true;
                              return false;
                            });
  return found;
}

template <class Point>
auto BasicFeatureSizes<Point>::of_subsegment(const Point& a, const Point& b, int i) const -> Ball {
  return is_input_vertex(a) || is_input_vertex(b) ? local(a, b, i) : mesh(a, b, i);
}

namespace {

template <class Point>
BasicFeatureBall<Point> clear_ball(const FeatureTable<Point>& table, const Piece<Point>& piece,
                                   std::uint32_t segment,
                                   const typename FeatureTable<Point>::Item& other) {
  const Approach nearest = table.approach(piece, other);
  const Point x = piece.at(nearest.t);
  BasicFeatureBall<Point> result = ball_at(table, x, other, other, nearest.distance2);
  result.witness[0] = {Feature{FeatureKind::kSegment, segment}, x};
  return result;
}

}  // namespace

template <class Point>
auto BasicFeatureSizes<Point>::clearance(const Point& a, const Point& b, std::uint32_t segment,
                                         int i) const -> Ball {
  const FeatureTable<Point>& table = *table_;
  const auto& items = table.items(i);
  const Piece<Point> piece{a, b};
  Ball result = by_definition::none_at(a);
  if (!table.measurable(a) || !table.measurable(b)) return result;
  table.tree(i).nearest_by(
      [&](const typename FeatureTable<Point>::Box& box) { return box_bound2(piece, box); },
      [&](std::uint32_t f) { return table.approach(piece, items[f]).distance2; },
      [&](std::uint32_t f, double) {
        if (table.contains(items[f], segment)) return true;
        result = clear_ball(table, piece, segment, items[f]);
        return false;
      });
  return result;
}

template <class Point>
auto BasicFeatureSizes<Point>::local_by_brute_force(const Point& x, int i) const -> Ball {
  return by_definition::local(*table_, x, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::mesh_by_brute_force(const Point& x, int i) const -> Ball {
  return by_definition::mesh(*table_, x, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::local_by_brute_force(const Point& a, const Point& b, int i) const
    -> Ball {
  return by_definition::of_piece(*table_, true, {a, b}, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::mesh_by_brute_force(const Point& a, const Point& b, int i) const
    -> Ball {
  return by_definition::of_piece(*table_, false, {a, b}, i);
}
template <class Point>
auto BasicFeatureSizes<Point>::clearance_by_brute_force(const Point& a, const Point& b,
                                                        std::uint32_t segment, int i) const
    -> Ball {
  Ball result = by_definition::none_at(a);
  for (const auto& item : table_->items(i)) {
    if (table_->contains(item, segment)) continue;
    if (!(table_->approach({a, b}, item).distance2 < result.radius * result.radius)) continue;
    result = clear_ball(*table_, {a, b}, segment, item);
  }
  return result;
}

template class BasicFeatureSizes<Point2>;
template class BasicFeatureSizes<Point3>;

}  // namespace circumball
