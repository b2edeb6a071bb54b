#include "complex/export3.h"

#include "complex/carried.h"
#include "delaunay/constructions.h"

namespace circumball {

Mesh export_mesh(Live3* live, std::uint32_t input_vertices) {
  const Delaunay3& dt = live->triangulation();
  const Complex& complex = live->complex();
  Mesh mesh;
  mesh.dimension = 3;
  mesh.input_vertices = input_vertices;
  mesh.box_vertices = static_cast<std::uint32_t>(complex.vertices.size()) - input_vertices;
  const std::uint32_t n = dt.vertex_count();
  mesh.vertices.reserve(n);
  mesh.vertex_features.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.vertices.push_back(dt.point(VertexId(i)));
    mesh.vertex_features.push_back(live->feature(VertexId(i)));
  }
  if (dt.dimension() == 3) {
    dt.for_each_cell([&](CellSlot c) {
      for (std::uint32_t i = 0; i < 4; ++i) mesh.cells.push_back(dt.corner(c, i).value);
    });
  }
  const bool segment_markers = !complex.segment_markers.empty();
  for (std::uint32_t i = 0; i < live->subsegment_count(); ++i) {
    const Subsegment& u = live->subsegment(SubsegmentId(i));
    if (!u.alive) continue;
    mesh.edges.push_back({u.a.value, u.b.value, u.segment.value});
    if (segment_markers) mesh.edge_markers.push_back(complex.segment_markers[u.segment.value]);
  }
  for (std::uint32_t f = 0; f < live->face_count(); ++f) {
    const FaceRefinement& face = live->face(f);
    face.triangulation().for_each_triangle([&](TriangleId t) {
      const Delaunay2::Triangle& triangle = face.triangulation().triangle(t);
      if (!live->is_inside(f, triangle)) return;
      const VertexId a = face.global(triangle.v[0]), b = face.global(triangle.v[1]),
                     c = face.global(triangle.v[2]);
      if (dt.find_facet(a, b, c) == kNone) return;
      mesh.facets.push_back({a.value, b.value, c.value, f});
    });
  }
  carry_attributes(complex, &mesh);
  return mesh;
}

}  // namespace circumball
