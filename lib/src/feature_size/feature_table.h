#ifndef CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_
#define CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_

#include <cmath>
#include <cstdint>
#include <vector>

#include "circumball/feature_size.h"
#include "complex/box_tree.h"

namespace circumball {

/// The features of a complex as items, and what can be asked of one or two of them.
struct FeatureSizes::Table {
  /// Ends, as points; equal for a vertex.
  struct Item {
    std::uint32_t a, b;
    Feature feature;
  };

  Table(const Complex& complex, const Filter& filter);

  const std::vector<Item>& items(int i) const { return i == 0 ? vertices : features; }
  const BoxTree& tree(int i) const { return i == 0 ? vertex_tree : feature_tree; }

  /// Whether squares of distances from there are finite: coordinates of features are at most 1e55.
  static bool measurable(const Point2& x) {
    return std::fabs(x.x) <= 1e150 && std::fabs(x.y) <= 1e150;
  }
  static bool disjoint(const Item& f, const Item& g) {
    return f.a != g.a && f.a != g.b && f.b != g.a && f.b != g.b;
  }
  /// Squared distance from a point to an item, rounded, within a few ulp.
  double distance2(const Point2& x, const Item& item) const;
  /// The point of an item that is nearest to x, rounded.
  Point2 nearest_point(const Point2& x, const Item& item) const;
  /// The ball at x that meets two items, the second at squared distance d2.
  FeatureBall ball(const Point2& x, const Item& nearer, const Item& farther, double d2) const;

  std::vector<Point2> points;
  std::vector<Item> vertices;
  std::vector<Item> features;  ///< vertices, then segments
  BoxTree vertex_tree, feature_tree;
};

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_
