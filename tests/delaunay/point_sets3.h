#ifndef CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS3_H_
#define CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS3_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "delaunay/delaunay3.h"
#include "point_sets.h"

/// Point sets of space that triangulations go wrong on, and what the tests of Delaunay3 compare.
namespace circumball::testing {

enum class Kind3 {
  kRandom,
  kLattice,
  kSheared,
  kCollinear,
  kDiagonal,
  kNearlyCollinear,
  kPlane,
  kPlaneLattice,
  kTiltedLattice,
  kNearlyCoplanar,
  kTwoPlanes,
  kTwoLines,
  kCospherical,
  kCocircular,
  kClusters,
  kOffset,
  kDuplicates,
  kLarge,
  kSmall,
};
constexpr Kind3 kAllKinds3[] = {
    Kind3::kRandom,        Kind3::kLattice,         Kind3::kSheared,   Kind3::kCollinear,
    Kind3::kDiagonal,      Kind3::kNearlyCollinear, Kind3::kPlane,     Kind3::kPlaneLattice,
    Kind3::kTiltedLattice, Kind3::kNearlyCoplanar,  Kind3::kTwoPlanes, Kind3::kTwoLines,
    Kind3::kCospherical,   Kind3::kCocircular,      Kind3::kClusters,  Kind3::kOffset,
    Kind3::kDuplicates,    Kind3::kLarge,           Kind3::kSmall,
};

inline std::string name(Kind3 kind) {
  static const char* const names[] = {
      "random",           "lattice",    "sheared lattice", "collinear",      "diagonal",
      "nearly collinear", "plane",      "plane lattice",   "tilted lattice", "nearly coplanar",
      "two planes",       "two lines",  "cospherical",     "cocircular",     "clusters",
      "offset",           "duplicates", "large",           "small",
  };
  return names[static_cast<int>(kind)];
}

inline Point3 random_point(Kind3 kind, Random* random) {
  // The 168 lattice points of a sphere, exactly cospherical: x^2 + y^2 + z^2 = 15^2.
  static const std::vector<Point3> sphere = [] {
    std::vector<Point3> points;
    for (int x = -15; x <= 15; ++x)
      for (int y = -15; y <= 15; ++y)
        for (int z = -15; z <= 15; ++z)
          if (x * x + y * y + z * z == 15 * 15) points.push_back({double(x), double(y), double(z)});
    return points;
  }();
  // One draw a statement: compilers order the operands of an expression as they like.
  const double u = random->unit();
  const double v = random->unit();
  const double w = random->unit();
  const std::uint32_t i = random->below(1u << 20);
  const std::uint32_t j = random->below(1u << 20);
  const std::uint32_t k = random->below(1u << 20);
  switch (kind) {
    case Kind3::kRandom:
      return {u, v, w};
    case Kind3::kLattice:
      return {double(i % 4) - 1, double(j % 4) - 2, double(k % 4) - 3};
    case Kind3::kSheared:
      return {double(i % 4 + j % 3), double(j % 3 - k % 4), double(k % 4)};
    case Kind3::kCollinear:
      return {3.0 * (i % 64) - 90, 2.0 * (i % 64) + 7, 5.0 - (i % 64)};
    case Kind3::kDiagonal:
      return {0.25, i % 2 ? u : -u, i % 2 ? u : -u};
    case Kind3::kNearlyCollinear:
      return {u, u + 0x1p-50 * (j % 3), u + 0x1p-50 * (k % 3)};
    case Kind3::kPlane:
      return {u, v, 0.5};
    case Kind3::kPlaneLattice:
      return {double(i % 6), -3, double(k % 6)};
    case Kind3::kTiltedLattice:
      return {double(i % 6), double(j % 6), 2.0 * (i % 6) - 3.0 * (j % 6)};
    case Kind3::kNearlyCoplanar:
      return {u, v, u + v + 0x1p-50 * (k % 3)};
    case Kind3::kTwoPlanes:
      return {double(i % 6), double(j % 6), k % 2 ? 1.0 : 0.0};
    case Kind3::kTwoLines:
      return k % 2 ? Point3{double(i % 32), 0, 0} : Point3{0, double(j % 32), 1};
    case Kind3::kCospherical:
      return sphere[i % sphere.size()];
    case Kind3::kCocircular: {  // on a few circles of an axis, the axis too
      static const double circle[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                           {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
      if (j % 8 == 0) return {0, 0, double(k % 5)};
      return {circle[i % 12][0], circle[i % 12][1], double(k % 3)};
    }
    case Kind3::kClusters:
      return {double(i % 2) + 1e-12 * (j % 5), double(j % 2) + 1e-12 * (k % 5),
              double(k % 2) + 1e-12 * (i % 5)};
    case Kind3::kOffset:
      return {1e6 + 1e-3 * u, 1e6 + 1e-3 * v, 1e6 + 1e-3 * w};
    case Kind3::kDuplicates:
      return {double(i % 3), (j % 3 == 0 ? -0.0 : double(j % 3)), double(k % 2)};
    case Kind3::kLarge:
      return {1e55 * (2 * u - 1), 1e55 * (2 * v - 1), 1e55 * (2 * w - 1)};
    case Kind3::kSmall:
      return {1e-45 * (1 + i % 5), 1e-45 * (1 + j % 5), 1e-45 * (1 + k % 5)};
  }
  return {};
}

inline std::vector<Point3> random_points(Kind3 kind, std::size_t n, std::uint64_t seed) {
  Random random(seed * 32 + static_cast<std::uint64_t>(kind));
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(random_point(kind, &random));
  return points;
}

inline std::vector<Point3> without_duplicates(const std::vector<Point3>& points) {
  std::vector<Point3> distinct;
  for (const Point3& p : points)
    if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) distinct.push_back(p);
  return distinct;
}

using Corners4 = std::array<std::uint32_t, 4>;

/// The corners of a cell by an even permutation: all in order, but for the last two perhaps.
inline Corners4 corners(const Delaunay3::Cell& cell) {
  Corners4 c{cell.v[0].value, cell.v[1].value, cell.v[2].value, cell.v[3].value};
  bool odd = false;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (c[j] < c[i]) {
        std::swap(c[i], c[j]);
        odd = !odd;
      }
  if (odd) std::swap(c[2], c[3]);
  return c;
}

/// All cells, ghosts too.
inline std::multiset<Corners4> cells(const Delaunay3& d) {
  std::multiset<Corners4> all;
  for (CellSlot c = 0; c < d.slot_count(); ++c)
    if (d.alive(c)) all.insert(corners(d.cell(c)));
  return all;
}

/// Inserts one by one, from hints at random.
inline void insert_all(Delaunay3* d, const std::vector<std::uint32_t>& order, Random* random) {
  for (const std::uint32_t v : order)
    if (d->probe(VertexId(v), random->below(300)) == Delaunay3::Probe::kOk) d->commit(VertexId(v));
}

inline Delaunay3 in_number_order(const std::vector<Point3>& points) {
  Delaunay3 d;
  Random random(points.size());
  std::vector<std::uint32_t> order;
  for (const Point3& p : points) order.push_back(d.add_vertex(p).value);
  insert_all(&d, order, &random);
  return d;
}

inline Delaunay3 in_a_batch(const std::vector<Point3>& points) {
  Delaunay3 d;
  for (const Point3& p : points) d.add_vertex(p);
  d.insert_batch(0, d.vertex_count(), nullptr);
  return d;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_DELAUNAY_POINT_SETS3_H_
