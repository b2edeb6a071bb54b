#ifndef CIRCUMBALL_ALGORITHMS_REGISTRY3_H_
#define CIRCUMBALL_ALGORITHMS_REGISTRY3_H_

#include <vector>

#include "circumball/registry.h"

namespace circumball {

/// The entries of the registry for complexes in space.
std::vector<AlgorithmInfo> algorithms_in_space();

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_REGISTRY3_H_
