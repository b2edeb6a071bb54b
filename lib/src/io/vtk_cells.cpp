#include "io/vtk_cells.h"

#include "io/mesh_parts.h"

namespace circumball::io {
namespace {

/// Types of cells in VTK.
constexpr int kLine = 3, kTriangle = 5, kTetrahedron = 10;

std::string signed_index(std::uint32_t index) {
  return index == kNoIndex ? "-1" : std::to_string(index);
}

/// An array whose entry i is the text `value(i)`.
template <class Value>
VtkArray array(std::string name, std::string type, std::size_t count, Value value) {
  VtkArray out{std::move(name), std::move(type), {}};
  out.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.values.push_back(value(i));
  return out;
}

}  // namespace

std::vector<VtkCell> vtk_cells(const Mesh& mesh, const Complex& complex) {
  std::vector<VtkCell> out;
  out.reserve(mesh.cell_count() + mesh.facets.size() + mesh.edges.size());
  const int type = mesh.dimension == 2 ? kTriangle : kTetrahedron;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    VtkCell cell{right_handed(mesh, i), mesh.dimension + 1, type};
    if (!mesh.cell_regions.empty()) cell.region = mesh.cell_regions[i];
    out.push_back(cell);
  }
  for (const MeshFacet& f : mesh.facets)
    out.push_back({{f.a, f.b, f.c, kNoIndex}, 3, kTriangle, 0, f.face, facet_marker(f, complex)});
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const MeshEdge& e = mesh.edges[i];
    out.push_back({{e.a, e.b, kNoIndex, kNoIndex},
                   2,
                   kLine,
                   0,
                   e.segment,
                   mesh.edge_markers.empty() ? 0 : mesh.edge_markers[i]});
  }
  return out;
}

std::vector<VtkArray> vtk_point_data(const Mesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  std::vector<VtkArray> out;
  if (!mesh.vertex_features.empty()) {
    out.push_back(array("feature_kind", "Int8", n, [&](std::size_t i) {
      return std::to_string(static_cast<int>(mesh.vertex_features[i].kind));
    }));
    out.push_back(array("feature", "Int64", n, [&](std::size_t i) {
      return signed_index(mesh.vertex_features[i].index);
    }));
  }
  if (!mesh.vertex_markers.empty())
    out.push_back(array("marker", "Int32", n,
                        [&](std::size_t i) { return std::to_string(mesh.vertex_markers[i]); }));
  const auto attributes = static_cast<std::size_t>(mesh.attributes_per_vertex);
  if (attributes > 0 && mesh.vertex_attributes.size() == attributes * n)
    for (std::size_t k = 0; k < attributes; ++k)
      out.push_back(array("attribute_" + std::to_string(k + 1), "Float64", n, [&](std::size_t i) {
        return format_double(mesh.vertex_attributes[i * attributes + k]);
      }));
  return out;
}

std::vector<VtkArray> vtk_cell_data(const Mesh& mesh, const Complex& complex,
                                    const std::vector<VtkCell>& cells) {
  const std::size_t n = cells.size();
  std::vector<VtkArray> out;
  if (!mesh.cell_regions.empty())
    out.push_back(array("region", "Float64", n,
                        [&](std::size_t i) { return format_double(cells[i].region); }));
  out.push_back(
      array("feature", "Int64", n, [&](std::size_t i) { return signed_index(cells[i].feature); }));
  if (!mesh.edge_markers.empty() || (mesh.dimension == 3 && !complex.face_markers.empty()))
    out.push_back(array("marker", "Int32", n,
                        [&](std::size_t i) { return std::to_string(cells[i].marker); }));
  return out;
}

}  // namespace circumball::io
