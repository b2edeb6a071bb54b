#ifndef CIRCUMBALL_ALGORITHMS_FEM_SIZE_H_
#define CIRCUMBALL_ALGORITHMS_FEM_SIZE_H_

#include "algorithms/ruppert.h"

namespace circumball {

/// Simple Delaunay refinement for the finite element method: thesis Algorithm 7.1. The acutely
/// adjacent input segments were split at equal lengths first (`split_at_equal_lengths`). Segments
/// and circumcenters are treated as by Ruppert; what a triangle is split for is its circumradius
/// alone, which bounds the error of linear interpolation on it (Theorem 7.10), and not its angles.
///
/// Ends for every h that is bounded away from 0: a circumcenter is inserted farther than inf h from
/// all vertices, a segment that a circumcenter yields to is longer than sqrt 2 inf h, and segments
/// encroach upon each other finitely often (equal_lengths.h). Then R_t <= inf of h over t, and no
/// triangle is much smaller than h or the local feature size asks for (Theorem 7.13; the check
/// `sizing-lower` says what of its lower bound holds).
struct FemSize : Ruppert {
  /// Priority: segments are processed before triangles (the loop does it); triangles by birth.
  using Triangles = TrianglesByBirth;

  using Conform::unacceptable;
  /// Unacceptability: a segment is unacceptable if its diametral disk is non-empty (Conform). A
  /// triangle t is unacceptable if inf of h over t is less than R_t. A region's own bound on the
  /// area counts, too.
  Verdict unacceptable(const View& view, TriangleRef t) const {
    return too_large(view, t, view.shape(t));
  }

  /// Action: insert the circumcenter of a simplex unless the simplex is a triangle and the
  /// circumcenter encroaches upon a segment. In this case, queue the encroached segment for
  /// splitting.
  using Ruppert::action;

  /// Safety: it is safe to split any simplex.
  using Ruppert::safe;
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_FEM_SIZE_H_
