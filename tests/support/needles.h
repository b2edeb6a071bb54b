#ifndef CIRCUMBALL_TESTS_SUPPORT_NEEDLES_H_
#define CIRCUMBALL_TESTS_SUPPORT_NEEDLES_H_

#include <cstdint>

#include "circumball/complex.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

/// Complexes with one angle, as small as asked, many times: fans, stars and combs.
namespace circumball::testing {

/// Segments of random lengths from one vertex, neighbors `angle` to twice that apart; in a square.
inline Complex fan(Random* random, std::uint32_t count, double angle) {
  Complex c;
  c.vertices.push_back({0, 0, 0});
  double at = 360 * random->unit(), turned = 0;
  for (std::uint32_t i = 0; i < count && turned < 330; ++i) {
    c.segments.push_back({0, static_cast<std::uint32_t>(c.vertices.size())});
    c.vertices.push_back(xyz(polar(0, 0, 0.2 + 0.8 * random->unit(), at)));
    const double step = angle * (1 + random->unit());
    at += step;
    turned += step;
  }
  add_square(&c, -2, -2, 4);
  return c;
}

/// A star-shaped polygon: `points` needle tips, each of an angle of `angle` degrees.
inline Complex star(std::uint32_t points, double angle) {
  Complex c;
  const double half = 180.0 / points;
  // The corners between the tips are where rays from the tips at half the angle meet.
  const double a = 0.5 * angle * (elementary::kPi / 180), b = half * (elementary::kPi / 180);
  const double inner = elementary::sin(a) / elementary::sin(a + b);
  for (std::uint32_t i = 0; i < points; ++i) {
    c.vertices.push_back(xyz(polar(0, 0, 1, 2 * half * i)));
    c.vertices.push_back(xyz(polar(0, 0, inner, 2 * half * i + half)));
  }
  for (std::uint32_t i = 0; i < 2 * points; ++i) c.segments.push_back({i, (i + 1) % (2 * points)});
  return c;
}

/// Needle teeth of the given angle side by side on a bar.
inline Complex comb(std::uint32_t teeth, double angle) {
  Complex c;
  const double width = 2 * elementary::sin(0.5 * angle * (elementary::kPi / 180));
  c.vertices = {{0, -0.3, 0}, {1.0 * teeth, -0.3, 0}};
  for (std::uint32_t i = teeth; i-- > 0;) {
    c.vertices.push_back({i + 0.5 + 0.5 * width, 0, 0});
    c.vertices.push_back({i + 0.5, 1, 0});
    c.vertices.push_back({i + 0.5 - 0.5 * width, 0, 0});
  }
  const auto n = static_cast<std::uint32_t>(c.vertices.size());
  for (std::uint32_t i = 0; i < n; ++i) c.segments.push_back({i, (i + 1) % n});
  return c;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_NEEDLES_H_
