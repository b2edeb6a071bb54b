#ifndef CIRCUMBALL_IO_MESH_PARTS_H_
#define CIRCUMBALL_IO_MESH_PARTS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"

/// Parts of a mesh as the writers need them.
namespace circumball::io {

/// A cell as most formats have it: the first three corners of a tetrahedron counter-clockwise as
/// seen from the fourth (VTK, Gmsh, MEDIT, TetGen). Ours are the other way around (orient3d). Of a
/// triangle the first three count.
std::array<std::uint32_t, 4> right_handed(const Mesh& mesh, std::size_t cell);

/// The facets of tetrahedra that no second one has, counter-clockwise from outside; in the order of
/// the cells. O(n log n).
std::vector<std::array<std::uint32_t, 3>> hull_facets(const Mesh& mesh);

/// The marker of the input face that a facet lies on; 0 if the face or its marker is unknown.
std::int32_t facet_marker(const MeshFacet& facet, const Complex& complex);

/// A surface with its own vertices: the triangles of a mesh of the plane; of a mesh of space the
/// facets on input faces, or its hull where there are none.
struct MeshSurface {
  std::vector<Point3> vertices;  ///< those that are used, order kept
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> faces;  ///< the input face of each; kNoIndex if there is none
  std::vector<MeshEdge> edges;       ///< the subsegments
};
MeshSurface surface_of(const Mesh& mesh);

/// Whether a complex is what a list of polygons and lines can hold: each face one loop and nothing
/// in it. If not, `error` says what to do.
bool only_polygons(const Complex& complex, std::string* error);

/// The segments that are no sides of faces. O(n).
std::vector<std::uint32_t> segments_of_no_face(const Complex& complex);

/// "x y z"
std::string coordinates(const Point3& p);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_MESH_PARTS_H_
