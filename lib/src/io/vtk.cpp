#include "io/formats.h"
#include "io/mesh_parts.h"
#include "io/vtk_cells.h"

// VTK's legacy format, version 3.0, ASCII (VTK User's Guide, "Simple Legacy Formats").
namespace circumball::io {
namespace {

std::string scalars(const std::vector<VtkArray>& all) {
  std::string out;
  for (const VtkArray& a : all) {
    const char* const type = a.type == "Float64" ? "double" : "int";
    out += "SCALARS " + a.name + " " + type + " 1\nLOOKUP_TABLE default\n";
    for (const std::string& value : a.values) out += value + "\n";
  }
  return out;
}

}  // namespace

std::string write_vtk(const Mesh& mesh, const Complex& complex) {
  const std::vector<VtkCell> cells = vtk_cells(mesh, complex);
  std::string out =
      "# vtk DataFile Version 3.0\nCircumball\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
      std::to_string(mesh.vertices.size()) + " double\n";
  for (const Point3& p : mesh.vertices) out += coordinates(p) + "\n";
  std::size_t numbers = 0;
  for (const VtkCell& c : cells) numbers += 1 + static_cast<std::size_t>(c.count);
  out += "CELLS " + std::to_string(cells.size()) + " " + std::to_string(numbers) + "\n";
  for (const VtkCell& c : cells) {
    out += std::to_string(c.count);
    for (int k = 0; k < c.count; ++k)
      out += " " + std::to_string(c.vertices[static_cast<std::size_t>(k)]);
    out += "\n";
  }
  out += "CELL_TYPES " + std::to_string(cells.size()) + "\n";
  for (const VtkCell& c : cells) out += std::to_string(c.type) + "\n";
  const std::string of_points = scalars(vtk_point_data(mesh));
  const std::string of_cells = scalars(vtk_cell_data(mesh, complex, cells));
  if (!of_points.empty())
    out += "POINT_DATA " + std::to_string(mesh.vertices.size()) + "\n" + of_points;
  return out + "CELL_DATA " + std::to_string(cells.size()) + "\n" + of_cells;
}

}  // namespace circumball::io
