#include "algorithms/circles.h"

#include <vector>

#include "protection/circle.h"
#include "refinement/split_at.h"

namespace circumball {
namespace {

class DrawProtectingCircles final : public Stage {
 public:
  DrawProtectingCircles() : Stage("1d", "Draw the protecting circles") {}

  bool advance(Workspace& w, Budget& budget) override {
    const auto count = static_cast<std::uint32_t>(w.live.complex().vertices.size());
    for (; next_ < count; ++next_) {
      if (w.live.protection_distance(VertexId(next_)) == 0) continue;
      if (!budget.spend() || !w.within_limits()) return false;
      draw(w, VertexId(next_));
    }
    return true;
  }

 private:
  /// An arc-to-be: from the tip of an end segment counter-clockwise to that of the next.
  struct Sector {
    VertexId from, to;
  };

  void draw(Workspace& w, VertexId q0) {
    for (const Sector& sector : sectors(w.live, q0)) {
      const Delaunay2& dt = w.live.triangulation();
      const Point2 center = dt.point(q0), a = dt.point(sector.from), b = dt.point(sector.to);
      const double radius = w.live.protection_distance(q0);
      const std::vector<Point2> cuts = quarter_turns(center, radius, a, b);
      if (w.live.domain() == Domain::kHull && !stays_in_hull(w.live, q0, a, cuts, b)) continue;
      VertexId last = sector.from;
      for (const Point2& p : cuts) {
        const VertexId v = insert_free(w, p, q0, Reason::kCircle);
        if (!v.valid()) continue;  // the arc is longer then; it is split as soon as it matters
        w.live.create_arc(last, v, q0);
        last = v;
      }
      if (last != sector.to) w.live.create_arc(last, sector.to, q0);
    }
  }

  /// The sectors of the disk about q0 that are in the domain.
  std::vector<Sector> sectors(Live2& live, VertexId q0) const {
    const Delaunay2& dt = live.triangulation();
    std::vector<HalfEdge> ends;  // counter-clockwise
    dt.for_each_outgoing(q0, [&](HalfEdge h) {
      if (live.on_segment(h)) ends.push_back(h);
      return true;
    });
    std::vector<Sector> inside;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const SubsegmentId s(dt.tag(ends[i]));
      // Without room for a collar, in double precision, there is no disk.
      if (!live.subsegment(s).is_collar) return {};
      if (!live.in_domain(ends[i] / 4)) continue;
      inside.push_back({dt.target(ends[i]), dt.target(ends[(i + 1) % ends.size()])});
    }
    return inside;
  }

  /// Whether the arc from a to b lies in the convex hull of the vertices.
  static bool stays_in_hull(Live2& live, VertexId q0, const Point2& a,
                            const std::vector<Point2>& cuts, const Point2& b) {
    const Delaunay2& dt = live.triangulation();
    const auto inside = [&](const Point2& p) {
      return !dt.is_ghost(dt.locate(p, dt.triangle_of(q0)));
    };
    Point2 last = a;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      const Point2& p = i < cuts.size() ? cuts[i] : b;
      if (!inside(p) || !inside(tangent_corner(dt.point(q0), last, p))) return false;
      last = p;
    }
    return true;
  }

  std::uint32_t next_ = 0;
};

}  // namespace

std::unique_ptr<Stage> draw_protecting_circles() {
  return std::make_unique<DrawProtectingCircles>();
}

}  // namespace circumball
