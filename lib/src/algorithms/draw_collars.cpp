#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithms/protect3.h"
#include "protection/segment_clearance.h"
#include "refinement/split_at3.h"

namespace circumball {
namespace {

Point2 minus(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
Point2 plus(const Point2& a, double s, const Point2& d) { return {a.x + s * d.x, a.y + s * d.y}; }
double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
Point2 unit(const Point2& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length};
}

class DrawCollars final : public Stage3 {
 public:
  explicit DrawCollars(double height)
      : Stage3("2c", "Draw collars in the faces"), height_(height) {}

  void begin(Workspace3& w) override {
    if (!w.live.protects_anything()) return;
    w.live.track_collars();
    clearance_.emplace(w.live.complex(), w.live.incidence());
    segments_in_.resize(w.live.face_count());
    for (std::uint32_t k = 0; k < w.live.complex().segments.size(); ++k) {
      for (const std::uint32_t f : w.live.incidence().faces_of_segment(k)) {
        segments_in_[f].push_back(k);
      }
    }
  }

  bool advance(Workspace3& w, Budget& budget) override {
    if (!w.live.protects_anything()) return true;
    for (; face_ < w.live.face_count(); ++face_) {
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      draw_in(w, face_);
    }
    return true;
  }

 private:
  /// A vertex on the circle about an input vertex, on one side of an end segment: that of rule 2,
  /// or where the segment is not protected, its tip.
  struct OnCircle {
    VertexId center;
    Point2 along;  // direction of the end segment, from the center
    double side;   // 1: to the left of it, -1: to the right
    VertexId vertex;
  };

  void draw_in(Workspace3& w, std::uint32_t f) {
    Live3& live = w.live;
    const FacePlane& plane = live.face(f).plane();
    on_circles_.clear();
    for (const std::uint32_t k : segments_in_[f]) {
      const auto& ends = live.complex().segments[k];
      if (live.is_protected(SegmentId(k))) {
        const std::vector<VertexId> v = vertices_on_segment(live, k);
        if (v.size() < 4) continue;
        std::vector<Point2> at;
        for (const VertexId q : v) at.push_back(plane.to_plane(live.triangulation().point(q)));
        const Point2 t = unit(minus(at.back(), at.front()));
        for (const double side : {1.0, -1.0}) draw_beside(w, f, v, at, t, side);
      } else {
        for (const std::uint32_t end : ends) find_tip(live, f, k, VertexId(end));
      }
    }
    std::stable_sort(on_circles_.begin(), on_circles_.end(),
                     [](const OnCircle& c, const OnCircle& d) { return c.center < d.center; });
    draw_circles(w, f);
  }

  /// The tip of a segment that is not protected, at a vertex that is: on the sides of it that are
  /// in the face.
  void find_tip(const Live3& live, std::uint32_t f, std::uint32_t segment, VertexId q0) {
    if (!live.is_protected(q0)) return;
    for (const SubsegmentId s : live.subsegments_at(q0)) {
      const Subsegment& u = live.subsegment(s);
      if (u.segment.value != segment || u.is_collar_element()) continue;
      const FacePlane& plane = live.face(f).plane();
      const VertexId tip = u.a == q0 ? u.b : u.a;
      if (live.is_input_vertex(tip)) return;  // rounding left no place for a tip
      const Point3 middle =
          midpoint(live.triangulation().point(q0), live.triangulation().point(tip));
      const double beside = 0.45 * clearance_->of(middle, middle, segment);
      const Point2 at = plane.to_plane(middle);
      const Point2 t = unit(minus(at, plane.to_plane(live.triangulation().point(q0))));
      for (const double side : {1.0, -1.0}) {
        if (!plane.contains(plus(at, beside * side, {-t.y, t.x}))) continue;
        on_circles_.push_back({q0, t, side, tip});
      }
    }
  }

  /// Rules 1 and 2, on one side of a segment, and the collar segments between.
  void draw_beside(Workspace3& w, std::uint32_t f, const std::vector<VertexId>& v,
                   const std::vector<Point2>& at, const Point2& t, double side) {
    const Point2 n{-side * t.y, side * t.x};
    const std::size_t last = v.size() - 1;
    const auto size = [&](std::size_t i) {
      const Point2 d = minus(at[i + 1], at[i]);
      return std::sqrt(dot(d, d));
    };
    std::vector<Point2> places;
    for (std::size_t i = 1; i < last; ++i) {
      if (i == 1 || i == last - 1) {
        const double d = i == 1 ? size(0) : size(last - 1);
        const double h = height_ * (i == 1 ? size(1) : size(last - 2));
        const double x = std::sqrt(std::max(d * d - h * h, 0.0));
        places.push_back(plus(plus(i == 1 ? at[0] : at[last], i == 1 ? x : -x, t), h, n));
      } else {
        places.push_back(plus(at[i], height_ * std::max(size(i - 1), size(i)), n));
      }
    }
    const FacePlane& plane = w.live.face(f).plane();
    if (!plane.contains(places[places.size() / 2])) return;
    VertexId before;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool first = i == 0, ends = first || i + 1 == places.size();
      const VertexId center = ends ? v[first ? 0 : last] : VertexId();
      const VertexId p = insert(w, f, places[i], v[i + 1], Reason::kCollar, center);
      if (p.valid() && before.valid()) create(w, before, p, f, VertexId());
      before = p;
      if (i == 0) on_circles_.push_back({v[0], t, side, p});
      if (i + 1 == places.size()) on_circles_.push_back({v[last], {-t.x, -t.y}, -side, p});
    }
  }

  /// `near` is a vertex of the face; `center` the input vertex whose circle it lies on, if any.
  VertexId insert(Workspace3& w, std::uint32_t f, const Point2& at, VertexId near, Reason why,
                  VertexId center) {
    const Point3 p = w.live.face(f).plane().to_space(at);
    Delaunay3& dt = w.live.triangulation();
    const Feature feature{FeatureKind::kFace, f};
    if (dt.probe(p, dt.cell_of(near)) != Delaunay3::Probe::kOk ||
        !w.live.probe_faces(p, feature, near)) {
      ++w.refused;
      w.refusal_limit = Reason::kLimitPrecision;
      return VertexId();
    }
    const View3 view(w.live, w.recorder.on());
    Event event = w.recorder.insertion(why);
    if (why == Reason::kCollar) event.simplex[0] = near.value;
    event.simplex[1] = center.value;
    event.simplex[3] = f;
    return insert_vertex(w, view, event, p, feature);
  }

  static void create(Workspace3& w, VertexId a, VertexId b, std::uint32_t f, VertexId center) {
    w.recorder.protection_began(w.live.create_collar_element(a, b, f, center));
  }

  /// Rule 3: arcs about input vertices, none longer than a quarter turn.
  void draw_circles(Workspace3& w, std::uint32_t f) {
    const FacePlane& plane = w.live.face(f).plane();
    const OnCircle* next = on_circles_.data();
    const OnCircle* const end = next + on_circles_.size();
    for (const std::uint32_t v : w.live.incidence().vertices_of_face(f)) {
      const VertexId q0(v);
      if (!w.live.is_protected(q0)) continue;
      const Point2 center = plane.to_plane(w.live.triangulation().point(q0));
      std::vector<OnCircle> left, right;
      while (next != end && next->center < q0) ++next;
      for (; next != end && next->center == q0; ++next) {
        if (next->vertex.valid()) (next->side > 0 ? left : right).push_back(*next);
      }
      // From the left side of each end segment to the right side of the next one,
      // counter-clockwise.
      for (const OnCircle& from : left) {
        const OnCircle* to = nullptr;
        for (const OnCircle& c : right) {
          if (to == nullptr || is_before(from.along, c.along, to->along)) to = &c;
        }
        if (to == nullptr) continue;
        draw_arc(w, f, q0, center, from.vertex, to->vertex);
      }
      if (left.empty() && right.empty()) draw_circle(w, f, q0, center);
    }
  }

  /// Whether, turning counter-clockwise from `from`, a comes before b. `from` itself comes last.
  static bool is_before(const Point2& from, const Point2& a, const Point2& b) {
    const auto half = [&](const Point2& d) {
      const double c = cross(from, d), scale = 1e-12;
      if (c > scale) return 0;
      if (c < -scale) return 2;
      return dot(from, d) < 0 ? 1 : 3;
    };
    if (half(a) != half(b)) return half(a) < half(b);
    return cross(a, b) > 0;
  }

  void draw_arc(Workspace3& w, std::uint32_t f, VertexId q0, const Point2& center, VertexId from,
                VertexId to) {
    const FacePlane& plane = w.live.face(f).plane();
    const Point2 a = minus(plane.to_plane(w.live.triangulation().point(from)), center);
    const Point2 b = minus(plane.to_plane(w.live.triangulation().point(to)), center);
    const double radius = std::sqrt(dot(a, a));
    if (from != to && cross(a, b) > 0 && dot(a, b) > -1e-9 * radius * radius) {
      return create(w, from, to, f, q0);
    }
    // Halved: along the mean of the ends, or opposite to it where they are more than half a turn
    // apart; a whole turn from a tip to itself, opposite to this.
    Point2 mean{a.x + b.x, a.y + b.y};
    const double size = std::sqrt(dot(mean, mean));
    if (from == to) {
      mean = {-a.x, -a.y};
    } else if (size < 1e-6 * radius) {
      mean = {-a.y, a.x};
    } else if (cross(a, b) < 0) {
      mean = {-mean.x, -mean.y};
    }
    const double scale = radius / std::sqrt(dot(mean, mean));
    const VertexId m = insert(w, f, plus(center, scale, mean), from, Reason::kCircle, q0);
    if (!m.valid()) return;
    draw_arc(w, f, q0, center, from, m);
    draw_arc(w, f, q0, center, m, to);
  }

  /// About a vertex inside of the face, where something else meets it: a segment, another face.
  void draw_circle(Workspace3& w, std::uint32_t f, VertexId q0, const Point2& center) {
    const double radius = w.live.protection_radius(q0);
    VertexId first, before, near = q0;
    for (const Point2& d : {Point2{1, 0}, Point2{0, 1}, Point2{-1, 0}, Point2{0, -1}}) {
      const VertexId p = insert(w, f, plus(center, radius, d), near, Reason::kCircle, q0);
      if (!p.valid()) return;
      if (before.valid()) create(w, before, p, f, q0);
      if (!first.valid()) first = p;
      before = near = p;
    }
    create(w, before, first, f, q0);
  }

  const double height_;
  std::uint32_t face_ = 0;
  std::vector<std::vector<std::uint32_t>> segments_in_;  // by face; ascending
  std::vector<OnCircle> on_circles_;
  std::optional<SegmentClearance> clearance_;
};

}  // namespace

std::unique_ptr<Stage3> draw_collars(double height) {
  return std::make_unique<DrawCollars>(height);
}

}  // namespace circumball
