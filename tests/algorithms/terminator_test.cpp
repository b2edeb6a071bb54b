#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "complex/shells.h"
#include "support/acute_complexes.h"
#include "support/complexes.h"
#include "support/needles.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::Random;

std::size_t expect_promises(const Complex& complex, Options options, const std::string& what) {
  options.limits.max_vertices = 200000;
  const auto run = finish(complex, options);
  EXPECT_TRUE(run) << what;
  if (!run) return 0;
  EXPECT_EQ(run->status(), Status::kComplete) << what;
  for (const Unresolved& u : run->unresolved()) EXPECT_EQ(u.reason, "seditious") << what;
  for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
    EXPECT_TRUE(c.ok) << what << ", " << c.name << ": " << c.detail;
  }
  return run->mesh().vertices.size();
}

Options terminator(double degrees, bool off_centers) {
  Options options = options_of("terminator");
  options.min_angle_degrees = degrees;
  if (off_centers) options.parameters["steiner"] = "off-center";
  return options;
}

TEST(ShellRadius, IsThePowerOfTwoNearestToHalf) {
  EXPECT_EQ(shell_radius(2), 1);
  EXPECT_EQ(shell_radius(1.5), 0.5);  // 0.5 and 1 are as near: the smaller
  EXPECT_EQ(shell_radius(1.51), 1);
  EXPECT_EQ(shell_radius(0.1), 0.0625);
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const double length = 1e-3 + 10 * random.unit(), r = shell_radius(length);
    EXPECT_GE(r * (3 + 1e-15), length);
    EXPECT_LE(r * 1.5, length * (1 + 1e-15));
    EXPECT_EQ(shell_radius(2 * length), 2 * r);
  }
}

TEST(Terminator, EndsOnFansAndLeavesSeditiousTrianglesAlone) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    Random random(seed);
    const double angle = seed % 10 == 0 ? 0.01 : seed % 10 == 1 ? 0.3 : seed % 2 ? 3 : 20;
    const Complex c = testing::fan(&random, 2 + random.below(24), angle);
    const double asked = seed % 3 == 0 ? 26.45 : seed % 3 == 1 ? 20.7 : 15;
    expect_promises(c, terminator(asked, seed % 4 == 0),
                    "seed " + std::to_string(seed) + ", angle " + std::to_string(angle));
  }
}

TEST(Terminator, EndsOnStarsAndCombsWithNeedles) {
  for (const double angle : {40.0, 10.0, 1.0, 0.1, 0.01}) {
    for (const bool off_centers : {false, true}) {
      expect_promises(testing::star(5, angle), terminator(20.7, off_centers),
                      "star of " + std::to_string(angle));
      expect_promises(testing::star(12, std::min(angle, 29.0)), terminator(26, off_centers),
                      "star of " + std::to_string(angle));
      expect_promises(testing::comb(6, angle), terminator(20.7, off_centers),
                      "comb of " + std::to_string(angle));
    }
  }
}

/// All edges of the Delaunay triangulation of random points as segments: acute angles at both ends
/// of nearly every segment, and shells about all vertices.
Complex all_edges(Random* random, std::uint32_t count, double flatten) {
  Complex points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.vertices.push_back({random->unit(), flatten * random->unit(), 0});
  }
  const Mesh mesh = finish(points, options_of("delaunay"))->mesh();
  std::set<std::array<std::uint32_t, 2>> edges;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    for (unsigned j = 0; j < 3; ++j) {
      edges.insert({std::min(v[j], v[(j + 1) % 3]), std::max(v[j], v[(j + 1) % 3])});
    }
  }
  points.segments.assign(edges.begin(), edges.end());
  return points;
}

TEST(Terminator, EndsOnRandomComplexesOfAllKinds) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const double least = seed % 25 == 0 ? 0.01 : seed % 5 == 1 ? 0.3 : seed % 2 ? 3 : 20;
    expect_promises(testing::random_acute_complex(seed, least),
                    terminator(seed % 3 ? 20.7 : 26.45, seed % 4 == 0),
                    "seed " + std::to_string(seed));
  }
}

TEST(Terminator, EndsWhereSegmentsHaveShellsAtBothEnds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const double flatten = seed % 3 == 0 ? 0.01 : seed % 3 == 1 ? 0.2 : 1;
    const double asked = seed % 2 ? 26.45 : 20.7;
    expect_promises(all_edges(&random, 5 + random.below(25), flatten),
                    terminator(asked, seed % 4 < 2), "seed " + std::to_string(seed));
  }
}

TEST(Terminator, TellsShellsFarFromTheOrigin) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    Complex c = testing::fan(&random, 6, 8);
    const std::size_t here = expect_promises(c, terminator(20.7, false), "at the origin");
    for (Point3& p : c.vertices) p = {1e6 + 1e-3 * p.x, -3e6 + 1e-3 * p.y, 0};
    const std::size_t there = expect_promises(c, terminator(20.7, false), "far away");
    EXPECT_LT(there, 2 * here + 20);
  }
}

TEST(Terminator, IsRuppertWhereNoAngleIsAcute) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Complex complex = testing::random_grid(seed, 0);
    EXPECT_EQ(fingerprint(finish(complex, options_of("terminator"))->mesh()),
              fingerprint(finish(complex, options_of("ruppert"))->mesh()));
  }
}

TEST(Terminator, ScalingByAPowerOfTwoScalesTheMesh) {
  Random random(11);
  Complex c = testing::fan(&random, 9, 12);
  const Mesh mesh = finish(c, options_of("terminator"))->mesh();
  for (Point3& p : c.vertices) p = {8 * p.x, 8 * p.y, 0};
  const Mesh scaled = finish(c, options_of("terminator"))->mesh();
  ASSERT_EQ(mesh.vertices.size(), scaled.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_EQ(8 * mesh.vertices[i].x, scaled.vertices[i].x);
    EXPECT_EQ(8 * mesh.vertices[i].y, scaled.vertices[i].y);
  }
}

TEST(Terminator, SizeBoundsHoldForSeditiousTrianglesToo) {
  Random random(5);
  Options options = terminator(20.7, false);
  options.size = "0.05";
  expect_promises(testing::fan(&random, 7, 10), options, "size");
}

TEST(SeditiousCheck, TellsATriangleWithoutASeditiousEdge) {
  Random random(5);
  const Complex c = testing::fan(&random, 7, 10);
  const auto run = finish(c, options_of("delaunay"));
  VerifyOptions options;
  options.tau = 1.4145;
  options.domain = "hull";
  options.checks = {"seditious"};
  const auto checks = verify(run->mesh(), c, options);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_FALSE(checks[0].ok);
  EXPECT_EQ(checks[0].worst.size(), 3u);
}

}  // namespace
}  // namespace circumball
