#ifndef CIRCUMBALL_ALGORITHMS_PLAN_H_
#define CIRCUMBALL_ALGORITHMS_PLAN_H_

#include <memory>
#include <string>
#include <vector>

#include "circumball/refine.h"
#include "refinement/stage.h"
#include "sizing/sizing.h"

namespace circumball {

/// Options with every default filled in, as numbers.
struct Settings {
  std::string algorithm;
  Domain domain = Domain::kHull;
  double tau = 0;
  double size = 0;                       ///< bound on the circumradius; 0: none
  std::shared_ptr<const Sizing> sizing;  ///< the same, where it is not a number
  double protection = 0.45;              ///< distance of the collar, in N(q0)
  bool off_centers = false;  ///< where triangles are split: off-centers instead of circumcenters
  bool protect_all = false;  ///< at every input vertex, not only at those of acute angles
};

/// The steps of an algorithm, in order: the driver is this list. Step names are the thesis' where
/// it names them.
std::vector<std::unique_ptr<Stage>> plan(const Settings& settings);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PLAN_H_
