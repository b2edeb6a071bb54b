#ifndef CIRCUMBALL_MESH_H_
#define CIRCUMBALL_MESH_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/types.h"

namespace circumball {

/// A subsegment of the mesh: two vertices and the input segment it lies on.
struct MeshEdge {
  std::uint32_t a, b;
  std::uint32_t segment;  ///< index of the input segment; kNoIndex if unknown, or of the box
};

/// A facet of the mesh that lies on an input face (3D).
struct MeshFacet {
  std::uint32_t a, b, c;
  std::uint32_t face;
};

/// A simplicial mesh. Vertices are numbered: the input's in file order, then the box's, then
/// Steiner vertices by birth. Vertices that no cell uses stay (see `compact`).
struct Mesh {
  int dimension = 2;
  std::uint32_t input_vertices = 0;  ///< how many of the vertices are the input's; 0 if unknown
  std::uint32_t box_vertices = 0;    ///< how many, after those, are the corners of the box
  std::vector<Point3> vertices;
  /// (dimension + 1) vertex numbers for each cell, positively oriented (counter-clockwise in the
  /// plane).
  std::vector<std::uint32_t> cells;
  std::vector<double>
      cell_regions;  ///< empty, or one label for each cell (0: no region seed reached it)
  std::vector<Feature>
      vertex_features;  ///< empty (somebody else's mesh), or the smallest feature of each vertex
  std::vector<MeshEdge> edges;               ///< the subsegments
  std::vector<MeshFacet> facets;             ///< 3D
  std::vector<std::int32_t> vertex_markers;  ///< empty, or one for each vertex
  std::vector<std::int32_t> edge_markers;    ///< empty, or one for each of `edges`
  int attributes_per_vertex = 0;
  std::vector<double> vertex_attributes;  ///< attributes of the input vertices; Steiner vertices:
                                          ///< interpolated on segments, else 0

  std::size_t cell_count() const {
    return cells.size() / (static_cast<std::size_t>(dimension) + 1);
  }
  const std::uint32_t* cell(std::size_t i) const {
    return cells.data() + i * (static_cast<std::size_t>(dimension) + 1);
  }
};

/// Dihedral angles of a mesh in space.
struct DihedralHistogram {
  std::array<std::uint64_t, 18> counts{};  ///< of angles in [0, 10), [10, 20), … [170, 180] degrees
  double min = 0, max = 0;                 ///< degrees; 0 where there is no cell
  std::uint64_t slivers = 0;               ///< cells with an angle below the bound
};
/// Six angles a cell, some ulp accurate; empty for a mesh in the plane.
DihedralHistogram dihedral_histogram(const Mesh& mesh, double bound_degrees = 0);

/// FNV-1a 64 over the mesh's coordinates and cells: the same on every platform (16 hex digits).
/// Order of cells and of vertices within a cell does not matter; numbering of vertices does.
std::string fingerprint(const Mesh& mesh);

/// The mesh without the vertices that no cell uses; renumbered, order kept.
Mesh compact(const Mesh& mesh);

}  // namespace circumball

#endif  // CIRCUMBALL_MESH_H_
