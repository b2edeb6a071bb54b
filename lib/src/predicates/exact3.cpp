// The stages after the filter for the predicates of space.
//
// Coordinates come from somewhere: lattices and drawings have few bits, and points that are near
// each other, but not near zero, have differences on a common grid of few bits, exact or not. So
// orient3d and insphere look at the differences as integers: if they have so few bits that
// determinants of doubles are exact, or fit 64 bits. What is left are points that were rounded onto
// a plane or a sphere: their determinants are tiny, but not zero, and doubles of twice the
// precision nearly always tell the sign. Only what is left then goes to expansions.

#include <cmath>

#include "predicates/double_bits.h"
#include "predicates/expansion.h"
#include "predicates/fast.h"
#include "predicates/fixed_integer.h"
#include "predicates/twofold.h"

namespace circumball::internal {
namespace {

/// `Count` vectors from a common point to others, exactly.
template <int Count>
struct Differences {
  double high[3 * Count], low[3 * Count];  // x, y, z of each
  double size = 0;                         // the largest magnitude of `high`
  bool single = true;                      // no `low`

  Differences(const Point3* const (&to)[Count], const Point3& from) {
    for (int i = 0; i < Count; ++i) {
      set(3 * i, to[i]->x, from.x);
      set(3 * i + 1, to[i]->y, from.y);
      set(3 * i + 2, to[i]->z, from.z);
    }
    double any = 0;
    for (int i = 0; i < 3 * Count; ++i) {
      size = std::fabs(high[i]) > size ? std::fabs(high[i]) : size;
      any += std::fabs(low[i]);
    }
    single = any == 0;
  }

  /// 2^bits over the smallest power of two that is above `size`: it scales all to below 2^bits.
  /// Sizes are at least 2^-202, unless zero, and at most 2^185 (predicates/fast.h).
  double scale(int bits) const {
    const std::uint64_t exponent = to_bits(size) >> 52;
    return from_bits((2 * 1023 + static_cast<std::uint64_t>(bits) - 1 - exponent) << 52);
  }

  /// Whether all are multiples of 2^-bits times that power of two; if so, as such multiples.
  bool as_integers(int bits, double (&out)[3 * Count]) const {
    constexpr double kRound = 0x1.8p52;  // sums with it are integers
    if (!single) return false;
    const double s = scale(bits);
    bool fits = true;
    for (int i = 0; i < 3 * Count; ++i) {
      out[i] = high[i] * s;
      fits &= (out[i] + kRound) - kRound == out[i];
    }
    return fits;
  }

  /// The same with 62 bits (and a last place more, by rounding: magnitudes are at most 2^62).
  bool as_integers(FixedInteger<1> (&out)[3 * Count]) const {
    const double s = scale(62);
    bool fits = true;
    for (int i = 0; i < 3 * Count; ++i) {
      const double h = high[i] * s, l = low[i] * s;
      const std::int64_t ih = static_cast<std::int64_t>(h), il = static_cast<std::int64_t>(l);
      fits &= (static_cast<double>(ih) == h) & (static_cast<double>(il) == l);
      out[i] = fixed_integer(ih + il);
    }
    return fits;
  }

 private:
  void set(int i, double to, double from) {
    const TwoDoubles d = two_difference(to, from);
    high[i] = d.high;
    low[i] = d.low;
  }
};

/// Predicates call their stages as something cold, which compilers then optimize for size; but for
/// cospherical points the stages are where the time goes.
#define CIRCUMBALL_HOT __attribute__((hot, noinline))

void count(Predicate p, bool by_integers) {
  StageCounters& c = counters_of(p);
  (by_integers ? c.adaptive : c.exact).add_one();
}

/// The determinant of three rows x, y, z.
template <class Number>
auto determinant3(const Number (&d)[9]) {
  return (d[2] * (d[3] * d[7] - d[6] * d[4]) + d[5] * (d[6] * d[1] - d[0] * d[7])) +
         d[8] * (d[0] * d[4] - d[3] * d[1]);
}

/// The determinant of four rows x, y, z, x^2 + y^2 + z^2, of the sign of insphere.
template <class Number>
auto determinant4(const Number (&d)[12]) {
  const auto minor2 = [&](int i, int j) {
    return d[3 * i] * d[3 * j + 1] - d[3 * j] * d[3 * i + 1];
  };
  const auto ab = minor2(0, 1), bc = minor2(1, 2), cd = minor2(2, 3);
  const auto da = minor2(3, 0), ac = minor2(0, 2), bd = minor2(1, 3);
  const auto &az = d[2], &bz = d[5], &cz = d[8], &dz = d[11];
  const auto abc = (az * bc - bz * ac) + cz * ab, bcd = (bz * cd - cz * bd) + dz * bc;
  const auto cda = (cz * da + dz * ac) + az * cd, dab = (dz * ab + az * bd) + bz * da;
  const auto lift = [&](int i) {
    return (d[3 * i] * d[3 * i] + d[3 * i + 1] * d[3 * i + 1]) + d[3 * i + 2] * d[3 * i + 2];
  };
  return (lift(3) * abc - lift(2) * dab) + (lift(1) * cda - lift(0) * bcd);
}

/// An upper bound of the sum of the absolute values of the monomials, but for its own rounding.
struct Magnitude {
  double value;
};
inline Magnitude operator+(Magnitude a, Magnitude b) { return {a.value + b.value}; }
inline Magnitude operator-(Magnitude a, Magnitude b) { return {a.value + b.value}; }
inline Magnitude operator*(Magnitude a, Magnitude b) { return {a.value * b.value}; }

/// The sign of insphere in double-double arithmetic, if that is certain; else 0.
///
/// Differences are exact. Each monomial passes through a product and a difference (a minor of two
/// rows), a product and two sums (of three rows), a product and three sums (with the lift, itself a
/// product and two sums): at most 4 * 7 + 8 * 3 = 52 u^2, and some u^3, of the sum of their
/// absolute values. That sum is computed with 12 roundings from `high`, each of which is the
/// difference but for u; 2^-100 = 64 u^2 covers all of it. Underflow: see predicates/fast.h; the
/// low parts are multiples of the same lattice.
double insphere_twofold(const Differences<4>& v) {
  Twofold number[12];
  Magnitude magnitude[12];
  for (int i = 0; i < 12; ++i) {
    number[i] = {v.high[i], v.low[i]};
    magnitude[i] = {std::fabs(v.high[i])};
  }
  const Twofold det = determinant4(number);
  return std::fabs(det.high) > 0x1p-100 * determinant4(magnitude).value ? det.high : 0;
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

// Integers below 2^16 in magnitude: the six products of the determinant are below 2^48, and their
// sum below 2^51. At most 2^62: minors of two rows 2^125, products with the third 2^187, and their
// sum 2^189.
CIRCUMBALL_HOT double orient3d_by_stages(const Point3& a, const Point3& b, const Point3& c,
                                         const Point3& d) {
  const Differences<3> v({&a, &b, &c}, d);
  if (v.size == 0) return 0;
  double small[9];
  FixedInteger<1> integers[9];
  const bool is_small = v.as_integers(16, small), by_integers = is_small || v.as_integers(integers);
  count(Predicate::kOrient3d, by_integers);
  if (is_small) return determinant3(small);
  if (by_integers) return determinant3(integers).sign();
  const auto at = [&](int i) { return expansion(TwoDoubles{v.high[i], v.low[i]}); };
  const Expansion<2> e[9] = {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8)};
  return determinant3(e).sign();
}

// Integers below 2^9: 4 * 3 * 6 = 72 monomials below 2^45, so sums below 2^52. At most 2^62: minors
// of three rows 2^189, squared lengths 2^126, their four products 2^315, and the sum 2^317.
CIRCUMBALL_HOT double insphere_by_stages(const Point3& a, const Point3& b, const Point3& c,
                                         const Point3& d, const Point3& e) {
  const Differences<4> v({&a, &b, &c, &d}, e);
  if (v.size == 0) return 0;
  double small[12];
  FixedInteger<1> integers[12];
  const bool is_small = v.as_integers(9, small), by_integers = is_small || v.as_integers(integers);
  const double sign = by_integers ? 0 : insphere_twofold(v);
  count(Predicate::kInsphere, by_integers || sign != 0);
  if (is_small) return determinant4(small);
  if (by_integers) return determinant4(integers).sign();
  if (sign != 0) return sign;
  return insphere_of_coordinates({&a, &b, &c, &d, &e});
}

}  // namespace

double orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return orient3d_by_stages(a, b, c, d);
}

double insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  return insphere_by_stages(a, b, c, d, e);
}

double segment_ball3_exact(const Point3& a, const Point3& b, const Point3& p) {
  const auto dot = [](const Expansion<2>(&u)[3], const Expansion<2>(&v)[3]) {
    return (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]).sign();
  };
  const Expansion<2> u[3] = {difference(a.x, p.x), difference(a.y, p.y), difference(a.z, p.z)};
  const Expansion<2> v[3] = {difference(p.x, b.x), difference(p.y, b.y), difference(p.z, b.z)};
  bool exact = true;
  for (int i = 0; i < 3; ++i) exact = exact && u[i].size < 2 && v[i].size < 2;
  count(Predicate::kSegmentBall3, exact);
  return dot(u, v);
}

}  // namespace circumball::internal
