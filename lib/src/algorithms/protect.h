#ifndef CIRCUMBALL_ALGORITHMS_PROTECT_H_
#define CIRCUMBALL_ALGORITHMS_PROTECT_H_

#include <memory>
#include <vector>

#include "refinement/stage.h"

namespace circumball {

/// Step 1b of Algorithm 5.1: protects acute input angles. Runs the feature size estimate (Algorithm
/// 3.1) on a triangulation of its own, takes d = `fraction` N(q0) at each input vertex q0 of an
/// acute angle (at each input vertex where `all`), and splits all segments at q0 at distance d.
/// With fraction = 0.45: b = 0.225, c0 = 0.45 and c1 = 0.45 sqrt 2, as the thesis asks (5.2.1).
std::unique_ptr<Stage> protect_acute_angles(double fraction, bool all);

/// For each vertex, whether two input segments meet there at less than 90 degrees. Exact.
std::vector<bool> acute_vertices(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PROTECT_H_
