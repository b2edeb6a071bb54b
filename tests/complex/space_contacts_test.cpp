#include "complex/space_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/rational_adaptor.hpp>
#include <cstdint>
#include <vector>

#include "support/complexes.h"

namespace circumball {
namespace {

using testing::Random;
using Meeting = SpaceContacts::Meeting;
/// Of fixed width, as numbers are small: coordinates are below 4.
using Integer =
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>;
using Rational = boost::multiprecision::number<boost::multiprecision::rational_adaptor<Integer>>;
using Vector = std::vector<Rational>;  // of 3
using Simplex = std::vector<std::uint32_t>;

/// Whether sum_i x_i (p_i, 1) - sum_j y_j (q_j, 1) = 0 has a solution with all x, y >= 1: the
/// relative interiors of two simplices have a point in common exactly then. By Fourier-Motzkin
/// elimination on the null space: shares nothing with what it checks.
bool interiors_meet(const std::vector<Point3>& points, const Simplex& s, const Simplex& t) {
  const std::size_t n = s.size() + t.size();
  std::vector<std::vector<Rational>> rows(4, std::vector<Rational>(n));
  for (std::size_t k = 0; k < n; ++k) {
    const bool first = k < s.size();
    const Point3& p = points[first ? s[k] : t[k - s.size()]];
    const int sign = first ? 1 : -1;
    rows[0][k] = Rational(p.x) * sign;
    rows[1][k] = Rational(p.y) * sign;
    rows[2][k] = Rational(p.z) * sign;
    rows[3][k] = sign;
  }
  std::vector<std::size_t> pivots;  // Gauss-Jordan
  std::size_t rank = 0;
  for (std::size_t column = 0; column < n && rank < 4; ++column) {
    std::size_t at = rank;
    while (at < 4 && rows[at][column] == 0) ++at;
    if (at == 4) continue;
    std::swap(rows[at], rows[rank]);
    const Rational scale = rows[rank][column];
    for (Rational& x : rows[rank]) x /= scale;
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == rank || rows[r][column] == 0) continue;
      const Rational factor = rows[r][column];
      for (std::size_t k = 0; k < n; ++k) rows[r][k] -= factor * rows[rank][k];
    }
    pivots.push_back(column);
    ++rank;
  }
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < n; ++k)
    if (std::find(pivots.begin(), pivots.end(), k) == pivots.end()) free.push_back(k);
  // Inequalities c . z >= 1 in the free variables z.
  struct Inequality {
    std::vector<Rational> c;
    Rational bound;
  };
  std::vector<Inequality> system;
  for (std::size_t f = 0; f < free.size(); ++f) {
    Inequality e{std::vector<Rational>(free.size()), 1};
    e.c[f] = 1;
    system.push_back(e);
  }
  for (std::size_t r = 0; r < rank; ++r) {
    Inequality e{std::vector<Rational>(free.size()), 1};
    for (std::size_t f = 0; f < free.size(); ++f) e.c[f] = -rows[r][free[f]];
    system.push_back(e);
  }
  for (std::size_t f = 0; f < free.size(); ++f) {
    std::vector<Inequality> next, lower, upper;
    for (const Inequality& e : system)
      (e.c[f] > 0 ? lower : e.c[f] < 0 ? upper : next).push_back(e);
    for (const Inequality& l : lower)
      for (const Inequality& u : upper) {
        Inequality e = l;
        for (std::size_t k = 0; k < free.size(); ++k) e.c[k] = l.c[k] / l.c[f] - u.c[k] / u.c[f];
        e.bound = l.bound / l.c[f] - u.bound / u.c[f];
        next.push_back(e);
      }
    system = next;
  }
  return std::all_of(system.begin(), system.end(),
                     [](const Inequality& e) { return e.bound <= 0; });
}

/// Points of a small lattice: every coincidence, collinearity and coplanarity comes up.
std::vector<Point3> lattice_points(Random* random, int count, std::uint32_t side) {
  std::vector<Point3> points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const Point3 p{static_cast<double>(random->below(side)),
                   static_cast<double>(random->below(side)),
                   static_cast<double>(random->below(side))};
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

TEST(SpaceContacts, AgreeWithExactLinearProgramsOnLatticePoints) {
  Random random(3);
  int met[4] = {};
  for (int run = 0; run < 6000; ++run) {
    const auto points = lattice_points(&random, 6, run % 2 == 0 ? 3 : 4);
    const SpaceContacts contacts(points);
    // Simplices that share numbers now and then.
    const auto pick = [&](std::size_t n) {
      Simplex s;
      while (s.size() < n) {
        const std::uint32_t v = random.below(6);
        if (std::find(s.begin(), s.end(), v) == s.end()) s.push_back(v);
      }
      return s;
    };
    const Simplex v = pick(1), a = pick(2), b = pick(2), t = pick(3), u = pick(3);
    EXPECT_EQ(contacts.on_segment(v[0], a[0], a[1]),
              v[0] != a[0] && v[0] != a[1] && interiors_meet(points, v, a));
    const Meeting ab = contacts.segments(a[0], a[1], b[0], b[1]);
    EXPECT_EQ(ab != Meeting::kNone, interiors_meet(points, a, b));
    met[0] += ab == Meeting::kCross;
    if (contacts.collinear(t[0], t[1], t[2]) || contacts.collinear(u[0], u[1], u[2])) continue;
    const SpaceContacts::Triangle tt{t[0], t[1], t[2]}, uu{u[0], u[1], u[2]};
    EXPECT_EQ(contacts.in_triangle(v[0], tt), interiors_meet(points, v, t));
    const Meeting at = contacts.segment_triangle(a[0], a[1], tt);
    EXPECT_EQ(at != Meeting::kNone, interiors_meet(points, a, t));
    met[1] += at == Meeting::kCross;
    const Meeting tu = contacts.triangles(tt, uu);
    EXPECT_EQ(tu != Meeting::kNone, interiors_meet(points, t, u));
    met[2] += tu == Meeting::kCross;
    met[3] += tu == Meeting::kOverlap;
  }
  for (const int count : met) EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace circumball
