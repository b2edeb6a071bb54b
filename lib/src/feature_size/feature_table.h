#ifndef CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_
#define CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "circumball/feature_size.h"
#include "complex/box_tree.h"
#include "feature_size/piece.h"

// The features of a complex as items, which are convex, and what can be asked of one or two of
// them. Everything else of the oracle is the same in the plane and in space.
namespace circumball {

/// Vertices and segments of a 2D complex.
template <>
struct FeatureTable<Point2> {
  using Box = Box2;
  /// Ends, as points; equal for a vertex.
  struct Item {
    std::uint32_t a, b;
    Feature feature;
  };

  FeatureTable(const Complex& complex, const FeatureSizes::Filter& filter);

  const std::vector<Item>& items(int i) const { return i == 0 ? vertices : features; }
  const BoxTree& tree(int i) const { return i == 0 ? vertex_tree : feature_tree; }

  /// Whether squares of distances from there are finite: coordinates of features are at most 1e55.
  static bool measurable(const Point2& x) {
    return std::fabs(x.x) <= 1e150 && std::fabs(x.y) <= 1e150;
  }
  static bool disjoint(const Item& f, const Item& g) {
    return f.a != g.a && f.a != g.b && f.b != g.a && f.b != g.b;
  }
  static bool same(const Item& f, const Item& g) { return f.feature == g.feature; }
  /// Whether the feature of the item contains an input segment.
  static bool contains(const Item& f, std::uint32_t segment) {
    return f.feature == Feature{FeatureKind::kSegment, segment};
  }
  /// The points in the feature of the item, ascending.
  static std::vector<std::uint32_t> points_of(const Item& f) {
    if (f.a == f.b) return {f.a};
    return {std::min(f.a, f.b), std::max(f.a, f.b)};
  }
  /// Squared distance from a point to an item, rounded, within a few ulp.
  double distance2(const Point2& x, const Item& item) const;
  /// The point of an item that is nearest to x, rounded.
  Point2 nearest_point(const Point2& x, const Item& item) const;
  /// Where on a piece an item is nearest, and how near.
  Approach approach(const Piece<Point2>& piece, const Item& item) const;

  std::vector<Point2> points;
  std::vector<Item> vertices;
  std::vector<Item> features;  ///< vertices, then segments
  BoxTree vertex_tree, feature_tree;
};

/// Vertices, segments and faces of a 3D complex; a face is one item for each of its triangles.
template <>
struct FeatureTable<Point3> {
  using Box = Box3;
  /// A point, a segment or a triangle, by its first 1, 2 or 3 corners.
  struct Item {
    std::array<Point3, 3> corner;
    int corners;
    Feature feature;
    std::uint32_t a, b;  ///< a vertex, or the ends of a segment; of a face kNoIndex
  };

  FeatureTable(const Complex& complex, const FeatureSizes3::Filter& filter);

  const std::vector<Item>& items(int i) const {
    return i == 0 ? vertices : i == 1 ? edges : features;
  }
  const BoxTree3& tree(int i) const {
    return i == 0 ? vertex_tree : i == 1 ? edge_tree : feature_tree;
  }

  /// Whether products of distances from there are finite.
  static bool measurable(const Point3& x) {
    return std::fabs(x.x) <= 1e80 && std::fabs(x.y) <= 1e80 && std::fabs(x.z) <= 1e80;
  }
  bool disjoint(const Item& f, const Item& g) const;
  static bool same(const Item& f, const Item& g) { return f.feature == g.feature; }
  bool contains(const Item& f, std::uint32_t segment) const;
  std::vector<std::uint32_t> points_of(const Item& f) const;
  /// Squared distance from a point to an item, rounded.
  double distance2(const Point3& x, const Item& item) const;
  Point3 nearest_point(const Point3& x, const Item& item) const;
  Approach approach(const Piece<Point3>& piece, const Item& item) const;

  std::vector<Item> vertices;
  std::vector<Item> edges;     ///< vertices, then segments
  std::vector<Item> features;  ///< these, then triangles of faces
  BoxTree3 vertex_tree, edge_tree, feature_tree;
  /// Of each face of the complex its vertices, and the segments in it, ascending; empty for a face
  /// that is left out.
  std::vector<std::vector<std::uint32_t>> face_vertices, face_segments;
  /// Of each segment the first with the same ends; kNoIndex if it cannot be used.
  std::vector<std::uint32_t> first_of;

 private:
  bool face_has(std::uint32_t face, std::uint32_t vertex) const;
};

/// The ball at x that meets two items, the second at squared distance d2.
template <class Point>
BasicFeatureBall<Point> ball_at(const FeatureTable<Point>& table, const Point& x,
                                const typename FeatureTable<Point>::Item& nearer,
                                const typename FeatureTable<Point>::Item& farther, double d2) {
  BasicFeatureBall<Point> result;
  result.radius = std::sqrt(d2);
  result.center = x;
  result.witness[0] = {nearer.feature, table.nearest_point(x, nearer)};
  result.witness[1] = {farther.feature, table.nearest_point(x, farther)};
  return result;
}

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_FEATURE_TABLE_H_
