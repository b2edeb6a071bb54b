#include "complex/face_plane.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/complexes.h"

namespace circumball {
namespace {

using testing::Random;

double uniform(Random* random, double low, double high) {
  return low + (high - low) * random->unit();
}

/// A face in the plane z = x / 2 + 3.
struct SlopingFace {
  Complex complex;
  SlopingFace() {
    complex.dimension = 3;
    complex.faces.emplace_back();
  }
  static Point3 lift(double x, double y) { return {x, y, x / 2 + 3}; }
  void add_loop(const std::vector<Point2>& corners) {
    complex.faces[0].loops.emplace_back();
    for (const Point2& p : corners) {
      complex.faces[0].loops.back().push_back(static_cast<std::uint32_t>(complex.vertices.size()));
      complex.vertices.push_back(lift(p.x, p.y));
    }
  }
  void add_square(double x, double y, double side) {
    add_loop({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
  }
};

TEST(FacePlane, TakesPointsToThePlaneAndBack) {
  SlopingFace f;
  f.add_square(1, 1, 4);
  const FacePlane plane(f.complex, 0);
  ASSERT_TRUE(plane.valid());
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Point3 p = SlopingFace::lift(uniform(&random, -5, 5), uniform(&random, -5, 5));
    const Point3 q = plane.to_space(plane.to_plane(p));
    EXPECT_NEAR(p.x, q.x, 1e-14);
    EXPECT_NEAR(p.y, q.y, 1e-14);
    EXPECT_NEAR(p.z, q.z, 1e-14);
    EXPECT_NEAR(plane.height(p), 0, 1e-14);
  }
}

TEST(FacePlane, ContainsWhatIsInsideOfAStarOfManySides) {
  constexpr int kCorners = 600;
  SlopingFace f;
  std::vector<Point2> corners;
  for (int i = 0; i < kCorners; ++i) {
    corners.push_back(testing::polar(0, 0, i % 2 == 0 ? 1 : 0.5, 360.0 * i / kCorners));
  }
  f.add_loop(corners);
  const FacePlane plane(f.complex, 0);
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Point2 p{uniform(&random, -1.2, 1.2), uniform(&random, -1.2, 1.2)};
    // Star-shaped about the origin: inside of exactly one of its triangles with two corners.
    int wedges = 0;
    for (int k = 0; k < kCorners; ++k) {
      const Point2 &a = corners[k], &b = corners[(k + 1) % kCorners];
      const auto turn = [](const Point2& u, const Point2& v, const Point2& w) {
        return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
      };
      if (turn({0, 0}, a, p) > 0 && turn(a, b, p) > 0 && turn(b, {0, 0}, p) > 0) ++wedges;
    }
    EXPECT_EQ(plane.contains(plane.to_plane(SlopingFace::lift(p.x, p.y))), wedges == 1)
        << p.x << ' ' << p.y;
  }
}

TEST(FacePlane, CutsOutThePartsOfHolePointsAmongThousandLoops) {
  // A plate with 32 times 32 squares, each with a smaller one inside. Of each, by turns, the hole
  // point lies in the ring between the two, in the inner one, or there is none.
  constexpr int kSide = 32;
  SlopingFace f;
  f.add_square(-1, -1, kSide + 1);
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      f.add_square(i, j, 0.5);
      f.add_square(i + 0.125, j + 0.125, 0.25);
      const double at = (i + j) % 3 == 0 ? 0.0625 : 0.25;
      if ((i + j) % 3 < 2) f.complex.faces[0].holes.push_back(SlopingFace::lift(i + at, j + at));
    }
  }
  const FacePlane plane(f.complex, 0);
  const auto contains = [&](double x, double y) {
    return plane.contains(plane.to_plane(SlopingFace::lift(x, y)));
  };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const int kind = (i + j) % 3;
      EXPECT_TRUE(contains(i + 0.75, j + 0.75));
      EXPECT_EQ(contains(i + 0.4375, j + 0.25), kind != 0) << i << ' ' << j;
      EXPECT_EQ(contains(i + 0.1875, j + 0.3125), kind != 1) << i << ' ' << j;
    }
  }
  EXPECT_FALSE(contains(-1.5, 3));
  EXPECT_FALSE(contains(kSide + 0.5, 3.25));
}

TEST(FacePlane, HasNoPlaneForWhatHasNoArea) {
  SlopingFace f;
  f.add_loop({{0, 0}, {1, 0}, {2, 0}});
  EXPECT_FALSE(FacePlane(f.complex, 0).valid());
  SlopingFace two;
  two.add_loop({{0, 0}, {1, 0}});
  EXPECT_FALSE(FacePlane(two.complex, 0).valid());
}

}  // namespace
}  // namespace circumball
