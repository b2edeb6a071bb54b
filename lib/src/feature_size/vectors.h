#ifndef CIRCUMBALL_FEATURE_SIZE_VECTORS_H_
#define CIRCUMBALL_FEATURE_SIZE_VECTORS_H_

#include "circumball/types.h"

// The few vector operations of distances, alike in the plane and in space.
namespace circumball {

inline Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
inline Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
inline double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// a + t d.
inline Point2 along(const Point2& a, double t, const Point2& d) {
  return {a.x + t * d.x, a.y + t * d.y};
}
inline Point3 along(const Point3& a, double t, const Point3& d) {
  return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
}
/// |a x b|^2.
inline double cross2(const Point2& a, const Point2& b) {
  const double c = a.x * b.y - a.y * b.x;
  return c * c;
}
inline double cross2(const Point3& a, const Point3& b) {
  const Point3 c = cross(a, b);
  return dot(c, c);
}

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_VECTORS_H_
