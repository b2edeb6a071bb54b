#ifndef CIRCUMBALL_ALGORITHMS_RUPPERT3_H_
#define CIRCUMBALL_ALGORITHMS_RUPPERT3_H_

#include "refinement/solid_agenda.h"
#include "refinement/solid_view.h"

namespace circumball {

/// The part of Ruppert's algorithm in space that is about segments and faces alone: after it, the
/// tetrahedralization conforms. They have priority over tetrahedra, so that running this first
/// changes nothing; the domain is known afterwards.
struct Conform3 {
  static constexpr bool kTetrahedra = false;

  /// Unacceptability: a segment, or a Delaunay triangle of a face, is unacceptable if its diametral
  /// ball is not empty.
  Verdict unacceptable(const SolidView& view, SubsegmentId s) const { return view.encroachment(s); }
  Verdict unacceptable(const SolidView& view, const FaceTriangle& t) const {
    return view.is_in_face(t) ? view.encroachment(t) : Verdict{};
  }
  Verdict unacceptable(const SolidView&, const CellRef&) const { return {}; }
  Verdict encroached_by(const SolidView& view, SubsegmentId s, VertexId v) const {
    return view.encroached_by(s, v);
  }
  Verdict encroached_by(const SolidView& view, const FaceTriangle& t, VertexId v) const {
    return view.is_in_face(t) ? view.encroached_by(t, v) : Verdict{};
  }

  /// Safety: it is safe to split any simplex.
  template <class Simplex>
  Verdict safe(const SolidView&, const Simplex&) const {
    return {};
  }

  /// Action: a segment is split at its midpoint. The circumcenter of a triangle of a face is
  /// inserted, unless it encroaches upon segments, which are queued then. (It never lies outside of
  /// its face, but for rounding: thesis, Proposition 6.8.)
  Proposal3 action(const SolidView& view, SubsegmentId s) const {
    return insert(view.midpoint(s), Reason::kMidpoint);
  }
  Proposal3 action(SolidView& view, const FaceTriangle& t) const {
    const Point3 c = view.circumcenter(t);
    switch (view.look(c, t)) {
      case Outlook3::kEncroaches:
        return yield3(c);
      case Outlook3::kCoincides:
        return refuse(c, Reason::kPrecision);
      default:
        if (!view.circumcenter_is_in_face(t)) return refuse(c, Reason::kOutsideFace);
        return insert(c, Reason::kCircumcenter);
    }
  }
  Proposal3 action(const SolidView&, const CellRef&) const { return {}; }
};

/// Ruppert's algorithm in space: thesis 6.2.2, the algorithm that 6.2 protects; Shewchuk 1998.
///
/// Ends for input without acute angles and tau > 2; then the mesh conforms, and RE(t) <= tau.
/// `size` and the volume bounds of regions only add tetrahedra to split.
struct Ruppert3 : Conform3 {
  static constexpr bool kTetrahedra = true;

  double tau = 2.1;  ///< radius-edge threshold
  double size = 0;   ///< upper bound on the circumradius; 0: none

  using Conform3::unacceptable;
  /// Unacceptability: a tetrahedron is unacceptable if its radius-edge ratio is greater than tau.
  Verdict unacceptable(const SolidView& view, const CellRef& c) const {
    if (!view.in_domain(c)) return {};
    const TetrahedronShape shape = view.shape(c);
    const Verdict why = too_bad(view, c, shape);
    return why && view.is_flat(c, shape) ? Verdict{} : why;
  }
  Verdict too_bad(const SolidView& view, const CellRef& c, const TetrahedronShape& shape) const {
    if (shape.radius_edge_exceeds(tau)) {
      return {Reason::kRadiusEdge, VertexId(),
              view.measure([&] { return std::sqrt(shape.circumradius2 / shape.shortest2); })};
    }
    if (size > 0 && shape.circumradius2 > size * size) {
      return {Reason::kSize, VertexId(), std::sqrt(shape.circumradius2)};
    }
    const double bound = view.volume_bound(c);
    if (bound > 0 && shape.volume6 > 6 * bound) {
      return {Reason::kRegionSize, VertexId(), shape.volume6 / 6};
    }
    return {};
  }

  using Conform3::action;
  /// Action: the circumcenter of a tetrahedron is inserted, unless it encroaches upon segments, or
  /// upon triangles of faces: these are queued then.
  Proposal3 action(SolidView& view, const CellRef& t) const {
    const Point3 c = view.shape(t).circumcenter;
    switch (view.look(c, t)) {
      case Outlook3::kFree:
        return insert(c, Reason::kCircumcenter);
      case Outlook3::kEncroaches:
        return yield3(c);
      case Outlook3::kOutside:
        return refuse(c, Reason::kOutsideDomain);
      case Outlook3::kCoincides:
        break;
    }
    return refuse(c, Reason::kPrecision);
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_RUPPERT3_H_
