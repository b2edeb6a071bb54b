#include <vector>

#include "quality/context3.h"
#include "quality/surfaces3.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {

/// Theorems 6.14 and 6.15, of quality: outside of spheres and tubes, RE(t) <= tau, without
/// exception; and the surface between is a union of facets, each with its corners on one sphere or
/// tube.
Check check_intestine(const VerifyContext3& context) {
  Check check;
  check.name = "intestine";
  check.bound = 0;
  const double tau = context.options.tau.value_or(0);
  const Surfaces3 surfaces(context);
  std::vector<std::uint8_t> inside(context.cells.size(), 0);
  for (std::uint32_t i = 0; i < context.cells.size(); ++i)
    inside[i] = surfaces.holds(context.cells[i]);
  std::size_t within = 0, allowed = 0, bad = 0, excused = 0, torn = 0, facets = 0;
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    const auto& c = context.cells[i];
    within += inside[i];
    const TetrahedronMeasure m = measure_tetrahedron(context.point(c[0]), context.point(c[1]),
                                                     context.point(c[2]), context.point(c[3]));
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    if (inside[i]) {
      ++allowed;
    } else if (context.beyond_hull(c)) {
      ++excused;
    } else if (bad++ == 0) {
      check.worst = {c[0], c[1], c[2], c[3]};
    }
  }
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    const std::uint32_t t = context.twin[f];
    if (t == kNoIndex || !inside[f / 4] || inside[t / 4]) continue;
    ++facets;
    const auto corners = context.corners(f);
    if (!surfaces.on_one_surface(corners) && torn++ == 0 && bad == 0) {
      check.worst = {corners[0], corners[1], corners[2]};
    }
  }
  check.ok = bad + torn == 0;
  check.observed = static_cast<double>(bad + torn);
  if (bad > 0) {
    check.detail = count_text(bad, "cell") +
                   " above tau outside of spheres and tubes, the first is " +
                   vertices_text(check.worst);
  } else if (torn > 0) {
    check.detail = count_text(torn, "facet") +
                   " between inside and outside with corners on more than one surface, the first "
                   "is " +
                   vertices_text(check.worst);
  } else {
    check.detail = "of " + count_text(within, "cell") + " inside of " +
                   count_text(surfaces.spheres(), "sphere") + " and " +
                   count_text(surfaces.tubes(), "tube") + " " + std::to_string(allowed) +
                   " above tau, of the others none (thesis, Theorems 6.14 and 6.15); " +
                   count_text(facets, "facet") + " between, each on one sphere or tube";
  }
  if (excused > 0)
    check.detail +=
        "; " + count_text(excused, "cell") + " above it with a circumcenter outside of the hull";
  return check;
}

}  // namespace circumball
