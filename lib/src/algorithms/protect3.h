#ifndef CIRCUMBALL_ALGORITHMS_PROTECT3_H_
#define CIRCUMBALL_ALGORITHMS_PROTECT3_H_

#include <memory>

#include "refinement/stage3.h"

/// What comes before step 3 of the refinement with collar in space (thesis 6.2.1).
namespace circumball {

/// Splits segments until (H1) to (H3) hold: by the vertices on segments of a run of Algorithm 4.1,
/// once more each, and then where adjacent end segments differ or others are near.
std::unique_ptr<Stage3> prepare_segments();

/// Step 2c: collar vertices, collar segments and collar arcs.
std::unique_ptr<Stage3> draw_collars();

/// After all collar elements are edges: which triangles of faces belong to the collars.
std::unique_ptr<Stage3> label_collars();

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PROTECT3_H_
