#include "complex/export2.h"

#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// Attributes of a vertex on a segment: those of the segment's ends, interpolated.
void interpolate(const Complex& complex, std::uint32_t segment, const Point2& p, double* out) {
  const auto& ends = complex.segments[segment];
  const Point2 a = xy(complex.vertices[ends[0]]), b = xy(complex.vertices[ends[1]]);
  const double whole = distance(a, b);
  const double s = whole > 0 ? distance(a, p) / whole : 0;
  const auto n = static_cast<std::size_t>(complex.attributes_per_vertex);
  for (std::size_t k = 0; k < n; ++k) {
    const double u = complex.vertex_attributes[ends[0] * n + k];
    const double v = complex.vertex_attributes[ends[1] * n + k];
    out[k] = u + s * (v - u);
  }
}

Mesh export_classified(Live2* live, std::uint32_t input_vertices) {
  const Delaunay2& dt = live->triangulation();
  const Complex& complex = live->complex();
  Mesh mesh;
  mesh.input_vertices = input_vertices;
  mesh.box_vertices = static_cast<std::uint32_t>(complex.vertices.size()) - input_vertices;
  const std::uint32_t n = dt.vertex_count();
  mesh.vertices.reserve(n);
  mesh.vertex_features.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.vertices.push_back(xyz(dt.point(VertexId(i))));
    mesh.vertex_features.push_back(live->feature(VertexId(i)));
  }
  const bool regions = !complex.regions.empty();
  for (TriangleId t = 0; t < dt.slot_count(); ++t) {
    if (!dt.alive(t) || !live->in_domain(t)) continue;
    const Delaunay2::Triangle& triangle = dt.triangle(t);
    for (const VertexId v : triangle.v) mesh.cells.push_back(v.value);
    if (!regions) continue;
    const bool seeded = triangle.label >= kFirstRegion;
    mesh.cell_regions.push_back(seeded ? complex.regions[triangle.label - kFirstRegion].label : 0);
  }
  const bool segment_markers = !complex.segment_markers.empty();
  for (std::uint32_t i = 0; i < live->subsegment_count(); ++i) {
    const SubsegmentId s(i);
    const Subsegment& u = live->subsegment(s);
    if (!u.alive || u.is_arc() || live->edge_of(s) == kNone) continue;
    mesh.edges.push_back({u.a.value, u.b.value, u.segment.value});
    if (segment_markers) mesh.edge_markers.push_back(complex.segment_markers[u.segment.value]);
  }
  if (!complex.vertex_markers.empty() || segment_markers) {
    mesh.vertex_markers.assign(n, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Feature& f = live->feature(VertexId(i));
      if (f.kind == FeatureKind::kVertex && !complex.vertex_markers.empty()) {
        mesh.vertex_markers[i] = complex.vertex_markers[f.index];
      } else if (f.kind == FeatureKind::kSegment && segment_markers) {
        mesh.vertex_markers[i] = complex.segment_markers[f.index];
      }
    }
  }
  if (complex.attributes_per_vertex > 0) {
    const auto k = static_cast<std::size_t>(complex.attributes_per_vertex);
    mesh.attributes_per_vertex = complex.attributes_per_vertex;
    mesh.vertex_attributes = complex.vertex_attributes;
    mesh.vertex_attributes.resize(n * k, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Feature& f = live->feature(VertexId(i));
      if (f.kind != FeatureKind::kSegment) continue;
      interpolate(complex, f.index, dt.point(VertexId(i)), &mesh.vertex_attributes[i * k]);
    }
  }
  return mesh;
}

}  // namespace

Mesh export_mesh(Live2* live, std::uint32_t input_vertices) {
  if (live->classified()) return export_classified(live, input_vertices);
  Live2 copy(*live);
  copy.classify();
  return export_classified(&copy, input_vertices);
}

}  // namespace circumball
