#ifndef CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS_H_
#define CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/delaunay2.h"

/// Point sets that triangulations go wrong on, and what the tests of Delaunay2 compare.
namespace circumball::testing {

/// Seeded, and the same everywhere (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits() % n); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

enum class Kind {
  kRandom,
  kLattice,
  kCollinear,
  kSteepCollinear,
  kNearlyCollinear,
  kComb,
  kCocircular,
  kClusters,
  kOffset,
  kDuplicates,
  kLarge,
  kSmall,
};
constexpr Kind kAllKinds[] = {
    Kind::kRandom,          Kind::kLattice,    Kind::kCollinear,  Kind::kSteepCollinear,
    Kind::kNearlyCollinear, Kind::kComb,       Kind::kCocircular, Kind::kClusters,
    Kind::kOffset,          Kind::kDuplicates, Kind::kLarge,      Kind::kSmall,
};

inline std::string name(Kind kind) {
  static const char* const names[] = {
      "random",           "lattice",    "collinear",  "steep collinear",
      "nearly collinear", "comb",       "cocircular", "clusters",
      "offset",           "duplicates", "large",      "small",
  };
  return names[static_cast<int>(kind)];
}

inline Point2 random_point(Kind kind, Random* random) {
  // The 36 lattice points of a circle, exactly cocircular: x^2 + y^2 = 65^2.
  static const std::vector<Point2> circle = [] {
    std::vector<Point2> points;
    for (int x = -65; x <= 65; ++x)
      for (int y = -65; y <= 65; ++y)
        if (x * x + y * y == 65 * 65) points.push_back({double(x), double(y)});
    return points;
  }();
  // One draw a statement: compilers order the operands of an expression as they like.
  const double u = random->unit();
  const double v = random->unit();
  const std::uint32_t i = random->below(1u << 20);
  const std::uint32_t j = random->below(1u << 20);
  switch (kind) {
    case Kind::kRandom:
      return {u, v};
    case Kind::kLattice:
      return {double(i % 8) - 3, double(j % 8) - 3};
    case Kind::kCollinear:
      return {3.0 * (i % 64) - 90, 2.0 * (i % 64) + 7};
    case Kind::kSteepCollinear:
      return {0.25, i % 2 ? u : -u};
    case Kind::kNearlyCollinear:
      return {u, u + 0x1p-50 * (j % 3)};
    case Kind::kComb:
      return {double(i % 32), j % 5 == 0 ? 1.0 : 0.0};
    case Kind::kCocircular:
      return circle[i % circle.size()];
    case Kind::kClusters:
      return {double(i % 3) + 1e-12 * (j % 7), double(j % 2) + 1e-12 * (i % 5)};
    case Kind::kOffset:
      return {1e6 + 1e-3 * u, 1e6 + 1e-3 * v};
    case Kind::kDuplicates:
      return {double(i % 4), (j % 4 == 0 ? -0.0 : double(j % 4))};
    case Kind::kLarge:
      return {1e55 * (2 * u - 1), 1e55 * (2 * v - 1)};
    case Kind::kSmall:
      return {1e-45 * (1 + i % 9), 1e-45 * (1 + j % 9)};
  }
  return {};
}

inline std::vector<Point2> random_points(Kind kind, std::size_t n, std::uint64_t seed) {
  Random random(seed * 16 + static_cast<std::uint64_t>(kind));
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(random_point(kind, &random));
  return points;
}

using Corners = std::array<std::uint32_t, 3>;

/// The corners of a triangle, the smallest number first (kGhost is the largest).
inline Corners corners(const Delaunay2::Triangle& t) {
  Corners c{t.v[0].value, t.v[1].value, t.v[2].value};
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

/// All triangles, ghosts too.
inline std::multiset<Corners> triangles(const Delaunay2& d) {
  std::multiset<Corners> all;
  for (TriangleId t = 0; t < d.slot_count(); ++t) all.insert(corners(d.triangle(t)));
  return all;
}

/// Inserts one by one, from hints at random.
inline void insert_all(Delaunay2* d, const std::vector<std::uint32_t>& order, Random* random) {
  for (const std::uint32_t v : order)
    if (d->probe(VertexId(v), random->below(200)) == Delaunay2::Probe::kOk) d->commit(VertexId(v));
}

inline Delaunay2 in_number_order(const std::vector<Point2>& points) {
  Delaunay2 d;
  Random random(points.size());
  std::vector<std::uint32_t> order;
  for (const Point2& p : points) order.push_back(d.add_vertex(p).value);
  insert_all(&d, order, &random);
  return d;
}

inline Delaunay2 in_a_batch(const std::vector<Point2>& points) {
  Delaunay2 d;
  for (const Point2& p : points) d.add_vertex(p);
  d.insert_batch(0, d.vertex_count(), nullptr);
  return d;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS_H_
