#include "complex/face_triangulation.h"

#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "complex/constrained_triangulation.h"
#include "complex/face_plane.h"

namespace circumball {

FaceProjection FaceProjection::along(const Point3& normal) {
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  FaceProjection p;
  p.axis = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
  p.mirrored = (p.axis == 2 ? normal.z : p.axis == 1 ? normal.y : normal.x) < 0;
  return p;
}

FaceLayout::FaceLayout(const Complex& complex, std::uint32_t face, const FaceProjection& along,
                       const std::vector<std::uint32_t>& inferred)
    : projection(along) {
  const Face& f = complex.faces[face];
  const auto add = [&](std::uint32_t a, std::uint32_t b, Kind kind, std::uint32_t segment) {
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b), kind, segment});
  };
  for (const auto& loop : f.loops) {
    members.insert(members.end(), loop.begin(), loop.end());
    if (loop.size() == 2) add(loop[0], loop[1], Kind::kSegment, kNoIndex);
    for (std::size_t i = 0; i < loop.size() && loop.size() > 2; ++i)
      add(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0], Kind::kSide, kNoIndex);
  }
  for (const std::uint32_t s : f.segments) {
    members.insert(members.end(), complex.segments[s].begin(), complex.segments[s].end());
    add(complex.segments[s][0], complex.segments[s][1], Kind::kSegment, s);
  }
  for (const std::uint32_t s : inferred)
    add(complex.segments[s][0], complex.segments[s][1], Kind::kInferred, s);
  members.insert(members.end(), f.vertices.begin(), f.vertices.end());
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  for (const std::uint32_t v : members) points.push_back(projection(complex.vertices[v]));

  const auto local = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(members.begin(), members.end(), v) -
                                      members.begin());
  };
  for (Edge& e : edges) e.a = local(e.a), e.b = local(e.b);
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& g) {
    if (e.a != g.a) return e.a < g.a;
    if (e.b != g.b) return e.b < g.b;
    if (e.kind != g.kind) return e.kind < g.kind;
    return e.segment < g.segment;
  });
  std::size_t kept = 0;
  for (const Edge& e : edges) {
    if (kept > 0 && edges[kept - 1].a == e.a && edges[kept - 1].b == e.b) {
      if (edges[kept - 1].segment == kNoIndex) edges[kept - 1].segment = e.segment;
      continue;
    }
    edges[kept++] = e;
  }
  edges.resize(kept);
  for (const Point3& hole : f.holes) holes.push_back(projection(hole));
}

Complex FaceLayout::planar() const {
  Complex c;
  c.vertices.reserve(points.size());
  for (const Point2& p : points) c.vertices.push_back(xyz(p));
  c.segments.reserve(edges.size());
  for (const Edge& e : edges) c.segments.push_back({e.a, e.b});
  return c;
}

/// One triangle and nothing else: the most common face.
static bool is_triangle(const FaceLayout& layout) {
  return layout.members.size() == 3 && layout.edges.size() == 3 && layout.holes.empty() &&
         std::all_of(layout.edges.begin(), layout.edges.end(),
                     [](const FaceLayout::Edge& e) { return e.kind == FaceLayout::Kind::kSide; });
}

bool is_planar(const FaceLayout& layout) {
  if (is_triangle(layout))
    return orient2d(layout.points[0], layout.points[1], layout.points[2]) != Sign::kZero;
  const PlanarView view(layout.planar(), {});
  if (view.points.size() != layout.members.size()) return false;
  const SweepResult swept = sweep(view);
  return std::none_of(swept.suspect.begin(), swept.suspect.end(), [](auto s) { return s != 0; });
}

bool is_usable(const Complex& complex, std::uint32_t face) {
  const Face& f = complex.faces[face];
  const auto vertex_ok = [&](std::uint32_t v) {
    if (v >= complex.vertices.size()) return false;
    const Point3& p = complex.vertices[v];
    return usable(p.x) && usable(p.y) && usable(p.z);
  };
  const auto all_ok = [&](const std::vector<std::uint32_t>& vertices) {
    return std::all_of(vertices.begin(), vertices.end(), vertex_ok);
  };
  return all_ok(f.vertices) && std::all_of(f.loops.begin(), f.loops.end(), all_ok) &&
         std::all_of(f.segments.begin(), f.segments.end(), [&](std::uint32_t s) {
           return s < complex.segments.size() && vertex_ok(complex.segments[s][0]) &&
                  vertex_ok(complex.segments[s][1]);
         });
}

namespace {

constexpr std::uint8_t kInside = 0, kOutside = 1, kInHole = 2;

/// The triangles of the constrained triangulation that a face consists of.
class Parts {
 public:
  Parts(const FaceLayout& layout, const ConstrainedTriangulation& cdt, FaceTriangles* out)
      : layout_(layout), triangles_(cdt.triangles()), out_(*out) {
    part_.assign(triangles_.size(), kInside);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      if (ConstrainedTriangulation::is_ghost(triangles_[t]) && part_[t] == kInside)
        flood(t, kOutside);
    carve();
    collect_triangles();
    collect_outside();
  }

 private:
  bool is_side(std::uint32_t edge) const {
    return edge != kNone && layout_.edges[edge].kind == FaceLayout::Kind::kSide;
  }

  /// What can be reached without crossing a side.
  void flood(std::uint32_t from, std::uint8_t part) {
    stack_.assign(1, from);
    part_[from] = part;
    while (!stack_.empty()) {
      const auto& t = triangles_[stack_.back()];
      stack_.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t other = t.n[i] >> 2;
        if (part_[other] == part || is_side(t.edge[i])) continue;
        part_[other] = part;
        stack_.push_back(other);
      }
    }
  }

  void carve() {
    const std::size_t count = layout_.holes.size();
    out_.hole_inside.assign(count, 0);
    out_.hole_on.assign(count, kNoIndex);
    if (count == 0) return;
    std::vector<Box2> boxes;
    std::vector<std::uint32_t> triangle_of;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (ConstrainedTriangulation::is_ghost(triangles_[t])) continue;
      Box2 box = Box2::of(at(t, 0), at(t, 1));
      box.extend(Box2::of(at(t, 2)));
      boxes.push_back(box);
      triangle_of.push_back(t);
    }
    const BoxTree tree(std::move(boxes));
    std::vector<std::uint32_t> carved;
    for (std::size_t k = 0; k < count; ++k) {
      const Box2 point = Box2::of(layout_.holes[k]);
      std::uint32_t found = kNone;
      tree.query([&](const Box2& box) { return box.meets(point); },
                 [&](std::uint32_t i) {
                   if (!holds(triangle_of[i], layout_.holes[k])) return true;
                   found = triangle_of[i];
                   return false;
                 });
      if (found == kNone || part_[found] == kOutside) continue;
      const std::uint32_t on = edge_through(found, layout_.holes[k]);
      if (on != kNoIndex) {
        out_.hole_on[k] = on;
        continue;
      }
      out_.hole_inside[k] = 1;
      carved.push_back(found);
    }
    for (const std::uint32_t t : carved)
      if (part_[t] == kInside) flood(t, kInHole);
  }

  const Point2& at(std::uint32_t t, int i) const { return layout_.points[triangles_[t].v[i]]; }
  bool holds(std::uint32_t t, const Point2& p) const {
    return orient2d(at(t, 0), at(t, 1), p) != Sign::kNegative &&
           orient2d(at(t, 1), at(t, 2), p) != Sign::kNegative &&
           orient2d(at(t, 2), at(t, 0), p) != Sign::kNegative;
  }
  /// The side that p in a triangle lies on.
  std::uint32_t edge_through(std::uint32_t t, const Point2& p) const {
    for (int i = 0; i < 3; ++i)
      if (is_side(triangles_[t].edge[i]) &&
          orient2d(at(t, (i + 1) % 3), at(t, (i + 2) % 3), p) == Sign::kZero)
        return triangles_[t].edge[i];
    return kNoIndex;
  }

  void collect_triangles() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (part_[t] != kInside) continue;
      const auto& from = triangles_[t];
      std::uint8_t inner = 0;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t e = from.edge[i];
        if (e == kNone || layout_.edges[e].kind == FaceLayout::Kind::kInferred)
          inner = static_cast<std::uint8_t>(inner | 1 << i);
      }
      out_.triangles.push_back(
          {layout_.members[from.v[0]], layout_.members[from.v[1]], layout_.members[from.v[2]]});
      out_.inner.push_back(inner);
    }
  }

  void collect_outside() {
    std::vector<std::uint8_t> member(layout_.members.size(), 0), edge(layout_.edges.size(), 0);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (part_[t] != kInside) continue;
      for (int i = 0; i < 3; ++i) {
        member[triangles_[t].v[i]] = 1;
        if (triangles_[t].edge[i] != kNone) edge[triangles_[t].edge[i]] = 1;
      }
    }
    for (std::uint32_t v = 0; v < member.size(); ++v)
      if (!member[v]) out_.members_outside.push_back(v);
    for (std::uint32_t e = 0; e < edge.size(); ++e) {
      if (layout_.edges[e].kind != FaceLayout::Kind::kInferred) {
        if (!edge[e]) out_.edges_outside.push_back(e);
      } else if (edge[e]) {
        out_.inferred_inside.push_back(e);
      }
    }
  }

  const FaceLayout& layout_;
  const std::vector<ConstrainedTriangulation::Triangle>& triangles_;
  FaceTriangles& out_;
  std::vector<std::uint8_t> part_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace

FaceTriangles triangulate(const FaceLayout& layout) {
  FaceTriangles out;
  if (is_triangle(layout)) {
    const Sign turn = orient2d(layout.points[0], layout.points[1], layout.points[2]);
    if (turn == Sign::kZero) return out;
    const auto& m = layout.members;
    out.valid = true;
    out.triangles.push_back(turn == Sign::kPositive
                                ? std::array<std::uint32_t, 3>{m[0], m[1], m[2]}
                                : std::array<std::uint32_t, 3>{m[0], m[2], m[1]});
    out.inner.push_back(0);
    return out;
  }
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(layout.edges.size());
  for (const FaceLayout::Edge& edge : layout.edges) edges.push_back({edge.a, edge.b});
  const ConstrainedTriangulation cdt(layout.points, edges);
  if (!cdt.valid() || cdt.triangles().empty()) return out;
  Parts(layout, cdt, &out);
  out.valid = !out.triangles.empty();
  return out;
}

std::vector<std::array<std::uint32_t, 3>> triangulate_face(const Complex& complex,
                                                           std::uint32_t face) {
  if (complex.dimension != 3 || face >= complex.faces.size() || !is_usable(complex, face))
    return {};
  const FacePlane plane(complex, face);
  if (!plane.valid()) return {};
  const FaceLayout layout(complex, face, FaceProjection::along(plane.normal()), {});
  if (!is_planar(layout)) return {};
  return triangulate(layout).triangles;
}

}  // namespace circumball
