#include <algorithm>
#include <cmath>

#include "quality/context.h"
#include "quality/protected_vertices.h"
#include "quality/triangle_measure.h"

namespace circumball {
/// Theorem 5.11, first half: any cell with RE(t) > tau lies in the disk B(q0, d) of an acute input
/// vertex q0. Such a cell has q0 as a corner, and its others on the circle.
Check check_intestine(const VerifyContext& context) {
  Check check;
  check.name = "intestine";
  const double tau = context.options.tau.value_or(0);
  const std::vector<double> protection = protection_distances(context);
  const auto disks = std::count_if(protection.begin(), protection.end(),
                                   [](double distance) { return distance > 0; });
  std::size_t allowed = 0, bad = 0, excused = 0;
  for (const auto& cell : context.cells) {
    const TriangleMeasure m =
        measure_triangle(context.point(cell[0]), context.point(cell[1]), context.point(cell[2]));
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    bool inside = false;
    for (unsigned i = 0; i < 3 && !inside; ++i) {
      const Point2 q0 = context.point(cell[i]);
      const double bound = protection[cell[i]] * (1 + kRoundedPosition) + context.rounding;
      const auto on_disk = [&](std::uint32_t v) {
        const Point2 p = context.point(v);
        const double x = p.x - q0.x, y = p.y - q0.y;
        return std::sqrt(x * x + y * y) <= bound;
      };
      inside = protection[cell[i]] > 0 && on_disk(cell[(i + 1) % 3]) && on_disk(cell[(i + 2) % 3]);
    }
    if (inside) {
      ++allowed;
    } else if (context.excused(cell)) {
      ++excused;
    } else if (bad++ == 0) {
      check.worst = {cell[0], cell[1], cell[2]};
    }
  }
  check.ok = bad == 0;
  check.bound = 0;
  check.observed = static_cast<double>(bad);
  check.detail = bad == 0 ? count_text(allowed, "cell") + " above tau, inside of " +
                                count_text(static_cast<std::size_t>(disks), "disk") +
                                " about acute input vertices (thesis, Theorem 5.11)"
                          : count_text(bad, "cell") +
                                " above tau outside of the protecting disks, the first is " +
                                vertices_text(check.worst);
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  return check;
}

/// Theorem 5.11, second half: no angle is larger than 180 degrees - 2 kappa. With sin(kappa) = 1 /
/// (2 tau) the cosine of that bound is 1 / (2 tau^2) - 1, which needs no libm.
Check check_max_angle(const VerifyContext& context) {
  Check check;
  check.name = "max-angle";
  const double tau = context.options.tau.value_or(0);
  const double least_cosine = 0.5 / (tau * tau) - 1;
  double worst = 2;
  std::size_t bad = 0, excused = 0;
  for (const auto& c : context.cells) {
    const TriangleMeasure m =
        measure_triangle(context.point(c[0]), context.point(c[1]), context.point(c[2]));
    // Opposite to the longest edge; differences of coordinates first, so that the error is that of
    // the measurement, and what rounding did to vertices on an arc.
    double cosine = 2;
    for (unsigned i = 0; i < 3; ++i) {
      const Point2 p = context.point(c[i]), q = context.point(c[(i + 1) % 3]),
                   r = context.point(c[(i + 2) % 3]);
      const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y;
      const double dot = ux * vx + uy * vy;
      cosine =
          std::min(cosine, dot / (std::sqrt(ux * ux + uy * uy) * std::sqrt(vx * vx + vy * vy)));
    }
    const bool is_bad = cosine < least_cosine - 2 * m.error;
    if (is_bad && context.excused(c)) {
      ++excused;
      continue;
    }
    bad += is_bad;
    if (cosine < worst) {
      worst = cosine;
      check.worst = {c[0], c[1], c[2]};
    }
  }
  check.ok = bad == 0;
  check.bound = degrees_of_cosine(least_cosine);
  check.detail =
      bad == 0 ? "no angle is larger than 180 degrees - 2 kappa = " + value_text(*check.bound) +
                     " (thesis, Theorem 5.11)"
               : count_text(bad, "cell") + " with an angle larger than " +
                     value_text(*check.bound) + " degrees";
  if (!check.worst.empty()) {
    check.observed = degrees_of_cosine(worst);
    check.detail += "; the largest is " + value_text(*check.observed) + ", of cell " +
                    vertices_text(check.worst);
  }
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  return check;
}

}  // namespace circumball
