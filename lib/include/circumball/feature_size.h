#ifndef CIRCUMBALL_FEATURE_SIZE_H_
#define CIRCUMBALL_FEATURE_SIZE_H_

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "circumball/complex.h"
#include "circumball/types.h"

/// Feature sizes of a 2D complex by definition (thesis, Definitions 2.1.6 and 2.1.7): the oracle
/// that the theorems are checked with. It shares nothing with the algorithms but the predicates.
namespace circumball {

/// One of the two features that the ball of a feature size meets.
struct FeatureWitness {
  Feature feature;  ///< of the complex; kFree if there is none
  Point2 at;        ///< its point nearest to the center of the ball, rounded
};

/// A feature size: the radius of a smallest closed ball that meets two features, and these two.
struct FeatureBall {
  double radius = std::numeric_limits<double>::infinity();  ///< infinite if there are no two
  Point2 center;  ///< the point asked for; of a set: the point of it where the infimum is attained
  std::array<FeatureWitness, 2> witness;  ///< nearer first; the second is at the radius

  bool found() const { return witness[1].feature.kind != FeatureKind::kFree; }
};

/// The input features of a 2D complex, those that cannot be used (see `check`) left out. Which of
/// them are disjoint is a matter of numbers, not of geometry: in a valid complex two features are
/// disjoint exactly when they share no input vertex, where a vertex lies in a segment if it is its
/// end.
///
/// Distances are rounded doubles: of a point a few ulp accurate, of a set a few ulp of the largest
/// coordinate involved. Every function may be called from several threads at once.
class FeatureSizes {
 public:
  /// Which features to take; null takes all. Called with vertices and segments of the complex.
  using Filter = std::function<bool(const Feature&)>;
  /// O(n log n).
  explicit FeatureSizes(const Complex& complex, const Filter& filter = nullptr);
  ~FeatureSizes();
  FeatureSizes(FeatureSizes&&) noexcept;
  FeatureSizes& operator=(FeatureSizes&&) noexcept;

  /// lfs_i(x): radius of the smallest closed ball at x that meets two disjoint features of
  /// dimension <= i (0 or 1). Infinite if no two are disjoint, or x is not finite. Looks at
  /// features in the order of their distance: O(log n + k log k) for k features in the ball.
  FeatureBall local(const Point2& x, int i = 1) const;
  /// mfs_i(x): the same for any two features.
  FeatureBall mesh(const Point2& x, int i = 1) const;

  /// lfs_i and mfs_i of a set: the infimum over the piece [a, b], or over a polyline (of one point:
  /// of the point; of none: infinite). Attained at the center of the ball. Not sampled: the larger
  /// of the distances to two features is convex along a piece, and is minimized.
  FeatureBall local(const Point2& a, const Point2& b, int i = 1) const;
  FeatureBall mesh(const Point2& a, const Point2& b, int i = 1) const;
  FeatureBall local(const std::vector<Point2>& polyline, int i = 1) const;
  FeatureBall mesh(const std::vector<Point2>& polyline, int i = 1) const;

  /// fs_i(s) of the subsegment s = [a, b] (Definition 2.1.7): lfs_i(s) for an end segment, that is
  /// one with an input vertex (bit for bit) as an endpoint, mfs_i(s) for any other.
  FeatureBall of_subsegment(const Point2& a, const Point2& b, int i = 1) const;
  bool is_input_vertex(const Point2& x) const;  ///< O(log n)

  /// The same from the definition, over all features or all pairs of them: what the fast ones
  /// are tested against. O(n^2), but for mfs_i at a point, O(n).
  FeatureBall local_by_brute_force(const Point2& x, int i = 1) const;
  FeatureBall mesh_by_brute_force(const Point2& x, int i = 1) const;
  FeatureBall local_by_brute_force(const Point2& a, const Point2& b, int i = 1) const;
  FeatureBall mesh_by_brute_force(const Point2& a, const Point2& b, int i = 1) const;

  struct Table;  ///< of the features; hidden

 private:
  std::unique_ptr<const Table> table_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_H_
