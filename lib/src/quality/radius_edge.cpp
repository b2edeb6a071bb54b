#include "quality/context.h"
#include "quality/context3.h"
#include "quality/tetrahedron_measure.h"
#include "quality/triangle_measure.h"

namespace circumball {

namespace {

TriangleMeasure measure_cell(const VerifyContext& context, const VerifyContext::Cell& c) {
  return measure_triangle(context.point(c[0]), context.point(c[1]), context.point(c[2]));
}
TetrahedronMeasure measure_cell(const VerifyContext3& context, const VerifyContext3::Cell& c) {
  return measure_tetrahedron(context.point(c[0]), context.point(c[1]), context.point(c[2]),
                             context.point(c[3]));
}

}  // namespace

template <class Context>
Check check_radius_edge(const Context& context) {
  Check check;
  check.name = "radius-edge";
  const double tau = context.options.tau.value_or(0);
  check.bound = tau;
  double worst = 0, error = 0;
  std::size_t bad = 0, excused = 0;
  bool worst_bad = false;
  for (const auto& c : context.cells) {
    const auto m = measure_cell(context, c);
    // Beyond tau for sure, or within the error of two measurements: the mesher's that let it pass,
    // and this one.
    const bool is_bad = m.radius_edge * (1 - 2 * m.error) > tau;
    if (is_bad && context.excused(c)) {
      ++excused;
      continue;
    }
    bad += is_bad;
    error = m.error > error ? m.error : error;
    if (m.radius_edge > worst || (is_bad && !worst_bad)) {
      worst = m.radius_edge;
      worst_bad = is_bad;
      check.worst.assign(c.begin(), c.end());
    }
  }
  check.ok = bad == 0;
  check.observed = worst;
  check.detail =
      bad == 0
          ? "circumradius / shortest edge of every cell is at most " + value_text(tau)
          : count_text(bad, "cell") + " with circumradius / shortest edge above " + value_text(tau);
  if (!check.worst.empty())
    check.detail +=
        "; the largest is " + value_text(worst) + ", of cell " + vertices_text(check.worst);
  check.detail +=
      " (relative rounding error of the measurements below " + value_text(2 * error) + ", granted)";
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  if (excused > 0 && context.options.domain == "hull") check.detail += " or layers of faces";
  return check;
}

template Check check_radius_edge(const VerifyContext&);
template Check check_radius_edge(const VerifyContext3&);

}  // namespace circumball
