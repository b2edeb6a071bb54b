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
  if (!view.in_domain(c)) return {};
  const double least = view.least_dihedral_cosine(c);
  if (!(least > cosine)) return {};
  return {Reason::kSliver, VertexId(), view.measure([&] { return degrees_of(least); })};
}

/// By how many the insertion of p, just looked at, would lower the number of slivers; `least` or
/// less if it would by no more than that, or would lose anything else.
int Slivers3::gain(SolidView& view, const CellRef& c, const Point3& p, int least) const {
  if (!view.cavity_is_in_one_part(c)) return least;
  if (min_edge > 0 && view.insertion_radius(p) < min_edge) return least;
  int balance = 0;
  view.for_each_dying(
      [&](const CellRef& dead) { balance += view.least_dihedral_cosine(dead) > cosine; });
  view.for_each_in_star([&](const Point3& q, const Point3& r, const Point3& s) {
    // The corners as a cell born has them, so that rounding makes no difference.
    balance -= least_dihedral_cosine(p, q, r, s) > cosine;
    if (balance > least && quality.too_bad(view, c, tetrahedron_shape(p, q, r, s))) balance = least;
    return balance > least;
  });
  return balance;
}

Proposal3 Slivers3::action(SolidView& view, const CellRef& c) const {
  const TetrahedronShape shape = view.shape(c);
  // The birth of a cell is its number, and the same everywhere.
  PickingRegion region(shape.circumcenter, std::sqrt(shape.circumradius2), view.key(c));
  Proposal3 best = refuse(shape.circumcenter, Reason::kNoRoom);
  int most = 0;
  for (int k = 0, enough = 0; k < kTries && enough < kEnough; ++k) {
    // The nearer to the circumcenter, the farther from all vertices.
    const Point3 p = region.next(0.95 * k / kTries);
    if (view.look(p, c) != Outlook3::kFree) continue;
    const int better = gain(view, c, p, most);
    if (better > most) {
      most = better;
      best = insert(p, Reason::kPicked);
    } else if (most == 0) {
      best.reason = Reason::kNotImproved;
    }
    enough += most > 0;
  }
  if (most > 0) view.look(best.at, c);  // its cavity is the last one found
  return best;
}

}  // namespace circumball
