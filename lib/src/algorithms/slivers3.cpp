#include "algorithms/slivers3.h"

#include <algorithm>
#include <cmath>

#include "predicates/elementary.h"
#include "refinement/picking_region.h"

namespace circumball {
namespace {

double degrees_of(double cosine) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return elementary::atan2(sine, cosine) * (180 / elementary::kPi);
}

}  // namespace

Verdict Slivers3::unacceptable(const SolidView& view, const CellRef& c) const {
  if (!view.in_domain(c) || view.is_in_intestine(c)) return {};
  const double least = view.least_dihedral_cosine(c);
  if (!(least > cosine)) return {};
  return {Reason::kSliver, VertexId(), view.measure([&] { return degrees_of(least); })};
}

/// By how many the insertion of p, just looked at, would lower the number of slivers; `least` or
/// less if it would by no more than that, or would lose anything else.
int Slivers3::gain(const SolidView& view, const Point3& p, int least) const {
  if (min_edge > 0 && view.insertion_radius(p) < min_edge) return least;
  int balance = 0;
  bool inside = false;
  view.for_each_dying([&](const CellRef& dead) {
    inside = inside || view.is_in_intestine(dead);
    balance += view.in_domain(dead) && view.least_dihedral_cosine(dead) > cosine;
  });
  // Spheres and tubes, and what is in them, stay what they are.
  if (inside) return least;
  view.for_each_in_star(
      [&](const CellRef& dead, const Point3& q, const Point3& r, const Point3& s) {
        if (!view.in_domain(dead)) return true;
        // The corners as a cell born has them, so that rounding makes no difference.
        balance -= least_dihedral_cosine(p, q, r, s) > cosine;
        if (balance > least && quality.too_bad(view, dead, tetrahedron_shape(p, q, r, s))) {
          balance = least;
        }
        return balance > least;
      });
  return balance;
}

Proposal3 Slivers3::action(SolidView& view, const CellRef& c) const {
  const TetrahedronShape shape = view.shape(c);
  if (!std::isfinite(shape.circumradius2)) return refuse(shape.circumcenter, Reason::kPrecision);
  // The birth of a cell is its number, and the same everywhere.
  PickingRegion region(shape.circumcenter, std::sqrt(shape.circumradius2), view.key(c));
  Proposal3 best = refuse(shape.circumcenter, Reason::kNoRoom);
  FaceTriangle of_best;
  int most = 0;
  for (int k = 0, enough = 0; k < kTries && enough < kEnough; ++k) {
    // The nearer to the circumcenter, the farther from all vertices.
    Point3 p = region.next(0.95 * k / kTries);
    FaceTriangle t;
    switch (view.look(p, c)) {
      case Outlook3::kFree:
        if (!view.cavity_is_in_one_part(c)) continue;
        break;
      case Outlook3::kEncroaches:
        t = view.triangle_in_the_way();
        if (t.face == kNone) continue;
        p = view.projection(p, t.face);
        if (view.look_in_face(p, t) != Outlook3::kFree) continue;
        break;
      default:
        continue;
    }
    const int better = gain(view, p, most);
    if (better > most) {
      most = better;
      best = insert(p, Reason::kPicked);
      of_best = t;
      if (t.face != kNone) best.feature = {FeatureKind::kFace, t.face};
    } else if (most == 0) {
      best.reason = Reason::kNotImproved;
    }
    enough += most > 0;
  }
  if (most > 0) {  // its cavities are the last that were found
    of_best.face == kNone ? view.look(best.at, c) : view.look_in_face(best.at, of_best);
  }
  return best;
}

}  // namespace circumball
