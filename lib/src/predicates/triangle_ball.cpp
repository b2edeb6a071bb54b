// The stages after the filter for the smallest ball through a triangle in space.

#include <cmath>

#include "predicates/expansion.h"
#include "predicates/fast.h"
#include "predicates/wide_integer.h"

namespace circumball::internal {
namespace {

template <class Vector>
auto dot(const Vector& a, const Vector& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// The form of degree six of in_triangle_ball_filtered, for vectors over any ring.
template <class Vector>
auto triangle_ball_form(const Vector& u, const Vector& v, const Vector& q) {
  const auto uu = dot(u, u), vv = dot(v, v), qq = dot(q, q);
  const auto uv = dot(u, v), qu = dot(q, u), qv = dot(q, v);
  return uu * vv * (qu + qv - qq) - uv * (uu * qv + vv * qu - uv * qq);
}

struct SingleVector {
  Expansion<1> x, y, z;
};

struct WideVector {
  WideInteger x, y, z;
};

/// One coordinate of the three differences, if all three are exact and their products of degree six
/// are in the range of expansions: 2^-126 to 2^160 have units of at least 2^-178, and 6 * 178 <
/// 1074; 6 * 160 + 10 < 1023.
class Differences {
 public:
  Expansion<1> operator()(double a, double b) {
    const TwoDoubles d = two_difference(a, b);
    const double size = std::fabs(d.high);
    usable_ = usable_ && d.low == 0 && (size == 0 || (size >= 0x1p-126 && size <= 0x1p160));
    return expansion(d.high);
  }
  bool usable() const { return usable_; }

 private:
  bool usable_ = true;
};

/// Exact for all finite doubles: the coordinates as integers in units of the smallest one's last
/// place.
double triangle_ball_of_integers(const Point3* const (&points)[4]) {
  int unit = 971;
  for (const Point3* p : points) {
    for (const double t : {p->x, p->y, p->z}) {
      const Decoded d(t);
      if (d.mantissa != 0 && d.exponent < unit) unit = d.exponent;
    }
  }
  const auto vector = [&](int i) {
    const Point3 &to = *points[i], &from = *points[2];
    const auto wide = [&](double t) { return WideInteger(Decoded(t), unit); };
    return WideVector{wide(to.x) - wide(from.x), wide(to.y) - wide(from.y),
                      wide(to.z) - wide(from.z)};
  };
  return triangle_ball_form(vector(0), vector(1), vector(3)).sign();
}

}  // namespace

double triangle_ball_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  StageCounters& counters = counters_of(Predicate::kTriangleBall);
  Differences difference;
  const SingleVector u{difference(a.x, c.x), difference(a.y, c.y), difference(a.z, c.z)};
  const SingleVector v{difference(b.x, c.x), difference(b.y, c.y), difference(b.z, c.z)};
  const SingleVector q{difference(p.x, c.x), difference(p.y, c.y), difference(p.z, c.z)};
  if (difference.usable()) {
    counters.adaptive.add_one();
    return triangle_ball_form(u, v, q).sign();
  }
  counters.exact.add_one();
  return triangle_ball_of_integers({&a, &b, &c, &p});
}

}  // namespace circumball::internal
