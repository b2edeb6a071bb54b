#ifndef CIRCUMBALL_ALGORITHMS_SETTINGS_H_
#define CIRCUMBALL_ALGORITHMS_SETTINGS_H_

#include <memory>
#include <string>

#include "circumball/refine.h"
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
  double box_scale = 3;
  bool off_centers = false;     ///< where triangles are split: off-centers instead of circumcenters
  bool protect_all = false;     ///< at every input vertex, not only at those of acute angles
  bool estimate_sizes = false;  ///< in space: by Algorithm 4.1
  double size_factor = 0.8;     ///< in space: the c of (H2)
  double height = 0.6;          ///< in space: of collars
  std::string step2a = "fourths";  ///< in space: fourths | halves | adaptive
  double sliver_degrees = 0;  ///< in space: least dihedral angle of no sliver; 0: slivers are kept
  double min_edge = 0;        ///< limit of the run; 0: none
};

/// Fills in the defaults of `options`, checks the ranges of the registry, and sets `settings`. An
/// empty answer, or what is wrong.
std::string settle(const Complex& complex, Options* options, Settings* settings);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_SETTINGS_H_
