#ifndef CIRCUMBALL_ALGORITHMS_CHEW_H_
#define CIRCUMBALL_ALGORITHMS_CHEW_H_

#include "refinement/queue.h"
#include "refinement/view.h"

namespace circumball {

/// Makes every subsegment an edge of the triangulation, and no more. Chew's algorithm keeps a
/// constrained Delaunay triangulation; ours is Delaunay, so what is no edge of it is bisected. On
/// input that suits the algorithm nothing is.
struct Recover {
  static constexpr bool kTriangles = false;
  static constexpr bool kLooksAtNeighbors = false;
  using Triangles = TrianglesByBirth;
  Verdict unacceptable(const View& view, SubsegmentId s) const { return view.missing(s); }
  Verdict unacceptable(const View&, TriangleRef) const { return {}; }
  Verdict encroaches(const View&, SubsegmentId, VertexId) const { return {}; }
  Verdict safe(const View&, SubsegmentId) const { return {}; }
  Verdict safe(const View&, TriangleRef) const { return {}; }
  Proposal action(const View& view, SubsegmentId s) const {
    return insert(view.midpoint(s), Reason::kMidpoint);
  }
  Proposal action(const View&, TriangleRef) const { return {}; }
};

/// Chew's first algorithm: thesis Algorithm 7.2; Chew 1989. The input segments are divided into
/// pieces between h and sqrt(3) h first.
///
/// Every vertex is inserted farther than h from all others, so it ends for every input. Where all
/// vertices and pieces were at least h apart to begin with, no edge is shorter than h and no
/// circumradius is larger: all angles are at least 30 degrees.
struct Chew : Recover {
  static constexpr bool kTriangles = true;

  double h = 1;  ///< bound on the circumradius

  /// Priority: triangles are prioritized by circumradius, larger circumradii are processed first.
  using Triangles = TrianglesByValue;

  using Recover::unacceptable;
  /// Unacceptability: a triangle is unacceptable if it has a circumradius larger than h.
  Verdict unacceptable(const View& view, TriangleRef t) const {
    const double radius = view.shape(t).circumradius();
    if (radius > h) return {Reason::kSize, VertexId(), radius};
    return {};
  }

  using Recover::action;
  /// Action: insert the circumcenter of a triangle. Where it lies outside the domain, or would take
  /// a subsegment out of the triangulation, the input does not suit the algorithm (its pieces are
  /// not as asked): refused.
  Proposal action(View& view, TriangleRef t) const {
    Point2 c = view.circumcenter(t);
    switch (view.look(c, t)) {
      case Outlook::kCoincides:
        return refuse(c, Reason::kPrecision);
      case Outlook::kOutside:
        return refuse(c, Reason::kOutsideDomain);
      case Outlook::kEncroaches:
        if (view.separates()) return refuse(c, Reason::kOutsideDomain);
        break;
      case Outlook::kFree:
        break;
    }
    return insert(c, Reason::kCircumcenter);
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_CHEW_H_
