#ifndef CIRCUMBALL_FEATURE_SIZE_FEATURE_SIZE_H_
#define CIRCUMBALL_FEATURE_SIZE_FEATURE_SIZE_H_

#include <cstdint>
#include <functional>
#include <vector>

#include "circumball/complex.h"
#include "circumball/types.h"
#include "complex/box_tree.h"

/// Feature sizes of a 2D complex by definition (thesis, Definition 2.1.6): the oracle that the
/// theorems are checked with. Distances are rounded doubles, a few ulp accurate.
namespace circumball {

/// The input features of a 2D complex, those that cannot be used (see `check`) left out. Which of
/// them are disjoint is a matter of numbers, not of geometry: in a valid complex two features are
/// disjoint exactly when they share no input vertex, where a vertex lies in a segment if it is its
/// end.
class FeatureSizes {
 public:
  /// Which features to take; null takes all. Called with vertices and segments of the complex.
  using Filter = std::function<bool(const Feature&)>;
  explicit FeatureSizes(const Complex& complex, const Filter& filter = nullptr);

  /// lfs_i(x): radius of the smallest closed ball at x that meets two disjoint features of
  /// dimension <= i (0 or 1). Infinite if no two are disjoint. Looks at features in the order of
  /// their distance: O(log n + features in the ball).
  double local(const Point2& x, int i = 1) const;
  /// mfs_i(x): the same for any two features.
  double mesh(const Point2& x, int i = 1) const;

  /// The same two from the definition, over all features or all pairs of them: what the fast ones
  /// are tested against.
  double local_by_brute_force(const Point2& x, int i = 1) const;
  double mesh_by_brute_force(const Point2& x, int i = 1) const;

 private:
  struct Item {
    std::uint32_t a, b;  // ends, as points; equal for a vertex
  };
  double distance2(const Point2& x, const Item& item) const;
  static bool disjoint(const Item& f, const Item& g) {
    return f.a != g.a && f.a != g.b && f.b != g.a && f.b != g.b;
  }

  std::vector<Point2> points_;
  std::vector<Item> vertices_;
  std::vector<Item> features_;  // vertices, then segments
  BoxTree vertex_tree_, feature_tree_;
};

/// N(x): distance from x to the second nearest of the points of a tree (whose boxes are points).
/// `self`, if given, is the item that x itself is: from a vertex, to its nearest other vertex.
/// Infinite if there is none.
double nearest_neighbor(const BoxTree& points, const Point2& x, std::uint32_t self = kNoIndex);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_FEATURE_SIZE_H_
