#include <cmath>
#include <limits>
#include <string>

#include "circumball/feature_size.h"
#include "complex/box_tree.h"
#include "feature_size/nearest_neighbor.h"
#include "quality/context.h"

namespace circumball {
namespace {
/// One side of 1/2 lfs(q0) <= N(q0) <= sqrt 2 lfs(q0): the most that N / lfs, or the least, is.
Check check_side(const VerifyContext& context, bool upper) {
  Check check;
  check.name = upper ? "nearest-neighbor" : "nearest-neighbor-lower";
  const double bound = upper ? std::sqrt(2.0) : 0.5;
  check.bound = bound;
  const FeatureSizes sizes(context.complex, [&](const Feature& f) { return context.counts(f); });
  std::vector<Box2> boxes;
  std::vector<std::uint32_t> item_of_vertex(context.mesh.vertices.size(), kNoIndex);
  for (std::uint32_t v = 0; v < context.mesh.vertices.size(); ++v) {
    const Point2 p = context.point(v);
    if (!usable(p.x) || !usable(p.y)) continue;
    item_of_vertex[v] = static_cast<std::uint32_t>(boxes.size());
    boxes.push_back(Box2::of(p));
  }
  const BoxTree tree(std::move(boxes));
  double worst = upper ? 0 : std::numeric_limits<double>::infinity();
  std::size_t bad = 0, looked_at = 0;
  for (std::uint32_t i = 0; i < context.complex.vertices.size(); ++i) {
    const std::uint32_t v = context.mesh_vertex[i];
    if (!context.vertex_wanted[i] || v == kNoIndex || item_of_vertex[v] == kNoIndex) continue;
    ++looked_at;
    const Point2 q0 = context.point(v);
    const double n = nearest_neighbor(tree, q0, item_of_vertex[v]);
    const double lfs = sizes.local(q0).radius;
    if (std::isinf(lfs)) continue;  // no two disjoint features
    const double ratio = n / lfs;
    bad += upper ? n > bound * lfs * (1 + kRoundedPosition) + context.rounding
                 : n < bound * lfs * (1 - kRoundedPosition) - context.rounding;
    if (upper ? ratio > worst : ratio < worst) {
      worst = ratio;
      check.worst = {v};
    }
  }
  check.ok = bad == 0;
  if (!std::isinf(worst)) check.observed = worst;
  const std::string source = upper ? " (thesis, Theorems 2.3 and 3.3)" : " (thesis, Theorem 3.2)";
  check.detail = bad == 0
                     ? std::string(upper ? "N(q0) <= sqrt 2 lfs(q0)" : "1/2 lfs(q0) <= N(q0)") +
                           " at " + std::to_string(looked_at) + " input vertices" + source +
                           ", lfs from the input features by definition"
                     : std::string(upper ? "N(q0) > sqrt 2 lfs(q0)" : "N(q0) < 1/2 lfs(q0)") +
                           " at " + std::to_string(bad) + " of " + std::to_string(looked_at) +
                           " input vertices" + source;
  if (!check.worst.empty())
    check.detail += std::string(upper ? "; the largest" : "; the smallest") + " ratio is " +
                    value_text(worst) + ", at vertex " + vertices_text(check.worst);
  return check;
}

}  // namespace

Check check_nearest_neighbor(const VerifyContext& context) { return check_side(context, true); }
Check check_nearest_neighbor_lower(const VerifyContext& context) {
  return check_side(context, false);
}

}  // namespace circumball
