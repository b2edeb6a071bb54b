#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "circumball/feature_size.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "predicates/elementary.h"
#include "quality/insertion_radius.h"
#include "support/acute_complexes.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::Random;

Check grading(const Run& run) {
  VerifyOptions options = promised_checks(run);
  options.checks = {"grading"};
  const std::vector<Check> checks = verify(run.mesh(), run.complex(), options);
  EXPECT_EQ(checks.size(), 1u);
  return checks.at(0);
}

TEST(Definition2_1_5, InsertionRadiusIsTheDistanceToTheNearestOfLowerNumber) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    std::vector<Point2> points;
    const std::uint32_t n = 1 + random.below(300);
    for (std::uint32_t k = 0; k < n; ++k) {
      const double scale = random.below(3) ? 1 : 1e-6;              // clusters
      const double x = seed % 3 ? random.unit() : random.below(8);  // lattices with duplicates
      points.push_back({scale * x, scale * random.below(8)});
    }
    const std::vector<double> radii = insertion_radii(points);
    ASSERT_EQ(radii.size(), n);
    for (std::uint32_t q = 0; q < n; ++q) {
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t p = 0; p < q; ++p) {
        const double dx = points[p].x - points[q].x, dy = points[p].y - points[q].y;
        least = std::min(least, std::sqrt(dx * dx + dy * dy));
      }
      EXPECT_EQ(radii[q], least) << seed << " " << q;
    }
  }
  EXPECT_TRUE(insertion_radii({}).empty());
}

TEST(Definition2_1_5, InsertionRadiiAreThoseOfTheTrace) {
  for (const char* algorithm : {"ruppert", "collar"}) {
    Trace trace;
    const auto run = finish(testing::random_acute_complex(7, 30), options_of(algorithm), &trace);
    const Mesh mesh = run->mesh();
    std::vector<Point2> points;
    for (const Point3& p : mesh.vertices) points.push_back(xy(p));
    const std::vector<double> radii = insertion_radii(points);
    std::vector<double> recorded(points.size(), 0);
    for (const Event& e : trace.events)
      if (e.kind == EventKind::kInserted && e.subject < points.size())
        recorded[e.subject] = e.value;
    for (std::size_t q = mesh.input_vertices + mesh.box_vertices; q < points.size(); ++q)
      EXPECT_NEAR(recorded[q], radii[q], 1e-14) << algorithm << " " << q;
  }
}

/// The constants of the proof, for input angles of at least 90 degrees and tau > sqrt 2.
TEST(Theorem2_2, ConstantOfGradingIsAtMostThatOfTheProof) {
  const double tau = 2;
  const double c2 = (1 + tau) / (tau - std::sqrt(2.0)), c1 = std::sqrt(2.0) * c2 + 1;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Options options = options_of("ruppert");
    options.tau = tau;
    options.domain = seed % 2 ? Domain::kBox : Domain::kDefault;
    const auto run = finish(testing::random_grid(seed, 0), options);
    const Check check = grading(*run);
    EXPECT_TRUE(check.ok) << check.detail;
    EXPECT_FALSE(check.bound);
    if (check.observed) {
      EXPECT_LE(*check.observed, c1) << check.detail;
    }
  }
}

/// What is outside of a closed domain is in no cell, yet it is in the triangulation.
TEST(Grading, FeaturesOutsideTheDomainCount) {
  Complex c = testing::unit_square();
  c.vertices.push_back({0.51, -1e-3, 0});
  c.vertices.push_back({0.2, -0.01, 0});
  c.vertices.push_back({0.5, -0.01, 0});
  c.segments.push_back({5, 6});
  for (const char* algorithm : {"ruppert", "feature-size"}) {
    Options options = options_of(algorithm);
    options.domain = Domain::kClosed;
    const auto run = finish(c, options);
    for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run)))
      EXPECT_TRUE(check.ok) << algorithm << ", " << check.name << ": " << check.detail;
    const Check check = grading(*run);
    ASSERT_TRUE(check.observed);
    EXPECT_LE(*check.observed, 5) << algorithm;
  }
}

TEST(Theorem5_6, ConstantOfGradingIsReportedWithItsVertex) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto run = finish(testing::random_acute_complex(seed, 1), options_of("collar"));
    const Mesh mesh = run->mesh();
    const Check check = grading(*run);
    ASSERT_TRUE(check.ok && check.observed) << check.detail;
    ASSERT_EQ(check.worst.size(), 1u);
    const std::uint32_t q = check.worst[0];
    EXPECT_GE(q, mesh.input_vertices + mesh.box_vertices);
    double r = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < q; ++p) {
      const double dx = mesh.vertices[p].x - mesh.vertices[q].x,
                   dy = mesh.vertices[p].y - mesh.vertices[q].y;
      r = std::min(r, std::sqrt(dx * dx + dy * dy));
    }
    const FeatureSizes sizes(run->complex());
    EXPECT_DOUBLE_EQ(*check.observed, sizes.local_by_brute_force(xy(mesh.vertices[q])).radius / r);
    // Small angles decide: collar vertices at distance d >= 0.225 lfs(q0) from q0, 2 d sin(alpha/2)
    // apart, where lfs is at most lfs(q0) + d. No other vertex was met with more.
    const double alpha = smallest_angle_degrees(run->complex());
    if (alpha < 30) {
      const double sine = elementary::sin(alpha * (elementary::kPi / 180));
      EXPECT_LE(*check.observed * sine, 1 + 1 / 0.225) << seed;
    }
  }
}

TEST(Grading, ABoundOnTheSizeIsPartOfIt) {
  for (const char* size : {"0.3", "0.03"}) {
    Options options = options_of("ruppert");
    options.size = size;
    const Check check = grading(*finish(testing::unit_square(), options));
    EXPECT_LE(*check.observed, 2) << check.detail;
    EXPECT_NE(check.detail.find(size), std::string::npos) << check.detail;
  }
}

TEST(Grading, SaysWhereItCannotBeMeasured) {
  const auto run = finish(testing::unit_square(), options_of("ruppert"));
  EXPECT_EQ(grading(*run).detail, "there is no Steiner vertex");
  const auto fine = [] {
    Options options = options_of("ruppert");
    options.size = "0.2";
    return finish(testing::unit_square(), options);
  }();
  Mesh mesh = fine->mesh();
  VerifyOptions options = promised_checks(*fine);
  options.checks = {"grading"};
  EXPECT_TRUE(verify(mesh, fine->complex(), options)[0].ok);
  mesh.vertices[9] = mesh.vertices[7];  // r_q = 0
  EXPECT_FALSE(verify(mesh, fine->complex(), options)[0].ok);
  EXPECT_EQ(verify(mesh, fine->complex(), options)[0].worst, std::vector<std::uint32_t>{9});
  mesh.vertices[9].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(verify(mesh, fine->complex(), options)[0].ok);
}

}  // namespace
}  // namespace circumball
