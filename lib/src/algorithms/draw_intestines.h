#ifndef CIRCUMBALL_ALGORITHMS_DRAW_INTESTINES_H_
#define CIRCUMBALL_ALGORITHMS_DRAW_INTESTINES_H_

#include <memory>

#include "refinement/stage3.h"

namespace circumball {

/// Step 2c of Algorithms 6.3 and 6.4: rings about segments with vertices in every face at them,
/// arcs in the faces about input vertices, seeds on spheres; then the patches between. After
/// prepare_segments with graded sizes.
/// `structured`: for 6.4.
std::unique_ptr<Stage3> draw_intestines(bool structured);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_DRAW_INTESTINES_H_
