#ifndef CIRCUMBALL_PROTECTION_CIRCLE_H_
#define CIRCUMBALL_PROTECTION_CIRCLE_H_

#include <vector>

#include "circumball/types.h"

/// Where the vertices of a protecting circle lie (thesis, 5.3.1).
namespace circumball {

/// Points that cut the arc from a counter-clockwise to b, both on the circle of `radius` about
/// `center`, so that no piece spans more than a quarter turn; in order, without a and b: at most
/// three. a == b means the whole circle. Rounded: each coordinate within a few ulp of the largest.
std::vector<Point2> quarter_turns(const Point2& center, double radius, const Point2& a,
                                  const Point2& b);

/// Where the tangents of the circle at a and b meet: the arc lies in the hull of a, b, it, and the
/// center. The arc spans at most a quarter turn.
Point2 tangent_corner(const Point2& center, const Point2& a, const Point2& b);

}  // namespace circumball

#endif  // CIRCUMBALL_PROTECTION_CIRCLE_H_
