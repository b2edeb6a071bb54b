#include "refinement/solid_view.h"

#include <algorithm>
#include <cmath>

#include "complex/solid_domain.h"

namespace circumball {

bool SolidView::is_in_face(const FaceTriangle& t) const {
  if (known_.size() < live_.face_count()) known_.resize(live_.face_count());
  auto& known = known_[t.face];
  if (known.size() <= t.id) {
    known.resize(live_.face(t.face).triangulation().slot_count() + std::size_t{t.id} / 2);
  }
  Known& k = known[t.id];
  if (k.birth != t.birth) {
    const auto v = corners(t);
    k = {t.birth, live_.is_in_face(t.face, v[0], v[1], v[2])};
  }
  return k.inside;
}

bool SolidView::ready(const Point3& p, SubsegmentId s) {
  const Subsegment& u = live_.subsegment(s);
  if (!u.is_collar_element()) return View3::ready(p, s);
  return probe(p, u.a) && live_.probe_faces(p, {FeatureKind::kFace, u.face}, u.a);
}

void SolidView::propose_collar_elements(const FaceTriangle& t) {
  segments_.clear();
  triangles_.clear();
  const FaceRefinement& face = live_.face(t.face);
  const Delaunay2& dt = face.triangulation();
  const double least2 = squared_circumradius(t) / 16;
  const auto find_at = [&](TriangleId u) {
    if (dt.is_ghost(u)) return;
    const auto& v = dt.triangle(u).v;
    for (unsigned i = 0; i < 3; ++i) {
      const SubsegmentId s =
          live_.subsegment_between(face.global(v[i]), face.global(v[(i + 1) % 3]));
      if (!s.valid() || live_.subsegment(s).face != t.face) continue;
      if (squared_length(s) > least2) segments_.push_back(s);
    }
  };
  find_at(t.id);
  if (!segments_.empty()) return;
  for (unsigned i = 0; i < 3; ++i) find_at(dt.twin(4 * t.id + i) / 4);
}

bool SolidView::leave_out_protected() {
  const std::size_t before = segments_.size() + triangles_.size();
  segments_.erase(
      std::remove_if(segments_.begin(), segments_.end(),
                     [&](SubsegmentId s) { return !live_.subsegment(s).is_collar_element(); }),
      segments_.end());
  triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(),
                                  [&](const FaceTriangle& t) { return is_in_collar(t); }),
                   triangles_.end());
  const bool some = segments_.size() + triangles_.size() < before;
  if (!segments_.empty()) triangles_.clear();
  return some;
}

// --- subsegments

bool SolidView::is_missing(SubsegmentId s) const {
  const Subsegment& u = live_.subsegment(s);
  if (u.is_collar_element()) {
    const Delaunay2& dt = live_.face(u.face).triangulation();
    return dt.find_edge(live_.local(u.a, u.face), live_.local(u.b, u.face)) == kNone;
  }
  if (!dt_.has_edge(u.a, u.b)) return true;
  for (const std::uint32_t f : live_.incidence().faces_of_segment(u.segment.value)) {
    const Delaunay2& dt = live_.face(f).triangulation();
    if (dt.find_edge(live_.local(u.a, f), live_.local(u.b, f)) == kNone) return true;
  }
  return false;
}

Verdict SolidView::encroachment(SubsegmentId s) const {
  // A vertex in the ball has one in it that is a neighbor of a, and one that is a neighbor of b
  // (shrink the ball towards that end).
  const Subsegment& u = live_.subsegment(s);
  VertexId inside;
  dt_.for_each_neighbor(dt_.of_lesser_degree(u.a, u.b), [&](VertexId p) {
    if (p != u.a && p != u.b && segment_ball_holds(s, dt_.point(p))) inside = p;
    return !inside.valid();
  });
  if (inside.valid()) return {Reason::kEncroached, inside, 0};
  return is_missing(s) ? Verdict{Reason::kMissing, VertexId(), 0} : Verdict{};
}

Verdict SolidView::encroached_by(SubsegmentId s, VertexId v) const {
  if (is_end_of(v, s)) return {};
  if (segment_ball_holds(s, dt_.point(v))) return {Reason::kEncroached, v, 0};
  return is_missing(s) ? Verdict{Reason::kMissing, VertexId(), 0} : Verdict{};
}

// --- triangles of faces

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
/// refinement inserts are in the convex hull of the input.
bool SolidView::is_hull_side(std::uint32_t face, CellFacet f) const {
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
  if (std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && probe(c, v[0])) {
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

// --- tetrahedra

bool SolidView::is_flat(const CellRef& c, const TetrahedronShape& shape) const {
  // Six times the volume is at most the square of the longest edge by twice the height.
  const double height = std::max(kFlatVolume * std::sqrt(shape.longest2), 2 * live_.rounding());
  return shape.volume6 < shape.longest2 * height && has_one_group(live_, c.slot);
}

// --- points that are not inserted yet

bool SolidView::cavity_holds(CellSlot c) const {
  const auto& cavity = dt_.cavity();
  return std::find(cavity.begin(), cavity.end(), c) != cavity.end();
}

Outlook3 SolidView::outside_or_free() const {
  // The first cell of a cavity is the one that holds the point.
  return live_.is_in_domain(dt_.cavity()[0]) ? Outlook3::kFree : Outlook3::kOutside;
}

/// A subsegment whose ball holds p is an edge of a cell of the cavity: it is an edge, and some cell
/// around it dies. The same for triangles of faces.
void SolidView::find_encroached_segments(const Point3& p) {
  for (const CellSlot c : dt_.cavity()) {
    const Delaunay3::Cell cell = dt_.cell(c);
    for_each_subsegment(cell.v, [&](SubsegmentId s) {
      if (std::find(segments_.begin(), segments_.end(), s) != segments_.end()) return;
      if (segment_ball_holds(s, p)) segments_.push_back(s);
    });
  }
}

void SolidView::find_encroached_triangles(const Point3& p) {
  begin_face_triangles();
  for (const CellSlot c : dt_.cavity()) {
    const Delaunay3::Cell cell = dt_.cell(c);
    for_each_face_triangle(cell.v, [&](const FaceTriangle& t) {
      const auto same = [&](const FaceTriangle& u) { return u.face == t.face && u.id == t.id; };
      if (std::any_of(triangles_.begin(), triangles_.end(), same)) return;
      if (ball(t).holds(p) && is_in_face(t)) triangles_.push_back(t);
    });
  }
}

Outlook3 SolidView::look(const Point3& c, const FaceTriangle& t) {
  segments_.clear();
  triangles_.clear();
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
    return Outlook3::kCoincides;
  }
  if (!View3::look(c, t)) return Outlook3::kCoincides;
  find_encroached_segments(c);
  return segments_.empty() ? Outlook3::kFree : Outlook3::kEncroaches;
}

Outlook3 SolidView::look(const Point3& p, const CellRef& c) {
  segments_.clear();
  triangles_.clear();
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    return Outlook3::kCoincides;
  }
  if (!probe_from(p, c.slot) || !cavity_holds(c.slot)) return Outlook3::kCoincides;
  find_encroached_segments(p);
  if (!segments_.empty() && !live_.tracks_collars()) return Outlook3::kEncroaches;
  find_encroached_triangles(p);
  if (!segments_.empty() || !triangles_.empty()) return Outlook3::kEncroaches;
  return outside_or_free();
}

}  // namespace circumball
