#include "complex/space_view.h"

#include <algorithm>

namespace circumball {

SpaceView::SpaceView(const Complex& complex) {
  const std::size_t n = complex.vertices.size();
  usable_vertex.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const Point3& p = complex.vertices[v];
    usable_vertex[v] = usable(p.x) && usable(p.y) && usable(p.z);
  }
  struct Ends {
    std::uint32_t lo, hi, segment;
  };
  std::vector<Ends> all;
  for (std::uint32_t i = 0; i < complex.segments.size(); ++i) {
    const auto& s = complex.segments[i];
    if (s[0] >= n || s[1] >= n || !usable_vertex[s[0]] || !usable_vertex[s[1]]) continue;
    if (complex.vertices[s[0]] == complex.vertices[s[1]]) continue;
    all.push_back({std::min(s[0], s[1]), std::max(s[0], s[1]), i});
  }
  std::sort(all.begin(), all.end(), [](const Ends& a, const Ends& b) {
    if (a.lo != b.lo) return a.lo < b.lo;
    if (a.hi != b.hi) return a.hi < b.hi;
    return a.segment < b.segment;
  });
  canonical.assign(complex.segments.size(), kNoIndex);
  first.assign(n + 1, 0);
  std::size_t kept = 0;
  for (const Ends& e : all) {
    if (kept > 0 && all[kept - 1].lo == e.lo && all[kept - 1].hi == e.hi) {
      canonical[e.segment] = all[kept - 1].segment;
      duplicate_segments.push_back({e.segment, all[kept - 1].segment});
      continue;
    }
    canonical[e.segment] = e.segment;
    segments.push_back(e.segment);
    ++first[e.lo + 1];
    ++first[e.hi + 1];
    all[kept++] = e;
  }
  all.resize(kept);
  for (std::size_t v = 0; v < n; ++v) first[v + 1] += first[v];
  star.resize(2 * kept);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  // Ends are in the order of (lo, hi): stars fill with lower neighbors first, both parts ascending.
  for (const Ends& e : all) star[next[e.hi]++] = {e.lo, e.segment};
  for (const Ends& e : all) star[next[e.lo]++] = {e.hi, e.segment};
  std::sort(segments.begin(), segments.end());
  std::sort(duplicate_segments.begin(), duplicate_segments.end());
}

std::uint32_t SpaceView::find(std::uint32_t a, std::uint32_t b) const {
  if (degree(b) < degree(a)) std::swap(a, b);
  const auto begin = star.begin() + first[a], end = star.begin() + first[a + 1];
  const auto at = std::lower_bound(
      begin, end, b, [](const Incident& i, std::uint32_t v) { return i.neighbor < v; });
  return at != end && at->neighbor == b ? at->segment : kNoIndex;
}

bool FaceSurface::has_member(std::uint32_t v) const {
  return std::binary_search(members.begin(), members.end(), v);
}

}  // namespace circumball
