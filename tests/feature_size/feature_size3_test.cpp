#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "circumball/feature_size.h"
#include "complex/face_plane.h"
#include "support/complexes3.h"

namespace circumball {
namespace {

using testing::between;
using testing::Builder3;
using testing::distance;
using testing::Random;
using testing::random_complex3;
using testing::uniform;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two unit squares, one above the other at a height.
Complex two_plates(double height) {
  Builder3 b;
  for (const double z : {0.0, height}) {
    std::vector<std::uint32_t> loop;
    for (const auto& p : {Point2{0, 0}, Point2{1, 0}, Point2{1, 1}, Point2{0, 1}})
      loop.push_back(b.vertex({p.x, p.y, z}));
    b.face(loop);
  }
  return b.complex();
}

TEST(Definition2_1_6InSpace, LocalFeatureSizeBetweenTwoPlates) {
  const FeatureSizes3 sizes(two_plates(0.25));
  EXPECT_EQ(sizes.local({0.5, 0.5, 0}, 2).radius, 0.25);
  EXPECT_EQ(sizes.local({0.5, 0.5, 0.125}, 2).radius, 0.125);
  EXPECT_EQ(sizes.local({0.5, 0.5, 0}, 1).radius, 0.5);             // two opposite sides
  EXPECT_EQ(sizes.local({0.5, 0.5, 0}, 0).radius, std::sqrt(0.5));  // two corners
  EXPECT_EQ(sizes.local({0, 0, 0}, 2).radius, 0.25);
  EXPECT_EQ(sizes.local({0, 0, 0}, 1).radius, 0.25);
  const FeatureBall3 ball = sizes.local({0.5, 0, 0}, {0.75, 0, 0}, 2);
  EXPECT_EQ(ball.radius, 0.25);
  EXPECT_TRUE(ball.found());
}

TEST(Definition2_1_6InSpace, MeshFeatureSizeNeedsNoDisjointFeatures) {
  const FeatureSizes3 sizes(two_plates(0.25));
  EXPECT_EQ(sizes.mesh({0.5, 0, 0}, 2).radius, 0);  // the face and its side
  EXPECT_EQ(sizes.mesh({0.5, 0.5, 0}, 2).radius, 0.25);
  EXPECT_EQ(sizes.mesh({0.25, 0, 0}, 1).radius, 0.25);
  EXPECT_EQ(sizes.mesh({0, 0, 0}, 1).radius, 0);
  EXPECT_EQ(sizes.mesh({0, 0, 0}, 0).radius, 0.25);
}

TEST(Definition2_1_7InSpace, IsLocalAtEndSegmentsAndMeshElsewhere) {
  const FeatureSizes3 sizes(two_plates(0.75));
  EXPECT_EQ(sizes.of_subsegment({0, 0, 0}, {0.25, 0, 0}).radius, 0.75);
  EXPECT_EQ(sizes.of_subsegment({0.25, 0, 0}, {0.5, 0, 0}).radius, 0.25);
  EXPECT_TRUE(sizes.is_input_vertex({0, 1, 0.75}));
  EXPECT_FALSE(sizes.is_input_vertex({0, 0.5, 0.75}));
}

/// A side of a loop is in the face, also where the face does not list the segment.
TEST(FeatureSizes3, ClearanceOfASideOfALoopIsNotFromItsOwnFace) {
  Complex c;
  c.dimension = 3;
  c.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 1}};
  c.segments = {{0, 1}};
  c.faces.emplace_back();
  c.faces[0].loops = {{0, 1, 2, 3}};
  EXPECT_EQ(FeatureSizes3(c).clearance({1.5, 0, 0}, {2.5, 0, 0}, 0).radius, 1);
}

TEST(FeatureSizes3, ClearanceIsTheDistanceToFeaturesThatDoNotContainTheSegment) {
  const Complex c = two_plates(0.25);
  const FeatureSizes3 sizes(c);
  EXPECT_EQ(sizes.clearance({0.25, 0, 0}, {0.5, 0, 0}, 0, 2).radius, 0.25);
  EXPECT_EQ(sizes.clearance({0.125, 0, 0}, {0.5, 0, 0}, 0, 2).radius, 0.125);  // the vertex
  EXPECT_EQ(sizes.clearance({0.125, 0, 0}, {0.5, 0, 0}, 0, 2).witness[1].feature,
            (Feature{FeatureKind::kVertex, 0}));
  EXPECT_EQ(sizes.clearance({0, 0, 0}, {0.5, 0, 0}, 0, 2).radius, 0);
}

TEST(FeatureSizes3, WhatCannotBeUsedIsLeftOut) {
  Complex c = two_plates(0.25);
  const double before = FeatureSizes3(c).local({0.5, 0.5, 0}).radius;
  c.vertices.push_back({kInfinity, 0, 0});
  c.segments.push_back({0, 99});
  c.segments.push_back({1, 1});
  c.segments.push_back({1, 0});  // again
  c.faces.emplace_back();
  c.faces.push_back({{{0, 1, 77}}, {}, {}, {}});
  c.faces.push_back({{{0, 1}}, {}, {}, {}});
  c.faces.push_back({{{0, 1, 1}}, {}, {55}, {}});
  const FeatureSizes3 sizes(c);
  EXPECT_EQ(sizes.local({0.5, 0.5, 0}).radius, before);
  EXPECT_EQ(sizes.mesh({0.25, 0, 0}, 1).radius, 0.25);
  EXPECT_EQ(
      sizes.clearance({0.25, 0, 0}, {0.5, 0, 0}, static_cast<std::uint32_t>(c.segments.size() - 1))
          .radius,
      0.25);
  EXPECT_EQ(sizes.local({kInfinity, 0, 0}).radius, kInfinity);
  EXPECT_EQ(FeatureSizes3(Complex{}).local({0, 0, 0}).radius, kInfinity);
  EXPECT_EQ(FeatureSizes3(Complex{}).local({0, 0, 0}, {1, 0, 0}).radius, kInfinity);
}

double to_segment(const Point3& x, const Point3& a, const Point3& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
  const double t =
      ((x.x - a.x) * dx + (x.y - a.y) * dy + (x.z - a.z) * dz) / (dx * dx + dy * dy + dz * dz);
  return distance(x, between(a, b, std::min(1.0, std::max(0.0, t))));
}

TEST(FeatureSizes3, DistanceFromAFaceIsItsHeightAboveOrThatOfItsSides) {
  int holes = 0, above = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    Builder3 b;
    const testing::Rotation turn(&random);
    b.place({0, 0, 0}, seed % 2 ? &turn : nullptr);
    testing::add_star_face(&b, &random, 1);
    const Complex c = b.complex();
    holes += c.faces[0].holes.empty() ? 0 : 1;
    const FeatureSizes3 sizes(c, [](const Feature& f) { return f.kind == FeatureKind::kFace; });
    const FacePlane plane(c, 0);
    for (int k = 0; k < 50; ++k) {
      const Point3 x{uniform(&random, -1, 1), uniform(&random, -1, 1), uniform(&random, -1, 1)};
      double expected = kInfinity;
      if (plane.contains(plane.to_plane(x))) {
        expected = std::fabs(plane.height(x));
        ++above;
      }
      for (const auto& loop : c.faces[0].loops) {
        for (std::size_t i = 0; i < loop.size(); ++i)
          expected = std::min(expected, to_segment(x, c.vertices[loop[i]],
                                                   c.vertices[loop[(i + 1) % loop.size()]]));
      }
      EXPECT_NEAR(sizes.clearance(x, x, kNoIndex).radius, expected, 1e-14) << seed << " " << k;
    }
  }
  EXPECT_GT(holes, 15);
  EXPECT_GT(above, 300);
}

/// The vertices of a feature.
std::set<std::uint32_t> vertices_of(const Complex& c, const Feature& f) {
  if (f.kind == FeatureKind::kVertex) return {f.index};
  if (f.kind == FeatureKind::kSegment)
    return {c.segments[f.index].begin(), c.segments[f.index].end()};
  const Face& face = c.faces[f.index];
  std::set<std::uint32_t> all(face.vertices.begin(), face.vertices.end());
  for (const auto& loop : face.loops) all.insert(loop.begin(), loop.end());
  for (const std::uint32_t s : face.segments)
    all.insert(c.segments[s].begin(), c.segments[s].end());
  return all;
}

/// What a ball says of itself: its witnesses are where they should be, and as they should be.
void expect_sound(const Complex& complex, const FeatureBall3& ball, bool disjoint) {
  if (!ball.found()) return;
  double largest = 0;
  for (const FeatureWitness3& w : ball.witness) {
    largest = std::max(largest, distance(ball.center, w.at));
    ASSERT_LE(distance(ball.center, w.at), ball.radius + 1e-14);
  }
  EXPECT_NEAR(largest, ball.radius, 1e-14);
  EXPECT_FALSE(ball.witness[0].feature == ball.witness[1].feature);
  if (!disjoint) return;
  const auto f = vertices_of(complex, ball.witness[0].feature);
  for (const std::uint32_t v : vertices_of(complex, ball.witness[1].feature))
    EXPECT_EQ(f.count(v), 0u);
}

/// A piece anywhere, of an input segment, in its spindle, or between two input vertices.
std::array<Point3, 2> some_piece(const Complex& c, Random* random) {
  const auto vertex = [&] {
    return c.vertices[random->below(static_cast<std::uint32_t>(c.vertices.size()))];
  };
  const std::uint32_t kind = random->below(5);
  if (kind == 0 || c.segments.empty()) {
    const double x = uniform(random, -1, 3), y = uniform(random, -1, 1);
    return {Point3{x, y, uniform(random, -1, 1)}, vertex()};
  }
  if (kind == 1) {
    const Point3 a = vertex();
    return {a, vertex()};
  }
  const auto& s = c.segments[random->below(static_cast<std::uint32_t>(c.segments.size()))];
  const Point3 &a = c.vertices[s[0]], &b = c.vertices[s[1]];
  const double t = random->unit(), u = random->unit();
  return {kind == 2 ? a : between(a, b, t), between(a, b, u)};
}

TEST(FeatureSizes3, OfAPieceAreBelowEverySampleAndAttained) {
  constexpr int kSamples = 100;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Complex complex = random_complex3(seed, 2, 2);
    const FeatureSizes3 sizes(complex);
    Random random(seed);
    for (int k = 0; k < 6; ++k) {
      const auto [a, b] = some_piece(complex, &random);
      const int i = k % 3;
      const bool disjoint = k < 3;
      const auto at = [&](const Point3& x) {
        return disjoint ? sizes.local_by_brute_force(x, i).radius
                        : sizes.mesh_by_brute_force(x, i).radius;
      };
      const FeatureBall3 ball = disjoint ? sizes.local(a, b, i) : sizes.mesh(a, b, i);
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
    }
  }
}

TEST(FeatureSizes3, TheTreeAgreesWithTheDefinition) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Complex complex = random_complex3(seed, 0.5, 2);
    const FeatureSizes3 sizes(complex);
    Random random(seed);
    const auto agree = [&](double fast, double slow) {
      return fast == slow || std::fabs(fast - slow) <= 1e-14;
    };
    for (int k = 0; k < 4; ++k) {
      const auto [a, b] = some_piece(complex, &random);
      for (int i = 0; i < 3; ++i) {
        const FeatureBall3 lfs = sizes.local(a, b, i), mfs = sizes.mesh(a, b, i);
        ASSERT_PRED2(agree, lfs.radius, sizes.local_by_brute_force(a, b, i).radius)
            << seed << " " << k << " " << i;
        ASSERT_PRED2(agree, mfs.radius, sizes.mesh_by_brute_force(a, b, i).radius)
            << seed << " " << k << " " << i;
        expect_sound(complex, lfs, true);
        expect_sound(complex, mfs, false);
        ASSERT_EQ(sizes.local(a, i).radius, sizes.local_by_brute_force(a, i).radius);
        ASSERT_EQ(sizes.mesh(b, i).radius, sizes.mesh_by_brute_force(b, i).radius);
        const auto s = complex.segments.empty()
                           ? kNoIndex
                           : random.below(static_cast<std::uint32_t>(complex.segments.size()));
        ASSERT_PRED2(agree, sizes.clearance(a, b, s, i).radius,
                     sizes.clearance_by_brute_force(a, b, s, i).radius);
      }
    }
  }
}

TEST(FeatureSizes3, AreLipschitzAndMonotoneInTheDimension) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const FeatureSizes3 sizes(random_complex3(seed, 1));
    Random random(seed);
    for (int k = 0; k < 20; ++k) {
      const Point3 x{uniform(&random, -1, 4), uniform(&random, -1, 1), uniform(&random, -1, 1)};
      const Point3 y{uniform(&random, -1, 4), uniform(&random, -1, 1), uniform(&random, -1, 1)};
      for (int i = 0; i < 3; ++i) {
        const double at_x = sizes.local(x, i).radius, at_y = sizes.local(y, i).radius;
        if (at_x != kInfinity) {
          EXPECT_LE(std::fabs(at_x - at_y), distance(x, y) * (1 + 1e-12));
        }
        EXPECT_LE(sizes.mesh(x, i).radius, at_x);
        if (i > 0) {
          EXPECT_LE(at_x, sizes.local(x, i - 1).radius);
        }
      }
    }
  }
}

TEST(FeatureSizes3, AreThoseOfThePlaneWhereNothingLeavesIt) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Complex complex = testing::random_grid(seed, 0.3);
    const FeatureSizes plane(complex);
    complex.dimension = 3;
    const FeatureSizes3 space(complex);
    Random random(seed);
    for (int k = 0; k < 10; ++k) {
      const Point2 a{uniform(&random, -1, 7), uniform(&random, -1, 7)};
      const Point2 b{uniform(&random, -1, 7), uniform(&random, -1, 7)};
      for (int i = 0; i < 2; ++i) {
        const double l2 = plane.local(a, b, i).radius, m2 = plane.mesh(a, b, i).radius;
        const double l3 = space.local(xyz(a), xyz(b), i).radius;
        const double m3 = space.mesh(xyz(a), xyz(b), i).radius;
        EXPECT_TRUE(l2 == l3 || std::fabs(l2 - l3) <= 1e-13) << seed;
        EXPECT_TRUE(m2 == m3 || std::fabs(m2 - m3) <= 1e-13) << seed;
      }
    }
  }
}

TEST(FeatureSizes3, ScaleWithTheComplexByPowersOfTwo) {
  const Complex complex = random_complex3(11, 2);
  Complex large = complex;
  for (Point3& p : large.vertices) p = testing::scaled(0x1p40, p);
  for (Face& f : large.faces)
    for (Point3& p : f.holes) p = testing::scaled(0x1p40, p);
  const FeatureSizes3 sizes(complex), large_sizes(large);
  Random random(9);
  for (int k = 0; k < 60; ++k) {
    const auto [a, b] = some_piece(complex, &random);
    EXPECT_EQ(0x1p40 * sizes.local(a, b).radius,
              large_sizes.local(testing::scaled(0x1p40, a), testing::scaled(0x1p40, b)).radius);
  }
}

}  // namespace
}  // namespace circumball
