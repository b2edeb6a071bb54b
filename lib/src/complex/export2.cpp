#include "complex/export2.h"

#include "complex/carried.h"

namespace circumball {
namespace {

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
  carry_attributes(complex, &mesh);
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
