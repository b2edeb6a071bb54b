#include "complex/planar_arrangement.h"

#include <algorithm>

#include "circumball/predicates.h"
#include "complex/product_sum.h"

namespace circumball {

PlanarStars::PlanarStars(const PlanarView& view) {
  const std::uint32_t n = static_cast<std::uint32_t>(view.segments.size());
  first.assign(view.points.size() + 1, 0);
  for (const auto& s : view.segments) ++first[s.lo + 1], ++first[s.hi + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  outgoing.resize(std::size_t{2} * n);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t s = 0; s < n; ++s) {
    outgoing[next[view.segments[s].lo]++] = 2 * s;
    outgoing[next[view.segments[s].hi]++] = 2 * s + 1;
  }
  const auto target = [&](std::uint32_t h) -> const Point2& {
    return view.points[h & 1 ? view.segments[h / 2].lo : view.segments[h / 2].hi];
  };
  for (std::uint32_t p = 0; p < view.points.size(); ++p) {
    std::sort(outgoing.begin() + first[p], outgoing.begin() + first[p + 1],
              [&](std::uint32_t a, std::uint32_t b) {
                if ((a & 1) != (b & 1)) return (a & 1) == 0;  // the right half-plane comes first
                const Sign t = orient2d(view.points[p], target(a), target(b));
                return t != Sign::kZero ? t == Sign::kPositive : a < b;
              });
  }
}

PlanarArrangement::PlanarArrangement(const PlanarView& view, const SweepResult& swept)
    : stars_(view), below_(swept.below), through_(swept.through) {
  trace_loops(view);
  nest_components(view, swept);
  find_levels(view);
}

void PlanarArrangement::trace_loops(const PlanarView& view) {
  const std::uint32_t half_edges = static_cast<std::uint32_t>(2 * view.segments.size());
  std::vector<std::uint32_t> next(half_edges);
  for (std::uint32_t p = 0; p < view.points.size(); ++p) {
    const std::uint32_t first = stars_.first[p], last = stars_.first[p + 1];
    for (std::uint32_t k = first; k < last; ++k)  // turn clockwise at p: the face stays on the left
      next[stars_.outgoing[k] ^ 1] = stars_.outgoing[k > first ? k - 1 : last - 1];
  }
  loop_.assign(half_edges, kNoIndex);
  for (std::uint32_t start = 0; start < half_edges; ++start) {
    if (loop_[start] != kNoIndex) continue;
    const std::uint32_t loop = static_cast<std::uint32_t>(loop_area_.size());
    ProductSum twice;
    for (std::uint32_t h = start; loop_[h] == kNoIndex; h = next[h]) {
      loop_[h] = loop;
      const auto& s = view.segments[h / 2];
      const Point2& a = view.points[h & 1 ? s.hi : s.lo];
      const Point2& b = view.points[h & 1 ? s.lo : s.hi];
      twice.add_cross(a.x, a.y, b.x, b.y);
    }
    loop_area_.push_back(0.5 * twice.value());
  }
}

void PlanarArrangement::nest_components(const PlanarView& view, const SweepResult& swept) {
  // The outermost loop of a connected component passes its lexicographically least point, where it
  // has the direction to the left in its wedge: it leaves along the last half-edge, and lies in the
  // face above `below`.
  std::vector<std::uint8_t> reached(view.points.size(), 0);
  struct Outer {
    std::uint32_t loop, point;
  };
  std::vector<Outer> outers;
  std::vector<std::uint8_t> is_outer(loop_area_.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t p = 0; p < view.points.size(); ++p) {
    if (reached[p] || stars_.first[p] == stars_.first[p + 1]) continue;
    const std::uint32_t loop = loop_[stars_.outgoing[stars_.first[p + 1] - 1]];
    outers.push_back({loop, p});
    is_outer[loop] = 1;
    reached[p] = 1;
    stack.assign(1, p);
    while (!stack.empty()) {
      const std::uint32_t q = stack.back();
      stack.pop_back();
      for (std::uint32_t k = stars_.first[q]; k < stars_.first[q + 1]; ++k) {
        const std::uint32_t h = stars_.outgoing[k];
        const std::uint32_t r = h & 1 ? view.segments[h / 2].lo : view.segments[h / 2].hi;
        if (reached[r]) continue;
        reached[r] = 1;
        stack.push_back(r);
      }
    }
  }
  face_of_loop_.assign(loop_area_.size(), kNoIndex);
  area_.assign(1, 0);
  for (std::uint32_t loop = 0; loop < loop_area_.size(); ++loop) {
    if (is_outer[loop]) continue;
    face_of_loop_[loop] = static_cast<std::uint32_t>(area_.size());
    area_.push_back(loop_area_[loop]);
  }
  for (const Outer& o : outers) {  // in the order of their least points: what lies below is settled
    const std::uint32_t below = swept.below[o.point];
    const std::uint32_t face = below == kNoIndex ? kUnbounded : face_of_loop_[loop_[2 * below]];
    face_of_loop_[o.loop] = face;
    area_[face] += loop_area_[o.loop];  // negative
  }
}

void PlanarArrangement::find_levels(const PlanarView& view) {
  const std::uint32_t n = static_cast<std::uint32_t>(view.segments.size());
  std::vector<std::uint32_t> first(area_.size() + 1, 0), across(std::size_t{2} * n);
  for (std::uint32_t h = 0; h < 2 * n; ++h) ++first[left_face(h) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t h = 0; h < 2 * n; ++h) across[next[left_face(h)]++] = left_face(h ^ 1);
  level_.assign(area_.size(), kNoIndex);
  level_[kUnbounded] = 0;
  std::vector<std::uint32_t> queue(1, kUnbounded);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t f = queue[head];
    for (std::uint32_t k = first[f]; k < first[f + 1]; ++k) {
      if (level_[across[k]] != kNoIndex) continue;
      level_[across[k]] = level_[f] + 1;
      queue.push_back(across[k]);
    }
  }
}

std::uint32_t PlanarArrangement::face_of_point(std::uint32_t p) const {
  if (stars_.first[p] != stars_.first[p + 1] || through_[p] != kNoIndex) return kNoIndex;
  return below_[p] == kNoIndex ? kUnbounded : left_face(2 * below_[p]);
}

std::vector<bool> PlanarArrangement::inside(const Complex& complex, const PlanarView& view) const {
  HoleRule rule = complex.hole_rule;
  if (rule == HoleRule::kAuto)
    rule = complex.holes.empty() && complex.regions.empty() ? HoleRule::kParity : HoleRule::kSeeds;
  std::vector<bool> in(face_count());
  for (std::uint32_t f = 0; f < in.size(); ++f)
    in[f] = rule == HoleRule::kParity ? level_[f] % 2 == 1 : level_[f] >= 1;
  if (rule == HoleRule::kSeeds) {
    for (std::size_t i = 0; i < complex.holes.size() && i < view.point_of_seed.size(); ++i) {
      if (view.point_of_seed[i] == kNoIndex) continue;
      const std::uint32_t face = face_of_point(view.point_of_seed[i]);
      if (face != kNoIndex) in[face] = false;
    }
  }
  return in;
}

}  // namespace circumball
