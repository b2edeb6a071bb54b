#include "sizing/sizing.h"

#include "quality/context.h"
#include "quality/triangle_measure.h"

namespace circumball {

/// The upper side of Theorem 7.13, for whichever algorithm was given a sizing function: R_t <= inf
/// of h over t. A cell fails only for a point of it where h is smaller for sure.
Check check_sizing(const VerifyContext& context) {
  Check check;
  check.name = "sizing";
  check.bound = 1;
  Sizing h;
  std::string error;
  if (!Sizing::parse(context.options.sizing, &h, &error)) {
    check.detail = "the sizing function cannot be read: " + error;
    return check;
  }
  std::size_t bad = 0, unclear = 0, excused = 0;
  double worst = 0;
  for (const auto& c : context.cells) {
    const Point2 p[3] = {context.point(c[0]), context.point(c[1]), context.point(c[2])};
    const TriangleMeasure m = measure_triangle(p[0], p[1], p[2]);
    // What two measurements may differ by is granted: the mesher's, and this one.
    const double radius = m.circumradius * (1 - 2 * m.error);
    const Sizing::Infimum infimum = h.compare_over_triangle(radius, p[0], p[1], p[2]);
    if (infimum == Sizing::Infimum::kBelow && context.excused(c)) {
      ++excused;
      continue;
    }
    bad += infimum == Sizing::Infimum::kBelow;
    unclear += infimum == Sizing::Infimum::kUnclear;
    double least = h.at((p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3);
    for (const Point2& corner : p) {
      const double here = h.at(corner.x, corner.y);
      if (here < least) least = here;
    }
    const double ratio = m.circumradius / least;
    if (infimum == Sizing::Infimum::kBelow ? bad == 1 || ratio > worst
                                           : bad == 0 && ratio > worst) {
      worst = ratio;
      check.worst = {c[0], c[1], c[2]};
    }
  }
  check.ok = bad == 0;
  check.observed = worst;
  check.detail =
      bad == 0 ? "no circumradius exceeds the infimum of the sizing function over its cell, by "
                 "certain bounds (thesis, Theorem 7.13)"
               : count_text(bad, "cell") +
                     " with a circumradius above the sizing function at one of its points";
  if (!check.worst.empty()) {
    check.detail += "; the largest R / h at corners and centroid is " + value_text(worst) +
                    ", of cell " + vertices_text(check.worst);
  }
  if (unclear > 0) {
    check.detail += "; of " + count_text(unclear, "cell") + " 256 boxes could not decide it";
  }
  if (excused > 0) {
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  }
  return check;
}

}  // namespace circumball
