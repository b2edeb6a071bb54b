#ifndef CIRCUMBALL_FEATURE_SIZE_H_
#define CIRCUMBALL_FEATURE_SIZE_H_

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "circumball/complex.h"
#include "circumball/types.h"

/// Feature sizes of a complex by definition (thesis, Definitions 2.1.6 and 2.1.7), in the plane and
/// in space: the oracle that the theorems are checked with. It shares nothing with the algorithms
/// but the predicates.
namespace circumball {

/// One of the two features that the ball of a feature size meets.
template <class Point>
struct BasicFeatureWitness {
  Feature feature;  ///< of the complex; kFree if there is none
  Point at;         ///< its point nearest to the center of the ball, rounded
};

/// A feature size: the radius of a smallest closed ball that meets two features, and these two.
template <class Point>
struct BasicFeatureBall {
  double radius = std::numeric_limits<double>::infinity();  ///< infinite if there are no two
  Point center;  ///< the point asked for; of a set: the point of it where the infimum is attained
  std::array<BasicFeatureWitness<Point>, 2> witness;  ///< nearer first; the second is at the radius

  bool found() const { return witness[1].feature.kind != FeatureKind::kFree; }
};

template <class Point>
struct FeatureTable;  ///< of the features of a complex; hidden

/// The input features of a complex, those that cannot be used (see `check`) left out. Which of them
/// are disjoint is a matter of numbers, not of geometry: in a valid complex two features are
/// disjoint exactly when they share no input vertex, where a vertex lies in a segment if it is its
/// end, and in a face if it is of its loops, an end of one of its segments, or isolated in it.
///
/// `Point` is Point2 or Point3, for complexes of that dimension. Faces are measured in convex
/// pieces, triangles between points of the face.
///
/// Distances are rounded doubles: of a point a few ulp accurate (from a face: a few ulp of the
/// largest coordinate involved), of a set a few ulp of the largest coordinate involved. Every
/// function may be called from several threads at once.
template <class Point>
class BasicFeatureSizes {
 public:
  using Ball = BasicFeatureBall<Point>;
  /// The largest dimension of a feature (d - 1): what `i` is where it is left out.
  static constexpr int kTop = std::is_same_v<Point, Point3> ? 2 : 1;
  /// Which features to take; null takes all. Called with the features of the complex.
  using Filter = std::function<bool(const Feature&)>;
  /// O(n log n).
  explicit BasicFeatureSizes(const Complex& complex, const Filter& filter = nullptr);
  ~BasicFeatureSizes();
  BasicFeatureSizes(BasicFeatureSizes&&) noexcept;
  BasicFeatureSizes& operator=(BasicFeatureSizes&&) noexcept;

  /// lfs_i(x): radius of the smallest closed ball at x that meets two disjoint features of
  /// dimension <= i (0 to d - 1). Infinite if no two are disjoint, or x is not finite. Looks at
  /// features in the order of their distance: O(log n + k log k) for k features in the ball.
  Ball local(const Point& x, int i = kTop) const;
  /// mfs_i(x): the same for any two features.
  Ball mesh(const Point& x, int i = kTop) const;

  /// lfs_i and mfs_i of a set: the infimum over the piece [a, b], or over a polyline (of one point:
  /// of the point; of none: infinite). Attained at the center of the ball. Not sampled: the larger
  /// of the distances to two features is convex along a piece, and is minimized.
  Ball local(const Point& a, const Point& b, int i = kTop) const;
  Ball mesh(const Point& a, const Point& b, int i = kTop) const;
  Ball local(const std::vector<Point>& polyline, int i = kTop) const;
  Ball mesh(const std::vector<Point>& polyline, int i = kTop) const;

  /// fs_i(s) of the subsegment s = [a, b] (Definition 2.1.7): lfs_i(s) for an end segment, that is
  /// one with an input vertex (bit for bit) as an endpoint, mfs_i(s) for any other.
  Ball of_subsegment(const Point& a, const Point& b, int i = 1) const;
  bool is_input_vertex(const Point& x) const;  ///< O(log n)

  /// Distance from the piece [a, b] of an input segment to the nearest feature of dimension <= i
  /// that does not contain that segment (what H2 of chapter 6 needs for non-end segments: mfs_2
  /// itself is 0 on every segment of a face). The segment is the first witness. Infinite if there
  /// is no such feature.
  Ball clearance(const Point& a, const Point& b, std::uint32_t segment, int i = kTop) const;

  /// The same from the definition, over all features or all pairs of them: what the fast ones
  /// are tested against. O(n^2), but for mfs_i at a point and the clearance, O(n).
  Ball local_by_brute_force(const Point& x, int i = kTop) const;
  Ball mesh_by_brute_force(const Point& x, int i = kTop) const;
  Ball local_by_brute_force(const Point& a, const Point& b, int i = kTop) const;
  Ball mesh_by_brute_force(const Point& a, const Point& b, int i = kTop) const;
  Ball clearance_by_brute_force(const Point& a, const Point& b, std::uint32_t segment,
                                int i = kTop) const;

 private:
  std::unique_ptr<const FeatureTable<Point>> table_;
};

extern template class BasicFeatureSizes<Point2>;
extern template class BasicFeatureSizes<Point3>;

// In the plane: dimensions of features are 0 and 1.
using FeatureWitness = BasicFeatureWitness<Point2>;
using FeatureBall = BasicFeatureBall<Point2>;
using FeatureSizes = BasicFeatureSizes<Point2>;
// In space: 0, 1 and 2.
using FeatureWitness3 = BasicFeatureWitness<Point3>;
using FeatureBall3 = BasicFeatureBall<Point3>;
using FeatureSizes3 = BasicFeatureSizes<Point3>;

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_H_
