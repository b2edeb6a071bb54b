#include <algorithm>

#include "complex/planar_meetings.h"
#include "complex/validate_defects.h"

namespace circumball {
namespace {

using Segment = PlanarView::Segment;

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

std::string pair_text(std::uint32_t s, std::uint32_t t) {
  return "segments " + std::to_string(s) + " and " + std::to_string(t);
}

}  // namespace

void check_crossings(const PlanarView& view, const SweepResult& swept, std::size_t max,
                     std::vector<Defect>* defects) {
  DefectList on("vertex-on-segment", false, max), cross("segments-cross", false, max),
      overlap("segments-overlap", false, max);
  const auto tell_on = [&](std::uint32_t p, std::uint32_t i) {
    const std::uint32_t v = view.vertex[p], segment = view.segments[i].segment;
    if (!on.has_room()) return on.count_only();
    const Point3 at = xyz(view.points[p]);
    on.add({{FeatureKind::kVertex, v}, {FeatureKind::kSegment, segment}}, {at},
           "vertex " + std::to_string(v) + " at " + point_text(at) +
               " lies in the interior of segment " + std::to_string(segment) +
               ": split the segment there, or move the vertex");
  };
  const auto tell_meeting = [&](std::uint32_t i, std::uint32_t j, PlanarMeeting m) {
    const Segment &s = view.segments[i], &t = view.segments[j];
    DefectList& list = m == PlanarMeeting::kCross ? cross : overlap;
    if (!list.has_room()) return list.count_only();
    const std::uint32_t f = std::min(s.segment, t.segment), g = std::max(s.segment, t.segment);
    const std::vector<Feature> features = {{FeatureKind::kSegment, f}, {FeatureKind::kSegment, g}};
    if (m == PlanarMeeting::kCross) {
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
  };
  if (!find_meetings(view, swept, tell_on, tell_meeting)) {
    on.set_incomplete();
    cross.set_incomplete();
    overlap.set_incomplete();
  }
  on.append_to(defects, true);
  cross.append_to(defects, true);
  overlap.append_to(defects, true);
}

}  // namespace circumball
