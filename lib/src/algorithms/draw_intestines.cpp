#include "algorithms/draw_intestines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/protect3.h"
#include "predicates/elementary.h"
#include "refinement/split_at3.h"

namespace circumball {
namespace {

/// Heights of rings, in lengths of subsegments. At 1/2, as in the thesis, circumcenters of collar
/// triangles lie on the segment; above, each is on its face's side of it.
constexpr double kHeight = 0.6;

/// Cosine of 40 degrees: no seed is nearer to another vertex on its sphere.
constexpr double kNearSeed = 0.766044443118978;

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 plus(const Point3& a, double s, const Point3& d) {
  return {a.x + s * d.x, a.y + s * d.y, a.z + s * d.z};
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 unit(const Point3& a) {
  const double s = 1 / std::sqrt(dot(a, a));
  return {s * a.x, s * a.y, s * a.z};
}
double positive_angle(double y, double x) {
  const double angle = elementary::atan2(y, x);
  return angle < 0 ? angle + 2 * elementary::kPi : angle;
}

class DrawIntestines final : public Stage3 {
 public:
  explicit DrawIntestines(bool structured)
      : Stage3("2c", "Draw spheres and tubes"), structured_(structured) {}

  void begin(Workspace3& w) override {
    w.live.track_collars();
    w.live.begin_intestine(structured_);
    is_tip_.assign(w.live.triangulation().vertex_count(), false);
  }

  bool advance(Workspace3& w, Budget& budget) override {
    const auto& complex = w.live.complex();
    while (phase_ < 3) {
      const std::size_t count = phase_ == 0   ? complex.vertices.size()
                                : phase_ == 1 ? complex.segments.size()
                                              : complex.vertices.size();
      for (; next_ < count; ++next_) {
        if (!budget.spend() || !w.within_limits()) return false;
        ++w.iterations;
        if (phase_ == 0) begin_sphere(w, next_);
        if (phase_ == 1) draw_tube(w, next_);
        if (phase_ == 2) draw_circles(w, next_);
      }
      next_ = 0;
      ++phase_;
    }
    for (; next_ < complex.vertices.size(); ++next_) {
      if (!budget.spend() || !w.within_limits()) return false;
      sow(w, next_);
    }
    w.live.intestine().make_patches(w.live.triangulation(), is_tip_);
    w.recorder.patches_changed({}, w.live.intestine().take_born());
    return true;
  }

 private:
  /// A vertex of a tip's ring in a face: where an arc in that face ends.
  struct RingEnd {
    std::uint32_t vertex, segment, face;
    Point3 direction;
    VertexId at;
  };

  static const Point3& point(const Workspace3& w, VertexId v) {
    return w.live.triangulation().point(v);
  }

  /// Its radius is the length of the end segments, which are equal.
  void begin_sphere(Workspace3& w, std::uint32_t v) {
    Live3& live = w.live;
    const double radius = live.protection_radius(VertexId(v));
    if (!(radius > 0 && std::isfinite(radius))) return;
    for (const SubsegmentId s : live.subsegments_at(VertexId(v))) {
      const Subsegment& u = live.subsegment(s);
      if (live.is_input_vertex(u.a) && live.is_input_vertex(u.b)) return;  // a limit was reached
    }
    live.intestine().add_sphere(VertexId(v), radius);
    for (const SubsegmentId s : live.subsegments_at(VertexId(v))) {
      const Subsegment& u = live.subsegment(s);
      const VertexId tip = u.a == VertexId(v) ? u.b : u.a;
      live.intestine().add_to_sphere(v, tip);
      is_tip_[tip.value] = live.is_protected(u.segment);
    }
  }

  // --- tubes

  /// Directions of sides of faces at a segment, and of what fills the gaps.
  static std::vector<BaseDirection> bases(const Live3& live, std::uint32_t segment,
                                          const Point3& axis, const Point3& middle, double height) {
    std::vector<BaseDirection> list;
    for (const std::uint32_t f : live.incidence().faces_of_segment(segment)) {
      const FacePlane& plane = live.face(f).plane();
      const Point3 across = unit(cross(plane.normal(), axis));
      for (const double side : {1.0, -1.0}) {
        const Point3 d{side * across.x, side * across.y, side * across.z};
        if (plane.contains(plane.to_plane(plus(middle, height, d)))) list.push_back({d, f, 0});
      }
    }
    Point3 first;
    if (!list.empty()) {
      first = list[0].direction;
    } else {
      const double x = std::fabs(axis.x), y = std::fabs(axis.y), z = std::fabs(axis.z);
      const Point3 e = x <= y && x <= z ? Point3{1, 0, 0}
                       : y <= z         ? Point3{0, 1, 0}
                                        : Point3{0, 0, 1};
      first = unit(cross(axis, e));
      list.push_back({first, kNoIndex, 0});
    }
    const Point3 second = cross(axis, first);
    for (std::size_t i = 1; i < list.size(); ++i) {
      const Point3& d = list[i].direction;
      list[i].angle = positive_angle(dot(d, second), dot(d, first));
    }
    std::stable_sort(
        list.begin() + 1, list.end(),
        [](const BaseDirection& a, const BaseDirection& b) { return a.angle < b.angle; });
    fill_gaps(&list, first, second);
    return list;
  }

  void draw_tube(Workspace3& w, std::uint32_t segment) {
    Live3& live = w.live;
    Intestines& intestine = live.intestine();
    if (!live.is_protected(SegmentId(segment))) return;
    const std::vector<VertexId> v = vertices_on_segment(live, segment);
    const std::size_t last = v.size() - 1;
    // Fewer than three pieces, or an end without a sphere: a limit was reached.
    if (last < 3 || intestine.radius(v[0].value) == 0 || intestine.radius(v[last].value) == 0) {
      return;
    }
    const auto size = [&](std::size_t i) { return distance(point(w, v[i]), point(w, v[i + 1])); };
    Tube tube;
    tube.segment = segment;
    tube.origin = point(w, v[0]);
    tube.axis = unit(minus(point(w, v[last]), tube.origin));
    tube.bases = bases(live, segment, tube.axis, midpoint(point(w, v[1]), point(w, v[last - 1])),
                       kHeight * size(1));
    const std::uint32_t t = intestine.add_tube(tube);
    std::uint32_t before = kNoIndex;
    for (std::size_t i = 1; i < last; ++i) {
      Ring ring;
      ring.tube = t;
      ring.about = v[i];
      ring.center = point(w, v[i]);
      if (i == 1 || i + 1 == last) {
        // Where sphere and tube meet.
        const VertexId q0 = i == 1 ? v[0] : v[last];
        const double d = intestine.radius(q0.value);
        ring.radius = kHeight * (i == 1 ? size(1) : size(last - 2));
        const double along = std::sqrt(std::max(d * d - ring.radius * ring.radius, 0.0));
        ring.center = plus(point(w, q0), i == 1 ? along : -along, tube.axis);
        ring.sphere = q0.value;
      } else {
        ring.radius = kHeight * std::max(size(i - 1), size(i));
      }
      const std::uint32_t r = draw_ring(w, ring, before, v[i]);
      join(w, before, r);
      before = r;
    }
  }

  std::uint32_t draw_ring(Workspace3& w, const Ring& ring, std::uint32_t before, VertexId near) {
    Intestines& intestine = w.live.intestine();
    const std::uint32_t r = intestine.add_ring(ring, before);
    const auto& bases = intestine.tube_of(ring).bases;
    for (std::size_t k = 0; k < bases.size(); ++k) {
      const RingKey key = k * kRingGap;
      const std::uint32_t face = bases[k].face;
      const VertexId p =
          insert(w, face, intestine.place(ring, key), near, Reason::kRing, ring.about, VertexId());
      if (!p.valid()) continue;
      intestine.add_to_ring(r, key, p);
      if (ring.sphere == kNoIndex) continue;
      intestine.add_to_sphere(ring.sphere, p);
      if (face != kNoIndex) {
        ends_.push_back(
            {ring.sphere, intestine.tube_of(ring).segment, face, bases[k].direction, p});
      }
    }
    const auto& vertices = intestine.ring(r).vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      w.recorder.protection_began(w.live.create_ring_arc(
          vertices[i].vertex, vertices[(i + 1) % vertices.size()].vertex, r));
    }
    return r;
  }

  /// Collar segments between two rings, in the faces.
  static void join(Workspace3& w, std::uint32_t before, std::uint32_t r) {
    if (before == kNoIndex) return;
    Intestines& intestine = w.live.intestine();
    const auto& bases = intestine.tube_of(intestine.ring(r)).bases;
    for (std::size_t k = 0; k < bases.size(); ++k) {
      if (bases[k].face == kNoIndex && intestine.structured()) continue;
      const VertexId a = intestine.ring(before).at(k * kRingGap),
                     b = intestine.ring(r).at(k * kRingGap);
      if (!a.valid() || !b.valid()) continue;
      if (bases[k].face == kNoIndex) {
        w.live.create_generator(a, b, before);
        continue;
      }
      w.recorder.protection_began(w.live.create_collar_element(a, b, bases[k].face, VertexId()));
    }
  }

  /// A vertex in a face, or of space where `face` is none.
  VertexId insert(Workspace3& w, std::uint32_t face, const Point3& p, VertexId near, Reason why,
                  VertexId across, VertexId center) {
    Delaunay3& dt = w.live.triangulation();
    const Feature feature = face != kNoIndex ? Feature{FeatureKind::kFace, face}
                                             : Feature{FeatureKind::kFree, kNoIndex};
    if (dt.probe(p, dt.cell_of(near)) != Delaunay3::Probe::kOk ||
        !w.live.probe_faces(p, feature, near)) {
      ++w.refused;
      w.refusal_limit = Reason::kLimitPrecision;
      return VertexId();
    }
    const View3 view(w.live, w.recorder.on());
    return insert_vertex(w, view, w.recorder.insertion_on(why, across, center, feature), p,
                         feature);
  }

  // --- spheres

  /// Where the circle about an input vertex in one of its faces meets a segment, or the tube about
  /// it: arcs come in at one vertex, and leave at the other one.
  struct Crossing {
    double angle;
    VertexId in, out;
    double in_angle, out_angle;
  };

  void draw_circles(Workspace3& w, std::uint32_t v) {
    const double radius = w.live.intestine().radius(v);
    if (radius == 0) return;
    for (const std::uint32_t f : w.live.incidence().faces_of_vertex(v))
      draw_circle(w, v, f, radius);
  }

  void draw_circle(Workspace3& w, std::uint32_t v, std::uint32_t f, double radius) {
    const FacePlane& plane = w.live.face(f).plane();
    const Point2 center = plane.to_plane(point(w, VertexId(v)));
    const double turn = 2 * elementary::kPi;
    const auto angle_of = [&](VertexId p) {
      const Point2 q = plane.to_plane(point(w, p));
      return positive_angle(q.y - center.y, q.x - center.x);
    };
    std::vector<Crossing> crossings;
    for (const SubsegmentId s : w.live.subsegments_at(VertexId(v))) {
      const Subsegment& u = w.live.subsegment(s);
      if (!w.live.incidence().face_has_segment(f, u.segment.value)) continue;
      const VertexId tip = u.a == VertexId(v) ? u.b : u.a;
      Crossing c{angle_of(tip), tip, tip, 0, 0};
      c.in_angle = c.out_angle = c.angle;
      for (const RingEnd& e : ends_) {
        if (e.vertex != v || e.face != f || e.segment != u.segment.value) continue;
        const double at = angle_of(e.at);
        double ahead = at - c.angle;
        if (ahead < 0) ahead += turn;
        // Within 37 degrees, the angle that a ring is seen at.
        (ahead < turn / 2 ? c.out : c.in) = e.at;
        (ahead < turn / 2 ? c.out_angle : c.in_angle) = at;
      }
      crossings.push_back(c);
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.angle < b.angle; });
    const auto at = [&](double angle, double r) {
      return Point2{center.x + r * elementary::cos(angle), center.y + r * elementary::sin(angle)};
    };
    if (crossings.empty()) {
      if (!plane.contains(at(0, 0.5 * radius))) return;
      draw_arc(w, v, f, {}, {}, 0, turn, at, radius);
      return;
    }
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const Crossing &from = crossings[i], &to = crossings[(i + 1) % crossings.size()];
      double until = to.angle;
      if (i + 1 == crossings.size()) until += turn;
      if (!plane.contains(at(0.5 * (from.angle + until), 0.5 * radius))) continue;
      double length = to.in_angle - from.out_angle;
      while (length <= 0) length += turn;
      draw_arc(w, v, f, from.out, to.in, from.out_angle, length, at, radius);
    }
  }

  /// Arcs of at most 60 degrees from one vertex to another, or all the way around.
  template <class At>
  void draw_arc(Workspace3& w, std::uint32_t v, std::uint32_t f, VertexId from, VertexId to,
                double angle, double length, At at, double radius) {
    const FacePlane& plane = w.live.face(f).plane();
    const unsigned parts = parts_of_sixty_degrees(length);
    VertexId before = from, first = from;
    for (unsigned k = from.valid() ? 1 : 0; k < parts; ++k) {
      const VertexId near = before.valid() ? before : VertexId(v);
      const VertexId p = insert(w, f, plane.to_space(at(angle + length * k / parts, radius)), near,
                                Reason::kCircle, VertexId(), VertexId(v));
      if (!p.valid()) return;
      w.live.intestine().add_to_sphere(v, p);
      if (before.valid()) create_arc(w, before, p, f, v);
      if (!first.valid()) first = p;
      before = p;
    }
    create_arc(w, before, to.valid() ? to : first, f, v);
  }
  static void create_arc(Workspace3& w, VertexId a, VertexId b, std::uint32_t f, std::uint32_t v) {
    w.recorder.protection_began(w.live.create_collar_element(a, b, f, VertexId(v)));
  }

  /// Seeds: those of the 26 directions of a grid that are far from what is on the sphere. With them
  /// the center is well inside of the hull of its sphere.
  void sow(Workspace3& w, std::uint32_t v) {
    Intestines& intestine = w.live.intestine();
    const double radius = intestine.radius(v);
    if (radius == 0) return;
    for (const int ones : {1, 2, 3}) {
      for (int code = 0; code < 27; ++code) {
        const Point3 grid{double(code % 3 - 1), double(code / 3 % 3 - 1), double(code / 9 - 1)};
        if (dot(grid, grid) != ones) continue;
        const Point3 d = unit(grid);
        const Point3& q0 = point(w, VertexId(v));
        const auto& on = intestine.sphere_vertices(v);
        const bool near = std::any_of(on.begin(), on.end(), [&](VertexId u) {
          return dot(minus(point(w, u), q0), d) > kNearSeed * radius;
        });
        const Point3 p = plus(q0, radius, d);
        if (near || encroaches(w, v, p)) continue;
        const VertexId seed =
            insert(w, kNoIndex, p, VertexId(v), Reason::kSeed, VertexId(), VertexId(v));
        if (seed.valid()) intestine.add_to_sphere(v, seed);
      }
    }
  }

  /// Whether p is in the ball of an element of dimension 1 with an end on the sphere.
  static bool encroaches(const Workspace3& w, std::uint32_t v, const Point3& p) {
    for (const VertexId u : w.live.intestine().sphere_vertices(v)) {
      for (const SubsegmentId s : w.live.subsegments_at(u)) {
        const Subsegment& r = w.live.subsegment(s);
        if (in_diametral_ball_of_chord(point(w, r.a), point(w, r.b), p, 0)) return true;
      }
    }
    return false;
  }

  const bool structured_;
  int phase_ = 0;
  std::uint32_t next_ = 0;
  std::vector<bool> is_tip_;
  std::vector<RingEnd> ends_;
};

}  // namespace

std::unique_ptr<Stage3> draw_intestines(bool structured) {
  return std::make_unique<DrawIntestines>(structured);
}

}  // namespace circumball
