#include "refinement/solid_view.h"

#include <algorithm>
#include <cmath>

#include "complex/solid_domain.h"

namespace circumball {
namespace {

/// Squared half lengths of collar elements, in squared circumradii of an encroached triangle, down
/// to which they are split for it. Two faces at an angle of theta at a vertex ask for lengths of 2
/// theta radii.
constexpr double kShortest2 = 1.0 / (1 << 24);

}  // namespace

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
  if (u.is_of_tube()) return probe(p, u.a);
  if (!u.is_collar_element()) return View3::ready(p, s);
  if (live_.has_intestine() && live_.intestine().structured() && !u.is_arc()) {
    return ready_for_ring(u.a, u.b, p);
  }
  return probe(p, u.a) && live_.probe_faces(p, {FeatureKind::kFace, u.face}, u.a);
}

void SolidView::propose_collar_elements(const FaceTriangle& t) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
  const FaceRefinement& face = live_.face(t.face);
  const Delaunay2& dt = face.triangulation();
  const auto for_each_element = [&](TriangleId u, auto f) {
    if (dt.is_ghost(u)) return;
    const auto& v = dt.triangle(u).v;
    for (unsigned i = 0; i < 3; ++i) {
      const SubsegmentId s =
          live_.subsegment_between(face.global(v[i]), face.global(v[(i + 1) % 3]));
      if (s.valid() && live_.subsegment(s).face == t.face) f(s);
    }
  };
  const auto for_each_near = [&](TriangleId u, auto f) {
    for_each_element(u, f);
    for (unsigned i = 0; i < 3; ++i) for_each_element(dt.twin(4 * u + i) / 4, f);
  };
  const double radius2 = squared_circumradius(t);

  // The counterpart of where the vertex is.
  const VertexId witness = encroachment(t).witness;
  if (witness.valid()) {
    const Point2 p = face.plane().to_plane(dt_.point(witness));
    SubsegmentId best;
    double least = 1;
    for_each_near(dt.locate(p, t.id), [&](SubsegmentId s) {
      const Subsegment& u = live_.subsegment(s);
      const Point2 a = face.point(live_.local(u.a, t.face)),
                   b = face.point(live_.local(u.b, t.face));
      const double x = p.x - 0.5 * (a.x + b.x), y = p.y - 0.5 * (a.y + b.y);
      const double half2 = 0.25 * squared_length(s);
      const double part = (x * x + y * y) / half2;
      if (part < least && half2 > radius2 * kShortest2) {
        least = part;
        best = s;
      }
    });
    if (best.valid()) return segments_.push_back(best);
  }
  const auto find = [&](SubsegmentId s) {
    if (16 * squared_length(s) > radius2) segments_.push_back(s);
  };
  for_each_element(t.id, find);
  if (segments_.empty()) for_each_near(t.id, find);
}

bool SolidView::leave_out_protected() {
  const std::size_t before = segments_.size() + triangles_.size();
  segments_.erase(std::remove_if(segments_.begin(), segments_.end(),
                                 [&](SubsegmentId s) { return live_.subsegment(s).is_collar; }),
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
  if (u.is_of_tube()) return false;
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

// --- tetrahedra

bool SolidView::is_flat(const CellRef& c, const TetrahedronShape& shape) const {
  // Six times the volume is at most the square of the longest edge by twice the height.
  const double height = std::max(kFlatVolume * std::sqrt(shape.longest2), 2 * live_.rounding());
  return shape.volume6 < shape.longest2 * height && has_one_group(live_, c.slot);
}

// --- points that are not inserted yet

FaceTriangle SolidView::triangle_in_the_way() const {
  if (!segments_.empty() || !patches_.empty() || triangles_.empty()) return {};
  const bool free = std::none_of(triangles_.begin(), triangles_.end(),
                                 [&](const FaceTriangle& t) { return is_in_collar(t); });
  return free ? triangles_[0] : FaceTriangle();
}

Outlook3 SolidView::look_in_face(const Point3& p, const FaceTriangle& t) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
  FaceRefinement& face = live_.face(t.face);
  if (!probe(p, corners(t)[0]) || !face.probe(p, t.id)) return Outlook3::kCoincides;
  find_encroached_segments(p);
  find_encroached_triangles(p);
  if (live_.has_intestine()) find_encroached_patches(p);
  const bool encroaches =
      !segments_.empty() || !patches_.empty() ||
      std::any_of(triangles_.begin(), triangles_.end(),
                  [&](const FaceTriangle& u) { return u.face != t.face || is_in_collar(u); });
  if (encroaches) return Outlook3::kEncroaches;
  return face.plane().contains(face.plane().to_plane(p)) ? Outlook3::kFree : Outlook3::kOutside;
}

bool SolidView::cavity_is_in_one_part(const CellRef& c) const {
  const std::uint32_t label = dt_.label(c.slot);
  for (const CellSlot d : dt_.cavity()) {
    if (dt_.is_ghost(d) || dt_.label(d) != label) return false;
  }
  for (const CellSlot d : dt_.cavity()) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellFacet f = 4 * d + i;
      const VertexId p = dt_.facet_corner(f, 0), q = dt_.facet_corner(f, 1),
                     r = dt_.facet_corner(f, 2);
      if (!can_lie_in_face(p) || !can_lie_in_face(q) || !can_lie_in_face(r)) continue;
      if (cavity_holds(dt_.twin(f) / 4) && live_.is_in_group(p, q, r)) return false;
    }
  }
  return true;
}

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
  segments_met_.begin();
  for (const CellSlot c : dt_.cavity()) {
    const Delaunay3::Cell cell = dt_.cell(c);
    for_each_subsegment(cell.v, [&](SubsegmentId s) {
      if (segments_met_.meet(0, s.value) && segment_ball_holds(s, p)) segments_.push_back(s);
    });
  }
}

void SolidView::find_encroached_triangles(const Point3& p) {
  begin_face_triangles();
  const auto look_at = [&](const FaceTriangle& t) {
    if (ball(t).holds(p) && is_in_face(t)) triangles_.push_back(t);
  };
  constexpr std::size_t kLarge = 64;
  if (dt_.cavity().size() < kLarge) {
    for (const CellSlot c : dt_.cavity()) for_each_face_triangle(dt_.cell(c).v, look_at);
    return;
  }
  // Each facet once: it is worth the marks.
  cells_met_.begin();
  for (const CellSlot c : dt_.cavity()) {
    const auto met = [&](unsigned i) {
      const CellSlot beyond = dt_.twin(4 * c + i) / 4;
      return cells_met_.met(0, beyond);
    };
    for_each_face_triangle(dt_.cell(c).v, met, look_at);
    cells_met_.meet(0, c);
  }
}

Outlook3 SolidView::look(const Point3& c, const FaceTriangle& t) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
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
  patches_.clear();
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    return Outlook3::kCoincides;
  }
  if (!probe_from(p, c.slot) || !cavity_holds(c.slot)) return Outlook3::kCoincides;
  find_encroached_segments(p);
  if (!segments_.empty() && !live_.tracks_collars()) return Outlook3::kEncroaches;
  find_encroached_triangles(p);
  if (live_.has_intestine()) find_encroached_patches(p);
  if (!segments_.empty() || !triangles_.empty() || !patches_.empty()) return Outlook3::kEncroaches;
  return outside_or_free();
}

}  // namespace circumball
