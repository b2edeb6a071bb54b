#ifndef CIRCUMBALL_COMPLEX_EXPORT3_H_
#define CIRCUMBALL_COMPLEX_EXPORT3_H_

#include "circumball/mesh.h"
#include "complex/live3.h"

namespace circumball {

/// The tetrahedralization as it stands. `edges` are all subsegments, whether or not they are edges
/// of cells: what chapter 4 estimates sizes on. `facets` are the triangles of the refinements of
/// faces, inside of their polygons, that are facets of cells. O(n).
Mesh export_mesh(Live3* live, std::uint32_t input_vertices);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_EXPORT3_H_
