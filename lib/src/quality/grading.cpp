#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "circumball/feature_size.h"
#include "predicates/elementary.h"
#include "quality/context.h"
#include "quality/insertion_radius.h"

namespace circumball {
namespace {

/// The smallest angle between segments that count, in degrees.
double smallest_angle(const VerifyContext& context) {
  Complex wanted;
  wanted.vertices = context.complex.vertices;
  for (std::size_t s = 0; s < context.complex.segments.size(); ++s)
    if (context.counts({FeatureKind::kSegment, static_cast<std::uint32_t>(s)}))
      wanted.segments.push_back(context.complex.segments[s]);
  return smallest_angle_degrees(wanted);
}

}  // namespace

/// The constant C of lfs(q) <= C r_q over all Steiner vertices q (thesis, Theorems 2.2, 5.6 and
/// 5.10), as it is observed: the thesis gives no number to check. Where the input has an acute
/// angle alpha the proofs let C grow like 1 / sin(alpha), so C sin(alpha) is told, too.
///
/// Where a bound h on the circumradius was given, triangles are split above it, too: then it is
/// min(lfs(q), h) <= C r_q, which the same proof gives (h is Lipschitz, and r_q > h there). Sizes
/// that vary are not known here; they make C larger.
///
/// lfs is of the input, by the oracle. Vertices are numbered by birth, so r_q is the distance to
/// the nearest vertex of a lower number; where the numbers mean something else, so does C.
Check check_grading(const VerifyContext& context) {
  Check check;
  check.name = "grading";
  const FeatureSizes sizes(context.complex, [&](const Feature& f) { return context.counts(f); });
  std::vector<bool> given(context.mesh.vertices.size(), false);
  for (const std::uint32_t v : context.mesh_vertex)
    if (v != kNoIndex) given[v] = true;
  std::vector<Point2> points;
  std::vector<std::uint32_t> number;
  std::size_t bad = 0;
  for (std::uint32_t v = 0; v < context.mesh.vertices.size(); ++v) {
    const Point2 p = context.point(v);
    if (!usable(p.x) || !usable(p.y)) {
      ++bad;  // it has neither
      check.worst = {v};
      continue;
    }
    points.push_back(p);
    number.push_back(v);
  }
  const std::vector<double> radius = insertion_radii(points);
  const double size = context.options.size.value_or(0);
  const double largest = size > 0 ? size : std::numeric_limits<double>::infinity();
  double worst = 0;
  std::size_t looked_at = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (given[number[k]]) continue;
    const double lfs = sizes.local(points[k]).radius;
    if (std::isinf(lfs) || std::isinf(radius[k])) continue;  // no two disjoint features; the first
    ++looked_at;
    const double ratio = std::min(lfs, largest) / radius[k];
    if (!std::isfinite(ratio)) {
      ++bad;
      check.worst = {number[k]};
    } else if (ratio > worst) {
      worst = ratio;
      if (bad == 0) check.worst = {number[k]};
    }
  }
  check.ok = bad == 0;
  if (!check.ok) {
    check.detail = "lfs(q) / r_q is not a number at " + std::to_string(bad) +
                   " of the vertices, one of them is " + vertices_text(check.worst);
    return check;
  }
  if (looked_at == 0) {
    check.detail = "there is no Steiner vertex";
    return check;
  }
  check.observed = worst;
  check.detail = (size > 0 ? "min(lfs(q), " + value_text(size) + ")" : std::string("lfs(q)")) +
                 " <= C r_q with C = " + value_text(worst) + ", attained at vertex " +
                 vertices_text(check.worst) + ", over " + std::to_string(looked_at) +
                 (looked_at == 1 ? " Steiner vertex" : " Steiner vertices");
  const double alpha = smallest_angle(context);
  if (alpha < 90) {
    const double sine = elementary::sin(alpha * (elementary::kPi / 180));
    check.detail += "; C sin(alpha) = " + value_text(worst * sine) +
                    " for the smallest input angle alpha of " + value_text(alpha) + " degrees";
  }
  check.detail += "; observed, there is no bound to check (thesis, Theorems 2.2, 5.6 and 5.10)";
  return check;
}

}  // namespace circumball
