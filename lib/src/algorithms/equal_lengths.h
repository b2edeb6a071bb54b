#ifndef CIRCUMBALL_ALGORITHMS_EQUAL_LENGTHS_H_
#define CIRCUMBALL_ALGORITHMS_EQUAL_LENGTHS_H_

#include <memory>
#include <vector>

#include "circumball/complex.h"
#include "refinement/stage.h"

/// Step 1 before Algorithm 7.1 (thesis, 7.3): "all acutely adjacent input segments must have equal
/// length (modulo powers of 2)". The thesis does not say how.
///
/// Which segments. Two subsegments that share a vertex q0 can encroach upon each other without end
/// only where their angle is less than 90 degrees: a point at distance r from q0 lies in the disk
/// of a piece from a to b at an angle of theta exactly when r^2 - r (a + b) cos(theta) + a b < 0,
/// which needs cos(theta) > 0. The segments of q0 fall into *clusters*: the classes that "less than
/// 90 degrees apart" generates. In each cluster, and in no wider circle, the pieces at q0 are made
/// equal modulo powers of two.
///
/// Then it ends. Where two pieces at q0 are equal and bisected, their vertices are at the same
/// distances from q0, the multiples of powers of two; by the inequality (left side
/// -(r - a)(b - r) + r (a + b)(1 - cos theta)) a vertex encroaches only upon a piece that has its
/// distance strictly inside, that is, upon one that is bisected less often than the piece that the
/// vertex halved. So neither makes the other finer than it is itself, and equal pieces never
/// encroach upon each other. All other pieces keep a distance from each other.
namespace circumball {

/// Splits the segments where `equal_division` says.
std::unique_ptr<Stage> split_at_equal_lengths();

/// A point of a segment: at this distance from its end 0 or 1.
struct Division {
  int end;
  double distance;
};

/// For each segment of a valid complex the points that divide it, in order from its end 0:
///
/// 1. A cluster whose segments are already equal modulo powers of two, but for a relative 1e-10, is
///    left alone. In any other, D is the length of its shortest segment; a segment that takes part
///    in a cluster at both ends counts as half as long, so that the two ends never meet. Where that
///    would leave a piece shorter than D / 4, half of it.
/// 2. Every segment of such a cluster that is not D modulo powers of two is split at distance D.
///    Where the other end belongs to a cluster that needs the length as it was, also in the middle.
/// 3. What is left of the segments beyond D is not aligned, and where their angle is theta they
///    would be refined to about theta times the distance from q0. That is avoided: a point made
///    here, or the end of a segment, that lies in the disk of a piece of another segment of the
///    cluster (which must be split in any case) splits it at its own distance from q0, and the new
///    point is looked at in turn. Then the pieces side by side are equal, but where a point is so
///    near to the end of a piece that it is outside of the disk; bisection keeps it there.
///
/// Each segment is compared with 32 neighbors on each side. O(n log n) but for clusters of hundreds
/// of segments, where every point costs 64 comparisons.
std::vector<std::vector<Division>> equal_division(const Complex& complex);

/// Whether a / b is a power of two, but for a relative 1e-10. Of positive numbers.
bool equal_modulo_powers_of_two(double a, double b);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_EQUAL_LENGTHS_H_
