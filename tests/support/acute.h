#ifndef CIRCUMBALL_TESTS_SUPPORT_ACUTE_H_
#define CIRCUMBALL_TESTS_SUPPORT_ACUTE_H_

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "predicates/elementary.h"
#include "support/complexes.h"

/// Random complexes with small angles and narrow gaps: what Ruppert's algorithm does not end on.
namespace circumball::testing {

/// `count`, times CIRCUMBALL_CASES from the environment where that is set: for long runs by hand.
inline std::uint64_t cases(std::uint64_t count) {
  const char* factor = std::getenv("CIRCUMBALL_CASES");
  return factor ? count * std::strtoull(factor, nullptr, 10) : count;
}

/// Adds segments from a common vertex in the disk of radius 1 about (x, y): angles between `least`
/// degrees and a few times as much, or anything.
inline void add_fan(Complex* c, Random* random, double x, double y, double least) {
  const auto hub = static_cast<std::uint32_t>(c->vertices.size());
  c->vertices.push_back({x, y, 0});
  const std::uint32_t count = 2 + random->below(8);
  double angle = 360 * random->unit();
  double turned = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double length = 0.1 + 0.85 * random->unit();
    const auto tip = static_cast<std::uint32_t>(c->vertices.size());
    c->vertices.push_back(xyz(polar(x, y, length, angle)));
    c->segments.push_back({hub, tip});
    const double step =
        random->below(2) ? least * (1 + random->unit()) : least + 60 * random->unit();
    angle += step;
    turned += step;
    if (turned + least + 60 > 360) break;
  }
}

/// Some fans far enough apart not to cross, with isolated vertices between; within a square, if
/// `closed`.
inline Complex random_fans(std::uint64_t seed, double least, bool closed) {
  Random random(seed);
  Complex c;
  const std::uint32_t n = 1 + random.below(3);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      if (random.below(4) == 0) {
        c.vertices.push_back({2.0 * i + 0.3 * random.unit(), 2.0 * j, 0});
      } else {
        add_fan(&c, &random, 2.0 * i, 2.0 * j, least);
      }
    }
  }
  if (closed) add_square(&c, -1.5, -1.5, 2.0 * n + 1);
  return c;
}

/// Adds a loop through points.
inline void add_loop(Complex* c, const std::vector<Point2>& points) {
  const auto first = static_cast<std::uint32_t>(c->vertices.size());
  const auto n = static_cast<std::uint32_t>(points.size());
  for (const Point2& p : points) c->vertices.push_back(xyz(p));
  for (std::uint32_t i = 0; i < n; ++i) c->segments.push_back({first + i, first + (i + 1) % n});
}

/// A fan of `count` segments of random lengths, `degrees` between neighbors, in a square.
inline Complex dense_fan(std::uint64_t seed, std::uint32_t count, double degrees) {
  Random random(seed);
  Complex c;
  c.vertices.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point2 tip = polar(0, 0, 0.3 + 0.7 * random.unit(), 10 + degrees * i);
    c.vertices.push_back(xyz(tip));
    c.segments.push_back({0, i + 1});
  }
  add_square(&c, -2, -2, 4);
  return c;
}

/// A polygon with needles that point outward: `degrees` at their tips. Each tip is a vertex of
/// degree two.
inline Complex needle_star(std::uint64_t seed, double degrees) {
  Random random(seed);
  const std::uint32_t tips = 3 + random.below(5);
  std::vector<Point2> loop;
  const double core = 0.3;
  for (std::uint32_t i = 0; i < tips; ++i) {
    const double at = 360.0 * i / tips + 20 * random.unit(), reach = 0.6 + 0.6 * random.unit();
    // Half the needle's width at its foot, seen from the middle.
    const double half = std::min(15.0, 0.5 * degrees * (reach - core) / core);
    loop.push_back(polar(0, 0, core, at - half));
    loop.push_back(polar(0, 0, reach, at));
    loop.push_back(polar(0, 0, core, at + half));
  }
  Complex c;
  add_loop(&c, loop);
  return c;
}

/// A bar with slits of width `gap` and a depth of some hundred gaps, some of them V-shaped.
inline Complex slit_bar(std::uint64_t seed, double gap) {
  Random random(seed);
  const std::uint32_t slits = 2 + random.below(4);
  std::vector<Point2> loop{{0, 0}};
  double x = 0;
  for (std::uint32_t i = 0; i < slits; ++i) {
    x += 0.1 + random.unit();
    const double depth = gap * (20 + 200 * random.unit());
    loop.push_back({x, 0});
    if (random.below(2)) {
      loop.push_back({x + 0.5 * gap, depth});
    } else {
      loop.push_back({x, depth});
      loop.push_back({x + gap, depth});
    }
    loop.push_back({x + gap, 0});
  }
  x += 0.1 + random.unit();
  loop.push_back({x, 0});
  loop.push_back({x, 1});
  loop.push_back({0, 1});
  Complex c;
  add_loop(&c, loop);
  return c;
}

/// A shore about (x, y): a star-shaped loop whose distance from the middle is noise of several
/// octaves, between 0.35 and 1 times `radius`; the rougher, the sharper its capes.
inline std::vector<Point2> shore(Random* random, double x, double y, double radius,
                                 std::uint32_t corners, double roughness) {
  std::vector<double> noise(corners, 0);
  double amplitude = 1;
  for (std::uint32_t waves = 3; waves <= corners; waves *= 2, amplitude *= roughness) {
    std::vector<double> knots(waves);
    for (double& k : knots) k = random->unit() - 0.5;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double at = static_cast<double>(i) * waves / corners;
      const auto k = static_cast<std::uint32_t>(at);
      const double s = at - k;
      noise[i] += amplitude * ((1 - s) * knots[k % waves] + s * knots[(k + 1) % waves]);
    }
  }
  const auto [low, high] = std::minmax_element(noise.begin(), noise.end());
  const double least = *low, range = *high - *low;
  std::vector<Point2> loop;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double r = radius * (0.35 + 0.65 * (noise[i] - least) / range);
    loop.push_back(polar(x, y, r, 360.0 * i / corners));
  }
  return loop;
}

/// A lake with islands: rough shores with sharp capes and inlets.
inline Complex rough_lake(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  add_loop(&c, shore(&random, 0, 0, 1, 24 + random.below(200), 0.4 + 0.5 * random.unit()));
  const std::uint32_t islands = random.below(5);
  for (std::uint32_t i = 0; i < islands; ++i) {  // within 0.35, apart
    const Point2 at = polar(0, 0, 0.22, 90.0 * i);
    add_loop(&c, shore(&random, at.x, at.y, 0.1, 6 + random.below(60), 0.8));
  }
  return c;
}

/// A coast: the graph of noise, with land below it to the edge of the map.
inline Complex rough_coast(std::uint64_t seed) {
  Random random(seed);
  const std::uint32_t n = 16 + random.below(200);
  const double roughness = 0.4 + 0.5 * random.unit();
  std::vector<double> y(n + 1, 0);
  double amplitude = 0.4;
  for (std::uint32_t waves = 2; waves <= n; waves *= 2, amplitude *= roughness) {
    std::vector<double> knots(waves + 2);
    for (double& k : knots) k = random.unit() - 0.5;
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double at = static_cast<double>(i) * waves / n;
      const auto k = static_cast<std::uint32_t>(at);
      y[i] += amplitude * ((1 - (at - k)) * knots[k] + (at - k) * knots[k + 1]);
    }
  }
  std::vector<Point2> loop{{0, -2}, {2, -2}};
  for (std::uint32_t i = 0; i <= n; ++i) loop.push_back({2.0 * (n - i) / n, y[n - i]});
  Complex c;
  add_loop(&c, loop);
  return c;
}

/// Two segments at an angle of theta are split to about theta times the distance from their vertex:
/// 1 / theta pieces. So the smallest angles come rarely.
inline double least_angle(std::uint64_t seed) {
  return seed % 50 == 0 ? 0.01 : seed % 10 == 1 ? 0.3 : seed % 2 ? 3 : 20;
}

/// One of all these kinds.
inline Complex acute_complex(std::uint64_t seed) {
  switch (seed % 8) {
    case 0:
      return dense_fan(seed, 12 + static_cast<std::uint32_t>(seed / 8 % 37),
                       seed % 64 == 0 ? 0.05 : 1 + static_cast<double>(seed / 8 % 6));
    case 1:
      return needle_star(seed, seed % 80 == 1 ? 0.01 : seed % 3 ? 1 : 10);
    case 2:
      return slit_bar(seed, seed % 3 ? 1e-6 : 1e-3);
    case 3:
      return rough_lake(seed);
    case 4:
      return rough_coast(seed);
    default:
      return random_fans(seed, least_angle(seed / 8), seed % 3 != 0);
  }
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_ACUTE_H_
