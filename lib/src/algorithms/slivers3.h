#ifndef CIRCUMBALL_ALGORITHMS_SLIVERS3_H_
#define CIRCUMBALL_ALGORITHMS_SLIVERS3_H_

#include "algorithms/ruppert3.h"

namespace circumball {

/// Removes slivers, tetrahedra with a good radius-edge ratio and next to no volume, after a
/// refinement in space: beyond the thesis, in the spirit of Chew ("Guaranteed-quality Delaunay
/// meshing in 3D", SoCG 1997), Li ("Sliver-free three dimensional Delaunay mesh generation",
/// thesis, Urbana 2000) and Li and Teng ("Generating well-shaped Delaunay meshes in 3D", SODA
/// 2001). These insert a point of a ball about the circumcenter, the picking region, chosen so that
/// no sliver comes into being; they prove such a point to be there for a bound on dihedral angles
/// that is positive, but far too small to be of use. Here the bound is useful, so that a point need
/// not be there, and slivers may be born if more of them die.
///
/// It ends: every insertion lowers the number of slivers. Nothing that held before is lost: the
/// point is in the ball of no subsegment, collar element or triangle of a face, so that segments
/// and faces stay what they are; or, where triangles of a face beyond the collars are in the way,
/// it is projected onto that face (as Li picks in faces, too), and the triangles that are made
/// there have no vertex in their balls (thesis, Proposition 6.7). New tetrahedra have RE(t) <= tau
/// and keep the bounds on sizes. What remains is refused with a reason.
struct Slivers3 {
  static constexpr bool kTetrahedra = true;
  /// Points tried for a sliver, and how many that will do are compared.
  static constexpr int kTries = 60, kEnough = 8;

  Ruppert3 quality;     ///< tau and size, for the tetrahedra that are born
  double cosine = 1;    ///< of the least dihedral angle that is no sliver's
  double min_edge = 0;  ///< no edge shorter than this is made; 0: none

  /// Unacceptability: a tetrahedron is unacceptable if its smallest dihedral angle is below the
  /// bound.
  Verdict unacceptable(const SolidView& view, const CellRef& c) const;
  template <class Simplex>
  Verdict unacceptable(const SolidView&, const Simplex&) const {
    return {};
  }
  template <class Simplex>
  Verdict encroached_by(const SolidView&, const Simplex&, VertexId) const {
    return {};
  }

  /// Safety: it is safe to split any tetrahedron.
  template <class Simplex>
  Verdict safe(const SolidView&, const Simplex&) const {
    return {};
  }

  /// Action: of points of the ball, those about its circumcenter first, or their projections, the
  /// one is inserted that lowers the number of slivers most.
  Proposal3 action(SolidView& view, const CellRef& c) const;
  template <class Simplex>
  Proposal3 action(const SolidView&, const Simplex&) const {
    return {};
  }

 private:
  int gain(const SolidView& view, const Point3& p, int least) const;
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_SLIVERS3_H_
