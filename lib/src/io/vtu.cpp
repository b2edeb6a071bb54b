#include "io/formats.h"
#include "io/mesh_parts.h"
#include "io/vtk_cells.h"

// VTK's XML format for unstructured grids (VTK User's Guide, "VTK File Formats"), ASCII.
namespace circumball::io {
namespace {

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

std::string arrays(const std::vector<VtkArray>& all) {
  std::string out;
  for (const VtkArray& a : all)
    out += array(a.type, a.name, 1, a.values.size(), [&](std::size_t i) { return a.values[i]; });
  return out;
}

}  // namespace

std::string write_vtu(const Mesh& mesh, const Complex& complex) {
  const std::vector<VtkCell> cells = vtk_cells(mesh, complex);
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(mesh.vertices.size()) + "\" NumberOfCells=\"" + std::to_string(cells.size()) +
      "\">\n";
  out += "<Points>\n" +
         array("Float64", "points", 3, mesh.vertices.size(),
               [&](std::size_t i) { return coordinates(mesh.vertices[i]); }) +
         "</Points>\n<Cells>\n";
  out += array("Int64", "connectivity", 1, cells.size(), [&](std::size_t i) {
    std::string text;
    for (int k = 0; k < cells[i].count; ++k)
      text += (k ? " " : "") + std::to_string(cells[i].vertices[static_cast<std::size_t>(k)]);
    return text;
  });
  std::size_t offset = 0;
  out += array("Int64", "offsets", 1, cells.size(), [&](std::size_t i) {
    return std::to_string(offset += static_cast<std::size_t>(cells[i].count));
  });
  out += array("UInt8", "types", 1, cells.size(),
               [&](std::size_t i) { return std::to_string(cells[i].type); });
  return out + "</Cells>\n<PointData>\n" + arrays(vtk_point_data(mesh)) +
         "</PointData>\n<CellData>\n" + arrays(vtk_cell_data(mesh, complex, cells)) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace circumball::io
