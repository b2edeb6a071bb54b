#ifndef CIRCUMBALL_PREDICATES_FAST_H_
#define CIRCUMBALL_PREDICATES_FAST_H_

#include <cmath>

#include "circumball/types.h"
#include "predicates/counters.h"
#include "predicates/double_bits.h"
#include "predicates/pair.h"

// Like the vectors of predicates/pair.h, these are extensions that GCC and Clang share.
#define CIRCUMBALL_COLD __attribute__((cold, noinline))
#define CIRCUMBALL_LIKELY(condition) __builtin_expect(static_cast<bool>(condition), 1)

/// Predicates for the kernels: the filter is inline, what follows it is not.
///
/// Each `*_filtered` returns a double whose *sign* is the exact sign of the predicate (see
/// circumball/predicates.h for the meaning of the signs); its magnitude means nothing.
///
/// Why the filters are right. Write eps = 2^-53. By the standard model, a sum of monomials, each of
/// which passes through at most k roundings, is computed with an error of at most gamma_k P, where
/// P is the sum of the absolute values of the monomials and gamma_k = k eps / (1 - k eps) (Higham,
/// Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, Lemma 3.1). The last rounding need
/// not be counted: it never changes a sign. The comments give k and an upper bound of P that is
/// cheap to compute. The constants are (k + 1/2) eps or more: half an eps, at least 3 % of the
/// bound, covers gamma_k - k eps and the dozen roundings of the bound itself. Where the bound is
/// zero, the determinant is exactly zero; so `>=` decides that case, too.
///
/// Why nothing underflows. Doubles that are zero or at least 1e-45 > 2^-150 are multiples of u =
/// 2^-202, hence so are their differences, rounded or not, and a product of d differences, rounded
/// or not, is a multiple of u^d: a rounding to 53 bits never leaves such a lattice. For d <= 5 u^d
/// >= 2^-1010 is a normal number, so that the standard model holds without an underflow term; and
/// an error that is not zero is at least u^d, so that a bound which matters is normal as well.
/// Differences are at most 2^184, so nothing overflows: degree 5 stays below 2^940. (The ball of a
/// triangle has degree 6 and looks after itself.)
namespace circumball {

namespace internal {
/// The stages after the filter. They return a double of the exact sign. `cold` keeps them, and what
/// a call to them costs in registers, out of the hot path.
CIRCUMBALL_COLD double orient2d_exact(double ax, double ay, double bx, double by, double cx,
                                      double cy);
CIRCUMBALL_COLD double orient3d_exact(const Point3& a, const Point3& b, const Point3& c,
                                      const Point3& d);
CIRCUMBALL_COLD double incircle_exact(double ax, double ay, double bx, double by, double cx,
                                      double cy, double dx, double dy);
CIRCUMBALL_COLD double insphere_exact(const Point3& a, const Point3& b, const Point3& c,
                                      const Point3& d, const Point3& e);
CIRCUMBALL_COLD double segment_ball2_exact(double ax, double ay, double bx, double by, double px,
                                           double py);
CIRCUMBALL_COLD double segment_ball3_exact(const Point3& a, const Point3& b, const Point3& p);
CIRCUMBALL_COLD double triangle_ball_exact(const Point3& a, const Point3& b, const Point3& c,
                                           const Point3& p);
CIRCUMBALL_COLD double compare_distance_exact(const Point2& a, const Point2& b, const Point2& c,
                                              const Point2& d);

constexpr double kEpsilon = 0x1p-53;  ///< the unit roundoff: half a unit in the last place of 1

constexpr double kOrient2dBound = 7 * kEpsilon;
constexpr double kOrient3dBound = 7.5 * kEpsilon;
constexpr double kIncircleBound = 10.5 * kEpsilon;
constexpr double kInsphereBound = 2.3 * kEpsilon;
constexpr double kSegmentBall2Bound = 7 * kEpsilon;
constexpr double kSegmentBall3Bound = 9 * kEpsilon;
constexpr double kTriangleBallBound = 20 * kEpsilon;
constexpr double kDistanceBound = 9 * kEpsilon;

/// At least sqrt(x) and at most 1.07 sqrt(x), for positive normal x, by halving the exponent with
/// the mantissa for its fraction: x = 4^k (1 + f) gives 2^k (1 + f / 2), and x = 4^k 2 (1 + f)
/// gives 2^k (3 + f) / 2; the inequality of the means says that neither is too small. std::sqrt
/// might have to set errno, which costs more than the rest of a filter.
inline double sqrt_bound(double x) {
  // Half of the exponent's bias of 1023, in place.
  return from_bits((to_bits(x) >> 1) + 0x1ff8000000000000u);
}
}  // namespace internal

/// Sign of orient2d(a, b, c).
/// k = 3 (two differences, a product), P = |left| + |right| <= |left - right| + 2 |right| (so do
/// with one of the two, which saves an addition to Shewchuk's filter of 1997, section 4.1): if
/// |det| >= 7 eps |right|, then 3 eps P <= 3 eps |det| + 6/7 |det| < |det|.
inline double orient2d_filtered(double ax, double ay, double bx, double by, double cx, double cy) {
  using internal::Pair, internal::swapped;
  const Pair c = {cx, cy};
  const Pair products = (Pair{ax, ay} - c) * swapped(Pair{bx, by} - c);
  const double left = products[0], right = products[1];
  const double det = left - right;
  if (CIRCUMBALL_LIKELY(std::fabs(det) >= internal::kOrient2dBound * std::fabs(right))) {
    internal::count_filter(internal::Predicate::kOrient2d);
    return det;
  }
  return internal::orient2d_exact(ax, ay, bx, by, cx, cy);
}

/// Sign of incircle(a, b, c, d).
/// With A, B, C the squared distances of a, b, c from d: k = 10 (A: 4; a product of two
/// differences: 3; their product; two sums), and P <= AB + BC + CA, because |bx cy| + |by cx| <=
/// |b| |c| <= (B + C) / 2 by Cauchy-Schwarz and the means.
inline double incircle_filtered(double ax, double ay, double bx, double by, double cx, double cy,
                                double dx, double dy) {
  using internal::both, internal::Pair, internal::swapped;
  const Pair d = {dx, dy};
  const Pair ad = Pair{ax, ay} - d, bd = Pair{bx, by} - d, cd = Pair{cx, cy} - d;
  const Pair aa = ad * ad, bb = bd * bd, cc = cd * cd;
  const double a2 = aa[0] + aa[1], b2 = bb[0] + bb[1], c2 = cc[0] + cc[1];
  // The first and the second products of the three minors, apart until the end.
  const Pair products =
      both(a2) * (bd * swapped(cd)) + both(b2) * (cd * swapped(ad)) + both(c2) * (ad * swapped(bd));
  const double det = products[0] - products[1];
  if (CIRCUMBALL_LIKELY(std::fabs(det) >= internal::kIncircleBound * (a2 * (b2 + c2) + b2 * c2))) {
    internal::count_filter(internal::Predicate::kIncircle);
    return det;
  }
  return internal::incircle_exact(ax, ay, bx, by, cx, cy, dx, dy);
}

/// Sign of orient3d(a, b, c, d).
/// k = 7 (a product of two differences: 3; a difference; their product; two sums); P as it stands.
inline double orient3d_filtered(const Point3& a, const Point3& b, const Point3& c,
                                const Point3& d) {
  using internal::absolute, internal::both, internal::Pair, internal::swapped;
  const Pair dxy = {d.x, d.y};
  const Pair ad = Pair{a.x, a.y} - dxy, bd = Pair{b.x, b.y} - dxy, cd = Pair{c.x, c.y} - dxy;
  // The first and the second products of the three minors, apart until the end.
  const Pair t = both(a.z - d.z) * (bd * swapped(cd));
  const Pair u = both(b.z - d.z) * (cd * swapped(ad));
  const Pair v = both(c.z - d.z) * (ad * swapped(bd));
  const Pair products = t + u + v;
  const Pair absolutes = absolute(t) + absolute(u) + absolute(v);
  const double det = products[0] - products[1];
  const double permanent = absolutes[0] + absolutes[1];
  if (CIRCUMBALL_LIKELY(std::fabs(det) >= internal::kOrient3dBound * permanent)) {
    internal::count_filter(internal::Predicate::kOrient3d);
    return det;
  }
  return internal::orient3d_exact(a, b, c, d);
}

/// Sign of insphere(a, b, c, d, e).
/// k = 15 (a squared distance: 5; the 3x3 minor: 8; their product; one of two sums). The permanent
/// of a 3x3 matrix is at most 6 / 3^(3/2) times the product of the lengths of its rows (Carlen,
/// Lieb, Loss, Methods Appl. Anal. 13, 2006), so with S the sum of the four squared distances P
/// <= 1.1548 |a||b||c||d| (|a|+|b|+|c|+|d|) <= 1.1548 (S/4)^2 2 sqrt(S) < 0.1444 S^2 sqrt(S), by
/// the inequality of the means; 15.5 * 0.1444 < 2.3.
inline double insphere_filtered(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const Point3& e) {
  using internal::both, internal::Pair, internal::swapped;
  const Pair exy = {e.x, e.y};
  const Pair axy = Pair{a.x, a.y} - exy, bxy = Pair{b.x, b.y} - exy;
  const Pair cxy = Pair{c.x, c.y} - exy, dxy = Pair{d.x, d.y} - exy;
  const Pair acz = Pair{a.z, c.z} - both(e.z), bdz = Pair{b.z, d.z} - both(e.z);
  // Minors of two rows, two at a time: ab = ax by - bx ay and so on.
  const Pair ab = axy * swapped(bxy), bc = bxy * swapped(cxy), cd = cxy * swapped(dxy);
  const Pair da = dxy * swapped(axy), ac = axy * swapped(cxy), bd = bxy * swapped(dxy);
  const Pair ab_cd = Pair{ab[0], cd[0]} - Pair{ab[1], cd[1]};
  const Pair bc_da = Pair{bc[0], da[0]} - Pair{bc[1], da[1]};
  const Pair ac_bd = Pair{ac[0], bd[0]} - Pair{ac[1], bd[1]};
  // Minors of three rows: abc and cda, bcd and dab.
  const Pair bz_minus_dz = {bdz[0], -bdz[1]}, cz_minus_az = {acz[1], -acz[0]};
  const Pair abc_cda = (acz * bc_da + swapped(acz) * ab_cd) - bz_minus_dz * both(ac_bd[0]);
  const Pair bcd_dab = (bdz * swapped(ab_cd) + swapped(bdz) * bc_da) - cz_minus_az * both(ac_bd[1]);
  // Squared distances.
  const Pair aa = axy * axy, bb = bxy * bxy, cc = cxy * cxy, dd = dxy * dxy;
  const Pair ac2 = (Pair{aa[0], cc[0]} + Pair{aa[1], cc[1]}) + acz * acz;
  const Pair bd2 = (Pair{bb[0], dd[0]} + Pair{bb[1], dd[1]}) + bdz * bdz;
  const Pair halves = swapped(bd2) * abc_cda - ac2 * bcd_dab;
  const Pair sums = ac2 + bd2;
  const double det = halves[0] + halves[1];
  const double sum = sums[0] + sums[1];
  if (CIRCUMBALL_LIKELY(std::fabs(det) >=
                        internal::kInsphereBound * (sum * sum * internal::sqrt_bound(sum)))) {
    internal::count_filter(internal::Predicate::kInsphere);
    return det;
  }
  return internal::insphere_exact(a, b, c, d, e);
}

/// The signs of insphere(a[0], b[0], c[0], d[0], e) and insphere(a[1], ...), side by side: nothing
/// need be moved between lanes, so it costs little more than one. The same k and P. If `count` is
/// 1, only the first is exact.
inline internal::Pair insphere_pair_filtered(const Point3* const (&a)[2],
                                             const Point3* const (&b)[2],
                                             const Point3* const (&c)[2],
                                             const Point3* const (&d)[2], const Point3& e,
                                             int count) {
  using internal::absolute, internal::both, internal::Pair;
  const Pair ex = both(e.x), ey = both(e.y), ez = both(e.z);
  const Pair ax = Pair{a[0]->x, a[1]->x} - ex, bx = Pair{b[0]->x, b[1]->x} - ex;
  const Pair cx = Pair{c[0]->x, c[1]->x} - ex, dx = Pair{d[0]->x, d[1]->x} - ex;
  const Pair ay = Pair{a[0]->y, a[1]->y} - ey, by = Pair{b[0]->y, b[1]->y} - ey;
  const Pair cy = Pair{c[0]->y, c[1]->y} - ey, dy = Pair{d[0]->y, d[1]->y} - ey;
  const Pair az = Pair{a[0]->z, a[1]->z} - ez, bz = Pair{b[0]->z, b[1]->z} - ez;
  const Pair cz = Pair{c[0]->z, c[1]->z} - ez, dz = Pair{d[0]->z, d[1]->z} - ez;
  const Pair ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  const Pair da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  const Pair abc = (az * bc - bz * ac) + cz * ab, bcd = (bz * cd - cz * bd) + dz * bc;
  const Pair cda = (cz * da + dz * ac) + az * cd, dab = (dz * ab + az * bd) + bz * da;
  const Pair a2 = (ax * ax + ay * ay) + az * az, b2 = (bx * bx + by * by) + bz * bz;
  const Pair c2 = (cx * cx + cy * cy) + cz * cz, d2 = (dx * dx + dy * dy) + dz * dz;
  Pair det = (d2 * abc - c2 * dab) + (b2 * cda - a2 * bcd);
  const Pair sum = (a2 + b2) + (c2 + d2);
  const Pair roots = {internal::sqrt_bound(sum[0]), internal::sqrt_bound(sum[1])};
  const Pair bound = both(internal::kInsphereBound) * (sum * sum * roots), size = absolute(det);
  for (int i = 0; i < count; ++i) {
    if (CIRCUMBALL_LIKELY(size[i] >= bound[i]))
      internal::count_filter(internal::Predicate::kInsphere);
    else
      det[i] = internal::insphere_exact(*a[i], *b[i], *c[i], *d[i], e);
  }
  return det;
}

/// Sign of in_diametral_ball(a, b, p) in the plane: (a - p) . (p - b). k = 3, P as in orient2d.
inline double in_segment_ball_filtered(double ax, double ay, double bx, double by, double px,
                                       double py) {
  using internal::Pair;
  const Pair p = {px, py};
  const Pair products = (Pair{ax, ay} - p) * (p - Pair{bx, by});
  const double s = products[0], t = products[1];
  const double dot = s + t;
  if (CIRCUMBALL_LIKELY(std::fabs(dot) >= internal::kSegmentBall2Bound * std::fabs(t))) {
    internal::count_filter(internal::Predicate::kSegmentBall2);
    return dot;
  }
  return internal::segment_ball2_exact(ax, ay, bx, by, px, py);
}

/// Sign of in_diametral_ball(a, b, p) in space.
/// k = 4 (two differences, a product, one of two sums), P <= |dot| + 2 (|t| + |u|) as in orient2d.
inline double in_segment_ball_filtered(const Point3& a, const Point3& b, const Point3& p) {
  const double s = (a.x - p.x) * (p.x - b.x);
  const double t = (a.y - p.y) * (p.y - b.y);
  const double u = (a.z - p.z) * (p.z - b.z);
  const double dot = s + t + u;
  if (CIRCUMBALL_LIKELY(std::fabs(dot) >=
                        internal::kSegmentBall3Bound * (std::fabs(t) + std::fabs(u)))) {
    internal::count_filter(internal::Predicate::kSegmentBall3);
    return dot;
  }
  return internal::segment_ball3_exact(a, b, p);
}

/// Sign of compare_distance(a, b, c, d). k = 4 (two differences, a square, a sum), P = |ab|^2 +
/// |cd|^2 as in orient2d.
inline double compare_distance_filtered(const Point2& a, const Point2& b, const Point2& c,
                                        const Point2& d) {
  const double abx = a.x - b.x, aby = a.y - b.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double cd2 = cdx * cdx + cdy * cdy;
  const double det = (abx * abx + aby * aby) - cd2;
  if (CIRCUMBALL_LIKELY(std::fabs(det) >= internal::kDistanceBound * cd2)) return det;
  return internal::compare_distance_exact(a, b, c, d);
}

/// Sign of in_diametral_ball(a, b, c, p): the smallest ball through a triangle in space.
///
/// With u = a - c, v = b - c, q = p - c and n = u x v, the centre is c + ((uu v - vv u) x n) / (2
/// nn), so p is inside if nn qq < q . ((uu v - vv u) x n). Expanding the triple products leaves
/// inner products only:
///   D = uu vv (qu + qv - qq) - uv (uu qv + vv qu - uv qq) > 0.
/// Its degree, 6, is the least possible: as a polynomial in q the form has the leading coefficient
/// nn, which is irreducible and does not divide the rest, so D is irreducible, and a polynomial of
/// the same sign is a multiple.
///
/// k = 19 on either side of the last minus (left: uu and vv, 5 each, 1 product, qu 5 and 2 sums, 1
/// product; right: uv 5, uu qv 5 + 5 + 1, 2 sums, 1 product). |uv| <= |u||v| and so on bound the
/// monomials: P <= 2 uu vv (|u||q| + |v||q| + qq) <= uu vv (uu + vv + 4 qq). Degree 6 underflows
/// only in the last two products (u^4 of the lattice above is normal), by at most 2^-1074 in all:
/// nothing beside a bound of 2^-1000. What overflows makes the bound infinite, which nothing
/// exceeds.
inline double in_triangle_ball_filtered(const Point3& a, const Point3& b, const Point3& c,
                                        const Point3& p) {
  const double ux = a.x - c.x, uy = a.y - c.y, uz = a.z - c.z;
  const double vx = b.x - c.x, vy = b.y - c.y, vz = b.z - c.z;
  const double qx = p.x - c.x, qy = p.y - c.y, qz = p.z - c.z;
  const double uu = ux * ux + uy * uy + uz * uz;
  const double vv = vx * vx + vy * vy + vz * vz;
  const double qq = qx * qx + qy * qy + qz * qz;
  const double uv = ux * vx + uy * vy + uz * vz;
  const double qu = qx * ux + qy * uy + qz * uz;
  const double qv = qx * vx + qy * vy + qz * vz;
  const double uuvv = uu * vv;
  const double det = uuvv * (qu + qv - qq) - uv * (uu * qv + vv * qu - uv * qq);
  const double bound = internal::kTriangleBallBound * (uuvv * (uu + vv + 4 * qq));
  if (CIRCUMBALL_LIKELY(std::fabs(det) > bound && bound >= 0x1p-1000)) {
    internal::count_filter(internal::Predicate::kTriangleBall);
    return det;
  }
  return internal::triangle_ball_exact(a, b, c, p);
}

}  // namespace circumball

#endif  // CIRCUMBALL_PREDICATES_FAST_H_
