#include <cmath>

#include "io/formats.h"

// VTK's XML format for unstructured grids (VTK User's Guide, "VTK File Formats"), ASCII. Cells come
// first, then the subsegments as lines.
namespace circumball::io {
namespace {

/// Types of cells in VTK.
constexpr int kLine = 3, kTriangle = 5, kTetrahedron = 10;

/// <DataArray> with `count` entries, each a text of `element(i)`.
template <class Element>
std::string array(const std::string& type, const std::string& name, int components,
                  std::size_t count, Element element) {
  std::string out =
      "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" +
      (components > 1 ? " NumberOfComponents=\"" + std::to_string(components) + "\"" : "") +
      " format=\"ascii\">\n";
  for (std::size_t i = 0; i < count; ++i) {
    out += element(i);
    out += "\n";
  }
  return out + "</DataArray>\n";
}

std::string signed_index(std::uint32_t index) {
  return index == kNoIndex ? "-1" : std::to_string(index);
}

std::string point_data(const Mesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  std::string out;
  if (!mesh.vertex_features.empty()) {
    out += array("Int8", "feature_kind", 1, n, [&](std::size_t i) {
      return std::to_string(static_cast<int>(mesh.vertex_features[i].kind));
    });
    out += array("Int64", "feature", 1, n,
                 [&](std::size_t i) { return signed_index(mesh.vertex_features[i].index); });
  }
  if (!mesh.vertex_markers.empty())
    out += array("Int32", "marker", 1, n,
                 [&](std::size_t i) { return std::to_string(mesh.vertex_markers[i]); });
  const auto attributes = static_cast<std::size_t>(mesh.attributes_per_vertex);
  if (attributes > 0 && mesh.vertex_attributes.size() == attributes * n)
    for (std::size_t k = 0; k < attributes; ++k)
      out += array("Float64", "attribute_" + std::to_string(k + 1), 1, n, [&](std::size_t i) {
        return format_double(mesh.vertex_attributes[i * attributes + k]);
      });
  return "<PointData>\n" + out + "</PointData>\n";
}

}  // namespace

std::string write_vtu(const Mesh& mesh) {
  const std::size_t corners = static_cast<std::size_t>(mesh.dimension) + 1;
  const std::size_t cells = mesh.cell_count(), all = cells + mesh.edges.size();
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(mesh.vertices.size()) + "\" NumberOfCells=\"" + std::to_string(all) + "\">\n";
  out += "<Points>\n" +
         array("Float64", "points", 3, mesh.vertices.size(),
               [&](std::size_t i) {
                 const Point3& p = mesh.vertices[i];
                 return format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z);
               }) +
         "</Points>\n<Cells>\n";
  out += array("Int64", "connectivity", 1, all, [&](std::size_t i) {
    if (i >= cells) {
      const MeshEdge& e = mesh.edges[i - cells];
      return std::to_string(e.a) + " " + std::to_string(e.b);
    }
    std::string text;
    for (std::size_t k = 0; k < corners; ++k)
      text += (k ? " " : "") + std::to_string(mesh.cell(i)[k]);
    return text;
  });
  out += array("Int64", "offsets", 1, all, [&](std::size_t i) {
    return std::to_string(i < cells ? corners * (i + 1) : corners * cells + 2 * (i - cells + 1));
  });
  out += array("UInt8", "types", 1, all, [&](std::size_t i) {
    return std::to_string(i >= cells ? kLine : mesh.dimension == 2 ? kTriangle : kTetrahedron);
  });
  out += "</Cells>\n" + point_data(mesh) + "<CellData>\n";
  if (!mesh.cell_regions.empty())
    out += array("Float64", "region", 1, all, [&](std::size_t i) {
      return i < cells ? format_double(mesh.cell_regions[i]) : "0";
    });
  out += array("Int64", "feature", 1, all, [&](std::size_t i) {
    return i < cells ? "-1" : signed_index(mesh.edges[i - cells].segment);
  });
  if (!mesh.edge_markers.empty())
    out += array("Int32", "marker", 1, all, [&](std::size_t i) {
      return i < cells ? "0" : std::to_string(mesh.edge_markers[i - cells]);
    });
  return out + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace circumball::io
