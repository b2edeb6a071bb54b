#include <algorithm>
#include <cmath>
#include <set>

#include "complex/box_filters.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

/// What is closer than this, relative to the diameter of the input, draws a warning, like
/// near-duplicate vertices (architecture.md, "Numbers").
constexpr double kNear = 1e-9;
/// Boxes looked at before the search is ended: seconds.
constexpr std::uint64_t kMaxWork = 400'000'000;

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 along(const Point3& a, const Point3& u, double f) {
  return {a.x + f * u.x, a.y + f * u.y, a.z + f * u.z};
}
double unit(double f) { return f < 0 ? 0 : f > 1 ? 1 : f; }
double length(const Point3& u) { return std::sqrt(dot(u, u)); }

double distance_to_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 u = minus(b, a);
  const double f = unit(dot(minus(p, a), u) / dot(u, u));
  return length(minus(p, along(a, u, f)));
}

/// Distance of two segments whose ends are not nearest to the other: of their lines.
double distance_of_lines(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                         Point3* at) {
  const Point3 u = minus(b, a), v = minus(d, c), w = minus(c, a);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double det = uu * vv - uv * uv;
  if (!(det > 0)) return length(w);
  const double f = unit((uw * vv - vw * uv) / det);
  const double g = unit((uw * uv - vw * uu) / det);
  *at = along(a, u, f);
  return length(minus(*at, along(c, v, g)));
}

class NearCheck {
 public:
  NearCheck(const Complex& complex, const SpaceView& view, const std::vector<FaceSurface>& surfaces,
            const SpaceMeetings& meetings, std::size_t max)
      : complex_(complex),
        view_(view),
        surfaces_(surfaces),
        meetings_(meetings),
        on_segment_("vertex-near-segment", true, max),
        in_face_("vertex-near-face", true, max),
        crossing_("segments-near", true, max) {}

  void run() {
    std::vector<Box3> boxes;
    for (std::uint32_t v = 0; v < complex_.vertices.size(); ++v) {
      if (!view_.usable_vertex[v]) continue;
      vertices_.push_back(v);
      boxes.push_back(Box3::of(point(v)));
    }
    if (boxes.empty()) return;
    Box3 all = boxes[0];
    for (const Box3& box : boxes) all.extend(box);
    limit_ = kNear * length({all.extent(0), all.extent(1), all.extent(2)});
    vertex_tree_ = BoxTree3(std::move(boxes));
    boxes.clear();
    for (const std::uint32_t s : view_.segments) boxes.push_back(Box3::of(end(s, 0), end(s, 1)));
    segment_tree_ = BoxTree3(std::move(boxes));
    for (std::uint32_t i = 0; i < view_.segments.size() && work_ < kMaxWork; ++i) look_near(i);
    for (std::uint32_t f = 0; f < surfaces_.size(); ++f)
      for (std::size_t k = 0; k < surfaces_[f].triangles.size() && work_ < kMaxWork; ++k)
        look_near(f, k);
  }
  void append_to(std::vector<Defect>* defects) {
    for (DefectList* list : {&on_segment_, &in_face_, &crossing_}) {
      if (work_ >= kMaxWork) list->set_incomplete();
      list->append_to(defects, true);
    }
  }

 private:
  const Point3& point(std::uint32_t v) const { return complex_.vertices[v]; }
  const Point3& end(std::uint32_t s, int i) const { return point(complex_.segments[s][i]); }
  bool near(const Point3& p, const Point3& q) const { return length(minus(p, q)) < limit_; }
  static std::string effect(double distance) {
    return " are only " + number_text(distance) +
           " apart without meeting: the mesh there is graded down to that length; ";
  }

  void look_near(std::uint32_t i) {
    const std::uint32_t s = view_.segments[i];
    const auto& ends = complex_.segments[s];
    const Point3 &a = end(s, 0), &b = end(s, 1);
    SegmentFilter filter(a, b);
    filter.grow(limit_);
    const auto enter = [&](const Box3& box) {
      ++work_;
      return filter.may_meet(box);
    };
    vertex_tree_.query(enter, [&](std::uint32_t k) {
      const std::uint32_t v = vertices_[k];
      const Point3& p = point(v);
      if (v == ends[0] || v == ends[1]) return true;
      const double distance = distance_to_segment(p, a, b);
      if (!(distance < limit_) || near(p, a) || near(p, b)) return true;
      if (meetings_.vertex_on_segment.count({v, s})) return true;
      on_segment_.add({{FeatureKind::kVertex, v}, {FeatureKind::kSegment, s}}, {p},
                      "vertex " + std::to_string(v) + " at " + point_text(p, 3) + " and segment " +
                          std::to_string(s) + effect(distance) +
                          "if the vertex is meant to be on the segment, split the segment there");
      return true;
    });
    segment_tree_.query(enter, [&](std::uint32_t j) {
      if (j <= i) return true;
      const std::uint32_t t = view_.segments[j];
      const auto& others = complex_.segments[t];
      if (others[0] == ends[0] || others[0] == ends[1] || others[1] == ends[0] ||
          others[1] == ends[1])
        return true;
      const Point3 &c = end(t, 0), &d = end(t, 1);
      Point3 at = a;
      const double distance = distance_of_lines(a, b, c, d, &at);
      if (!(distance < limit_)) return true;
      if (distance_to_segment(a, c, d) < limit_ || distance_to_segment(b, c, d) < limit_ ||
          distance_to_segment(c, a, b) < limit_ || distance_to_segment(d, a, b) < limit_)
        return true;  // told of the vertex
      if (meetings_.segments_cross.count({s, t}) || meetings_.segments_overlap.count({s, t}))
        return true;
      crossing_.add({{FeatureKind::kSegment, s}, {FeatureKind::kSegment, t}}, {at},
                    "segments " + std::to_string(s) + " and " + std::to_string(t) + ", near " +
                        point_text(at, 3) + "," + effect(distance) +
                        "if they are meant to cross, split both at a vertex there");
      return true;
    });
  }

  void look_near(std::uint32_t f, std::size_t k) {
    const FaceSurface& surface = surfaces_[f];
    const auto& t = surface.triangles[k];
    const Point3 &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    TriangleFilter filter(a, b, c);
    filter.grow(limit_);
    const double n = length(filter.n);
    if (!(n > 0)) return;
    const auto enter = [&](const Box3& box) {
      ++work_;
      return filter.may_meet(box);
    };
    vertex_tree_.query(enter, [&](std::uint32_t i) {
      const std::uint32_t v = vertices_[i];
      if (v == t[0] || v == t[1] || v == t[2]) return true;
      const Point3& p = point(v);
      const double height = std::fabs(dot(minus(p, a), filter.n)) / n;
      if (!(height < limit_) || surface.has_member(v)) return true;
      // Inside, or near an edge that is inside the face; near a listed edge or a corner the segment
      // or vertex is told of.
      for (int e = 0; e < 3; ++e) {
        const Point3 &q = point(t[(e + 1) % 3]), &r = point(t[(e + 2) % 3]);
        if (near(p, point(t[e]))) return true;
        const bool beside = distance_to_segment(p, q, r) < limit_;
        if (beside && (surface.inner[k] >> e & 1)) break;
        if (beside || !is_left(q, r, p, filter.n)) return true;
      }
      if (meetings_.vertex_in_face.count({v, f}) || !told_.insert({v, f}).second) return true;
      in_face_.add({{FeatureKind::kVertex, v}, {FeatureKind::kFace, f}}, {p},
                   "vertex " + std::to_string(v) + " at " + point_text(p, 3) + " and face " +
                       std::to_string(f) + effect(height) +
                       "if the vertex is meant to be in the face, add it to the face's vertices");
      return true;
    });
  }
  static bool is_left(const Point3& q, const Point3& r, const Point3& p, const Point3& n) {
    const Point3 u = minus(r, q), w = minus(p, q);
    return dot(n, {u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x}) > 0;
  }

  const Complex& complex_;
  const SpaceView& view_;
  const std::vector<FaceSurface>& surfaces_;
  const SpaceMeetings& meetings_;
  DefectList on_segment_, in_face_, crossing_;
  BoxTree3 vertex_tree_, segment_tree_;
  std::vector<std::uint32_t> vertices_;
  std::set<std::array<std::uint32_t, 2>> told_;  // (vertex, face)
  double limit_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace

void check_near_contacts(const Complex& complex, const SpaceView& view,
                         const std::vector<FaceSurface>& surfaces, const SpaceMeetings& meetings,
                         std::size_t max, std::vector<Defect>* defects) {
  NearCheck near(complex, view, surfaces, meetings, max);
  near.run();
  near.append_to(defects);
}

}  // namespace circumball
