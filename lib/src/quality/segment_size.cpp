#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/vectors.h"
#include "quality/context3.h"

// Theorems 4.1 and 4.2: the lengths of subsegments against the feature sizes of the input.
namespace circumball {
namespace {

/// The subsegments of a mesh: those that it lists, or the chains of edges along input segments.
std::vector<std::array<std::uint32_t, 2>> subsegments(const VerifyContext3& context) {
  std::vector<std::array<std::uint32_t, 2>> all;
  const std::size_t n = context.mesh.vertices.size();
  for (const MeshEdge& e : context.mesh.edges)
    if (e.a < n && e.b < n) all.push_back({e.a, e.b});
  if (!all.empty()) return all;
  const ChainFinder finder(context);
  for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
    if (!context.segment_wanted[s]) continue;
    const Chain chain = finder.find(s);
    for (std::size_t k = 0; k + 1 < chain.vertices.size(); ++k)
      all.push_back({chain.vertices[k], chain.vertices[k + 1]});
  }
  return all;
}

Check check_side(const VerifyContext3& context, bool upper) {
  Check check;
  check.name = upper ? "segment-upper" : "segment-lower";
  check.bound = 1;
  const FeatureSizes3 sizes(context.complex);
  std::size_t bad = 0, looked_at = 0;
  double worst = upper ? 0 : std::numeric_limits<double>::infinity();
  double worst_length = 0, worst_fs = 0, worst_lfs = 0;
  for (const auto& s : subsegments(context)) {
    const Point3 &a = context.point(s[0]), &b = context.point(s[1]);
    const double length = std::sqrt(dot(b - a, b - a));
    const double fs = sizes.of_subsegment(a, b, 1).radius, lfs = sizes.local(a, b, 2).radius;
    const double bound =
        upper ? std::min(std::sqrt(2.0) * fs, 5.0 / 3 * lfs) : std::min(fs / 16, lfs / 4);
    ++looked_at;
    if (std::isinf(bound)) continue;  // no two disjoint features
    bad += upper ? length > bound * (1 + kRoundedPosition) + context.rounding
                 : length < bound * (1 - kRoundedPosition) - context.rounding;
    const double ratio = length / bound;
    if (upper ? ratio > worst : ratio < worst) {
      worst = ratio;
      check.worst = {s[0], s[1]};
      worst_length = length;
      worst_fs = fs;
      worst_lfs = lfs;
    }
  }
  check.ok = bad == 0;
  if (!std::isinf(worst)) check.observed = worst;
  const std::string claim =
      upper ? "|s| <= min(sqrt 2 fs_1(s), 5/3 lfs(s))" : "min(fs_1(s) / 16, lfs(s) / 4) <= |s|";
  const std::string source = upper ? " (thesis, Theorem 4.2)" : " (thesis, Theorem 4.1)";
  check.detail = bad == 0 ? claim + " for " + count_text(looked_at, "subsegment") + source +
                                ", feature sizes from the input features by definition"
                          : claim + " fails for " + std::to_string(bad) + " of " +
                                count_text(looked_at, "subsegment") + source;
  if (!check.worst.empty())
    check.detail += std::string(upper ? "; the largest" : "; the smallest") +
                    " ratio of the two sides is " + value_text(worst) + ", at " +
                    vertices_text(check.worst) + ": |s| = " + value_text(worst_length) +
                    ", fs_1 = " + value_text(worst_fs) + ", lfs = " + value_text(worst_lfs);
  return check;
}

}  // namespace

Check check_segment_lower(const VerifyContext3& context) { return check_side(context, false); }
Check check_segment_upper(const VerifyContext3& context) { return check_side(context, true); }

}  // namespace circumball
