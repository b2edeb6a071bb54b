#include "complex/planar_arrangement.h"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "complex/product_sum.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::Random;

/// Random unit edges of a lattice as a complex (seen through a linear map), beside the same thing
/// as a maze of unit cells.
struct Maze {
  std::uint32_t side;
  std::vector<bool> wall_right,
      wall_up;  // between lattice cells, with a margin of one free cell all around
  Complex complex;
  std::vector<std::uint32_t> level, face;  // of each lattice cell, by flood fill
  std::uint32_t faces = 0;

  Point2 map(double x, double y) const {
    return {1e6 + 2 * x + y, 3 * y - 5e5 - x};
  }  // area times 7, exact
  std::uint32_t at(std::uint32_t x, std::uint32_t y) const { return y * side + x; }

  Maze(std::uint64_t seed, double density) {
    Random random(seed);
    side = 3 + random.below(6);
    wall_right.assign(side * side, false);
    wall_up.assign(side * side, false);
    std::vector<std::uint32_t> number((side + 1) * (side + 1), kNoIndex);
    const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
      std::uint32_t& n = number[y * (side + 1) + x];
      if (n == kNoIndex) {
        n = static_cast<std::uint32_t>(complex.vertices.size());
        complex.vertices.push_back(xyz(map(x, y)));
      }
      return n;
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      if (random.below(2))
        complex.segments.push_back({a, b});
      else
        complex.segments.push_back({b, a});
    };
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const bool inner_x = x > 0 && x + 1 < side, inner_y = y > 0 && y + 1 < side;
        if (x + 1 < side && inner_y && random.unit() < density) {
          wall_right[at(x, y)] = true;
          const std::uint32_t a = vertex(x + 1, y);
          add(a, vertex(x + 1, y + 1));
        }
        if (y + 1 < side && inner_x && random.unit() < density) {
          wall_up[at(x, y)] = true;
          const std::uint32_t a = vertex(x, y + 1);
          add(a, vertex(x + 1, y + 1));
        }
      }
    }
    flood();
  }

  template <class F>
  void for_each_neighbor(std::uint32_t c, F f) const {  // f(cell, wall between)
    const std::uint32_t x = c % side, y = c / side;
    if (x + 1 < side) f(c + 1, static_cast<bool>(wall_right[c]));
    if (x > 0) f(c - 1, static_cast<bool>(wall_right[c - 1]));
    if (y + 1 < side) f(c + side, static_cast<bool>(wall_up[c]));
    if (y > 0) f(c - side, static_cast<bool>(wall_up[c - side]));
  }
  void flood() {
    face.assign(side * side, kNoIndex);
    level.assign(side * side, kNoIndex);
    for (std::uint32_t start = 0; start < face.size(); ++start) {
      if (face[start] != kNoIndex) continue;
      std::deque<std::uint32_t> queue{start};
      face[start] = faces;
      while (!queue.empty()) {
        const std::uint32_t c = queue.front();
        queue.pop_front();
        for_each_neighbor(c, [&](std::uint32_t d, bool wall) {
          if (wall || face[d] != kNoIndex) return;
          face[d] = faces;
          queue.push_back(d);
        });
      }
      ++faces;
    }
    level[0] = 0;  // shortest paths, a wall costs 1: relax until nothing changes
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t c = 0; c < face.size(); ++c) {
        if (level[c] == kNoIndex) continue;
        for_each_neighbor(c, [&](std::uint32_t d, bool wall) {
          const std::uint32_t through = level[c] + (wall ? 1 : 0);
          if (through >= level[d]) return;
          level[d] = through;
          changed = true;
        });
      }
    }
  }
};

TEST(PlanarArrangement, FacesAreasAndLevelsAreThoseOfAFloodFill) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Maze maze(seed, 0.15 + 0.1 * static_cast<double>(seed % 9));
    std::vector<Point2> centers;
    for (std::uint32_t c = 0; c < maze.face.size(); ++c)
      centers.push_back(maze.map(c % maze.side + 0.5, c / maze.side + 0.5));
    const PlanarView view(maze.complex, centers);
    const SweepResult swept = sweep(view);
    for (const std::uint8_t suspect : swept.suspect) ASSERT_FALSE(suspect);
    const PlanarArrangement arrangement(view, swept);
    ASSERT_EQ(arrangement.face_count(), maze.faces) << "seed " << seed;
    std::vector<std::uint32_t> face_of(maze.faces, kNoIndex);
    std::vector<double> area(maze.faces, 0);
    for (std::uint32_t c = 0; c < centers.size(); ++c) {
      const std::uint32_t f = arrangement.face_of_point(view.point_of_seed[c]);
      std::uint32_t& expected = face_of[maze.face[c]];
      if (expected == kNoIndex) expected = f;
      ASSERT_EQ(f, expected) << "seed " << seed << ", cell " << c;
      ASSERT_EQ(arrangement.level(f), maze.level[c]) << "seed " << seed << ", cell " << c;
      area[f] += 7;
    }
    for (std::uint32_t f = 1; f < maze.faces; ++f)
      ASSERT_EQ(arrangement.area(f), area[f]) << "seed " << seed;
  }
}

TEST(PlanarArrangement, HoleSeedsTakeOutTheirFaceAndParityEverySecondLevel) {
  for (std::uint64_t seed = 1000; seed < 1200; ++seed) {
    Maze maze(seed, 0.8);
    Random random(seed);
    const std::uint32_t hole = random.below(maze.side * maze.side);
    const Point2 at = maze.map(hole % maze.side + 0.5, hole / maze.side + 0.5);
    maze.complex.holes.push_back(xyz(at));
    const PlanarView view(maze.complex, {at});
    const PlanarArrangement arrangement(view, sweep(view));
    std::vector<double> expected(2, 0);
    for (std::uint32_t c = 0; c < maze.level.size(); ++c) {
      if (maze.level[c] >= 1 && maze.face[c] != maze.face[hole]) expected[0] += 7;
      if (maze.level[c] % 2 == 1) expected[1] += 7;
    }
    for (int rule = 0; rule < 2; ++rule) {
      maze.complex.hole_rule =
          rule == 0 ? HoleRule::kAuto : HoleRule::kParity;  // a hole is listed: kSeeds
      const std::vector<bool> inside = arrangement.inside(maze.complex, view);
      double area = 0;
      for (std::uint32_t f = 1; f < inside.size(); ++f)
        if (inside[f]) area += arrangement.area(f);
      EXPECT_FALSE(inside[PlanarArrangement::kUnbounded]);
      EXPECT_EQ(area, expected[rule]) << "seed " << seed;
    }
  }
}

TEST(ProductSum, CancelsWhatDoublesCannot) {
  ProductSum sum;  // a triangle of area 2^-61 at an offset of 2^20
  const double x = 0x1p20, h = 0x1p-30;
  const Point2 p[3] = {{x, x}, {x + h, x}, {x, x + h}};
  for (int k = 0; k < 3; ++k) sum.add_cross(p[k].x, p[k].y, p[(k + 1) % 3].x, p[(k + 1) % 3].y);
  EXPECT_EQ(0.5 * sum.value(), 0x1p-61);
}

}  // namespace
}  // namespace circumball
