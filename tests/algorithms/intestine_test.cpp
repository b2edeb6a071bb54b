#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "protection/circle.h"
#include "support/acute.h"

namespace circumball {
namespace {

using testing::acute_complex;
using testing::cases;
using testing::finish;
using testing::options_of;

/// Just above sqrt 2, and larger.
double tau_of(std::uint64_t seed) {
  const double taus[] = {1.4145, 1.4143, 2.0};
  return taus[seed % 3];
}

void expect_promises_kept(const Run& run, std::uint64_t seed) {
  for (const Check& c : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(c.ok) << run.options().algorithm << ", seed " << seed << ", " << c.name << ": "
                      << c.detail;
  }
}

/// A run to the end on an acute complex, in the box every fifth time; null where it did not end.
std::unique_ptr<Run> finish_acute(const char* algorithm, std::uint64_t seed) {
  Options options = options_of(algorithm);
  options.tau = tau_of(seed / 8);
  options.limits.max_vertices = 1000000;
  if (seed % 5 == 0) options.domain = Domain::kBox;
  auto run = finish(acute_complex(seed), options);
  return run && run->status() == Status::kComplete ? std::move(run) : nullptr;
}

TEST(Theorem5_11, IntestinesEndConformAndBoundAllAngles) {
  for (std::uint64_t seed = 0; seed < cases(160); ++seed) {
    const auto run = finish_acute("intestine", seed);
    ASSERT_TRUE(run) << "seed " << seed;
    // Nothing ever needs to be refused.
    for (const StepReport& step : run->steps()) EXPECT_EQ(step.refused, 0u) << "seed " << seed;
    EXPECT_TRUE(run->unresolved().empty());
    expect_promises_kept(*run, seed);
  }
}

TEST(Theorem5_7, CollarsEndOnStarsCombsLakesAndCoasts) {
  for (std::uint64_t seed = 0; seed < cases(96); ++seed) {
    const auto run = finish_acute("collar", seed);
    ASSERT_TRUE(run) << "seed " << seed;
    for (const Unresolved& u : run->unresolved()) EXPECT_EQ(u.reason, "protected");
    expect_promises_kept(*run, seed);
  }
}

TEST(Protection, BoundsOnTheSizeHoldAtAcuteAnglesToo) {
  for (std::uint64_t seed = 3; seed < 40; seed += 8) {
    for (const char* algorithm : {"collar", "intestine"}) {
      Options options = options_of(algorithm);
      options.size = "0.02";
      const auto run = finish(acute_complex(seed), options);
      ASSERT_EQ(run->status(), Status::kComplete);
      VerifyOptions promised = promised_checks(*run);
      promised.checks = {"size"};
      promised.excused.clear();
      const auto checks = verify(run->mesh(), run->complex(), promised);
      ASSERT_EQ(checks.size(), 1u);
      EXPECT_TRUE(checks[0].ok) << algorithm << ", seed " << seed << ": " << checks[0].detail;
    }
  }
}

TEST(Protection, AreaBoundsOfRegionsHoldAtAcuteAnglesToo) {
  // A square in two parts by a zigzag with sharp corners, each with its own bound; a loose segment
  // that leans on it, a vertex alone, and a hole with a needle.
  Complex c;
  testing::add_loop(&c, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto zigzag = static_cast<std::uint32_t>(c.vertices.size());
  for (const Point2& p : {Point2{0.5, 0.5}, {3.5, 0.7}, {0.6, 0.9}, {3.4, 1.1}, {2, 2.5}}) {
    c.vertices.push_back(xyz(p));
  }
  for (const std::array<std::uint32_t, 2> s : {std::array<std::uint32_t, 2>{0, zigzag},
                                               {zigzag, zigzag + 1},
                                               {zigzag + 1, zigzag + 2},
                                               {zigzag + 2, zigzag + 3},
                                               {zigzag + 3, 2},
                                               {zigzag + 3, zigzag + 4}}) {
    c.segments.push_back(s);
  }
  c.vertices.push_back({3.8, 0.2, 0});
  testing::add_loop(&c, {{0.5, 3}, {1.5, 3.05}, {0.5, 3.1}});
  c.hole_rule = HoleRule::kSeeds;
  c.holes = {{0.6, 3.05, 0}};
  c.regions = {{{3.9, 0.1, 0}, 1, 0.02}, {{0.1, 3.9, 0}, 2, 0.002}};
  for (const char* algorithm : {"collar", "intestine"}) {
    const auto run = finish(c, options_of(algorithm));
    ASSERT_TRUE(run);
    ASSERT_EQ(run->status(), Status::kComplete);
    expect_promises_kept(*run, 0);
    const Mesh mesh = run->mesh();
    ASSERT_EQ(mesh.cell_regions.size(), mesh.cell_count());
    std::array<std::size_t, 2> cells{};
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
      const std::uint32_t* v = mesh.cell(i);
      const Point3 &p = mesh.vertices[v[0]], &q = mesh.vertices[v[1]], &r = mesh.vertices[v[2]];
      const double area = 0.5 * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
      const bool first = mesh.cell_regions[i] == 1;
      EXPECT_LE(area, (first ? 0.02 : 0.002) * (1 + 1e-12))
          << algorithm << ", label " << mesh.cell_regions[i] << " at " << p.x << " " << p.y;
      ++cells[first ? 0 : 1];
    }
    EXPECT_GT(cells[0], 300u);
    EXPECT_GT(cells[1], 3000u);
  }
}

TEST(Intestine, IsRuppertWhereNoAngleIsAcute) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Complex complex = testing::random_grid(seed, 0);
    EXPECT_EQ(fingerprint(finish(complex, options_of("intestine"))->mesh()),
              fingerprint(finish(complex, options_of("ruppert"))->mesh()));
  }
}

TEST(Intestine, ProtectsAllVerticesOnRequest) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Options options = options_of("intestine");
    options.parameters["protect"] = "all";
    const auto run =
        finish(seed % 2 ? acute_complex(seed) : testing::random_grid(seed, 0.3), options);
    ASSERT_EQ(run->status(), Status::kComplete) << "seed " << seed;
    expect_promises_kept(*run, seed);
  }
}

TEST(Intestine, KeepsItsMeshInTheHull) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Options options = options_of("intestine");
    options.domain = Domain::kHull;
    options.limits.max_vertices = 20000;
    const Complex complex = acute_complex(seed);
    const auto run = finish(complex, options);
    // Hull edges are no segments: nothing keeps vertices from coming near to them, and a run may
    // reach a limit, as Ruppert's does.
    ASSERT_NE(run->status(), Status::kRunning);
    if (run->status() == Status::kComplete) expect_promises_kept(*run, seed);
    // Nothing is outside of the box of the input, but for the rounding of hull edges.
    double high = -HUGE_VAL, highest = -HUGE_VAL;
    for (const Point3& p : complex.vertices) high = std::max(high, p.y);
    for (const Point3& p : run->mesh().vertices) highest = std::max(highest, p.y);
    EXPECT_LE(highest, high + 1e-12) << "seed " << seed;
  }
}

TEST(Circle, IsCutIntoAtMostQuarterTurnsByAtMostThreeMorePoints) {
  testing::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Point2 center{random.unit(), random.unit()};
    const double radius = 0.01 + random.unit(), at = 360 * random.unit();
    const double span = i % 7 == 0 ? 90.0 * (1 + i % 4) : 360 * random.unit();
    const auto on_circle = [&](double degrees) {
      return testing::polar(center.x, center.y, radius, degrees);
    };
    const Point2 a = on_circle(at), b = span == 360 ? a : on_circle(at + span);
    const std::vector<Point2> cuts = quarter_turns(center, radius, a, b);
    EXPECT_LE(cuts.size(), 3u);
    std::vector<Point2> all{a};
    all.insert(all.end(), cuts.begin(), cuts.end());
    all.push_back(b);
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      const double ux = all[k].x - center.x, uy = all[k].y - center.y;
      const double vx = all[k + 1].x - center.x, vy = all[k + 1].y - center.y;
      EXPECT_GE(ux * vx + uy * vy, -1e-9 * radius * radius);
      EXPECT_NEAR(std::sqrt(vx * vx + vy * vy), radius, 1e-14);
      EXPECT_GE(ux * vy - uy * vx, -1e-12);  // counter-clockwise
      const Point2 corner = tangent_corner(center, all[k], all[k + 1]);
      const double dx = corner.x - all[k].x, dy = corner.y - all[k].y;
      EXPECT_NEAR(dx * ux + dy * uy, 0, 1e-9);  // on the tangent
    }
  }
}

}  // namespace
}  // namespace circumball
