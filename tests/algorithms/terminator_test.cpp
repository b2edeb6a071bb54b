#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "complex/shells.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::Random;

Point3 polar(double radius, double degrees) {
  const double radians = degrees * (elementary::kPi / 180);
  return {radius * elementary::cos(radians), radius * elementary::sin(radians), 0};
}

/// Segments of random lengths from one vertex, neighbors `angle` to twice that apart; in a square.
Complex fan(Random* random, std::uint32_t count, double angle) {
  Complex c;
  c.vertices.push_back({0, 0, 0});
  double at = 360 * random->unit(), turned = 0;
  for (std::uint32_t i = 0; i < count && turned < 330; ++i) {
    c.segments.push_back({0, static_cast<std::uint32_t>(c.vertices.size())});
    c.vertices.push_back(polar(0.2 + 0.8 * random->unit(), at));
    const double step = angle * (1 + random->unit());
    at += step;
    turned += step;
  }
  testing::add_square(&c, -2, -2, 4);
  return c;
}

/// A star-shaped polygon: `points` needle tips, each of an angle of `angle` degrees.
Complex star(std::uint32_t points, double angle) {
  Complex c;
  const double half = 180.0 / points;
  // The corners between the tips are where rays from the tips at half the angle meet.
  const double a = 0.5 * angle * (elementary::kPi / 180), b = half * (elementary::kPi / 180);
  const double inner = elementary::sin(a) / elementary::sin(a + b);
  for (std::uint32_t i = 0; i < points; ++i) {
    c.vertices.push_back(polar(1, 2 * half * i));
    c.vertices.push_back(polar(inner, 2 * half * i + half));
  }
  for (std::uint32_t i = 0; i < 2 * points; ++i) c.segments.push_back({i, (i + 1) % (2 * points)});
  return c;
}

/// Needle teeth of the given angle side by side on a bar.
Complex comb(std::uint32_t teeth, double angle) {
  Complex c;
  const double width = 2 * elementary::sin(0.5 * angle * (elementary::kPi / 180));
  c.vertices = {{0, -0.3, 0}, {1.0 * teeth, -0.3, 0}};
  for (std::uint32_t i = teeth; i-- > 0;) {
    c.vertices.push_back({i + 0.5 + 0.5 * width, 0, 0});
    c.vertices.push_back({i + 0.5, 1, 0});
    c.vertices.push_back({i + 0.5 - 0.5 * width, 0, 0});
  }
  const auto n = static_cast<std::uint32_t>(c.vertices.size());
  for (std::uint32_t i = 0; i < n; ++i) c.segments.push_back({i, (i + 1) % n});
  return c;
}

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
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const double angle = seed % 10 == 0 ? 0.01 : seed % 10 == 1 ? 0.3 : seed % 2 ? 3 : 20;
    const Complex c = fan(&random, 2 + random.below(24), angle);
    const double asked = seed % 3 == 0 ? 26.45 : seed % 3 == 1 ? 20.7 : 15;
    expect_promises(c, terminator(asked, seed % 4 == 0),
                    "seed " + std::to_string(seed) + ", angle " + std::to_string(angle));
  }
}

TEST(Terminator, EndsOnStarsAndCombsWithNeedles) {
  for (const double angle : {40.0, 10.0, 1.0, 0.1, 0.01}) {
    for (const bool off_centers : {false, true}) {
      expect_promises(star(5, angle), terminator(20.7, off_centers),
                      "star of " + std::to_string(angle));
      expect_promises(star(12, std::min(angle, 29.0)), terminator(26, off_centers),
                      "star of " + std::to_string(angle));
      expect_promises(comb(6, angle), terminator(20.7, off_centers),
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
    Complex c = fan(&random, 6, 8);
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
  Complex c = fan(&random, 9, 12);
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
  expect_promises(fan(&random, 7, 10), options, "size");
}

TEST(SeditiousCheck, TellsATriangleWithoutASeditiousEdge) {
  Random random(5);
  const Complex c = fan(&random, 7, 10);
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
