#include "complex/planar_meetings.h"

#include <algorithm>

#include "circumball/predicates.h"
#include "complex/box_filters.h"

namespace circumball {
namespace {

/// Boxes looked at before the search is ended and the count becomes a lower bound: a few seconds.
/// Reached only by inputs with tens of millions of crossings, or with tens of thousands of suspects
/// that all span the whole input.
constexpr std::uint64_t kMaxWork = 50'000'000;

using Segment = PlanarView::Segment;
using Meeting = PlanarMeeting;

/// Exact. Touching at an end is no meeting: a vertex in an interior is told as such.
Meeting meeting(const PlanarView& view, const Segment& s, const Segment& t) {
  const Point2 &a = view.points[s.lo], &b = view.points[s.hi];
  const Point2 &c = view.points[t.lo], &d = view.points[t.hi];
  const int oc = static_cast<int>(orient2d(a, b, c)), od = static_cast<int>(orient2d(a, b, d));
  if (oc == 0 && od == 0)  // points are numbered lexicographically: intervals of numbers are
                           // intervals of the line
    return std::max(s.lo, t.lo) < std::min(s.hi, t.hi) ? Meeting::kOverlap : Meeting::kNone;
  if (oc * od >= 0) return Meeting::kNone;
  const int oa = static_cast<int>(orient2d(c, d, a)), ob = static_cast<int>(orient2d(c, d, b));
  return oa * ob < 0 ? Meeting::kCross : Meeting::kNone;
}

}  // namespace

bool find_meetings(const PlanarView& view, const SweepResult& swept,
                   const std::function<void(std::uint32_t, std::uint32_t)>& on,
                   const std::function<void(std::uint32_t, std::uint32_t, PlanarMeeting)>& meet) {
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t i = 0; i < view.segments.size(); ++i)
    if (swept.suspect[i]) suspects.push_back(i);
  if (suspects.empty()) return true;

  std::vector<Box2> segment_boxes, point_boxes;
  std::vector<std::uint32_t> points;
  for (const Segment& s : view.segments)
    segment_boxes.push_back(Box2::of(view.points[s.lo], view.points[s.hi]));
  for (std::uint32_t p = 0; p < view.points.size(); ++p) {
    if (view.vertex[p] == kNoIndex) continue;
    points.push_back(p);
    point_boxes.push_back(Box2::of(view.points[p]));
  }
  const BoxTree segment_tree(std::move(segment_boxes)), point_tree(std::move(point_boxes));

  std::uint64_t work = 0;
  for (const std::uint32_t i : suspects) {
    const Segment& s = view.segments[i];
    const Point2 &a = view.points[s.lo], &b = view.points[s.hi];
    const Box2 box = segment_tree.box(i);
    const LineFilter line = LineFilter::through(a.x, a.y, b.x, b.y);
    const auto enter = [&](const Box2& o) {
      ++work;
      return o.meets(box) && line.may_meet(o.lo_x, o.lo_y, o.hi_x, o.hi_y);
    };
    point_tree.query(enter, [&](std::uint32_t k) {
      const std::uint32_t p = points[k];
      if (p > s.lo && p < s.hi && orient2d(a, b, view.points[p]) == Sign::kZero) on(p, i);
      return true;
    });
    segment_tree.query(enter, [&](std::uint32_t j) {
      if (j == i || (swept.suspect[j] && j < i)) return true;  // a pair of suspects is told once
      const Meeting m = meeting(view, s, view.segments[j]);
      if (m != Meeting::kNone) meet(i, j, m);
      return true;
    });
    if (work > kMaxWork) return false;
  }
  return true;
}

}  // namespace circumball
