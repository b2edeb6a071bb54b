#ifndef CIRCUMBALL_TESTS_PREDICATES_REFERENCE_H_
#define CIRCUMBALL_TESTS_PREDICATES_REFERENCE_H_

#include <boost/multiprecision/cpp_int.hpp>
#include <initializer_list>

#include "circumball/predicates.h"
#include "predicates/double_bits.h"

/// The predicates from their definitions, in exact integers: coordinates in units of the least last
/// place among them. The forms are not those of the library where another one exists.
namespace circumball::testing {

/// Wide enough for degree six over 2^-202 to 2^184, without allocation.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    2624, 2624, boost::multiprecision::signed_magnitude, boost::multiprecision::checked, void>>;

struct Vector {
  Integer x, y, z;
};

inline Integer dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

inline Sign sign(const Integer& i) { return static_cast<Sign>(i.sign()); }

/// The points as integers, all in the same unit, less the last one.
template <std::size_t N>
struct Differences {
  Vector v[N];  // v[N - 1] is zero

  explicit Differences(const Point3* const (&points)[N]) {
    int unit = 971;
    for (const Point3* p : points) {
      for (const double c : {p->x, p->y, p->z}) {
        const internal::Decoded d(c);
        if (d.mantissa != 0 && d.exponent < unit) unit = d.exponent;
      }
    }
    const auto integer = [unit](double c) {
      const internal::Decoded d(c);
      if (d.mantissa == 0) return Integer(0);
      Integer i(d.mantissa);
      i <<= d.exponent - unit;
      return d.negative ? Integer(-i) : i;
    };
    for (std::size_t i = 0; i < N; ++i) {
      v[i] = {integer(points[i]->x), integer(points[i]->y), integer(points[i]->z)};
    }
    const Vector last = v[N - 1];
    for (Vector& w : v) w = minus(w, last);
  }
};

inline Sign exact_orient2d(const Point3& a, const Point3& b, const Point3& c) {
  const Differences<3> d({&a, &b, &c});
  return sign(d.v[0].x * d.v[1].y - d.v[0].y * d.v[1].x);
}

/// The determinant of the rows a - d, b - d, c - d is a triple product.
inline Sign exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Differences<4> v({&a, &b, &c, &d});
  return sign(dot(v.v[0], cross(v.v[1], v.v[2])));
}

/// On the paraboloid z = x^2 + y^2, d lies below the plane of the lifted a, b, c or above it.
inline Sign exact_incircle(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  Differences<4> v({&a, &b, &c, &d});
  for (Vector& w : v.v) w.z = w.x * w.x + w.y * w.y;
  return sign(dot(v.v[0], cross(v.v[1], v.v[2])));
}

/// Expansion of the 4x4 determinant by the column of lifts, in triple products.
inline Sign exact_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                           const Point3& e) {
  const Differences<5> v({&a, &b, &c, &d, &e});
  const Vector &p = v.v[0], &q = v.v[1], &r = v.v[2], &s = v.v[3];
  const Vector pq = cross(p, q), rs = cross(r, s);
  return sign(dot(s, s) * dot(pq, r) - dot(r, r) * dot(pq, s) + dot(q, q) * dot(p, rs) -
              dot(p, p) * dot(q, rs));
}

/// Twice p minus the ends' sum against the ends' difference: |2p - a - b|^2 < |a - b|^2.
inline Sign exact_segment_ball(const Point3& a, const Point3& b, const Point3& p) {
  const Differences<3> d({&a, &b, &p});
  const Vector &u = d.v[0], &v = d.v[1];
  const Vector sum = {u.x + v.x, u.y + v.y, u.z + v.z}, difference = minus(u, v);
  return sign(dot(difference, difference) - dot(sum, sum));
}

/// With the normal n and the center o = w / (2 nn), all relative to c: p is inside if qq < 2 q . o,
/// times nn.
inline Sign exact_triangle_ball(const Point3& a, const Point3& b, const Point3& c,
                                const Point3& p) {
  const Differences<4> d({&a, &b, &p, &c});
  const Vector &u = d.v[0], &v = d.v[1], &q = d.v[2];
  const Vector n = cross(u, v);
  const Integer uu = dot(u, u), vv = dot(v, v);
  const Vector w = cross({uu * v.x - vv * u.x, uu * v.y - vv * u.y, uu * v.z - vv * u.z}, n);
  return sign(dot(q, w) - dot(q, q) * dot(n, n));
}

inline Sign exact_compare_distance(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) {
  const Differences<4> v({&a, &b, &c, &d});
  const Vector ab = minus(v.v[0], v.v[1]), cd = v.v[2];
  return sign(ab.x * ab.x + ab.y * ab.y - cd.x * cd.x - cd.y * cd.y);
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_PREDICATES_REFERENCE_H_
