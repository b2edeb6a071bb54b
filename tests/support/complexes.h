#ifndef CIRCUMBALL_TESTS_SUPPORT_COMPLEXES_H_
#define CIRCUMBALL_TESTS_SUPPORT_COMPLEXES_H_

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/refine.h"
#include "predicates/elementary.h"

/// Complexes that tests share: a few by hand, and a generator of random ones whose angles are
/// bounded.
namespace circumball::testing {

/// splitmix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

/// The point at a distance from (x, y), in a direction in degrees; the same everywhere.
inline Point2 polar(double x, double y, double distance, double degrees) {
  const double radians = degrees * (elementary::kPi / 180);
  return {x + distance * elementary::cos(radians), y + distance * elementary::sin(radians)};
}

inline Complex polygon(const std::vector<Point2>& corners) {
  Complex c;
  for (const Point2& p : corners) c.vertices.push_back(xyz(p));
  const auto n = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t i = 0; i < n; ++i) c.segments.push_back({i, (i + 1) % n});
  return c;
}

inline Complex unit_square() { return polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

/// The unit cube: 8 vertices, 12 segments, 6 faces.
inline Complex unit_cube() {
  Complex empty;
  empty.dimension = 3;
  Complex cube = with_box(empty, 1);
  for (Point3& p : cube.vertices) p = {p.x + 0.5, p.y + 0.5, p.z + 0.5};
  return cube;
}
/// The unit square or the unit cube.
inline Complex unit_box(int dimension) { return dimension == 2 ? unit_square() : unit_cube(); }

/// Adds a square loop with the given corner and side.
inline void add_square(Complex* c, double x, double y, double side) {
  const auto n = static_cast<std::uint32_t>(c->vertices.size());
  const double corners[4][2] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  for (const auto& p : corners) c->vertices.push_back({p[0], p[1], 0});
  for (std::uint32_t i = 0; i < 4; ++i) c->segments.push_back({n + i, n + (i + 1) % 4});
}

/// A random complex on an uneven, skewed grid: some of its edges as segments, some vertices alone.
/// Every two segments at a vertex are at the angle of the skew (60 < skew <= 90 degrees: cos skew =
/// `lean`), its complement or straight. Steps of the grid are between `smallest` and `smallest` +
/// 1, some a twentieth of that if `graded`.
inline Complex random_grid(std::uint64_t seed, double lean, double smallest = 0.02,
                           bool graded = true) {
  Random random(seed);
  const std::uint32_t columns = 2 + random.below(6), rows = 2 + random.below(6);
  const auto steps = [&](std::uint32_t n) {
    std::vector<double> at{0};
    while (at.size() < n) {
      const double step = smallest + random.unit();
      at.push_back(at.back() + (graded && random.below(4) == 0 ? 0.05 * step : step));
    }
    return at;
  };
  const std::vector<double> x = steps(columns), y = steps(rows);
  const double rise = std::sqrt(1 - lean * lean);
  const double density = 0.2 + 0.8 * random.unit();
  Complex c;
  std::vector<std::uint32_t> number(columns * rows, kNoIndex);
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    std::uint32_t& n = number[j * columns + i];
    if (n == kNoIndex) {
      n = static_cast<std::uint32_t>(c.vertices.size());
      c.vertices.push_back({x[i] + lean * y[j], rise * y[j], 0});
    }
    return n;
  };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      if (i + 1 < columns && random.unit() < density) {
        const std::uint32_t a = vertex(i, j);
        c.segments.push_back({a, vertex(i + 1, j)});
      }
      if (j + 1 < rows && random.unit() < density) {
        const std::uint32_t a = vertex(i, j);
        c.segments.push_back({a, vertex(i, j + 1)});
      }
      if (random.below(8) == 0) vertex(i, j);
    }
  }
  if (c.vertices.empty()) vertex(0, 0);
  return c;
}

/// Runs an algorithm to its end. Fails hard (returns null) on an invalid complex or option.
inline std::unique_ptr<Run> start(const Complex& complex, const Options& options,
                                  TraceSink* sink = nullptr) {
  std::vector<Defect> defects;
  std::string error;
  return Run::create(complex, options, sink, &defects, &error);
}
inline std::unique_ptr<Run> finish(const Complex& complex, const Options& options,
                                   TraceSink* sink = nullptr) {
  auto run = start(complex, options, sink);
  if (run) run->advance();
  return run;
}
inline Options options_of(const std::string& algorithm) {
  Options o;
  o.algorithm = algorithm;
  return o;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_COMPLEXES_H_
