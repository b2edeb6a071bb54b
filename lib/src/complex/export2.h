#ifndef CIRCUMBALL_COMPLEX_EXPORT2_H_
#define CIRCUMBALL_COMPLEX_EXPORT2_H_

#include "circumball/mesh.h"
#include "complex/live2.h"

namespace circumball {

/// The mesh as it stands, restricted to the domain. Where the domain is not known yet (a run that
/// was stopped before its boundary conformed) it is found on a copy. O(n).
Mesh export_mesh(Live2* live, std::uint32_t input_vertices);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_EXPORT2_H_
