#include "complex/live3.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// Four times the area of a triangle between pieces of straight sides that rounding bent is less
/// than this part of the square of its longest edge, or four times that edge by the rounding.
constexpr double kFlatTriangle = 1e-11;

/// Faces at a common segment are in one plane where the sine between them is at most this: twice
/// what `check` allows a face to deviate from its plane, and what rounding turns the planes by.
constexpr double kSamePlane = 2e-9, kSamePlaneOfRounded = 2e-6;

}  // namespace

Incidence3::Table Incidence3::table(std::size_t rows,
                                    std::vector<std::array<std::uint32_t, 2>>* pairs) {
  std::sort(pairs->begin(), pairs->end());
  pairs->erase(std::unique(pairs->begin(), pairs->end()), pairs->end());
  Table t;
  t.first.assign(rows + 1, 0);
  t.items.reserve(pairs->size());
  for (const auto& [row, item] : *pairs) {
    ++t.first[row + 1];
    t.items.push_back(item);
  }
  for (std::size_t i = 0; i < rows; ++i) t.first[i + 1] += t.first[i];
  return t;
}

Incidence3::Incidence3(const Complex& complex) {
  const std::size_t vertices = complex.vertices.size(), segments = complex.segments.size();
  std::vector<std::array<std::uint32_t, 2>> face_vertices, vertex_faces, segment_faces,
      vertex_segments;
  std::vector<std::array<std::uint32_t, 3>> by_ends;  // lower, higher, number
  by_ends.reserve(segments);
  for (std::uint32_t s = 0; s < segments; ++s) {
    const auto [low, high] = std::minmax(complex.segments[s][0], complex.segments[s][1]);
    by_ends.push_back({low, high, s});
    vertex_segments.push_back({low, s});
    vertex_segments.push_back({high, s});
  }
  std::sort(by_ends.begin(), by_ends.end());
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    const Face& face = complex.faces[f];
    for (const auto& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        face_vertices.push_back({f, loop[i]});
        const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
        const std::array<std::uint32_t, 3> side{low, high, 0};
        auto at = std::lower_bound(by_ends.begin(), by_ends.end(), side);
        for (; at != by_ends.end() && (*at)[0] == low && (*at)[1] == high; ++at) {
          segment_faces.push_back({(*at)[2], f});
        }
      }
    }
    for (const std::uint32_t s : face.segments) {
      segment_faces.push_back({s, f});
      for (const std::uint32_t v : complex.segments[s]) face_vertices.push_back({f, v});
    }
    for (const std::uint32_t v : face.vertices) face_vertices.push_back({f, v});
  }
  for (const auto& [f, v] : face_vertices) vertex_faces.push_back({v, f});
  face_vertices_ = table(complex.faces.size(), &face_vertices);
  vertex_faces_ = table(vertices, &vertex_faces);
  segment_faces_ = table(segments, &segment_faces);
  vertex_segments_ = table(vertices, &vertex_segments);
}

bool Incidence3::face_has_vertex(std::uint32_t face, std::uint32_t v) const {
  const Range faces = faces_of_vertex(v);
  return std::binary_search(faces.begin(), faces.end(), face);
}

bool Incidence3::face_has_segment(std::uint32_t face, std::uint32_t s) const {
  const Range faces = faces_of_segment(s);
  return std::binary_search(faces.begin(), faces.end(), face);
}

Live3::Live3(const Complex& complex, Domain domain)
    : complex_(&complex), incidence_(complex), domain_(domain) {
  features_.reserve(complex.vertices.size());
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    const Point3& p = complex.vertices[i];
    add_vertex(p, {FeatureKind::kVertex, i});
    rounding_ = std::max({rounding_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  rounding_ *= 8 * std::numeric_limits<double>::epsilon();
}

VertexId Live3::add_vertex(const Point3& p, Feature feature) {
  features_.push_back(feature);
  incident_.emplace_back();
  return triangulation_.add_vertex(p);
}

Incidence3::Range Live3::faces_of_lower(const Feature& feature) const {
  static constexpr std::uint32_t kNothing = 0;
  switch (feature.kind) {
    case FeatureKind::kVertex:
      return incidence_.faces_of_vertex(feature.index);
    case FeatureKind::kSegment:
      return incidence_.faces_of_segment(feature.index);
    default:
      return {&kNothing, &kNothing};
  }
}

bool Live3::on_one_segment(VertexId a, VertexId b, VertexId c) const {
  std::uint32_t segment = kNoIndex;
  for (const VertexId v : {a, b, c}) {
    if (feature(v).kind == FeatureKind::kSegment) segment = feature(v).index;
  }
  if (segment == kNoIndex) return false;  // three input vertices are not
  const auto& ends = complex_->segments[segment];
  for (const VertexId v : {a, b, c}) {
    const Feature& f = feature(v);
    const bool on =
        f.kind == FeatureKind::kSegment
            ? f.index == segment
            : f.kind == FeatureKind::kVertex && (f.index == ends[0] || f.index == ends[1]);
    if (!on) return false;
  }
  return true;
}

bool Live3::disjoint(const Feature& f, const Feature& g) const {
  // From the lower dimension to the higher.
  if (f.kind > g.kind) return disjoint(g, f);
  const auto touches = [&](std::uint32_t v) {
    switch (g.kind) {
      case FeatureKind::kVertex:
        return v == g.index;
      case FeatureKind::kSegment: {
        const auto& ends = complex_->segments[g.index];
        return v == ends[0] || v == ends[1];
      }
      default:
        return incidence_.face_has_vertex(g.index, v);
    }
  };
  switch (f.kind) {
    case FeatureKind::kVertex:
      return !touches(f.index);
    case FeatureKind::kSegment: {
      const auto& ends = complex_->segments[f.index];
      return !touches(ends[0]) && !touches(ends[1]);
    }
    default:
      for (const std::uint32_t v : incidence_.vertices_of_face(f.index)) {
        if (touches(v)) return false;
      }
      return true;
  }
}

void Live3::create_features() {
  const auto& segments = complex_->segments;
  subsegments_.reserve(2 * segments.size());
  std::vector<std::array<std::uint32_t, 3>> by_ends;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const auto [low, high] = std::minmax(segments[i][0], segments[i][1]);
    by_ends.push_back({low, high, i});
    subsegments_.push_back({VertexId(segments[i][0]), VertexId(segments[i][1]), SegmentId(i)});
  }
  // Of segments given twice (a warning of `check`) the first counts.
  std::sort(by_ends.begin(), by_ends.end());
  for (std::size_t k = 1; k < by_ends.size(); ++k) {
    const auto &first = by_ends[k - 1], &second = by_ends[k];
    if (first[0] == second[0] && first[1] == second[1]) subsegments_[second[2]].alive = false;
  }
  for (std::uint32_t i = 0; i < subsegment_count(); ++i) {
    if (subsegments_[i].alive) link(SubsegmentId(i));
  }
  const auto count = static_cast<std::uint32_t>(complex_->faces.size());
  faces_.reserve(count);
  for (std::uint32_t f = 0; f < count; ++f) {
    face_numbers_.push_back(f);
    faces_.emplace_back(*complex_, f);
    for (const std::uint32_t v : incidence_.vertices_of_face(f)) {
      faces_.back().add_vertex(VertexId(v), complex_->vertices[v]);
    }
    faces_.back().insert_all();
  }
  group_faces();
  for (std::uint32_t v = 0; v < complex_->vertices.size(); ++v) {
    local_first_.push_back(static_cast<std::uint32_t>(locals_.size()));
    for (const std::uint32_t f : incidence_.faces_of_vertex(v)) {
      // Vertices of a face are numbered by ascending number in the complex.
      const Incidence3::Range vertices = incidence_.vertices_of_face(f);
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
      locals_.push_back(VertexId(static_cast<std::uint32_t>(at - vertices.begin())));
    }
  }
}

void Live3::link(SubsegmentId s) {
  const Subsegment& u = subsegments_[s.value];
  incident_[u.a.value].push_back(s);
  incident_[u.b.value].push_back(s);
}

SubsegmentId Live3::subsegment_between(VertexId a, VertexId b) const {
  if (incident_[b.value].size() < incident_[a.value].size()) std::swap(a, b);
  for (const SubsegmentId s : incident_[a.value]) {
    const Subsegment& u = subsegments_[s.value];
    if (u.a == b || u.b == b) return s;
  }
  return SubsegmentId();
}

std::array<SubsegmentId, 2> Live3::split(SubsegmentId s, VertexId m) {
  Subsegment& old = subsegments_[s.value];
  old.alive = false;
  Subsegment first{old.a, m, old.segment}, second{m, old.b, old.segment};
  first.center = second.center = old.center;
  first.face = second.face = old.face;
  first.ring = second.ring = old.ring;
  first.is_generator = second.is_generator = old.is_generator;
  for (const VertexId end : {old.a, old.b}) {
    auto& at = incident_[end.value];
    at.erase(std::find(at.begin(), at.end(), s));
  }
  const SubsegmentId left(subsegment_count()), right(subsegment_count() + 1);
  subsegments_.push_back(first);  // `old` dangles from here on
  subsegments_.push_back(second);
  link(left);
  link(right);
  if (tracks_collars_) {
    tag_edges(left);
    tag_edges(right);
  }
  return {left, right};
}

bool Live3::is_pocket(std::uint32_t face, const Delaunay2::Triangle& t) const {
  VertexId v[3];
  for (int i = 0; i < 3; ++i) v[i] = faces_[face].global(t.v[i]);
  const auto lies_on = [&](VertexId p, std::uint32_t segment) {
    const Feature& f = feature(p);
    const auto& ends = complex_->segments[segment];
    return f == Feature{FeatureKind::kSegment, segment} ||
           (f.kind == FeatureKind::kVertex && (f.index == ends[0] || f.index == ends[1]));
  };
  // One of the three is no input vertex: input vertices on a line are no triangle of the input.
  for (const VertexId p : v) {
    const Feature& f = feature(p);
    if (f.kind != FeatureKind::kSegment) continue;
    return lies_on(v[0], f.index) && lies_on(v[1], f.index) && lies_on(v[2], f.index);
  }
  return false;
}

VertexId Live3::local(VertexId v, std::uint32_t face) const {
  const Feature& f = feature(v);
  if (f.kind == FeatureKind::kFace) {
    return f.index == face ? locals_[local_first_[v.value]] : VertexId();
  }
  const Incidence3::Range faces = faces_of_lower(f);
  const auto at = std::lower_bound(faces.begin(), faces.end(), face);
  if (at == faces.end() || *at != face) return VertexId();
  return locals_[local_first_[v.value] + static_cast<std::size_t>(at - faces.begin())];
}

FaceTriangle Live3::face_triangle(std::uint32_t face, VertexId a, VertexId b, VertexId c) const {
  const Delaunay2& dt = faces_[face].triangulation();
  const VertexId p = local(a, face), q = local(b, face), r = local(c, face);
  if (!p.valid() || !q.valid() || !r.valid()) return {};
  HalfEdge h = dt.find_edge(p, q);
  if (h == kNone) return {};
  if (dt.apex(h) != r) h = dt.twin(h);
  if (dt.apex(h) != r) return {};
  return {face, h / 4, dt.triangle(h / 4).birth};
}

bool Live3::is_in_face(std::uint32_t face, VertexId a, VertexId b, VertexId c) const {
  return lies_in_face(a, face) && lies_in_face(b, face) && lies_in_face(c, face) &&
         !on_one_segment(a, b, c) && is_in_polygon(face, a, b, c);
}

bool Live3::is_in_polygon(std::uint32_t face, VertexId a, VertexId b, VertexId c) const {
  const FacePlane& plane = faces_[face].plane();
  const Point2 p = plane.to_plane(triangulation_.point(a)),
               q = plane.to_plane(triangulation_.point(b)),
               r = plane.to_plane(triangulation_.point(c));
  const auto on_sides = [this](VertexId v) {
    return feature(v).kind == FeatureKind::kVertex || feature(v).kind == FeatureKind::kSegment;
  };
  if (on_sides(a) && on_sides(b) && on_sides(c)) {
    const TriangleShape shape = shape_of(p, q, r);
    const double longest = std::sqrt(shape.longest2);
    if (std::fabs(shape.area4) < longest * std::max(kFlatTriangle * longest, 4 * rounding_)) {
      return false;
    }
  }
  return plane.contains({(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3});
}

bool Live3::lies_in_group(VertexId v, std::uint32_t group) const {
  const Incidence3::Range faces = faces_of(feature(v));
  return std::any_of(faces.begin(), faces.end(),
                     [&](std::uint32_t f) { return groups_[f] == group; });
}

bool Live3::is_in_group(VertexId a, VertexId b, VertexId c) const {
  for (const std::uint32_t f : faces_of(feature(a))) {
    if (is_in_face(f, a, b, c)) return true;
    const std::uint32_t group = groups_[f];
    if (!lies_in_group(b, group) || !lies_in_group(c, group) || on_one_segment(a, b, c)) continue;
    for (const VertexId v : {a, b, c}) {
      for (const std::uint32_t g : faces_of(feature(v))) {
        if (groups_[g] == group && is_in_polygon(g, a, b, c)) return true;
      }
    }
  }
  return false;
}

/// How far rounding turns the plane of a face: by its vertices' over the width.
double Live3::tilt(std::uint32_t face) const {
  double most = 0;  // area over extent
  for (const auto& loop : complex_->faces[face].loops) {
    double area2 = 0, extent = 0;
    const Point2 o = faces_[face].plane().to_plane(complex_->vertices[loop[0]]);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t next = loop[i + 1 < loop.size() ? i + 1 : 0];
      const Point2 p = faces_[face].plane().to_plane(complex_->vertices[loop[i]]),
                   q = faces_[face].plane().to_plane(complex_->vertices[next]);
      area2 += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
      extent = std::max({extent, std::fabs(p.x - o.x), std::fabs(p.y - o.y)});
    }
    if (extent > 0) most = std::max(most, std::fabs(area2) / extent);
  }
  return most > 0 ? rounding_ / most : 0;
}

void Live3::group_faces() {
  groups_ = face_numbers_;
  std::vector<double> tilts(faces_.size());
  for (std::uint32_t f = 0; f < tilts.size(); ++f) tilts[f] = tilt(f);
  const auto root = [&](std::uint32_t f) {
    while (groups_[f] != f) f = groups_[f] = groups_[groups_[f]];
    return f;
  };
  for (std::uint32_t s = 0; s < complex_->segments.size(); ++s) {
    const Incidence3::Range faces = incidence_.faces_of_segment(s);
    for (const std::uint32_t* f = faces.begin(); f != faces.end(); ++f) {
      for (const std::uint32_t* g = f + 1; g != faces.end(); ++g) {
        const Point3 &m = faces_[*f].plane().normal(), &n = faces_[*g].plane().normal();
        const double x = m.y * n.z - m.z * n.y, y = m.z * n.x - m.x * n.z,
                     z = m.x * n.y - m.y * n.x;
        const double sine =
            std::max(kSamePlane, std::min(kSamePlaneOfRounded, tilts[*f] + tilts[*g]));
        if (x * x + y * y + z * z > sine * sine) continue;
        const std::uint32_t a = root(*f), b = root(*g);
        groups_[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  for (std::uint32_t f = 0; f < groups_.size(); ++f) groups_[f] = root(f);
}

void Live3::freeze(const FaceTriangle& t) {
  if (frozen_triangles_.size() < faces_.size()) frozen_triangles_.resize(faces_.size());
  auto& frozen = frozen_triangles_[t.face];
  if (frozen.size() <= t.id) frozen.resize(t.id + 1, kNone);
  frozen[t.id] = t.birth;
}

bool Live3::is_frozen(const FaceTriangle& t) const {
  return t.face < frozen_triangles_.size() && t.id < frozen_triangles_[t.face].size() &&
         frozen_triangles_[t.face][t.id] == t.birth;
}

double Live3::volume_bound(CellSlot c) const {
  const std::uint32_t label = triangulation_.label(c);
  if (!classified_ || label < kFirstRegion) return 0;
  return std::max(complex_->regions[label - kFirstRegion].max, 0.0);
}

bool Live3::probe_faces(const Point3& p, const Feature& feature, VertexId near) {
  for (const std::uint32_t f : faces_of(feature)) {
    FaceRefinement& face = faces_[f];
    const VertexId from = local(near, f);
    if (!face.probe(p, face.triangulation().triangle_of(from))) return false;
  }
  return true;
}

void Live3::commit_to_faces(VertexId v, SubsegmentId splitting) {
  local_first_.push_back(static_cast<std::uint32_t>(locals_.size()));
  for (const std::uint32_t f : faces_of(feature(v))) {
    const VertexId number = faces_[f].add_vertex(v, triangulation_.point(v));
    faces_[f].commit(number, splitting.value);
    locals_.push_back(number);
  }
}

std::size_t Live3::bytes() const {
  std::size_t bytes = triangulation_.bytes() + features_.capacity() * sizeof(Feature) +
                      subsegments_.capacity() * sizeof(Subsegment) +
                      incident_.capacity() * sizeof(incident_[0]) +
                      (locals_.capacity() + local_first_.capacity()) * sizeof(std::uint32_t);
  for (const FaceRefinement& face : faces_) bytes += face.bytes();
  if (intestine_) bytes += intestine_->bytes();
  for (const auto& at : incident_) bytes += at.capacity() * sizeof(SubsegmentId);
  return bytes;
}

}  // namespace circumball
