#ifndef CIRCUMBALL_QUALITY_PROTECTED_VERTICES_H_
#define CIRCUMBALL_QUALITY_PROTECTED_VERTICES_H_

#include <vector>

#include "quality/context.h"

namespace circumball {

/// The distance d at which each vertex of a mesh is protected (thesis, 5.2.1), read off the mesh:
/// the length of the subsegments at it, the longest where they differ. 0 for vertices that are no
/// input vertices of an acute angle (two segments at less than 90 degrees, exactly; any input
/// vertex where all are protected), and where it has no subsegment in the mesh.
std::vector<double> protection_distances(const VerifyContext& context);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_PROTECTED_VERTICES_H_
