#ifndef CIRCUMBALL_IO_VTK_CELLS_H_
#define CIRCUMBALL_IO_VTK_CELLS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/io.h"

namespace circumball::io {

/// A cell as VTK has it: the mesh's cells come first, then the facets on input faces as triangles,
/// then the subsegments as lines.
struct VtkCell {
  std::array<std::uint32_t, 4> vertices;
  int count;                         ///< of the vertices
  int type;                          ///< 3 line, 5 triangle, 10 tetrahedron
  double region = 0;                 ///< of the mesh's cells
  std::uint32_t feature = kNoIndex;  ///< the input segment of a line, the input face of a facet
  std::int32_t marker = 0;
};
std::vector<VtkCell> vtk_cells(const Mesh& mesh, const Complex& complex);

/// One array of numbers for each point or for each cell.
struct VtkArray {
  std::string name, type;  ///< type: "Int8", "Int32", "Int64", "Float64"
  std::vector<std::string> values;
};
std::vector<VtkArray> vtk_point_data(const Mesh& mesh);
std::vector<VtkArray> vtk_cell_data(const Mesh& mesh, const Complex& complex,
                                    const std::vector<VtkCell>& cells);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_VTK_CELLS_H_
