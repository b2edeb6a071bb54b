#ifndef CIRCUMBALL_FEATURE_SIZE_NEAREST_NEIGHBOR_H_
#define CIRCUMBALL_FEATURE_SIZE_NEAREST_NEIGHBOR_H_

#include <cstdint>

#include "circumball/types.h"
#include "complex/box_tree.h"

namespace circumball {

/// N(x): distance from x to the second nearest of the points of a tree (whose boxes are points;
/// thesis, Definition 2.1.6). `self`, if given, is the item that x itself is: from a vertex, to its
/// nearest other vertex. Infinite if there is none.
double nearest_neighbor(const BoxTree& points, const Point2& x, std::uint32_t self = kNoIndex);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_NEAREST_NEIGHBOR_H_
