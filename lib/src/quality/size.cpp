#include "quality/context.h"
#include "quality/triangle_measure.h"

namespace circumball {

Check check_size(const VerifyContext& context) {
  Check check;
  check.name = "size";
  const double size = context.options.size.value_or(0);
  check.bound = size;
  double worst = 0;
  std::size_t bad = 0, excused = 0;
  for (const auto& c : context.cells) {
    const TriangleMeasure m =
        measure_triangle(context.point(c[0]), context.point(c[1]), context.point(c[2]));
    const bool is_bad = m.circumradius * (1 - 2 * m.error) > size;
    if (is_bad && context.excused(c)) {
      ++excused;
      continue;
    }
    bad += is_bad;
    if (m.circumradius > worst) {
      worst = m.circumradius;
      check.worst = {c[0], c[1], c[2]};
    }
  }
  check.ok = bad == 0;
  check.observed = worst;
  check.detail = bad == 0
                     ? "every circumradius is at most " + value_text(size)
                     : count_text(bad, "cell") + " with a circumradius above " + value_text(size);
  if (!check.worst.empty())
    check.detail +=
        "; the largest is " + value_text(worst) + ", of cell " + vertices_text(check.worst);
  check.detail += " (the rounding error of the measurement granted)";
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  return check;
}

}  // namespace circumball
