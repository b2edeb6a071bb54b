#include "quality/context.h"
#include "quality/triangle_measure.h"

namespace circumball {

/// Chew's algorithm promises 30 degrees. The smallest angle is opposite to the shortest edge, and
/// its sine is half of shortest edge / circumradius: 30 degrees is a radius-edge ratio of 1, which
/// needs no libm.
Check check_min_angle(const VerifyContext& context) {
  Check check;
  check.name = "min-angle";
  check.bound = 30;
  double worst = 0;
  std::size_t bad = 0, excused = 0;
  for (const auto& c : context.cells) {
    const TriangleMeasure m =
        measure_triangle(context.point(c[0]), context.point(c[1]), context.point(c[2]));
    const bool is_bad = m.radius_edge * (1 - 2 * m.error) > 1;
    if (is_bad && context.excused(c)) {
      ++excused;
      continue;
    }
    bad += is_bad;
    if (m.radius_edge > worst) {
      worst = m.radius_edge;
      check.worst = {c[0], c[1], c[2]};
    }
  }
  check.ok = bad == 0;
  check.detail = bad == 0 ? "every angle is at least 30 degrees"
                          : count_text(bad, "cell") + " with an angle below 30 degrees";
  if (!check.worst.empty()) {
    const auto& w = check.worst;
    const double angle =
        angles_degrees(context.point(w[0]), context.point(w[1]), context.point(w[2])).min;
    check.observed = angle;
    check.detail += "; the smallest is " + value_text(angle) + ", of cell " + vertices_text(w);
  }
  check.detail +=
      " (decided as circumradius / shortest edge <= 1, the rounding error of the measurement "
      "granted)";
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " below it excused as refused by Safety";
  return check;
}

}  // namespace circumball
