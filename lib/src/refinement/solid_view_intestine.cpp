#include <algorithm>
#include <cmath>

#include "refinement/solid_view.h"

namespace circumball {
namespace {

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Longer than this part of the distance of its rings, a chord is split rather than a new ring put
/// in between.
constexpr double kLongChord = 1.2;

}  // namespace

Point3 SolidView::ring_arc_midpoint(const Subsegment& u) const {
  const Intestines& intestine = live_.intestine();
  return intestine.place(intestine.ring(u.ring), intestine.middle_key(u.ring, u.a, u.b));
}

/// All of its vertices, that at p last.
bool SolidView::ready_for_ring(VertexId a, VertexId b, const Point3& p) {
  const Intestines& intestine = live_.intestine();
  RingKey key = 0;
  const std::uint32_t before = intestine.ring_before(a, b, &key);
  if (before == kNoIndex) return false;
  const Ring ring = intestine.ring_between(before);
  const auto is_ready = [&](RingKey k, const Point3& at) {
    const VertexId near = intestine.ring(before).vertices[0].vertex;
    if (!probe(at, near)) return false;
    const BaseDirection& base = intestine.tube_of(ring).bases[k / kRingGap];
    if (k % kRingGap != 0 || base.face == kNoIndex) return true;
    const VertexId beside = intestine.ring(before).at(k);
    return beside.valid() && live_.probe_faces(at, {FeatureKind::kFace, base.face}, beside);
  };
  for (const RingVertex& v : ring.vertices) {
    if (v.key != key && !is_ready(v.key, intestine.place(ring, v.key))) return false;
  }
  return is_ready(key, p);
}

bool SolidView::ready(const Point3& p, PatchId id) {
  const Patch& patch = live_.intestine().patch(id);
  if (patch.is_of_sphere() || !live_.intestine().structured()) return true;  // by the action
  const Ring& ring = live_.intestine().ring(patch.ring);
  const RingKey key = live_.intestine().ring(patch.ring).vertices[0].key;
  const VertexId a = ring.vertices[0].vertex, b = live_.intestine().ring(ring.next).at(key);
  return b.valid() && ready_for_ring(a, b, p);
}

SolidView::Ball SolidView::ball(PatchId id) const {
  const Patch& patch = live_.intestine().patch(id);
  const TriangleBall b =
      triangle_ball(dt_.point(patch.v[0]), dt_.point(patch.v[1]), dt_.point(patch.v[2]));
  return {b, (1 - kLengthSlack * kLengthSlack) * b.radius2 -
                 2 * live_.rounding() * std::sqrt(b.radius2)};
}

Verdict SolidView::encroachment(PatchId id) const {
  const Patch& patch = live_.intestine().patch(id);
  const Ball b = ball(id);
  const Point3 &o = b.ball.corner, &c = b.ball.center;
  if (!probe({o.x + c.x, o.y + c.y, o.z + c.z}, patch.v[0])) {
    // A vertex is there already: the deepest encroachment.
    const VertexId v = dt_.duplicate_of();
    return v.valid() && encroached_by(id, v) ? Verdict{Reason::kEncroached, v, 0} : Verdict{};
  }
  // The vertex nearest to the center is a neighbor that it would have.
  dt_.cavity_neighbors(&neighbors_);
  for (const VertexId v : neighbors_) {
    if (!patch.has(v) && b.holds(dt_.point(v))) return {Reason::kEncroached, v, 0};
  }
  return {};
}

Verdict SolidView::encroached_by(PatchId id, VertexId v) const {
  if (live_.intestine().patch(id).has(v)) return {};
  return ball(id).holds(dt_.point(v)) ? Verdict{Reason::kEncroached, v, 0} : Verdict{};
}

bool SolidView::is_wide(PatchId id) const {
  const Patch& patch = live_.intestine().patch(id);
  if (!patch.is_of_sphere()) return false;
  const Point3 &q0 = dt_.point(VertexId(patch.sphere)), &a = dt_.point(patch.v[0]);
  const Point3 n = cross(minus(dt_.point(patch.v[1]), a), minus(dt_.point(patch.v[2]), a));
  const double height = dot(n, minus(a, q0));
  return 2 * height * height < dot(n, n) * dot(minus(a, q0), minus(a, q0)) / kLengthSlack;
}

Point3 SolidView::top(PatchId id) const {
  const Patch& patch = live_.intestine().patch(id);
  const Point3 &q0 = dt_.point(VertexId(patch.sphere)), &a = dt_.point(patch.v[0]);
  const Point3 n = cross(minus(dt_.point(patch.v[1]), a), minus(dt_.point(patch.v[2]), a));
  const double scale = live_.intestine().radius(patch.sphere) / std::sqrt(dot(n, n));
  const double s = dot(n, minus(a, q0)) < 0 ? -scale : scale;
  return {q0.x + s * n.x, q0.y + s * n.y, q0.z + s * n.z};
}

bool SolidView::propose_arcs(PatchId id) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
  const Intestines& intestine = live_.intestine();
  const Patch& patch = intestine.patch(id);
  const Ring &a = intestine.ring(patch.ring), &b = intestine.ring(a.next);
  const double spacing2 = squared_distance(a.center, b.center);
  double longest2 = 0;
  const unsigned corners = patch.is_quad() ? 4 : 3;
  for (unsigned i = 0; i < corners; ++i) {
    const VertexId p = patch.v[i], q = patch.v[(i + 1) % corners];
    const SubsegmentId s = live_.subsegment_between(p, q);
    if (!s.valid() || !live_.subsegment(s).is_ring_arc()) continue;
    longest2 = std::max(longest2, squared_length(s));
    if (!live_.subsegment(s).frozen) segments_.push_back(s);
  }
  return longest2 > kLongChord * kLongChord * spacing2 && !segments_.empty();
}

bool SolidView::propose_sides(PatchId id) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
  const Patch& patch = live_.intestine().patch(id);
  for (unsigned i = 0; i < 3; ++i) {
    const SubsegmentId s = live_.subsegment_between(patch.v[i], patch.v[(i + 1) % 3]);
    if (s.valid() && !live_.subsegment(s).frozen) segments_.push_back(s);
  }
  return !segments_.empty();
}

Point3 SolidView::projected_circumcenter(PatchId id, bool* inside) const {
  const Intestines& intestine = live_.intestine();
  const Patch& patch = intestine.patch(id);
  const TubeCell& cell = intestine.cell(patch.ring, patch.gap);
  Point2 p[3];
  for (unsigned i = 0; i < 3; ++i) {
    const Point2 at = intestine.place_in_cell(patch.v[i], patch.ring, patch.gap);
    p[i] = cell.developed(at.x, at.y);
  }
  const Point2 at = cell.undeveloped(circumcenter_extended(p[0], p[1], p[2]));
  *inside = at.x > 0 && at.x < 1 && at.y > 0 && at.y < 1;
  return cell.place(at.x, at.y);
}

Point3 SolidView::place_on_new_ring(PatchId id) const {
  const Intestines& intestine = live_.intestine();
  const Ring& before = intestine.ring(intestine.patch(id).ring);
  return intestine.place(intestine.ring_between(intestine.patch(id).ring), before.vertices[0].key);
}

Outlook3 SolidView::look(const Point3& c, PatchId id) {
  segments_.clear();
  triangles_.clear();
  patches_.clear();
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
    return Outlook3::kCoincides;
  }
  if (!probe(c, live_.intestine().patch(id).v[0])) return Outlook3::kCoincides;
  find_encroached_segments(c);
  return segments_.empty() ? Outlook3::kFree : Outlook3::kEncroaches;
}

bool SolidView::leave_out_intestine() {
  const std::size_t before = segments_.size() + triangles_.size();
  segments_.erase(std::remove_if(segments_.begin(), segments_.end(),
                                 [&](SubsegmentId s) { return is_in_intestine(s); }),
                  segments_.end());
  triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(),
                                  [&](const FaceTriangle& t) { return is_in_collar(t); }),
                   triangles_.end());
  const bool some = segments_.size() + triangles_.size() < before;
  if (!segments_.empty()) {
    triangles_.clear();
    patches_.clear();
  }
  return some;
}

void SolidView::find_encroached_patches(const Point3& p) {
  for (const CellSlot c : dt_.cavity()) {
    const Delaunay3::Cell cell = dt_.cell(c);
    for_each_patch(cell.v, [&](PatchId id) {
      if (std::find(patches_.begin(), patches_.end(), id) != patches_.end()) return;
      if (ball(id).holds(p)) patches_.push_back(id);
    });
  }
}

}  // namespace circumball
