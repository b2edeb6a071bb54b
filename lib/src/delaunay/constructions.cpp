#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// A double-double number: the unevaluated sum hi + lo (Dekker 1971).
struct Twofold {
  double hi = 0, lo = 0;
};

Twofold fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

Twofold two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

Twofold two_product(double a, double b) {
  constexpr double kSplitter = 134217729;  // 2^27 + 1 (Veltkamp)
  const double p = a * b;
  const double ca = kSplitter * a, cb = kSplitter * b;
  const double ah = ca - (ca - a), al = a - ah;
  const double bh = cb - (cb - b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold s = two_sum(a.hi, b.hi);
  return fast_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

Twofold operator-(const Twofold& a, const Twofold& b) { return a + Twofold{-b.hi, -b.lo}; }

Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold p = two_product(a.hi, b.hi);
  return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

Twofold operator/(const Twofold& a, const Twofold& b) {
  const double q = a.hi / b.hi;
  const Twofold r = a - b * Twofold{q, 0};
  return fast_two_sum(q, r.hi / b.hi);
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
  const Twofold bx = two_sum(b.x, -a.x), by = two_sum(b.y, -a.y);
  const Twofold cx = two_sum(c.x, -a.x), cy = two_sum(c.y, -a.y);
  const Twofold b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Twofold cross = bx * cy - by * cx;
  const Twofold d = cross + cross;
  const Twofold ux = (cy * b2 - by * c2) / d, uy = (bx * c2 - cx * b2) / d;
  return {(Twofold{a.x, 0} + ux).hi, (Twofold{a.y, 0} + uy).hi};
}

}  // namespace circumball
