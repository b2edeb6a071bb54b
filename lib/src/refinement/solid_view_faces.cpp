// Triangles of faces: which vertices they are encroached upon by.
#include <algorithm>
#include <cmath>

#include "refinement/solid_view.h"

namespace circumball {

SolidView::Ball SolidView::ball(const FaceTriangle& t) const {
  const auto v = corners(t);
  const TriangleBall b = triangle_ball(dt_.point(v[0]), dt_.point(v[1]), dt_.point(v[2]));
  const double slack = 2 * live_.rounding() * std::sqrt(b.radius2);
  return {b, (1 - kLengthSlack * kLengthSlack) * b.radius2 - slack};
}

Verdict SolidView::encroached_by(const FaceTriangle& t, VertexId v) const {
  if (!live_.lies_in_face(v, t.face) && ball(t).holds(dt_.point(v))) {
    return {Reason::kEncroached, v, 0};
  }
  const auto at = corners(t);
  if (dt_.find_facet(at[0], at[1], at[2]) != kNone) return {};
  return encroachment_of_missing(t);
}

Verdict SolidView::encroachment(const FaceTriangle& t) const {
  const auto v = corners(t);
  const CellFacet f = dt_.find_facet(v[0], v[1], v[2]);
  if (f == kNone) return encroachment_of_missing(t);
  for (const CellFacet side : {f, dt_.twin(f)}) {
    const VertexId p = encroacher_behind(t, side);
    if (p.valid()) return {Reason::kEncroached, p, 0};
  }
  return {};
}

struct SolidView::Box3 {
  Point3 low, high;
  void add(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool meets(const Box3& b, double slack) const {
    return low.x <= b.high.x + slack && b.low.x <= high.x + slack && low.y <= b.high.y + slack &&
           b.low.y <= high.y + slack && low.z <= b.high.z + slack && b.low.z <= high.z + slack;
  }
};

SolidView::Box3 SolidView::box_of_facet(CellFacet f) const {
  const Point3& p = dt_.point(dt_.facet_corner(f, 0));
  Box3 box{p, p};
  box.add(dt_.point(dt_.facet_corner(f, 1)));
  box.add(dt_.point(dt_.facet_corner(f, 2)));
  return box;
}

/// Whether no vertex is beyond the facet f, which lies in the face: all input vertices that do not
/// belong to the group of the face are on its other side, by far more than rounding. Vertices that
/// refinement inserts are in the convex hull of the input, but for those on spheres and tubes.
bool SolidView::is_hull_side(std::uint32_t face, CellFacet f) const {
  if (live_.has_intestine()) return false;
  if (hull_sides_.empty()) hull_sides_.assign(live_.face_count(), HullSide::kUnknown);
  const FacePlane& plane = live_.face(face).plane();
  HullSide& side = hull_sides_[face];
  if (side == HullSide::kUnknown) {
    const double margin = 1000 * live_.rounding();
    bool above = false, below = false;
    const auto& vertices = live_.complex().vertices;
    for (std::uint32_t v = 0; v < vertices.size() && !(above && below); ++v) {
      if (live_.lies_in_group(VertexId(v), live_.group_of_face(face))) continue;
      const double height = plane.height(vertices[v]);
      above = above || height > -margin;
      below = below || height < margin;
    }
    side = above && below ? HullSide::kNone : above ? HullSide::kBelow : HullSide::kAbove;
  }
  if (side == HullSide::kNone) return false;
  const Point3 &a = dt_.point(dt_.facet_corner(f, 0)), &b = dt_.point(dt_.facet_corner(f, 1)),
               &c = dt_.point(dt_.facet_corner(f, 2));
  const Point2 p = plane.to_plane(a), q = plane.to_plane(b), r = plane.to_plane(c);
  const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return side == HullSide::kAbove ? area > 0 : area < 0;  // the apex is above where it is positive
}

/// If the ball of a facet holds a vertex, it holds the apex on that side. Where the cell there is
/// flat, the vertex is beyond it, and in the balls of its other facets, which are nearly that of t.
/// The way from the centroid of t to the vertex leads through flat cells over the middle of t
/// alone: over its triangle of midpoints, as they are thin beside the distance of features.
VertexId SolidView::encroacher_behind(const FaceTriangle& t, CellFacet f) const {
  const VertexId first = dt_.apex(f);
  if (first == Delaunay3::kGhost) return VertexId();
  const Ball ball_of_t = ball(t);
  const std::uint32_t group = live_.group_of_face(t.face);
  const auto encroaches = [&](VertexId p) {
    return !live_.lies_in_face(p, t.face) && ball_of_t.holds(dt_.point(p));
  };
  if (encroaches(first)) return first;
  if (!live_.lies_in_group(first, group) || is_hull_side(t.face, f)) return VertexId();
  const auto v = corners(t);
  Box3 around;
  for (unsigned i = 0; i < 3; ++i) {
    const Point3 m = circumball::midpoint(dt_.point(v[i]), dt_.point(v[(i + 1) % 3]));
    if (i == 0) around = {m, m};
    around.add(m);
  }
  flat_.assign(1, f / 4);
  for (std::size_t k = 0; k < flat_.size() && k < 64; ++k) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellFacet beyond = dt_.twin(4 * flat_[k] + i);
      const CellSlot cell = beyond / 4;
      const VertexId p = dt_.apex(beyond);
      if (cell == f / 4 || 4 * flat_[k] + i == f || p == Delaunay3::kGhost) continue;
      if (encroaches(p)) return p;
      if (!live_.lies_in_group(p, group)) continue;
      if (std::find(flat_.begin(), flat_.end(), cell) != flat_.end()) continue;
      if (around.meets(box_of_facet(beyond), 2 * live_.rounding())) flat_.push_back(cell);
    }
  }
  return VertexId();
}

Verdict SolidView::encroachment_of_missing(const FaceTriangle& t) const {
  const auto v = corners(t);
  const Point3 c = circumcenter(t);
  const bool finite = std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
  if (finite && !probe(c, v[0])) {
    const VertexId p = dt_.duplicate_of();  // a vertex is there: the deepest encroachment
    if (p.valid() && !live_.lies_in_face(p, t.face) && ball(t).holds(dt_.point(p))) {
      return {Reason::kEncroached, p, 0};
    }
  } else if (finite) {
    // The vertex nearest to the center is a neighbor that it would have.
    dt_.cavity_neighbors(&neighbors_);
    for (const VertexId p : neighbors_) {
      if (!live_.lies_in_face(p, t.face) && ball(t).holds(dt_.point(p))) {
        return {Reason::kEncroached, p, 0};
      }
    }
    const VertexId p = crosser_in_cavity(t);
    if (p.valid()) return {Reason::kMissing, p, 0};
  }
  // Let an edge pq cross t at x, p and q not in its ball. The power of a point with respect to that
  // ball less the one with respect to the (empty) ball of a cell at pq is an affine function, not
  // negative at p and q, not positive at the corners of t: zero at x, and so at all corners that x
  // is not opposite to. If x is inside of t, the two balls are one, and the cell's holds the
  // circumcenter of t; if x is on an edge of t, the cell's ball holds the edge's midpoint, as it
  // holds the chord.
  for (unsigned i = 0; i < 3; ++i) {
    const VertexId a = v[i], b = v[(i + 1) % 3];
    if (dt_.has_edge(a, b)) continue;
    if (!probe(circumball::midpoint(dt_.point(a), dt_.point(b)), a)) continue;
    const VertexId p = crosser_in_cavity(t);
    if (p.valid()) return {Reason::kMissing, p, 0};
  }
  return {};
}

/// An end of an edge of a cell of the last cavity that crosses t; invalid if there is none.
VertexId SolidView::crosser_in_cavity(const FaceTriangle& t) const {
  const std::uint32_t group = live_.group_of_face(t.face);
  for (const CellSlot c : dt_.cavity()) {
    if (dt_.is_ghost(c)) continue;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const VertexId p = dt_.corner(c, i);
      if (live_.lies_in_group(p, group)) continue;
      for (std::uint32_t j = i + 1; j < 4; ++j) {
        const VertexId q = dt_.corner(c, j);
        if (!live_.lies_in_group(q, group) && crosses(t, p, q)) return p;
      }
    }
  }
  return VertexId();
}

/// Whether the edge pq, p and q not in the plane, crosses t or its boundary. Heights of p and q are
/// far from rounding, as features that are not joined are apart.
bool SolidView::crosses(const FaceTriangle& t, VertexId p, VertexId q) const {
  const FaceRefinement& face = live_.face(t.face);
  const FacePlane& plane = face.plane();
  const double hp = plane.height(dt_.point(p)), hq = plane.height(dt_.point(q));
  if (!((hp > 0 && hq < 0) || (hp < 0 && hq > 0))) return false;
  const Point2 a = plane.to_plane(dt_.point(p)), b = plane.to_plane(dt_.point(q));
  const double s = hp / (hp - hq);
  const Point2 x{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  const auto& v = face.triangulation().triangle(t.id).v;
  for (unsigned i = 0; i < 3; ++i) {
    const Point2 &from = face.point(v[i]), &to = face.point(v[(i + 1) % 3]);
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double left = dx * (x.y - from.y) - dy * (x.x - from.x);
    if (left < (1 - kLengthSlack) * (dx * dx + dy * dy)) return false;
  }
  return true;
}

bool SolidView::conforms() const {
  // Inside of tubes of Algorithm 6.3 nothing needs to: floods go around them.
  const bool torn = live_.has_intestine() && !live_.intestine().structured();
  for (std::uint32_t i = 0; i < live_.subsegment_count(); ++i) {
    const Subsegment& u = live_.subsegment(SubsegmentId(i));
    if (torn && u.is_collar) continue;
    if (u.alive && !u.is_collar_element() && is_missing(SubsegmentId(i))) return false;
  }
  for (std::uint32_t f = 0; f < live_.face_count(); ++f) {
    const Delaunay2& dt = live_.face(f).triangulation();
    bool whole = true;
    dt.for_each_triangle([&](TriangleId id) {
      const FaceTriangle t{f, id, dt.triangle(id).birth};
      if (!whole || !is_in_face(t) || (torn && is_in_collar(t))) return;
      const auto v = corners(t);
      whole = dt_.find_facet(v[0], v[1], v[2]) != kNone || !encroachment_of_missing(t);
    });
    if (!whole) return false;
  }
  return true;
}

std::vector<RelabeledCell> classify_if_conforming(Live3* live) {
  const bool may_leak = live->domain() == Domain::kClosed || !live->complex().regions.empty();
  if (may_leak && !SolidView(*live, false).conforms()) return {};
  return classify(live);
}

}  // namespace circumball
