#include <algorithm>
#include <limits>

#include "io/formats.h"
#include "io/mesh_parts.h"

// MEDIT's .mesh, ASCII (P. Frey, MEDIT: an interactive mesh visualization software, INRIA RT-0253,
// 2001). References are integers: markers where there are any, else the number of the input feature
// from 1 (0: none, or not known); regions where they are integers, else 0.
namespace circumball::io {
namespace {

std::string reference(double label) {
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  const bool whole =
      label >= -kMost && label <= kMost && label == static_cast<double>(static_cast<int>(label));
  return whole ? std::to_string(static_cast<int>(label)) : "0";
}

std::string feature(std::uint32_t index) {
  return index == kNoIndex ? "0" : std::to_string(std::size_t{index} + 1);
}

template <class Vertices>
std::string row(const Vertices& vertices, int count, const std::string& reference) {
  std::string out;
  for (int k = 0; k < count; ++k)
    out += std::to_string(std::size_t{vertices[static_cast<std::size_t>(k)]} + 1) + " ";
  return out + reference + "\n";
}

std::string section(const char* name, std::size_t count) {
  return std::string("\n") + name + "\n" + std::to_string(count) + "\n";
}

}  // namespace

std::string write_medit(const Mesh& mesh, const Complex& complex) {
  std::string out = "MeshVersionFormatted 2\n\nDimension " + std::to_string(mesh.dimension) + "\n";
  out += section("Vertices", mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point3& p = mesh.vertices[i];
    out += mesh.dimension == 3 ? coordinates(p) : format_double(p.x) + " " + format_double(p.y);
    out +=
        " " + (mesh.vertex_markers.empty() ? "0" : std::to_string(mesh.vertex_markers[i])) + "\n";
  }
  if (!mesh.edges.empty()) out += section("Edges", mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const MeshEdge& e = mesh.edges[i];
    out +=
        row(std::array<std::uint32_t, 2>{e.a, e.b}, 2,
            mesh.edge_markers.empty() ? feature(e.segment) : std::to_string(mesh.edge_markers[i]));
  }
  if (!mesh.facets.empty()) out += section("Triangles", mesh.facets.size());
  for (const MeshFacet& f : mesh.facets)
    out += row(
        std::array<std::uint32_t, 3>{f.a, f.b, f.c}, 3,
        complex.face_markers.empty() ? feature(f.face) : std::to_string(facet_marker(f, complex)));
  out += section(mesh.dimension == 2 ? "Triangles" : "Tetrahedra", mesh.cell_count());
  for (std::size_t i = 0; i < mesh.cell_count(); ++i)
    out += row(right_handed(mesh, i), mesh.dimension + 1,
               mesh.cell_regions.empty() ? "0" : reference(mesh.cell_regions[i]));
  // The vertices of the input are corners, and subsegments are ridges: nobody shall move them.
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < mesh.vertex_features.size(); ++i)
    if (mesh.vertex_features[i].kind == FeatureKind::kVertex) corners.push_back(i + 1);
  for (const char* name : {"Corners", "RequiredVertices"}) {
    if (corners.empty()) break;
    out += section(name, corners.size());
    for (const std::size_t v : corners) out += std::to_string(v) + "\n";
  }
  for (const char* name : {"Ridges", "RequiredEdges"}) {
    if (mesh.edges.empty()) break;
    out += section(name, mesh.edges.size());
    for (std::size_t i = 1; i <= mesh.edges.size(); ++i) out += std::to_string(i) + "\n";
  }
  return out + "\nEnd\n";
}

}  // namespace circumball::io
