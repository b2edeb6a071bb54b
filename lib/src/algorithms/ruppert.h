#ifndef CIRCUMBALL_ALGORITHMS_RUPPERT_H_
#define CIRCUMBALL_ALGORITHMS_RUPPERT_H_

#include <memory>

#include "refinement/queue.h"
#include "refinement/view.h"
#include "sizing/sizing.h"

namespace circumball {

/// The part of Ruppert's algorithm that is about subsegments alone: after it, the triangulation
/// conforms. Subsegments have priority over triangles, so that running this first changes nothing.
struct Conform {
  static constexpr bool kTriangles = false;
  static constexpr bool kLooksAtNeighbors = false;

  /// Priority: ties by birth.
  using Triangles = TrianglesByBirth;

  /// Unacceptability: a segment is unacceptable if it has a nonempty diametral disk.
  Verdict unacceptable(const View& view, SubsegmentId s) const { return view.encroachment(s); }
  Verdict unacceptable(const View&, TriangleRef) const { return {}; }
  Verdict encroaches(const View& view, SubsegmentId s, VertexId v) const {
    return view.encroached_by(s, v);
  }

  /// Safety: it is safe to split any simplex.
  Verdict safe(const View&, SubsegmentId) const { return {}; }
  Verdict safe(const View&, TriangleRef) const { return {}; }

  /// Action: a segment is split at its midpoint (the circumcenter of a segment).
  Proposal action(const View& view, SubsegmentId s) const {
    return insert(view.midpoint(s), Reason::kMidpoint);
  }
  Proposal action(const View&, TriangleRef) const { return {}; }
};

/// Ruppert's algorithm: thesis Algorithm 2.3 (and 2.1); Ruppert 1995.
///
/// Ends for input angles of 60 degrees and more and tau > sqrt 2; then the mesh conforms, RE(t) <=
/// tau, and it is graded to the local feature size (Theorems 2.2 and 2.3). `size` and the area
/// bounds of regions only add triangles to split: their circumcentres are farther from every vertex
/// than the bound asks for.
struct Ruppert : Conform {
  static constexpr bool kTriangles = true;

  double tau = 1.4145;                   ///< radius-edge threshold
  double size = 0;                       ///< upper bound on the circumradius; 0: none
  std::shared_ptr<const Sizing> sizing;  ///< the same, as a function of the place; null: none
  bool off_centers = false;              ///< Üngör's Steiner points instead of circumcenters

  /// Priority: segments are processed before triangles (the loop does it); triangles by birth.
  using Triangles = TrianglesByBirth;

  using Conform::unacceptable;
  /// Unacceptability: a triangle is unacceptable if its radius-edge ratio is greater than tau.
  Verdict unacceptable(const View& view, TriangleRef t) const {
    const TriangleShape shape = view.shape(t);
    if (shape.radius_edge_exceeds(tau)) {
      return {Reason::kRadiusEdge, VertexId(), view.measure([&] { return shape.radius_edge(); })};
    }
    return too_large(view, t, shape);
  }
  /// The bounds on size.
  Verdict too_large(const View& view, TriangleRef t, const TriangleShape& shape) const {
    if (size > 0 && shape.circumradius() > size) {
      return {Reason::kSize, VertexId(), shape.circumradius()};
    }
    if (sizing && view.exceeds(*sizing, t, shape)) {
      return {Reason::kSize, VertexId(), shape.circumradius()};
    }
    if (const double bound = view.area_bound(t); bound > 0 && shape.area() > bound) {
      return {Reason::kRegionSize, VertexId(), shape.area()};
    }
    return {};
  }

  using Conform::action;
  /// Action: if a triangle's circumcenter encroaches upon a segment, the encroached segment is
  /// added to the queue. Otherwise its circumcenter is inserted.
  ///
  /// With off-centers: where the off-center is nearer to the shortest edge than the circumcenter,
  /// and encroaches upon nothing, it is inserted; elsewhere all is as before, so that what yields
  /// and what is refused is still said of circumcenters (Theorem 5.7). It is no nearer than tau
  /// times the shortest edge to any vertex, like the circumcenter, which is what the proofs ask
  /// for. Triangles that are only too large get their circumcenters.
  Proposal action(View& view, TriangleRef t) const {
    if (off_centers && view.shape(t).circumcenter_is_beyond_off_center(tau)) {
      const Point2 o = view.off_center(t, tau);
      if (view.look_exactly(o, t) == Outlook::kFree) return insert(o, Reason::kOffCenter);
    }
    Point2 c = view.circumcenter(t);
    switch (view.look(c, t)) {
      case Outlook::kFree:
        return insert(c, Reason::kCircumcenter);
      case Outlook::kEncroaches:
        return yield_to_encroached(c);
      case Outlook::kOutside:
        return refuse(c, Reason::kOutsideDomain);
      case Outlook::kCoincides:
        break;
    }
    return refuse(c, Reason::kPrecision);
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_RUPPERT_H_
