#include <algorithm>
#include <cmath>

#include "complex/planar_sweep.h"
#include "quality/context3.h"
#include "quality/enclosed_parts.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {
namespace {

/// The box around the vertices of the complex: where the domain is `box`, it is the domain.
double volume_of_box(const Complex& complex) {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Point3& p : complex.vertices) {
    const double at[3] = {p.x, p.y, p.z};
    if (!usable(p.x) || !usable(p.y) || !usable(p.z)) continue;
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
}

bool is_valid(const Complex& complex) {
  const std::vector<Defect> defects = check(complex);
  return std::all_of(defects.begin(), defects.end(), [](const Defect& d) { return d.warning; });
}

}  // namespace

Check check_volume(const VerifyContext3& context) {
  Check check;
  check.name = "volume";
  Twofold six_volume, six_enclosed;
  double size = 0;  // of the terms
  for (const auto& c : context.cells) {
    const Twofold six = measure_tetrahedron(context.point(c[0]), context.point(c[1]),
                                            context.point(c[2]), context.point(c[3]))
                            .six_volume;
    six_volume = six_volume + six;
    size += std::fabs(six.high);
  }
  // The boundary's pyramids over one of its corners: what it encloses (divergence theorem).
  const Point3* top = nullptr;
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    if (context.twin[f] != kNoIndex) continue;
    const auto v = context.corners(f);
    if (top == nullptr) top = &context.point(v[0]);
    const Twofold six =
        measure_tetrahedron(context.point(v[0]), context.point(v[1]), context.point(v[2]), *top)
            .six_volume;
    six_enclosed = six_enclosed + six;
    size += std::fabs(six.high);
  }
  const bool box = context.options.domain == "box" && !context.complex.vertices.empty();
  const double volume = six_volume.high / 6;
  double expected = box ? volume_of_box(context.complex) : six_enclosed.high / 6;
  double tolerance = kAreaTolerance * std::max(std::fabs(expected), size / 6 * 1e-3);
  std::string what =
      box ? "the volume of the box, " : "the volume that the boundary of the mesh encloses, ";
  if (context.closed() && is_valid(context.complex)) {
    const EnclosedParts parts(context.complex);
    if (parts.known()) {
      expected = parts.volume();
      // Vertices of sloping faces are rounded.
      tolerance = kAreaTolerance * std::max(expected, size / 6 * 1e-3) +
                  2 * parts.area() * context.rounding;
      what = "the volume that the input's faces enclose, ";
    }
  }
  const double off =
      std::max(std::fabs(volume - expected), std::fabs((six_volume.high - six_enclosed.high) / 6));
  check.bound = expected;
  check.observed = volume;
  check.ok = off <= tolerance;
  check.detail = check.ok ? "the cells add up to " + what + value_text(expected)
                          : "the cells have a volume of " + value_text(volume) + ", not " + what +
                                value_text(expected) + ", off by " + value_text(off);
  return check;
}

}  // namespace circumball
