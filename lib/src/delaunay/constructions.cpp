#include "delaunay/constructions.h"

#include "predicates/twofold.h"

namespace circumball {
namespace {

using internal::two_sum;
using internal::Twofold;

Twofold operator/(const Twofold& a, const Twofold& b) {
  using internal::operator-, internal::operator*;
  const double q = a.high / b.high;
  const Twofold r = a - b * Twofold{q, 0};
  return internal::twofold(internal::fast_two_sum(q, r.high / b.high));
}

}  // namespace

double squared_distance_of_segments(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d) {
  const auto clamped = [](double t) { return t < 0 ? 0 : t > 1 ? 1 : t; };
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = d.x - c.x, vy = d.y - c.y, vz = d.z - c.z;
  const double wx = a.x - c.x, wy = a.y - c.y, wz = a.z - c.z;
  const double uu = ux * ux + uy * uy + uz * uz, vv = vx * vx + vy * vy + vz * vz;
  const double uv = ux * vx + uy * vy + uz * vz;
  const double uw = ux * wx + uy * wy + uz * wz, vw = vx * wx + vy * wy + vz * wz;
  double s = 0, t = 0;
  if (uu > 0 && vv > 0) {
    const double determinant = uu * vv - uv * uv;
    s = determinant > 0 ? clamped((uv * vw - uw * vv) / determinant) : 0;
    t = clamped((uv * s + vw) / vv);
    s = clamped((uv * t - uw) / uu);
  } else if (uu > 0) {
    s = clamped(-uw / uu);
  } else if (vv > 0) {
    t = clamped(vw / vv);
  }
  const Point3 p = point_between(a, b, s), q = point_between(c, d, t);
  return squared_distance(p, q);
}

Point2 circumcenter_extended(const Point2& a, const Point2& b, const Point2& c) {
  using internal::operator+, internal::operator-, internal::operator*;
  const auto difference = [](double p, double q) { return internal::twofold(two_sum(p, -q)); };
  const Twofold bx = difference(b.x, a.x), by = difference(b.y, a.y);
  const Twofold cx = difference(c.x, a.x), cy = difference(c.y, a.y);
  const Twofold b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Twofold cross = bx * cy - by * cx;
  const Twofold d = cross + cross;
  const Twofold ux = (cy * b2 - by * c2) / d, uy = (bx * c2 - cx * b2) / d;
  return {(Twofold{a.x, 0} + ux).high, (Twofold{a.y, 0} + uy).high};
}

}  // namespace circumball
