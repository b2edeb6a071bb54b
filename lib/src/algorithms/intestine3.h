#ifndef CIRCUMBALL_ALGORITHMS_INTESTINE3_H_
#define CIRCUMBALL_ALGORITHMS_INTESTINE3_H_

#include "algorithms/ruppert3.h"

namespace circumball {

/// Step 3 of the refinement with intestines in space, the part about dimension 1 alone: collar
/// segments, collar arcs, arcs of rings, and subsegments that are not protected. Only where they
/// are edges is it known which triangles belong to the collars.
struct IntestineElements3 : Conform3 {
  static constexpr bool kPatches = true;

  /// Unacceptability: an element is unacceptable if its diametral ball is not empty. What is inside
  /// of spheres and tubes is not required, and never processed.
  Verdict unacceptable(const SolidView& view, SubsegmentId s) const {
    return view.is_in_intestine(s) ? Verdict{} : view.encroachment(s);
  }
  Verdict encroached_by(const SolidView& view, SubsegmentId s, VertexId v) const {
    return view.is_in_intestine(s) ? Verdict{} : view.encroached_by(s, v);
  }
  Verdict unacceptable(const SolidView&, PatchId) const { return {}; }
  Verdict encroached_by(const SolidView&, PatchId, VertexId) const { return {}; }
  Verdict unacceptable(const SolidView&, const FaceTriangle&) const { return {}; }
  Verdict encroached_by(const SolidView&, const FaceTriangle&, VertexId) const { return {}; }
  Verdict unacceptable(const SolidView&, const CellRef&) const { return {}; }

  using Conform3::action;
  /// Action: an arc is split at its midpoint, of a ring that one alone. A collar segment is split
  /// by a ring in the middle between its two, with the keys of both (6.4), or at its midpoint
  /// (6.3).
  Proposal3 action(const SolidView& view, SubsegmentId s) const {
    const Subsegment& u = view.subsegment(s);
    const Reason why = u.is_ring_arc() || u.is_arc()                   ? Reason::kArcMidpoint
                       : u.is_collar_element() && view.is_structured() ? Reason::kRing
                                                                       : Reason::kMidpoint;
    return insert(view.midpoint(s), why);
  }
  Proposal3 action(SolidView& view, PatchId p) const {
    if (!view.patch(p).is_of_sphere() && view.is_structured()) {
      const Point3 at = view.place_on_new_ring(p);
      return view.propose_arcs(p) ? yield3(at) : insert(at, Reason::kRing);
    }
    bool inside = true;
    const Point3 top =
        view.patch(p).is_of_sphere() ? view.top(p) : view.projected_circumcenter(p, &inside);
    switch (view.look(top, p)) {
      case Outlook3::kEncroaches:
        return yielded_unless_protected(view, top);
      case Outlook3::kCoincides:
        return refuse(top, Reason::kPrecision);
      default:
        // Where rounding, or the curvature of rings, lets it miss its cell, a side is in its way.
        if (!inside) return view.propose_sides(p) ? yield3(top) : refuse(top, Reason::kProtected);
        return insert(top, Reason::kSurface);
    }
  }

 protected:
  /// What was looked at yields to what it encroaches upon. It never comes near the inside of the
  /// intestine; if it did, it would be refused, and told.
  static Proposal3 yielded_unless_protected(SolidView& view, const Point3& at) {
    const bool is_protected = view.leave_out_intestine();
    bool any = false;
    view.for_each_encroached([&](const auto&) { any = true; });
    return !any && is_protected ? refuse(at, Reason::kProtected) : yield3(at);
  }
};

/// With patches and triangles of faces: after it, the tetrahedralization conforms outside of the
/// intestine and on its surface; of 6.4, also inside.
struct IntestineFaces3 : IntestineElements3 {
  using IntestineElements3::encroached_by;
  using IntestineElements3::unacceptable;
  /// Unacceptability: a patch is unacceptable if its smallest ball is not empty, or if it is of a
  /// sphere and has an angular radius above 45 degrees.
  Verdict unacceptable(const SolidView& view, PatchId p) const {
    if (view.is_wide(p)) return {Reason::kWide, VertexId(), 0};
    return view.encroachment(p);
  }
  Verdict encroached_by(const SolidView& view, PatchId p, VertexId v) const {
    return view.encroached_by(p, v);
  }
  /// A triangle of a face outside of the collars is, if its smallest ball is not empty.
  Verdict unacceptable(const SolidView& view, const FaceTriangle& t) const {
    return view.is_in_collar(t) ? Verdict{} : Conform3().unacceptable(view, t);
  }
  Verdict encroached_by(const SolidView& view, const FaceTriangle& t, VertexId v) const {
    return view.is_in_collar(t) ? Verdict{} : Conform3().encroached_by(view, t, v);
  }

  using IntestineElements3::action;
  Proposal3 action(SolidView& view, const FaceTriangle& t) const {
    const Proposal3 proposal = Conform3::action(view, t);
    return proposal.kind == ProposalKind::kYield ? yielded_unless_protected(view, proposal.at)
                                                 : proposal;
  }
};

/// Delaunay refinement with intestines in space, step 3: thesis Algorithms 6.3 and 6.4, as
/// docs/algorithms.md states them.
///
/// Ends with no exception met for tau > 2 (thesis, Conjecture 6.16 would prove it); then RE(t) <=
/// tau for every tetrahedron outside of the intestine, without exception (Theorems 6.14, 6.15).
struct Intestine3 : IntestineFaces3 {
  static constexpr bool kTetrahedra = true;

  Ruppert3 quality;  ///< tau and size

  using IntestineFaces3::unacceptable;
  Verdict unacceptable(const SolidView& view, const CellRef& c) const {
    const Verdict why = quality.unacceptable(view, c);
    return why && view.is_in_intestine(c) ? Verdict{} : why;
  }

  using IntestineFaces3::action;
  /// Action: the circumcenter of a tetrahedron yields to elements of dimension 1 that it encroaches
  /// upon, or where there are none, to patches and triangles of faces.
  Proposal3 action(SolidView& view, const CellRef& t) const {
    const Proposal3 proposal = quality.action(view, t);
    return proposal.kind == ProposalKind::kYield ? yielded_unless_protected(view, proposal.at)
                                                 : proposal;
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_INTESTINE3_H_
