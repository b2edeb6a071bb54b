#ifndef CIRCUMBALL_ALGORITHMS_COLLAR_H_
#define CIRCUMBALL_ALGORITHMS_COLLAR_H_

#include "algorithms/ruppert.h"

namespace circumball {

/// Step 2 of the refinement with collar, the part about segments alone (see Conform).
struct ConformWithCollar : Conform {
  /// Safety: collar simplices are not safe to split. Their diametral disks stay empty (Lemma 5.4),
  /// so that no vertex ever asks for it.
  Verdict safe(const View& view, SubsegmentId s) const {
    return view.subsegment(s).is_collar ? Verdict{Reason::kProtected, VertexId(), 0} : Verdict{};
  }
  using Conform::safe;
};

/// Delaunay refinement with collar, step 2: thesis Algorithm 5.2. Ruppert's algorithm, but for
/// Safety. The end segments at acute input angles were made equal in step 1b
/// (`protect_acute_angles`): they are the collar simplices.
///
/// It ends for every valid complex and tau > sqrt 2, conforms, and the circumcenter of every
/// remaining triangle with RE(t) > tau lies in the diametral disk of a collar simplex (Theorems 5.6
/// and 5.7).
struct Collar : Ruppert {
  using Ruppert::safe;
  Verdict safe(const View& view, SubsegmentId s) const { return ConformWithCollar().safe(view, s); }

  using Ruppert::action;
  /// Safety, again: a circumcenter that encroaches upon a collar simplex is refused.
  Proposal action(View& view, TriangleRef t) const {
    const Proposal proposal = Ruppert::action(view, t);
    if (proposal.kind == ProposalKind::kYield && view.encroaches_upon_collar()) {
      return refuse(proposal.at, Reason::kProtected);
    }
    return proposal;
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_COLLAR_H_
