#ifndef CIRCUMBALL_TESTS_PREDICATES_SUPPORT_H_
#define CIRCUMBALL_TESTS_PREDICATES_SUPPORT_H_

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "circumball/types.h"
#include "predicates/double_bits.h"

/// Inputs for the tests of predicates: seeded, the same everywhere, and made to be nearly
/// degenerate.
namespace circumball::testing {

/// splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// 0 to n - 1.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) {
    const std::uint64_t count = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(bits() % count));
  }
  /// Uniform in [-1, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; }
  /// A mantissa of full length times 2^e, e uniform.
  double any_magnitude(int low_exponent, int high_exponent) {
    const double mantissa =
        (bits() & 1 ? 1 : -1) * (1 + static_cast<double>(bits() >> 12) * 0x1p-52);
    return internal::scale(mantissa, between(low_exponent, high_exponent));
  }

 private:
  std::uint64_t state_;
};

/// x, `steps` doubles further.
inline double step(double x, int steps) {
  for (; steps > 0; --steps) x = internal::next_up(x);
  for (; steps < 0; ++steps) x = internal::next_down(x);
  return x;
}

inline double& coordinate(Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
inline Point3 operator+(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point3 operator*(double s, const Point3& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Five points; predicates of fewer arguments use the first ones, predicates of the plane forget z.
using Points = std::array<Point3, 5>;

/// The magnitudes that the predicates promise: 1e-45 > 2^-149.6 and 1e55 > 2^182.7.
constexpr int kLeastExponent = -149, kGreatestExponent = 181;

/// Multiplies by a power of two: to the lower edge of the range, to the upper edge, somewhere
/// between, or by one.
inline void rescale(Points& points, Random& random) {
  int least = 5000, greatest = -5000;
  for (Point3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      const double c = std::fabs(coordinate(p, axis));
      if (c == 0) continue;
      int e = static_cast<int>(internal::to_bits(c) >> 52) - 1023;
      least = e < least ? e : least;
      greatest = e > greatest ? e : greatest;
    }
  }
  if (greatest < least) return;  // all zero
  const int lowest = kLeastExponent - least, highest = kGreatestExponent - greatest;
  const int choice = random.below(4);
  const int k = choice == 0   ? lowest
                : choice == 1 ? highest
                : choice == 2 ? 0
                              : random.between(lowest, highest);
  for (Point3& p : points) {
    for (int axis = 0; axis < 3; ++axis)
      coordinate(p, axis) = internal::scale(coordinate(p, axis), k);
  }
}

/// Moves up to two coordinates by up to three doubles, or none. Zeros stay zero, because their
/// neighbors are out of range.
inline void perturb(Points& points, Random& random) {
  for (int i = random.below(3); i > 0; --i) {
    double& c = coordinate(points[random.below(5)], random.below(3));
    if (c != 0) c = step(c, random.between(-3, 3));
  }
}

inline Point3 random_point(Random& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {x, y, z};
}

/// A point with small integer coordinates, many of them equal or zero.
inline Point3 lattice_point(Random& random) {
  const int x = random.between(-3, 3), y = random.between(-3, 3), z = random.between(-3, 3);
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/// Points of the sphere of radius 5 around the origin with integer coordinates: permutations of (5,
/// 0, 0) and (4, 3, 0).
inline Point3 integer_sphere_point(Random& random) {
  const int kind = random.below(3);
  double c[] = {kind == 0 ? 5.0 : 4.0, kind == 0 ? 0.0 : 3.0, 0};
  for (int i = 2; i > 0; --i) {
    const int j = random.below(i + 1);
    const double t = c[i];
    c[i] = c[j];
    c[j] = t;
  }
  for (double& x : c) x = random.below(2) == 0 ? -x + 0.0 : x;
  return {c[0], c[1], c[2]};
}

/// A point of the sphere around `center`, with errors of rounding.
inline Point3 sphere_point(const Point3& center, double radius, Random& random) {
  for (;;) {
    const Point3 d = random_point(random);
    const double d2 = d.x * d.x + d.y * d.y + d.z * d.z;
    if (d2 > 0.01 && d2 <= 1) return center + radius / std::sqrt(d2) * d;
  }
}

/// A point of the circle around `center` in the plane of the first two coordinates.
inline Point3 circle_point(const Point3& center, double radius, Random& random) {
  Point3 d = random_point(random);
  while (d.x * d.x + d.y * d.y < 0.01) d = random_point(random);
  const double s = radius / std::sqrt(d.x * d.x + d.y * d.y);
  return {center.x + s * d.x, center.y + s * d.y, center.z};
}

inline Point3 random_offset(Random& random) {
  switch (random.below(4)) {
    case 0:
      return {0, 0, 0};
    case 1:
      return lattice_point(random);
    case 2:
      return 1e6 * random_point(random);
    default:
      return random_point(random);
  }
}

/// Magnitudes from one edge of the range to the other in the same input, and zeros.
inline Points mixed_points(Random& random) {
  Points points;
  const int low = random.between(kLeastExponent, 0), high = random.between(0, kGreatestExponent);
  for (Point3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      coordinate(p, axis) = random.below(4) == 0 ? 0 : random.any_magnitude(low, high);
    }
  }
  // Often equal coordinates, whose differences cancel.
  for (int i = random.below(6); i > 0; --i) {
    const int axis = random.below(3);
    coordinate(points[random.below(5)], axis) = coordinate(points[random.below(5)], axis);
  }
  return points;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_PREDICATES_SUPPORT_H_
