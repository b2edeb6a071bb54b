#ifndef CIRCUMBALL_ALGORITHMS_COLLAR3_H_
#define CIRCUMBALL_ALGORITHMS_COLLAR3_H_

#include "algorithms/ruppert3.h"

namespace circumball {

/// Step 3 of the refinement with collar in space, the part about collar segments and arcs alone:
/// they have the highest priority, and only where they are edges is it known which triangles belong
/// to the collars.
struct CollarElements3 : Conform3 {
  /// Unacceptability: a collar segment or collar arc is unacceptable if its diametral ball is not
  /// empty.
  Verdict unacceptable(const SolidView& view, SubsegmentId s) const {
    return view.subsegment(s).is_collar_element() ? view.encroachment(s) : Verdict{};
  }
  Verdict encroached_by(const SolidView& view, SubsegmentId s, VertexId v) const {
    return view.subsegment(s).is_collar_element() ? view.encroached_by(s, v) : Verdict{};
  }
  Verdict unacceptable(const SolidView&, const FaceTriangle&) const { return {}; }
  Verdict encroached_by(const SolidView&, const FaceTriangle&, VertexId) const { return {}; }
  Verdict unacceptable(const SolidView&, const CellRef&) const { return {}; }

  using Conform3::action;
  /// Action: a collar segment is split at its midpoint, a collar arc at the midpoint of the arc.
  Proposal3 action(const SolidView& view, SubsegmentId s) const {
    const bool arc = view.subsegment(s).is_arc();
    return insert(view.midpoint(s), arc ? Reason::kArcMidpoint : Reason::kMidpoint);
  }

  /// Safety: nothing yields to collar simplices. A point that encroaches upon nothing else is
  /// refused.
  static Proposal3 spare_protected(SolidView& view, const Proposal3& proposal) {
    if (proposal.kind != ProposalKind::kYield) return proposal;
    const bool is_protected = view.leave_out_protected();
    bool any = false;
    view.for_each_encroached([&](const auto&) { any = true; });
    if (!any && is_protected) return refuse(proposal.at, Reason::kProtected);
    return proposal;
  }
};

/// The part about collars, segments and faces: after it, the tetrahedralization conforms. Where
/// nothing is protected, it is that of Ruppert's algorithm.
struct CollarFaces3 : CollarElements3 {
  using CollarElements3::encroached_by;
  using CollarElements3::unacceptable;
  /// Unacceptability: a subsegment is unacceptable if its diametral ball is not empty, but for
  /// collar simplices: protected ones.
  Verdict unacceptable(const SolidView& view, SubsegmentId s) const {
    return view.subsegment(s).is_collar ? Verdict{} : view.encroachment(s);
  }
  Verdict encroached_by(const SolidView& view, SubsegmentId s, VertexId v) const {
    return view.subsegment(s).is_collar ? Verdict{} : view.encroached_by(s, v);
  }
  /// Unacceptability: a triangle of a face is unacceptable if its circumball is not empty.
  Verdict unacceptable(const SolidView& view, const FaceTriangle& t) const {
    return Conform3().unacceptable(view, t);
  }
  Verdict encroached_by(const SolidView& view, const FaceTriangle& t, VertexId v) const {
    return Conform3().encroached_by(view, t, v);
  }

  using CollarElements3::action;
  /// Action: the circumcenter of a triangle beyond the collars is inserted, unless it encroaches
  /// upon collar elements, which are queued then. Safety: triangles of the collars are never split;
  /// one that is encroached queues the collar elements at it, so that collars in adjacent faces
  /// come to line up.
  Proposal3 action(SolidView& view, const FaceTriangle& t) const {
    if (view.is_in_collar(t)) {
      view.propose_collar_elements(t);
      return yield3(view.circumcenter(t));
    }
    return spare_protected(view, Conform3::action(view, t));
  }
};

/// Delaunay refinement with collar in space, step 3: thesis Algorithm 6.2.
///
/// It ends for every valid complex and tau > 2; then it conforms, and the circumcenter of every
/// remaining tetrahedron with RE(t) > tau lies in the ball of a collar simplex (Theorems 6.10 and
/// 6.11).
struct Collar3 : CollarFaces3 {
  static constexpr bool kTetrahedra = true;

  Ruppert3 quality;  ///< tau and size

  using CollarFaces3::unacceptable;
  Verdict unacceptable(const SolidView& view, const CellRef& c) const {
    return quality.unacceptable(view, c);
  }

  using CollarFaces3::action;
  /// Action and Safety: the circumcenter of a tetrahedron yields to the collar elements and to the
  /// triangles beyond the collars that it encroaches; where it encroaches upon nothing but collar
  /// simplices, it is refused.
  Proposal3 action(SolidView& view, const CellRef& t) const {
    return spare_protected(view, quality.action(view, t));
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_COLLAR3_H_
