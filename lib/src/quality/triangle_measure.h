#ifndef CIRCUMBALL_QUALITY_TRIANGLE_MEASURE_H_
#define CIRCUMBALL_QUALITY_TRIANGLE_MEASURE_H_

#include "circumball/types.h"

namespace circumball {

/// Lengths of a triangle, with a bound on what rounding did to them.
struct TriangleMeasure {
  double circumradius = 0;  ///< infinite for a flat triangle
  double shortest = 0, longest = 0;
  double radius_edge = 0;  ///< thesis, Definition 2.1.2
  double cross = 0;        ///< twice the signed area
  /// Bound on the relative error of circumradius and radius_edge, and of any other evaluation of
  /// abc / 4A that takes differences of coordinates first. Below 1e-11: where differences cancel,
  /// the area is taken in twice the precision.
  double error = 0;
};
TriangleMeasure measure_triangle(const Point2& a, const Point2& b, const Point2& c);

/// Smallest and largest angle in degrees, a few ulp accurate; reported only, never decided with.
struct AngleRange {
  double min, max;
};
AngleRange angles_degrees(const Point2& a, const Point2& b, const Point2& c);

/// The angle in degrees, a few ulp accurate; reported only.
double degrees_of_cosine(double cosine);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_TRIANGLE_MEASURE_H_
