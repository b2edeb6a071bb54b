#ifndef CIRCUMBALL_ALGORITHMS_INTESTINE_H_
#define CIRCUMBALL_ALGORITHMS_INTESTINE_H_

#include "algorithms/collar.h"

namespace circumball {

/// Delaunay refinement with intestine, step 2: thesis Algorithm 5.3. Ruppert's algorithm outside of
/// the disks that protect the acute input angles; their circles were put into the complex as arcs
/// (`draw_protecting_circles`).
///
/// It ends for every valid complex and tau > sqrt 2 and conforms; triangles with RE(t) > tau remain
/// inside the disks only, and no angle is larger than 180 degrees - 2 kappa (Theorems 5.10, 5.11).
///
/// Read with care: printed literally ("any triangle", "all simplices are safe") it would refine the
/// fans in the disks, and run away. Outside of the disks is meant ("Ruppert's algorithm is
/// performed outside of the union of the disks").
struct Intestine : Ruppert {
  using Ruppert::unacceptable;
  /// Unacceptability: any segment or arc with a nonempty diametral disk is unacceptable. Any
  /// triangle outside of the protecting disks with radius-edge ratio larger than tau is, too.
  Verdict unacceptable(const View& view, TriangleRef t) const {
    const Verdict verdict = Ruppert::unacceptable(view, t);
    return verdict && view.in_protecting_disk(t) ? Verdict{} : verdict;
  }

  using Ruppert::safe;
  /// Safety: all simplices and arcs are safe to split; but for the end segments inside the disks,
  /// which nothing ever asks for.
  Verdict safe(const View& view, SubsegmentId s) const { return ConformWithCollar().safe(view, s); }

  /// Action: insert the circumcenter of a triangle; insert the midpoint of a segment or arc.
  Proposal action(const View& view, SubsegmentId s) const {
    return insert(view.midpoint(s),
                  view.subsegment(s).is_arc() ? Reason::kArcMidpoint : Reason::kMidpoint);
  }
  /// A circumcenter in the disks of an end segment and of an arc yields to the arc: refusing it, as
  /// Algorithm 5.2 does, breaks Theorem 5.11. In that of an end segment alone it never lies
  /// (docs/algorithms.md) where the circle is whole; where a sector has no arc, it is refused.
  Proposal action(View& view, TriangleRef t) const {
    const Proposal proposal = Ruppert::action(view, t);
    if (proposal.kind == ProposalKind::kYield && view.encroaches_upon_collar_only()) {
      return refuse(proposal.at, Reason::kProtected);
    }
    return proposal;
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_INTESTINE_H_
