#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "complex/validate_defects.h"

namespace circumball {
namespace {

/// Boxes looked at before the search is ended and the count becomes a lower bound: a few seconds.
/// Reached only by inputs with tens of millions of crossings, or with tens of thousands of suspects
/// that all span the whole input.
constexpr std::uint64_t kMaxWork = 50'000'000;

enum class Meeting { kNone, kCross, kOverlap };

using Segment = PlanarView::Segment;

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

/// The crossing point, rounded; within the box of s.
Point3 crossing_point(const PlanarView& view, const Segment& s, const Segment& t) {
  const Point2 &a = view.points[s.lo], &b = view.points[s.hi];
  const Point2 &c = view.points[t.lo], &d = view.points[t.hi];
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double wx = c.x - a.x, wy = c.y - a.y;
  const double den = ux * vy - uy * vx, num = wx * vy - wy * vx;
  double f = den != 0 ? num / den : 0.5;
  if (!(f >= 0)) f = 0;
  if (f > 1) f = 1;
  return {a.x + f * ux, a.y + f * uy, 0};
}

/// False only if the box is surely on one side of the line through a and b.
bool may_meet_line(const Box2& box, const Point2& a, const Point2& b) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double cx = 0.5 * box.lo_x + 0.5 * box.hi_x - a.x,
               cy = 0.5 * box.lo_y + 0.5 * box.hi_y - a.y;
  const double hx = 0.5 * box.hi_x - 0.5 * box.lo_x, hy = 0.5 * box.hi_y - 0.5 * box.lo_y;
  const double side = std::fabs(ux * cy - uy * cx);
  const double reach = std::fabs(ux) * hy + std::fabs(uy) * hx;
  // 2^-48 of the magnitudes that enter is far above the rounding of the few operations.
  const double slack =
      3.6e-15 * (std::fabs(ux) * (std::fabs(box.lo_y) + std::fabs(box.hi_y) + std::fabs(a.y)) +
                 std::fabs(uy) * (std::fabs(box.lo_x) + std::fabs(box.hi_x) + std::fabs(a.x)));
  return side <= reach + slack;
}

std::string pair_text(std::uint32_t s, std::uint32_t t) {
  return "segments " + std::to_string(s) + " and " + std::to_string(t);
}

}  // namespace

void check_crossings(const PlanarView& view, const SweepResult& swept, std::size_t max,
                     std::vector<Defect>* defects) {
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t i = 0; i < view.segments.size(); ++i)
    if (swept.suspect[i]) suspects.push_back(i);
  if (suspects.empty()) return;

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

  DefectList on("vertex-on-segment", false, max), cross("segments-cross", false, max),
      overlap("segments-overlap", false, max);
  std::uint64_t work = 0;
  for (const std::uint32_t i : suspects) {
    const Segment& s = view.segments[i];
    const Point2 &a = view.points[s.lo], &b = view.points[s.hi];
    const Box2 box = segment_tree.box(i);
    const auto enter = [&](const Box2& o) {
      ++work;
      return o.meets(box) && may_meet_line(o, a, b);
    };
    point_tree.query(enter, [&](std::uint32_t k) {
      const std::uint32_t p = points[k];
      if (p <= s.lo || p >= s.hi || orient2d(a, b, view.points[p]) != Sign::kZero) return true;
      const std::uint32_t v = view.vertex[p];
      if (!on.has_room()) {
        on.count_only();
        return true;
      }
      const Point3 at = xyz(view.points[p]);
      on.add({{FeatureKind::kVertex, v}, {FeatureKind::kSegment, s.segment}}, {at},
             "vertex " + std::to_string(v) + " at " + point_text(at) +
                 " lies in the interior of segment " + std::to_string(s.segment) +
                 ": split the segment there, or move the vertex");
      return true;
    });
    segment_tree.query(enter, [&](std::uint32_t j) {
      if (j == i || (swept.suspect[j] && j < i)) return true;  // a pair of suspects is told once
      const Segment& t = view.segments[j];
      const Meeting m = meeting(view, s, t);
      if (m == Meeting::kNone) return true;
      DefectList& list = m == Meeting::kCross ? cross : overlap;
      if (!list.has_room()) {
        list.count_only();
        return true;
      }
      const std::uint32_t f = std::min(s.segment, t.segment), g = std::max(s.segment, t.segment);
      const std::vector<Feature> features = {{FeatureKind::kSegment, f},
                                             {FeatureKind::kSegment, g}};
      if (m == Meeting::kCross) {
        const Point3 at = crossing_point(view, f == s.segment ? s : t, f == s.segment ? t : s);
        cross.add(features, {at},
                  pair_text(f, g) + " cross near " + point_text(at) +
                      ": add a vertex there and split both, or move one");
      } else {
        const Point3 p = xyz(view.points[std::max(s.lo, t.lo)]),
                     q = xyz(view.points[std::min(s.hi, t.hi)]);
        overlap.add(features, {p, q},
                    pair_text(f, g) + " overlap from " + point_text(p) + " to " + point_text(q) +
                        ": keep that piece in one of them only");
      }
      return true;
    });
    if (work > kMaxWork) {
      on.set_incomplete();
      cross.set_incomplete();
      overlap.set_incomplete();
      break;
    }
  }
  on.append_to(defects, true);
  cross.append_to(defects, true);
  overlap.append_to(defects, true);
}

}  // namespace circumball
