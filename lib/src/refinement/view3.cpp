#include "refinement/view3.h"

#include <algorithm>
#include <cmath>

namespace circumball {
namespace {

/// The predicates are exact for these (architecture.md, Numbers).
bool representable(const Point3& p) {
  const auto fine = [](double x) {
    return x == 0 || (x >= 1e-45 && x <= 1e55) || (x <= -1e-45 && x >= -1e55);
  };
  return fine(p.x) && fine(p.y) && fine(p.z);
}

}  // namespace

bool View3::probe_from(const Point3& p, CellSlot start) const {
  return representable(p) && dt_.probe(p, start) == Delaunay3::Probe::kOk;
}

bool View3::ready(const Point3& p, SubsegmentId s) {
  const Subsegment& u = live_.subsegment(s);
  return probe(p, u.a) && live_.probe_faces(p, {FeatureKind::kSegment, u.segment.value}, u.a);
}

bool View3::ready(const Point3& p, const FaceTriangle& t) {
  // The circumcenter was looked at in space when its safety was decided.
  FaceRefinement& face = live_.face(t.face);
  return face.probe(p, t.id) && face.cavity_holds(t.id);
}

double View3::insertion_radius(const Point3& p) const {
  dt_.cavity_neighbors(&neighbors_);
  double nearest2 = HUGE_VAL;
  for (const VertexId v : neighbors_)
    nearest2 = std::min(nearest2, squared_distance(dt_.point(v), p));
  return std::sqrt(nearest2);
}

bool View3::is_witness(VertexId p, SubsegmentId s) const {
  const Subsegment& u = live_.subsegment(s);
  const Feature& carrier = live_.feature(p);
  if (carrier.kind == FeatureKind::kVertex) return p != u.a && p != u.b;
  if (carrier.kind != FeatureKind::kSegment || carrier.index == u.segment.value) return false;
  // Another segment meets the simplex s in an input vertex, if at all.
  for (const std::uint32_t end : live_.complex().segments[carrier.index]) {
    if (VertexId(end) == u.a || VertexId(end) == u.b) return false;
  }
  return true;
}

double View3::squared_clearance_of_spindle(VertexId q0) const {
  if (!live_.is_input_vertex(q0)) return HUGE_VAL;
  if (clearances_.size() <= q0.value) clearances_.resize(live_.complex().vertices.size());
  Clearance& known = clearances_[q0.value];
  if (known.vertices == dt_.vertex_count()) return known.squared;
  double least2 = HUGE_VAL;
  const auto look_at = [&](VertexId q) {
    for_each_near_neighbor(q, HUGE_VAL, [&](VertexId p, double d2) {
      const Feature& carrier = live_.feature(p);
      if (p == q0 || carrier.kind > FeatureKind::kSegment) return true;
      if (carrier.kind == FeatureKind::kSegment) {
        const auto& ends = live_.complex().segments[carrier.index];
        if (VertexId(ends[0]) == q0 || VertexId(ends[1]) == q0) return true;
      }
      least2 = std::min(least2, d2);
      return true;
    });
  };
  look_at(q0);
  for (const SubsegmentId s : live_.subsegments_at(q0)) {
    const Subsegment& u = live_.subsegment(s);
    look_at(u.a == q0 ? u.b : u.a);
  }
  known = {dt_.vertex_count(), least2};
  return least2;
}

double View3::squared_circumradius(const FaceTriangle& t) const {
  const FaceRefinement& face = live_.face(t.face);
  const auto& v = face.triangulation().triangle(t.id).v;
  const double r = shape_of(face.point(v[0]), face.point(v[1]), face.point(v[2])).circumradius();
  return r * r;
}

Point2 View3::center_in_plane(const FaceTriangle& t) const {
  const FaceRefinement& face = live_.face(t.face);
  const auto& v = face.triangulation().triangle(t.id).v;
  // Always in extended precision: it is asked for once a split, and faces have thin triangles.
  return circumcenter_extended(face.point(v[0]), face.point(v[1]), face.point(v[2]));
}

Point3 View3::circumcenter(const FaceTriangle& t) const {
  return live_.face(t.face).plane().to_space(center_in_plane(t));
}

bool View3::circumcenter_is_in_face(const FaceTriangle& t) const {
  const Point2 c = center_in_plane(t);
  return std::isfinite(c.x) && std::isfinite(c.y) && live_.face(t.face).plane().contains(c);
}

bool View3::look(const Point3& c, const FaceTriangle& t) { return probe(c, corners(t)[0]); }

VertexId View3::near_segment_of_face(const Point3& c, std::uint32_t face) const {
  dt_.cavity_neighbors(&neighbors_);
  for (const VertexId q : neighbors_) {
    const double d2 = squared_distance(dt_.point(q), c);
    for (const SubsegmentId s : live_.subsegments_at(q)) {
      if (!live_.incidence().face_has_segment(face, live_.subsegment(s).segment.value)) continue;
      if (is_less(d2, squared_length(s))) return q;
    }
  }
  return VertexId();
}

}  // namespace circumball
