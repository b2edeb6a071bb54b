#include "delaunay/tetrahedron_shape.h"

#include <algorithm>
#include <cmath>

#include "delaunay/constructions.h"
#include "predicates/twofold.h"

namespace circumball {
namespace {

/// Below this part of the product of the lengths of three edges, the determinant has lost too many
/// digits: its absolute error is about 1e-15 of that product.
constexpr double kThin = 1e-5;

using internal::Twofold;

// Of double-doubles, named as the built-in ones are.
using internal::operator+;
using internal::operator-;
using internal::operator*;
/// Relative error about 2^-104.
Twofold operator/(const Twofold& a, const Twofold& b) {
  const double q = a.high / b.high;
  const Twofold r = a - b * Twofold{q, 0};
  return internal::twofold(internal::fast_two_sum(q, r.high / b.high));
}

template <class Number>
struct Vector {
  Number x, y, z;
};

template <class Number>
Vector<Number> cross(const Vector<Number>& u, const Vector<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

template <class Number>
Number dot(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// Circumcenter of the tetrahedron 0uvw: (|u|^2 v x w + |v|^2 w x u + |w|^2 u x v) / (2 u . v x w).
template <class Number>
Vector<Number> center(const Vector<Number>& u, const Vector<Number>& v, const Vector<Number>& w,
                      Number* det) {
  const Vector<Number> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Number uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  *det = dot(u, vw);
  const Number twice = *det + *det;
  return {(uu * vw.x + vv * wu.x + ww * uv.x) / twice, (uu * vw.y + vv * wu.y + ww * uv.y) / twice,
          (uu * vw.z + vv * wu.z + ww * uv.z) / twice};
}

Vector<double> minus(const Point3& p, const Point3& o) { return {p.x - o.x, p.y - o.y, p.z - o.z}; }
Vector<Twofold> minus_extended(const Point3& p, const Point3& o) {
  const auto difference = [](double a, double b) {
    return internal::twofold(internal::two_sum(a, -b));
  };
  return {difference(p.x, o.x), difference(p.y, o.y), difference(p.z, o.z)};
}

}  // namespace

TetrahedronShape tetrahedron_shape(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) {
  TetrahedronShape shape;
  const double ab = squared_distance(a, b), ac = squared_distance(a, c),
               ad = squared_distance(a, d), bc = squared_distance(b, c),
               bd = squared_distance(b, d), cd = squared_distance(c, d);
  shape.shortest2 = std::min({ab, ac, ad, bc, bd, cd});
  shape.longest2 = std::max({ab, ac, ad, bc, bd, cd});
  double det = 0;
  Vector<double> o = center(minus(b, a), minus(c, a), minus(d, a), &det);
  shape.circumcenter = {a.x + o.x, a.y + o.y, a.z + o.z};
  if (!(std::fabs(det) > kThin * std::sqrt(ab) * std::sqrt(ac) * std::sqrt(ad))) {
    Twofold det2;
    const auto e = center(minus_extended(b, a), minus_extended(c, a), minus_extended(d, a), &det2);
    det = det2.high;
    o = {e.x.high, e.y.high, e.z.high};
    shape.circumcenter = {(Twofold{a.x, 0} + e.x).high, (Twofold{a.y, 0} + e.y).high,
                          (Twofold{a.z, 0} + e.z).high};
  }
  shape.volume6 = std::fabs(det);
  const double radius2 = dot(o, o);
  shape.circumradius2 = std::isfinite(radius2) ? radius2 : HUGE_VAL;
  return shape;
}

double least_dihedral_cosine(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  // Normals of the facets, inwards at a (or all outwards), of bcd the other way.
  const Vector<double> u = minus(b, a), v = minus(c, a), w = minus(d, a);
  const Vector<double> n[3] = {cross(v, w), cross(w, u), cross(u, v)};
  const Vector<double> m = {n[0].x + n[1].x + n[2].x, n[0].y + n[1].y + n[2].y,
                            n[0].z + n[1].z + n[2].z};
  const double mm = dot(m, m);
  const double nn[3] = {dot(n[0], n[0]), dot(n[1], n[1]), dot(n[2], n[2])};
  double cosine = -1;
  const auto look_at = [&](double product, double squares) {
    const double x = product / std::sqrt(squares);
    cosine = x > cosine || !std::isfinite(x) ? x : cosine;
  };
  for (unsigned i = 0; i < 3; ++i) {
    look_at(dot(m, n[i]), mm * nn[i]);
    look_at(-dot(n[i], n[(i + 1) % 3]), nn[i] * nn[(i + 1) % 3]);
  }
  return std::isfinite(cosine) ? std::min(cosine, 1.0) : 1;
}

TriangleBall triangle_ball(const Point3& a, const Point3& b, const Point3& c) {
  const Vector<double> u = minus(b, a), v = minus(c, a);
  const Vector<double> n = cross(u, v);
  const double uu = dot(u, u), vv = dot(v, v), nn = dot(n, n);
  // The center, relative to a: (|u|^2 v x n + |v|^2 n x u) / (2 |n|^2).
  const Vector<double> vn = cross(v, n), nu = cross(n, u);
  const double t = 0.5 / nn;
  const Vector<double> o = {(uu * vn.x + vv * nu.x) * t, (uu * vn.y + vv * nu.y) * t,
                            (uu * vn.z + vv * nu.z) * t};
  return {a, {o.x, o.y, o.z}, dot(o, o)};
}

}  // namespace circumball
