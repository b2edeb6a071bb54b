#ifndef CIRCUMBALL_ALGORITHMS_CIRCLES_H_
#define CIRCUMBALL_ALGORITHMS_CIRCLES_H_

#include <memory>

#include "refinement/stage.h"

namespace circumball {

/// The second half of step 1b for intestines (thesis, 5.3.1): puts the circle about each protected
/// input vertex into the complex, cut where segments cross it and so that no arc spans more than a
/// quarter turn. Runs after the collar simplices conform and the triangles are told apart, so that
/// only arcs inside the domain count: sectors outside of it get none. Nor do sectors where the
/// circle would leave the convex hull of a domain `hull`; there the end segments protect alone, as
/// collars do.
std::unique_ptr<Stage> draw_protecting_circles();

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_CIRCLES_H_
