#include "io/formats.h"
#include "io/mesh_parts.h"

// PLY, ASCII. Beside the standard elements faces have the number of their input face, and edges
// that of their input segment (-1 for none), as properties of their own.
namespace circumball::io {
namespace {

std::string signed_index(std::uint32_t index) {
  return index == kNoIndex ? "-1" : std::to_string(index);
}

std::string head(const std::vector<Point3>& vertices, std::size_t faces, std::size_t edges) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices.size()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(faces) +
                    "\nproperty list int int vertex_indices\nproperty int face\nelement edge " +
                    std::to_string(edges) +
                    "\nproperty int vertex1\nproperty int vertex2\nproperty int segment\n"
                    "end_header\n";
  for (const Point3& p : vertices) out += coordinates(p) + "\n";
  return out;
}

template <class Corners>
std::string face_row(const Corners& corners, std::uint32_t face) {
  std::string out = std::to_string(corners.size());
  for (const std::uint32_t v : corners) out += " " + std::to_string(v);
  return out + " " + signed_index(face) + "\n";
}

std::string edge_row(std::uint32_t a, std::uint32_t b, std::uint32_t segment) {
  return std::to_string(a) + " " + std::to_string(b) + " " + signed_index(segment) + "\n";
}

}  // namespace

std::string write_ply_mesh(const Mesh& mesh) {
  const MeshSurface surface = surface_of(mesh);
  std::string out = head(surface.vertices, surface.triangles.size(), surface.edges.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    out += face_row(surface.triangles[i], surface.faces[i]);
  for (const MeshEdge& e : surface.edges) out += edge_row(e.a, e.b, e.segment);
  return out;
}

std::string write_ply_complex(const Complex& complex, std::string* error) {
  if (!only_polygons(complex, error)) return {};
  std::string out = head(complex.vertices, complex.faces.size(), complex.segments.size());
  for (std::uint32_t i = 0; i < complex.faces.size(); ++i)
    out += face_row(complex.faces[i].loops[0], i);
  for (std::uint32_t i = 0; i < complex.segments.size(); ++i)
    out += edge_row(complex.segments[i][0], complex.segments[i][1], i);
  return out;
}

}  // namespace circumball::io
