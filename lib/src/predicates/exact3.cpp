// The stages after the filter for the predicates of space.

#include "predicates/expansion.h"
#include "predicates/fast.h"

namespace circumball::internal {
namespace {

/// The vector from `from` to `to`, exactly.
struct Difference3 {
  Expansion<2> x, y, z;
  Difference3(const Point3& to, const Point3& from)
      : x(difference(to.x, from.x)), y(difference(to.y, from.y)), z(difference(to.z, from.z)) {}
  bool exact() const { return x.size < 2 && y.size < 2 && z.size < 2; }
};

void count(Predicate p, bool differences_were_exact) {
  StageCounters& c = counters_of(p);
  (differences_were_exact ? c.adaptive : c.exact).add_one();
}

/// A single double: the difference is known to be exact.
Expansion<1> single(const Expansion<2>& e) { return expansion(e.sign()); }

double insphere_of_exact_differences(const Difference3& a, const Difference3& b,
                                     const Difference3& c, const Difference3& d) {
  const Expansion<1> x[] = {single(a.x), single(b.x), single(c.x), single(d.x)};
  const Expansion<1> y[] = {single(a.y), single(b.y), single(c.y), single(d.y)};
  const Expansion<1> z[] = {single(a.z), single(b.z), single(c.z), single(d.z)};
  const auto minor2 = [&](int i, int j) { return x[i] * y[j] - x[j] * y[i]; };
  const auto minor3 = [&](int i, int j, int k) {
    return (z[i] * minor2(j, k) - z[j] * minor2(i, k)) + z[k] * minor2(i, j);
  };
  const auto term = [&](int l, int i, int j, int k) {
    return (square(x[l]) + square(y[l]) + square(z[l])) * minor3(i, j, k);
  };
  // Expansion along the column of squared lengths.
  return ((term(3, 0, 1, 2) - term(2, 0, 1, 3)) + (term(1, 0, 2, 3) - term(0, 1, 2, 3))).sign();
}

/// Without differences, so that the stack stays small: differences of two components each would
/// take up to 36,864 components, products of the coordinates themselves take 5,760 (Shewchuk 1997,
/// section 4.4).
double insphere_of_coordinates(const Point3* const (&p)[5]) {
  const auto minor2 = [&](int i, int j) {
    return expansion(two_product(p[i]->x, p[j]->y)) - expansion(two_product(p[j]->x, p[i]->y));
  };
  const auto minor3 = [&](int i, int j, int k) {
    return (minor2(j, k) * p[i]->z - minor2(i, k) * p[j]->z) + minor2(i, j) * p[k]->z;
  };
  // The 4x4 minor with a column of ones.
  const auto minor4 = [&](int i, int j, int k, int l) {
    return (minor3(i, j, k) - minor3(i, j, l)) + (minor3(i, k, l) - minor3(j, k, l));
  };
  Expansion<5760> sum[2];
  int now = 0;
  for (int l = 0; l < 5; ++l) {
    int i[4], n = 0;
    for (int m = 0; m < 5; ++m) {
      if (m != l) i[n++] = m;
    }
    const Expansion<96> minor =
        l % 2 == 0 ? -minor4(i[0], i[1], i[2], i[3]) : minor4(i[0], i[1], i[2], i[3]);
    const Point3& q = *p[l];
    const Expansion<1152> term = (minor * q.x * q.x + minor * q.y * q.y) + minor * q.z * q.z;
    sum[1 - now].size = add_components(sum[now].component, sum[now].size, term.component, term.size,
                                       sum[1 - now].component);
    now = 1 - now;
  }
  return sum[now].sign();
}

}  // namespace

double orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Difference3 u(a, d), v(b, d), w(c, d);
  count(Predicate::kOrient3d, u.exact() && v.exact() && w.exact());
  return (u.z * (v.x * w.y - w.x * v.y) + v.z * (w.x * u.y - u.x * w.y) +
          w.z * (u.x * v.y - v.x * u.y))
      .sign();
}

double insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  const Difference3 ae(a, e), be(b, e), ce(c, e), de(d, e);
  const bool exact = ae.exact() && be.exact() && ce.exact() && de.exact();
  count(Predicate::kInsphere, exact);
  if (exact) return insphere_of_exact_differences(ae, be, ce, de);
  return insphere_of_coordinates({&a, &b, &c, &d, &e});
}

double segment_ball3_exact(const Point3& a, const Point3& b, const Point3& p) {
  const Difference3 u(a, p), v(p, b);
  count(Predicate::kSegmentBall3, u.exact() && v.exact());
  return (u.x * v.x + u.y * v.y + u.z * v.z).sign();
}

}  // namespace circumball::internal
