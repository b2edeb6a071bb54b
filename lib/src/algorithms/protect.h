#ifndef CIRCUMBALL_ALGORITHMS_PROTECT_H_
#define CIRCUMBALL_ALGORITHMS_PROTECT_H_

#include <memory>
#include <vector>

#include "refinement/stage.h"
#include "sizing/sizing.h"

namespace circumball {

/// How acute input angles are protected.
struct Protection {
  double fraction = 0.45;                ///< of N(q0): the distance d
  bool all = false;                      ///< at every input vertex
  double size = 0;                       ///< bound on the circumradius; 0: none
  std::shared_ptr<const Sizing> sizing;  ///< the same, as a function of the place; null: none
};

/// Step 1b of Algorithm 5.1: protects acute input angles. Runs the feature size estimate (Algorithm
/// 3.1) on a triangulation of its own, takes d = `fraction` N(q0) at each input vertex q0 of an
/// acute angle (at each input vertex where `all`), and splits all segments at q0 at distance d.
/// With fraction = 0.45: b = 0.225, c0 = 0.45 and c1 = 0.45 sqrt 2, as the thesis asks (5.2.1).
///
/// What is refused for the sake of a protected simplex has a circumradius of at most d / sqrt 2,
/// and so has the fan in a disk. So d is at most the bound on the circumradius about q0, and small
/// enough for the area bounds of regions; then these bounds hold everywhere.
std::unique_ptr<Stage> protect_acute_angles(Protection how);

/// For each vertex, whether two input segments meet there at less than 90 degrees. Exact.
std::vector<bool> acute_vertices(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PROTECT_H_
