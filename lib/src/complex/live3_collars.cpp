#include <algorithm>
#include <utility>

#include "complex/live3.h"

namespace circumball {
namespace {

/// Labels of triangles in the refinement of a face.
enum CollarLabel : std::uint32_t { kLost = 0, kInCollar = 1, kBeyond = 2, kOnTheWay = 3 };

}  // namespace

void Live3::track_collars() {
  tracks_collars_ = true;
  for (std::uint32_t i = 0; i < subsegment_count(); ++i) {
    if (subsegments_[i].alive) tag_edges(SubsegmentId(i));
  }
}

SubsegmentId Live3::create_collar_element(VertexId a, VertexId b, std::uint32_t face,
                                          VertexId center) {
  Subsegment element{a, b, SegmentId()};
  element.face = face;
  element.center = center;
  const SubsegmentId s(subsegment_count());
  subsegments_.push_back(element);
  link(s);
  tag_edges(s);
  return s;
}

SubsegmentId Live3::create_ring_arc(VertexId a, VertexId b, std::uint32_t ring) {
  Subsegment element{a, b, SegmentId()};
  element.ring = ring;
  const SubsegmentId s(subsegment_count());
  subsegments_.push_back(element);
  link(s);
  return s;
}

SubsegmentId Live3::create_generator(VertexId a, VertexId b, std::uint32_t ring) {
  const SubsegmentId s = create_ring_arc(a, b, ring);
  subsegments_[s.value].is_generator = true;
  return s;
}

bool Live3::is_in_intestine(VertexId v) const {
  const Feature& f = feature(v);
  return f.kind == FeatureKind::kSegment  ? is_protected(SegmentId(f.index))
         : f.kind == FeatureKind::kVertex ? is_protected(v)
                                          : false;
}

bool Live3::is_in_intestine(CellSlot c) const {
  VertexId v[4];
  bool one_sphere = true, one_tube = true;
  for (std::uint32_t i = 0; i < 4; ++i) {
    v[i] = triangulation_.corner(c, i);
    if (is_in_intestine(v[i])) return true;
    one_sphere &= intestine_->sphere_of(v[i]) != kNoIndex &&
                  intestine_->sphere_of(v[i]) == intestine_->sphere_of(v[0]);
    one_tube &= intestine_->tube_at(v[i]) != kNoIndex &&
                intestine_->tube_at(v[i]) == intestine_->tube_at(v[0]);
  }
  if (one_sphere) return true;
  if (!one_tube) return false;
  const Point3 &p = triangulation_.point(v[0]), &q = triangulation_.point(v[1]),
               &r = triangulation_.point(v[2]), &s = triangulation_.point(v[3]);
  return intestine_->tube(intestine_->tube_at(v[0]))
      .holds({0.25 * (p.x + q.x + r.x + s.x), 0.25 * (p.y + q.y + r.y + s.y),
              0.25 * (p.z + q.z + r.z + s.z)});
}

bool Live3::is_in_tube(CellSlot c) const {
  bool one_sphere = true;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const VertexId v = triangulation_.corner(c, i);
    if (is_input_vertex(v) && is_protected(v)) return false;
    one_sphere &= intestine_->sphere_of(v) != kNoIndex &&
                  intestine_->sphere_of(v) == intestine_->sphere_of(triangulation_.corner(c, 0));
  }
  return !one_sphere && is_in_intestine(c);
}

void Live3::tag_edges(SubsegmentId s) {
  const Subsegment& u = subsegments_[s.value];
  const auto tag = [&](std::uint32_t f) {
    Delaunay2& dt = faces_[f].triangulation();
    const HalfEdge h = dt.find_edge(local(u.a, f), local(u.b, f));
    if (h != kNone) dt.set_tag(h, s.value);
  };
  if (u.is_of_tube()) return;
  if (u.is_collar_element()) return tag(u.face);
  for (const std::uint32_t f : incidence_.faces_of_segment(u.segment.value)) tag(f);
}

void Live3::protect(std::vector<double> radii, const std::vector<bool>& segments) {
  protection_radii_ = std::move(radii);
  protected_segments_ = segments;
  for (Subsegment& u : subsegments_) {
    if (!u.alive || u.is_collar_element()) continue;
    u.is_collar = is_protected(u.segment) || is_protected(u.a) || is_protected(u.b);
  }
}

void Live3::label_collars() {
  for (std::uint32_t f = 0; f < face_count(); ++f) {
    Delaunay2& dt = faces_[f].triangulation();
    stack_.clear();
    const auto seed = [&](TriangleId t) {
      if (dt.is_ghost(t) || dt.triangle(t).label == kInCollar) return;
      dt.set_label(t, kInCollar);
      stack_.push_back(t);
    };
    for (TriangleId t = 0; t < dt.slot_count(); ++t) dt.set_label(t, kBeyond);
    for (TriangleId t = 0; t < dt.slot_count(); ++t) {
      if (dt.is_ghost(t)) continue;
      const auto& v = dt.triangle(t).v;
      const FaceRefinement& face = faces_[f];
      if (!is_in_face(f, face.global(v[0]), face.global(v[1]), face.global(v[2]))) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t tag = dt.tag(4 * t + i);
        const Feature& at = feature(face.global(v[i]));
        // On a protected segment, or at an input vertex that a circle is about.
        if (tag != kNone && subsegments_[tag].is_collar) seed(t);
        if (at.kind == FeatureKind::kVertex && is_protected(face.global(v[i]))) seed(t);
      }
    }
    while (!stack_.empty()) {
      const TriangleId t = stack_.back();
      stack_.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (dt.tag(4 * t + i) == kNone) seed(dt.twin(4 * t + i) / 4);
      }
    }
  }
}

bool Live3::is_in_collar(const FaceTriangle& t) {
  if (!tracks_collars_) return false;
  Delaunay2& dt = faces_[t.face].triangulation();
  std::uint32_t label = dt.triangle(t.id).label;
  if (label != kLost) return label == kInCollar;
  // Flood what lost its label until a triangle is met that has it.
  std::vector<TriangleId> piece{t.id};
  dt.set_label(t.id, kOnTheWay);
  for (std::size_t next = 0; next < piece.size(); ++next) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h = 4 * piece[next] + i;
      const TriangleId u = dt.twin(h) / 4;
      if (dt.tag(h) != kNone || dt.is_ghost(u)) continue;
      const std::uint32_t other = dt.triangle(u).label;
      if (other == kLost) {
        dt.set_label(u, kOnTheWay);
        piece.push_back(u);
      } else if (other != kOnTheWay) {
        label = other;
      }
    }
  }
  if (label == kLost) label = kBeyond;
  for (const TriangleId u : piece) dt.set_label(u, label);
  return label == kInCollar;
}

}  // namespace circumball
