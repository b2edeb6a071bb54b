#ifndef CIRCUMBALL_QUALITY_INSERTION_RADIUS_H_
#define CIRCUMBALL_QUALITY_INSERTION_RADIUS_H_

#include <cstddef>
#include <vector>

#include "circumball/types.h"

namespace circumball {

/// r_q of each point q (thesis, Definition 2.1.5) where points are numbered by birth: the distance
/// to the nearest point of a lower number; infinite for the first. Coordinates are finite. O(n log
/// n) in practice: a tree whose nodes know the lowest number in them.
std::vector<double> insertion_radii(const std::vector<Point2>& points);

/// The nearest point of a lower number for each point; kNoIndex for the first.
std::vector<std::uint32_t> nearest_of_lower_number(const std::vector<Point2>& points);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_INSERTION_RADIUS_H_
