#include "circumball/feature_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "feature_size/nearest_neighbor.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::polygon;
using testing::Random;
using testing::random_grid;
using testing::unit_square;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point2 somewhere(Random* random) {
  const double x = 8 * random->unit() - 1;
  const double y = 8 * random->unit() - 1;
  return {x, y};
}

TEST(Definition2_1_6, LocalFeatureSizeOfASquare) {
  const FeatureSizes sizes(unit_square());
  EXPECT_EQ(sizes.local({0, 0}).radius, 1);  // the vertex and a side that does not touch it
  EXPECT_EQ(sizes.local({0.5, 0}).radius,
            0.5);  // its side and a vertical one share a vertex; the two vertical ones do not
  EXPECT_EQ(sizes.local({0.5, 0.5}).radius, 0.5);
  EXPECT_EQ(sizes.local({0.5, 0.25}).radius, 0.5);
  EXPECT_EQ(sizes.local({0.5, 0}, 0).radius, 0.5);
  EXPECT_EQ(sizes.local({0.5, 0.5}, 0).radius, std::sqrt(0.5));
}

TEST(Definition2_1_6, MeshFeatureSizeNeedsNoDisjointFeatures) {
  const FeatureSizes sizes(unit_square());
  EXPECT_EQ(sizes.mesh({0, 0}).radius, 0);  // the vertex and its segments
  EXPECT_EQ(sizes.mesh({0.25, 0}).radius, 0.25);
  EXPECT_EQ(sizes.mesh({0, 0}, 0).radius, 1);
}

TEST(Definition2_1_6, WhatHasNoTwoDisjointFeaturesHasNoSize) {
  Complex c;
  c.vertices = {{1, 2, 0}};
  EXPECT_EQ(FeatureSizes(c).local({0, 0}).radius, kInfinity);
  EXPECT_EQ(FeatureSizes(c).mesh({0, 0}).radius, kInfinity);
  EXPECT_EQ(FeatureSizes(Complex{}).local({0, 0}).radius, kInfinity);
  c = polygon({{0, 0}, {4, 0}, {0, 3}});  // the three sides meet each other, vertices are disjoint
  EXPECT_EQ(FeatureSizes(c).local({0, 0}).radius, 2.4);  // the opposite side
}

TEST(Definition2_1_6, AnAcuteAngleDoesNotShrinkIt) {
  Complex c;
  c.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1e-6, 0}};
  c.segments = {{0, 1}, {0, 2}};
  EXPECT_EQ(FeatureSizes(c).local({0, 0}).radius, 1);
  EXPECT_NEAR(FeatureSizes(c).local({1, 0}).radius, 1e-6, 1e-15);
}

TEST(FeatureSizes, TheTreeAgreesWithTheDefinition) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Complex complex = random_grid(seed, seed % 2 ? 0.3 : 0);
    const FeatureSizes sizes(complex);
    Random random(seed);
    for (int k = 0; k < 30; ++k) {
      const Point2 x = k % 3 ? somewhere(&random)
                             : xy(complex.vertices[random.below(
                                   static_cast<std::uint32_t>(complex.vertices.size()))]);
      for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(sizes.local(x, i).radius, sizes.local_by_brute_force(x, i).radius)
            << seed << " " << k;
        ASSERT_EQ(sizes.mesh(x, i).radius, sizes.mesh_by_brute_force(x, i).radius)
            << seed << " " << k;
      }
    }
  }
}

TEST(FeatureSizes, AreLipschitzWithConstantOne) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const FeatureSizes sizes(random_grid(seed, 0.3));
    Random random(seed + 77);
    for (int k = 0; k < 50; ++k) {
      const Point2 x = somewhere(&random);
      const Point2 y = somewhere(&random);
      const double distance = std::sqrt((x.x - y.x) * (x.x - y.x) + (x.y - y.y) * (x.y - y.y));
      for (int i = 0; i < 2; ++i) {
        if (sizes.local(x, i).radius != kInfinity) {
          EXPECT_LE(std::fabs(sizes.local(x, i).radius - sizes.local(y, i).radius),
                    distance * (1 + 1e-12));
        }
        if (sizes.mesh(x, i).radius != kInfinity) {
          EXPECT_LE(std::fabs(sizes.mesh(x, i).radius - sizes.mesh(y, i).radius),
                    distance * (1 + 1e-12));
        }
      }
      EXPECT_LE(sizes.mesh(x).radius, sizes.local(x).radius);
      EXPECT_LE(sizes.local(x, 1).radius, sizes.local(x, 0).radius);
    }
  }
}

TEST(FeatureSizes, ScaleWithTheComplexByPowersOfTwo) {
  Complex complex = random_grid(5, 0.3), large = complex;
  for (Point3& p : large.vertices) p = {0x1p40 * p.x, 0x1p40 * p.y, 0};
  const FeatureSizes sizes(complex), large_sizes(large);
  Random random(9);
  for (int k = 0; k < 100; ++k) {
    const Point2 x = somewhere(&random);
    EXPECT_EQ(0x1p40 * sizes.local(x).radius,
              large_sizes.local({0x1p40 * x.x, 0x1p40 * x.y}).radius);
  }
}

TEST(NearestNeighbor, IsTheDistanceToTheSecondNearestVertex) {
  Random random(1);
  std::vector<Point2> points;
  std::vector<Box2> boxes;
  for (int k = 0; k < 300; ++k) {
    points.push_back(somewhere(&random));
    boxes.push_back(Box2::of(points.back()));
  }
  const BoxTree tree(boxes);
  for (int k = 0; k < 100; ++k) {
    const bool on = k % 2 == 0;
    const auto self = static_cast<std::uint32_t>(k);
    const Point2 x = on ? points[self] : somewhere(&random);
    std::vector<double> distances;
    for (const Point2& p : points)
      distances.push_back(std::sqrt((x.x - p.x) * (x.x - p.x) + (x.y - p.y) * (x.y - p.y)));
    std::sort(distances.begin(), distances.end());
    EXPECT_EQ(nearest_neighbor(tree, x), distances[1]);
    if (on) {
      EXPECT_EQ(nearest_neighbor(tree, x, self), distances[1]);
    }
  }
  EXPECT_EQ(nearest_neighbor(BoxTree({Box2::of({0, 0})}), {1, 1}), kInfinity);
}

}  // namespace
}  // namespace circumball
