#ifndef CIRCUMBALL_TESTS_SUPPORT_INTERIORS_H_
#define CIRCUMBALL_TESTS_SUPPORT_INTERIORS_H_

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/rational_adaptor.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "circumball/types.h"

/// Contacts of simplices in space from their definition, in exact rationals.
namespace circumball::testing {

/// Of fixed width, as numbers are small: coordinates are below 4.
using Integer =
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>;
using Rational = boost::multiprecision::number<boost::multiprecision::rational_adaptor<Integer>>;
using Simplex = std::vector<std::uint32_t>;

/// Whether sum_i x_i (p_i, 1) - sum_j y_j (q_j, 1) = 0 has a solution with all x, y >= 1: the
/// relative interiors of two simplices have a point in common exactly then. By Fourier-Motzkin
/// elimination on the null space: shares nothing with what it checks.
inline bool interiors_meet(const std::vector<Point3>& points, const Simplex& s, const Simplex& t) {
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

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_INTERIORS_H_
