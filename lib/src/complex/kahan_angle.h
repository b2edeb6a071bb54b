#ifndef CIRCUMBALL_COMPLEX_KAHAN_ANGLE_H_
#define CIRCUMBALL_COMPLEX_KAHAN_ANGLE_H_

#include <cmath>

#include "circumball/types.h"
#include "predicates/elementary.h"

namespace circumball {

/// Angle between two directions in degrees, 0 to 180: twice the arc tangent of |u/|u| - v/|v|| /
/// |u/|u| + v/|v|| (Kahan), which is accurate for small and for straight angles. A few units in the
/// last place.
inline double angle_degrees(const Point3& u, const Point3& v) {
  const double lu = std::sqrt(u.x * u.x + u.y * u.y + u.z * u.z);
  const double lv = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double ax = u.x * lv, ay = u.y * lv, az = u.z * lv;
  const double bx = v.x * lu, by = v.y * lu, bz = v.z * lu;
  const double difference =
      std::sqrt((ax - bx) * (ax - bx) + (ay - by) * (ay - by) + (az - bz) * (az - bz));
  const double sum =
      std::sqrt((ax + bx) * (ax + bx) + (ay + by) * (ay + by) + (az + bz) * (az + bz));
  constexpr double kTwiceDegrees = 114.59155902616465;  // 360 / pi
  if (difference == sum) return 90;
  if (difference < sum) return kTwiceDegrees * elementary::atan(difference / sum);
  return 180 - kTwiceDegrees * elementary::atan(sum / difference);
}

/// In the plane. The same to the bit, as zeros are added.
inline double angle_degrees(const Point2& u, const Point2& v) {
  return angle_degrees(xyz(u), xyz(v));
}

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_KAHAN_ANGLE_H_
