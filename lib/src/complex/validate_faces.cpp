#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "complex/face_plane.h"
#include "complex/planar_meetings.h"
#include "complex/space_contacts.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

class FaceCheck {
 public:
  FaceCheck(const Complex& complex, const SpaceView& view, std::size_t max)
      : complex_(complex),
        view_(view),
        contacts_(complex.vertices),
        stamp_(complex.vertices.size(), kNoIndex),
        degenerate_("degenerate-face", false, max),
        touching_("loop-touches-itself", false, max),
        bent_("non-planar-face", false, max),
        unlisted_("side-without-segment", false, max),
        segment_("segment-not-in-face", false, max),
        vertex_("vertex-not-in-face", false, max),
        hole_("face-hole-outside", true, max) {}

  std::vector<FaceSurface> run(SpaceMeetings* meetings) {
    std::vector<FaceSurface> surfaces(complex_.faces.size());
    for (std::uint32_t f = 0; f < surfaces.size(); ++f)
      if (is_usable(complex_, f)) look(f, &surfaces[f], meetings);
    return surfaces;
  }
  void append_to(std::vector<Defect>* defects) {
    for (DefectList* list :
         {&degenerate_, &touching_, &bent_, &unlisted_, &segment_, &vertex_, &hole_})
      list->append_to(defects);
  }

 private:
  static std::string name(std::uint32_t f) { return "face " + std::to_string(f); }
  const Point3& point(std::uint32_t v) const { return complex_.vertices[v]; }
  static Feature feature(std::uint32_t f) { return {FeatureKind::kFace, f}; }

  /// Loops by number alone.
  bool loops_are_sound(std::uint32_t f) {
    const Face& face = complex_.faces[f];
    bool sound = true;
    if (face.loops.empty()) {
      degenerate_.add({feature(f)}, {}, name(f) + " has no loop of vertices: give it an outline");
      sound = false;
    }
    for (std::size_t k = 0; k < face.loops.size(); ++k) {
      const auto& loop = face.loops[k];
      const std::string which = "loop " + std::to_string(k) + " of " + name(f);
      std::vector<std::uint32_t> sorted = loop;
      std::sort(sorted.begin(), sorted.end());
      const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
      const std::size_t distinct =
          static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
      if (distinct < 3) {
        degenerate_.add({feature(f)}, corners(loop),
                        which + " has " + std::to_string(distinct) +
                            " distinct vertices: give it three or more, or list what it joins "
                            "among the face's segments or vertices");
        sound = false;
      } else if (distinct < loop.size()) {
        const std::uint32_t v = *twice;
        touching_.add({feature(f), {FeatureKind::kVertex, v}}, {point(v)},
                      which + " passes vertex " + std::to_string(v) + " at " +
                          point_text(point(v), 3) +
                          " more than once: give its parts as loops of their own, and dangling "
                          "sides as segments of the face");
      }
    }
    return sound;
  }
  std::vector<Point3> corners(const std::vector<std::uint32_t>& loop) const {
    std::vector<Point3> at;
    for (std::size_t i = 0; i < loop.size() && i < 3; ++i) at.push_back(point(loop[i]));
    return at;
  }

  bool is_flat(std::uint32_t f) const {  // all vertices of loops on a line
    std::uint32_t a = kNoIndex, b = kNoIndex;
    for (const auto& loop : complex_.faces[f].loops)
      for (const std::uint32_t v : loop) {
        if (a == kNoIndex)
          a = v;
        else if (b == kNoIndex)
          b = point(v) != point(a) ? v : kNoIndex;
        else if (!contacts_.collinear(a, b, v))
          return false;
      }
    return true;
  }

  /// Segments between members, whether the face lists them or not.
  std::vector<std::uint32_t> between_members(std::uint32_t f,
                                             const std::vector<std::uint32_t>& members) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t v : members) stamp_[v] = f;
    for (const std::uint32_t a : members) {
      if (view_.degree(a) <= members.size()) {
        for (std::uint32_t k = view_.first[a]; k < view_.first[a + 1]; ++k) {
          const auto& i = view_.star[k];
          if (i.neighbor > a && stamp_[i.neighbor] == f) found.push_back(i.segment);
        }
      } else {
        for (const std::uint32_t b : members) {
          const std::uint32_t s = b > a ? view_.find(a, b) : kNoIndex;
          if (s != kNoIndex) found.push_back(s);
        }
      }
    }
    return found;
  }

  /// The unit normal of the plane through a member, the one farthest from it, and the one farthest
  /// from their line: well-conditioned, where vector areas of a polygon that crosses itself cancel.
  Point3 spread_normal(const std::vector<std::uint32_t>& members) const {
    const auto minus = [](const Point3& p, const Point3& q) {
      return Point3{p.x - q.x, p.y - q.y, p.z - q.z};
    };
    const auto dot = [](const Point3& p, const Point3& q) {
      return p.x * q.x + p.y * q.y + p.z * q.z;
    };
    const Point3& a = point(members[0]);
    Point3 u, n;
    for (const std::uint32_t v : members) {
      const Point3 w = minus(point(v), a);
      if (dot(w, w) > dot(u, u)) u = w;
    }
    for (const std::uint32_t v : members) {
      const Point3 w = minus(point(v), a);
      const Point3 m = {u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x};
      if (dot(m, m) > dot(n, n)) n = m;
    }
    const double length = std::sqrt(dot(n, n));
    return length > 0 ? Point3{n.x / length, n.y / length, n.z / length} : n;
  }

  bool is_planar_enough(std::uint32_t f, const Point3& normal,
                        const std::vector<std::uint32_t>& members) {
    double low = 0, high = 0;
    const Point3& origin = point(members[0]);
    std::uint32_t farthest = members[0];
    Box3 box = Box3::of(point(members[0]));
    for (const std::uint32_t v : members) {
      const Point3& p = point(v);
      const double h =
          (p.x - origin.x) * normal.x + (p.y - origin.y) * normal.y + (p.z - origin.z) * normal.z;
      if (h < low || h > high) farthest = v;
      low = std::min(low, h);
      high = std::max(high, h);
      box.extend(Box3::of(point(v)));
    }
    const double dx = box.extent(0), dy = box.extent(1), dz = box.extent(2);
    const double size = std::sqrt(dx * dx + dy * dy + dz * dz), deviation = 0.5 * (high - low);
    const double allowed = planarity_of(box);
    if (deviation <= allowed) return true;
    bent_.add({feature(f), {FeatureKind::kVertex, farthest}}, {point(farthest)},
              name(f) + " is not planar: its vertices are up to " + number_text(deviation) +
                  " from a plane, " + number_text(deviation / size) + " of its size, and " +
                  number_text(allowed / size) + " is allowed; vertex " + std::to_string(farthest) +
                  " at " + point_text(point(farthest), 3) +
                  " is farthest: divide the face into triangles, or move the vertices into one "
                  "plane");
    return false;
  }

  /// What meets in the face's plane. Segments without a number are told by side-without-segment.
  void collect_meetings(std::uint32_t f, const FaceLayout& layout, SpaceMeetings* meetings) {
    const PlanarView view(layout.planar(), {});
    if (view.points.size() != layout.members.size()) {
      for (std::uint32_t k = 0; k < layout.members.size(); ++k) {
        const std::uint32_t v = layout.members[view.vertex[view.point_of_vertex[k]]];
        const std::uint32_t w = layout.members[k];
        if (v == w || point(v) == point(w)) continue;  // duplicate vertices are told elsewhere
        degenerate_.add({feature(f), {FeatureKind::kVertex, v}, {FeatureKind::kVertex, w}},
                        {point(v), point(w)},
                        "vertices " + std::to_string(v) + " and " + std::to_string(w) + " of " +
                            name(f) + " coincide in its plane: merge them");
      }
    }
    const auto segment = [&](std::uint32_t i) {
      const std::uint32_t s = layout.edges[view.segments[i].segment].segment;
      return s == kNoIndex ? s : view_.canonical[s];
    };
    const bool complete = find_meetings(
        view, sweep(view),
        [&](std::uint32_t p, std::uint32_t i) {
          const std::uint32_t v = layout.members[view.vertex[p]], s = segment(i);
          if (s != kNoIndex) meetings->vertex_on_segment.insert({{v, s}, f});
        },
        [&](std::uint32_t i, std::uint32_t j, PlanarMeeting m) {
          const std::uint32_t s = segment(i), t = segment(j);
          if (s == kNoIndex || t == kNoIndex) return;
          (m == PlanarMeeting::kCross ? meetings->segments_cross : meetings->segments_overlap)
              .insert({{std::min(s, t), std::max(s, t)}, f});
        });
    if (!complete) meetings->incomplete = true;
  }

  void look(std::uint32_t f, FaceSurface* surface, SpaceMeetings* meetings) {
    if (!loops_are_sound(f)) return;
    const FacePlane plane(complex_, f);
    if (is_flat(f)) {
      degenerate_.add({feature(f)}, corners(complex_.faces[f].loops[0]),
                      name(f) +
                          " has no area: its vertices are on a line, or its loops enclose "
                          "nothing; remove it, or correct its vertices");
      return;
    }
    FaceProjection projection = FaceProjection::along(plane.normal());
    FaceLayout layout(complex_, f, projection, {});
    Point3 normal = plane.normal();
    const Point3 spread = spread_normal(layout.members);
    const double along = normal.x * spread.x + normal.y * spread.y + normal.z * spread.z;
    if (!plane.valid() || std::fabs(along) < 0.5) {  // areas cancel
      normal = spread;
      projection = FaceProjection::along(normal);
    }
    surface->members = layout.members;
    surface->projection = projection;
    const std::vector<std::uint32_t> between = between_members(f, layout.members);
    if (!is_planar_enough(f, normal, layout.members)) return;
    layout = FaceLayout(complex_, f, projection, between);
    tell_unlisted(f, layout);
    bool planar = is_planar(layout);
    if (!planar) {
      collect_meetings(f, layout, meetings);
      layout = FaceLayout(complex_, f, projection, {});
      planar = is_planar(layout);
    }
    if (!planar) return;
    FaceTriangles parts = triangulate(layout);
    if (!parts.valid) {
      degenerate_.add(
          {feature(f)}, corners(complex_.faces[f].loops[0]),
          "nothing is left of " + name(f) + ": its hole points lie in every part of it; move them");
      return;
    }
    tell_parts(f, layout, parts, meetings);
    surface->triangles = std::move(parts.triangles);
    surface->inner = std::move(parts.inner);
  }

  void tell_unlisted(std::uint32_t f, const FaceLayout& layout) {
    for (const FaceLayout::Edge& e : layout.edges) {
      if (e.segment != kNoIndex) continue;
      const std::uint32_t a = layout.members[e.a], b = layout.members[e.b];
      if (point(a) == point(b)) continue;  // duplicate vertices are told elsewhere
      unlisted_.add({feature(f), {FeatureKind::kVertex, a}, {FeatureKind::kVertex, b}},
                    {point(a), point(b)},
                    "the side of " + name(f) + " between vertices " + std::to_string(a) + " and " +
                        std::to_string(b) + " is no segment: add it to the list of segments");
    }
  }

  void tell_parts(std::uint32_t f, const FaceLayout& layout, const FaceTriangles& parts,
                  SpaceMeetings* meetings) {
    for (const std::uint32_t e : parts.inferred_inside)
      meetings->segment_in_face.insert({{view_.canonical[layout.edges[e].segment], f}, f});
    for (const std::uint32_t k : parts.edges_outside) {
      const FaceLayout::Edge& e = layout.edges[k];
      const std::uint32_t a = layout.members[e.a], b = layout.members[e.b];
      std::vector<Feature> features = {feature(f)};
      if (e.segment != kNoIndex) features.push_back({FeatureKind::kSegment, e.segment});
      segment_.add(features, {point(a), point(b)},
                   (e.segment == kNoIndex ? "the side" : "segment " + std::to_string(e.segment)) +
                       " from " + point_text(point(a), 3) + " to " + point_text(point(b), 3) +
                       " is listed in " + name(f) +
                       ", but lies outside of it or in a hole: take it off the face's list");
    }
    for (const std::uint32_t k : parts.members_outside) {
      const std::uint32_t v = layout.members[k];
      vertex_.add({feature(f), {FeatureKind::kVertex, v}}, {point(v)},
                  "vertex " + std::to_string(v) + " at " + point_text(point(v), 3) +
                      " is listed in " + name(f) +
                      ", but lies outside of it or in a hole: take it off the face's list");
    }
    const auto& holes = complex_.faces[f].holes;
    for (std::size_t k = 0; k < holes.size() && k < parts.hole_inside.size(); ++k) {
      if (parts.hole_inside[k]) continue;
      const bool on = parts.hole_on[k] != kNoIndex;
      hole_.add({feature(f)}, {holes[k]},
                "hole point " + std::to_string(k) + " of " + name(f) + " at " +
                    point_text(holes[k], 3) +
                    (on ? " lies on a side of it, between the parts that it might mean"
                        : " lies outside of it") +
                    ": it removes nothing; move it into a loop");
    }
  }

  const Complex& complex_;
  const SpaceView& view_;
  const SpaceContacts contacts_;
  std::vector<std::uint32_t> stamp_;  // by vertex: the last face that it was seen in
  DefectList degenerate_, touching_, bent_, unlisted_, segment_, vertex_, hole_;
};

}  // namespace

std::vector<FaceSurface> check_faces(const Complex& complex, const SpaceView& view, std::size_t max,
                                     SpaceMeetings* meetings, std::vector<Defect>* defects) {
  FaceCheck faces(complex, view, max);
  std::vector<FaceSurface> surfaces = faces.run(meetings);
  faces.append_to(defects);
  return surfaces;
}

}  // namespace circumball
