#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "circumball/feature_size.h"
#include "support/acute_complexes.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::polygon;
using testing::Random;
using testing::unit_square;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance(const Point2& a, const Point2& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}
Point2 between(const Point2& a, const Point2& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

TEST(Definition2_1_6, OfASetItIsTheInfimum) {
  const FeatureSizes sizes(unit_square());
  EXPECT_EQ(sizes.local({0, 0}, {1, 0}).radius, 0.5);  // in the middle, both vertical sides
  EXPECT_EQ(sizes.local({0, 0}, {1, 0}).center, (Point2{0.5, 0}));
  EXPECT_EQ(sizes.local({0, 0}, {0.25, 0}).radius, 0.75);
  EXPECT_EQ(sizes.mesh({0, 0}, {0.25, 0}).radius, 0);
  EXPECT_EQ(sizes.mesh({0.25, 0}, {0.375, 0}).radius, 0.25);
  EXPECT_EQ(sizes.mesh({0.25, 0}, {0.375, 0}).center, (Point2{0.25, 0}));
  EXPECT_EQ(sizes.local({0, 0}, {0, 0}).radius, 1);  // a piece may be a point
  EXPECT_EQ(sizes.local({{0, 0}, {0.25, 0}, {0.25, 0.5}}).radius, 0.5);
  EXPECT_EQ(sizes.local(std::vector<Point2>{{0, 0}}).radius, 1);
  EXPECT_EQ(sizes.local(std::vector<Point2>()).radius, kInfinity);
  EXPECT_EQ(FeatureSizes(Complex{}).local({0, 0}, {1, 0}).radius, kInfinity);
  EXPECT_EQ(sizes.local({0, 0}, {kInfinity, 0}).radius, kInfinity);
}

TEST(Definition2_1_7, IsLocalAtEndSegmentsAndMeshElsewhere) {
  Complex c;  // two segments at a small angle
  c.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}};
  c.segments = {{0, 1}, {0, 2}};
  const FeatureSizes sizes(c);
  EXPECT_EQ(sizes.of_subsegment({0, 0}, {2, 0}).radius,
            sizes.local_by_brute_force({0, 0}, {2, 0}).radius);
  const FeatureBall middle = sizes.of_subsegment({1, 0}, {2, 0});
  EXPECT_EQ(middle.radius, sizes.mesh_by_brute_force({1, 0}, {2, 0}).radius);
  EXPECT_NEAR(middle.radius, 1 / std::sqrt(17.0), 1e-15);  // to the other segment, from (1, 0)
  EXPECT_EQ(middle.center, (Point2{1, 0}));
  EXPECT_EQ(sizes.of_subsegment({1, 0}, {2, 0}, 0).radius, 2 * std::sqrt(1.0));  // at (2, 0)
  EXPECT_TRUE(sizes.is_input_vertex({4, 1}));
  EXPECT_FALSE(sizes.is_input_vertex({4, 0.5}));
}

/// What a ball says of itself: its witnesses are where they should be.
void expect_sound(const Complex& complex, const FeatureBall& ball, bool disjoint) {
  if (!ball.found()) return;
  double largest = 0;
  for (const FeatureWitness& w : ball.witness) {
    largest = std::max(largest, distance(ball.center, w.at));
    ASSERT_LE(distance(ball.center, w.at), ball.radius + 1e-14);
  }
  EXPECT_NEAR(largest, ball.radius, 1e-14);
  const auto ends = [&](const Feature& f) {
    return f.kind == FeatureKind::kVertex ? std::array<std::uint32_t, 2>{f.index, f.index}
                                          : complex.segments[f.index];
  };
  const auto f = ends(ball.witness[0].feature), g = ends(ball.witness[1].feature);
  if (disjoint) {
    for (const std::uint32_t a : f) {
      for (const std::uint32_t b : g) EXPECT_NE(a, b);
    }
  } else {
    EXPECT_FALSE(ball.witness[0].feature == ball.witness[1].feature);
  }
}

/// A piece anywhere, of an input segment, or between two input vertices.
std::array<Point2, 2> some_piece(const Complex& c, Random* random) {
  const auto vertex = [&] {
    return xy(c.vertices[random->below(static_cast<std::uint32_t>(c.vertices.size()))]);
  };
  const std::uint32_t kind = random->below(4);
  if (kind == 0 || c.segments.empty()) {
    const double x = 4 * random->unit() - 1, y = 4 * random->unit() - 1;
    return {Point2{x, y}, vertex()};
  }
  if (kind == 1) {
    const Point2 a = vertex();
    return {a, vertex()};
  }
  const auto& s = c.segments[random->below(static_cast<std::uint32_t>(c.segments.size()))];
  const Point2 a = xy(c.vertices[s[0]]), b = xy(c.vertices[s[1]]);
  const double t = random->unit(), u = random->unit();
  return {kind == 2 ? a : between(a, b, t), between(a, b, u)};
}

TEST(FeatureSizes, OfAPieceAreBelowEverySampleAndAttained) {
  constexpr int kSamples = 200;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Complex complex = testing::random_acute_complex(seed, 1);
    const FeatureSizes sizes(complex);
    Random random(seed);
    for (int k = 0; k < 8; ++k) {
      const auto [a, b] = some_piece(complex, &random);
      const int i = k % 2;
      const bool disjoint = k % 3 != 0;
      const auto at = [&](const Point2& x) {
        return disjoint ? sizes.local_by_brute_force(x, i).radius
                        : sizes.mesh_by_brute_force(x, i).radius;
      };
      const FeatureBall ball = disjoint ? sizes.local(a, b, i) : sizes.mesh(a, b, i);
      expect_sound(complex, ball, disjoint);
      if (!ball.found()) {
        EXPECT_EQ(at(a), kInfinity);
        continue;
      }
      EXPECT_NEAR(at(ball.center), ball.radius, 1e-14) << seed << " " << k;  // attained
      double least = kInfinity;
      for (int j = 0; j <= kSamples; ++j)
        least = std::min(least, at(between(a, b, static_cast<double>(j) / kSamples)));
      EXPECT_LE(ball.radius, least + 1e-14) << seed << " " << k;
      // Lipschitz with constant 1: the infimum is not far below the least sample either.
      EXPECT_GE(ball.radius, least - distance(a, b) / kSamples) << seed << " " << k;
      for (const double step : {1e-3, 1e-6, 1e-9}) {  // nor below its neighborhood
        for (const double side : {-step, step}) {
          const Point2 x{ball.center.x + side * (b.x - a.x), ball.center.y + side * (b.y - a.y)};
          if ((x.x - a.x) * (b.x - x.x) + (x.y - a.y) * (b.y - x.y) < 0) continue;
          EXPECT_LE(ball.radius, at(x) + 1e-14) << seed << " " << k << " " << side;
        }
      }
    }
  }
}

TEST(FeatureSizes, OfPiecesTheTreeAgreesWithTheDefinition) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Complex complex =
        seed % 4 == 0 ? testing::random_grid(seed, 0.3) : testing::random_acute_complex(seed, 0.01);
    const FeatureSizes sizes(complex);
    Random random(seed);
    for (int k = 0; k < 10; ++k) {
      const auto [a, b] = some_piece(complex, &random);
      for (int i = 0; i < 2; ++i) {
        const FeatureBall lfs = sizes.local(a, b, i), mfs = sizes.mesh(a, b, i);
        const double local = sizes.local_by_brute_force(a, b, i).radius;
        const double mesh = sizes.mesh_by_brute_force(a, b, i).radius;
        if (local == kInfinity) {
          EXPECT_EQ(lfs.radius, kInfinity);
        } else {
          ASSERT_NEAR(lfs.radius, local, 1e-14) << seed << " " << k;
        }
        if (mesh == kInfinity) {
          EXPECT_EQ(mfs.radius, kInfinity);
        } else {
          ASSERT_NEAR(mfs.radius, mesh, 1e-14) << seed << " " << k;
        }
        expect_sound(complex, lfs, true);
        expect_sound(complex, mfs, false);
      }
    }
  }
}

TEST(FeatureSizes, OfLongPiecesAcrossManyFeaturesTheTreeAgreesWithTheDefinition) {
  Complex comb;  // teeth at random places, some very close to each other, and a hub of many
  Random random(3);
  const auto segment = [&](Point3 a, Point3 b) {
    const auto n = static_cast<std::uint32_t>(comb.vertices.size());
    comb.vertices.push_back(a);
    comb.vertices.push_back(b);
    comb.segments.push_back({n, n + 1});
  };
  double x = 0;
  for (int k = 0; k < 300; ++k) {
    x += random.below(10) ? 0.01 + 0.01 * random.unit() : 1e-5;
    segment({x, -1 + 0.1 * random.unit(), 0}, {x, 1, 0});
  }
  const auto hub = static_cast<std::uint32_t>(comb.vertices.size());
  comb.vertices.push_back({-2, 0, 0});
  for (int k = 0; k <= 100; ++k) {
    comb.vertices.push_back({-1, 1e-3 * k, 0});
    comb.segments.push_back({hub, hub + 1 + static_cast<std::uint32_t>(k)});
  }
  const FeatureSizes sizes(comb);
  for (const auto& [a, b] :
       std::vector<std::array<Point2, 2>>{{Point2{0, 0}, Point2{x, 0}},
                                          {Point2{-2, 0}, Point2{x, 0.1}},
                                          {Point2{-2, 0}, Point2{-1, 0.05}},
                                          {Point2{-1.5, -1}, Point2{-1.5, 1}}}) {
    EXPECT_NEAR(sizes.local(a, b).radius, sizes.local_by_brute_force(a, b).radius, 1e-14);
    EXPECT_NEAR(sizes.mesh(a, b).radius, sizes.mesh_by_brute_force(a, b).radius, 1e-14);
  }
}

TEST(FeatureSizes, OfPiecesScaleWithTheComplexByPowersOfTwo) {
  const Complex complex = testing::random_acute_complex(5, 3);
  Complex large = complex;
  for (Point3& p : large.vertices) p = {0x1p100 * p.x, 0x1p100 * p.y, 0};
  const FeatureSizes sizes(complex), large_sizes(large);
  Random random(9);
  for (int k = 0; k < 100; ++k) {
    const auto [a, b] = some_piece(complex, &random);
    EXPECT_EQ(
        0x1p100 * sizes.local(a, b).radius,
        large_sizes.local({0x1p100 * a.x, 0x1p100 * a.y}, {0x1p100 * b.x, 0x1p100 * b.y}).radius);
  }
}

}  // namespace
}  // namespace circumball
