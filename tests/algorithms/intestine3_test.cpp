#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "circumball/feature_size.h"
#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "predicates/elementary.h"
#include "support/acute.h"
#include "support/examples.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::example;
using testing::finish;
using testing::Random;
using testing::random_complex3;
using testing::Rotation;

const char* const kBoth[] = {"intestine-structured", "intestine"};

Options intestine(const std::string& algorithm) {
  Options options = testing::options_of(algorithm);
  options.limits.max_vertices = 60000;
  return options;
}

/// It ended, nothing was refused (so that no circumcenter lay in the ball of a protected simplex,
/// or in a tube), and every check that it promises holds.
void expect_kept_promises(const Run& run, const std::string& what) {
  ASSERT_EQ(run.status(), Status::kComplete) << what;
  EXPECT_TRUE(run.unresolved(10).empty()) << what;
  for (const StepReport& step : run.steps()) EXPECT_EQ(step.refused, 0u) << what << step.name;
  for (const Check& check : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(check.ok) << what << ", " << check.name << ": " << check.detail;
  }
}

/// Books, fans, spikes, plates and more. Theorem 6.14 for the structured one, 6.15 for the other.
TEST(IntestinesInSpace, EndConformAndLeaveNoBadTetrahedronOutsideOnRandomAcuteComplexes) {
  for (std::uint64_t seed = 1; seed <= testing::cases(16); ++seed) {
    const double least[] = {3, 8, 15, 30};
    const Complex complex = random_complex3(seed, least[seed % 4], 1);
    for (const char* algorithm : kBoth) {
      Options options = intestine(algorithm);
      options.domain = Domain::kBox;
      options.parameters["protect"] = seed % 5 ? "acute" : "all";
      const auto run = finish(complex, options);
      ASSERT_TRUE(run) << seed;
      if (run->limit() == Reason::kLimitVertices) continue;
      expect_kept_promises(*run, algorithm + (" " + std::to_string(seed)));
    }
  }
}

TEST(IntestinesInSpace, AreRuppertsAlgorithmWhereNothingIsAcute) {
  Random random(7);
  const testing::Solid solid = testing::solids()[0];
  const Rotation turn(&random);
  testing::SolidBuilder builder({1, &turn, {0, 0, 0}});
  solid.build(&builder);
  for (const char* algorithm : kBoth) {
    Options options = intestine(algorithm);
    options.tau = 2.2;
    const auto protected_run = finish(builder.complex(), options);
    options.algorithm = "ruppert";
    const auto run = finish(builder.complex(), options);
    ASSERT_TRUE(run && protected_run);
    EXPECT_EQ(fingerprint(run->mesh()), fingerprint(protected_run->mesh()));
  }
}

TEST(IntestinesInSpace, MeshThePyramidAndSchoenhardtsPrismClosed) {
  for (const char* name : {"pyramid.json", "schoenhardt.json"}) {
    for (const char* algorithm : kBoth) {
      Options options = intestine(algorithm);
      options.parameters["protect"] = "all";
      const auto run = finish(example(name), options);
      ASSERT_TRUE(run) << name;
      EXPECT_EQ(run->domain(), Domain::kClosed) << name;
      expect_kept_promises(*run, name);
    }
  }
}

TEST(IntestinesInSpace, ConformWhereverTheComplexStands) {
  const Complex pyramid = example("pyramid.json");
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    const Rotation turn(&random);
    const double scale = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 1e-6 : 1e6;
    const double away = seed == 3 ? 1e5 : 0;
    Complex complex = pyramid;
    for (Point3& p : complex.vertices) {
      const Point3 q = turn({scale * p.x, scale * p.y, scale * p.z});
      p = {q.x + away, q.y - away, q.z + 0.3 * away};
    }
    const auto run = finish(complex, intestine(kBoth[seed % 2]));
    ASSERT_TRUE(run) << seed;
    expect_kept_promises(*run, "placement " + std::to_string(seed));
  }
}

double distance(const Point3& a, const Point3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) +
                   (a.z - b.z) * (a.z - b.z));
}

/// Distance from p to the segment ab.
double distance(const Point3& p, const Point3& a, const Point3& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
  double t =
      ((p.x - a.x) * dx + (p.y - a.y) * dy + (p.z - a.z) * dz) / (dx * dx + dy * dy + dz * dz);
  t = std::min(1.0, std::max(0.0, t));
  return distance(p, {a.x + t * dx, a.y + t * dy, a.z + t * dz});
}

/// What protects a complex when step 2c ends.
struct Surfaces {
  std::map<std::uint32_t, Point3> vertices;
  std::map<std::uint32_t, std::set<std::uint32_t>> spheres, tubes;  // by center, by segment
  std::vector<ProtectingElement> elements;
  std::unique_ptr<Run> run;

  Surfaces(const Complex& complex, const Options& options) {
    Trace trace;
    trace.dimension = 3;
    run = finish(complex, options, &trace);
    if (!run) return;
    Replay replay(trace);
    for (const Event& e : trace.events) {
      replay.forward();
      if (e.kind == EventKind::kStepEnded && run->step_names()[e.step] == "2c") break;
    }
    elements = replay.protection();
    vertices = replay.vertices();
    for (const ProtectingElement& p : elements) {
      if (p.kind == ProtectingKind::kSpherePatch) spheres[p.carrier].insert({p.a, p.b, p.c});
      if (p.kind == ProtectingKind::kTubePatch) tubes[p.carrier].insert({p.a, p.b, p.c});
    }
  }
};

TEST(SpheresAndTubes, KeepApartAndHaveTheirVerticesWhereTheyShould) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const Complex complex = random_complex3(seed, 15, 1);
    Options options = intestine("intestine-structured");
    options.parameters["protect"] = "all";
    options.domain = Domain::kBox;
    options.limits.max_vertices = 3000;
    const Surfaces s(complex, options);
    ASSERT_TRUE(s.run);
    const auto at = [&](std::uint32_t v) { return s.vertices.at(v); };
    std::map<std::uint32_t, double> radius;
    for (const auto& [center, on] : s.spheres) {
      radius[center] = distance(at(center), at(*on.begin()));
      for (const std::uint32_t v : on) {
        EXPECT_NEAR(distance(at(center), at(v)), radius[center], 1e-12) << seed;
      }
    }
    for (const auto& [p, d] : radius) {
      for (const auto& [q, e] : radius) {
        if (p >= q) continue;
        EXPECT_LT(d + e, 0.9 * distance(at(p), at(q))) << seed;
      }
    }
    // No vertex of a tube is inside of a sphere, or as near to another segment as to its own.
    for (const auto& [segment, on] : s.tubes) {
      const auto& ends = s.run->complex().segments[segment];
      for (const std::uint32_t v : on) {
        for (const auto& [q, d] : radius) EXPECT_GE(distance(at(q), at(v)), (1 - 1e-9) * d) << seed;
        const double own = distance(at(v), at(ends[0]), at(ends[1]));
        for (const auto& [other, others] : s.tubes) {
          if (other == segment) continue;
          const auto& e = s.run->complex().segments[other];
          EXPECT_GT(distance(at(v), at(e[0]), at(e[1])), own) << seed;
        }
      }
    }
    // Rings: their vertices equally far from the segment, at most 60 degrees apart.
    for (const ProtectingElement& p : s.elements) {
      if (p.kind != ProtectingKind::kRingArc) continue;
      const auto& ends = s.run->complex().segments[p.carrier];
      const double h = distance(at(p.a), at(ends[0]), at(ends[1]));
      EXPECT_NEAR(distance(at(p.b), at(ends[0]), at(ends[1])), h, 1e-12);
      EXPECT_LE(distance(at(p.a), at(p.b)), (1 + 1e-9) * h);
    }
  }
}

/// Sharp enough that 6.3 leaves faces torn in the Delaunay tetrahedralization of its tubes.
TEST(MatchingRegion, ConformsWhereTheDelaunayTetrahedralizationDoesNot) {
  testing::Builder3 b;
  const std::uint32_t p = b.vertex({0, 0, -1}), q = b.vertex({0, 0, 1});
  for (const double degrees : {0.0, 3.0}) {
    const double c = elementary::cos(degrees * elementary::kPi / 180),
                 s = elementary::sin(degrees * elementary::kPi / 180);
    b.face({p, b.vertex({c, s, -1}), b.vertex({c, s, 1}), q});
  }
  Options options = intestine("intestine");
  options.domain = Domain::kBox;
  const auto run = finish(b.complex(), options);
  ASSERT_TRUE(run);
  expect_kept_promises(*run, "two faces");
  VerifyOptions checks = promised_checks(*run);
  checks.checks = {"delaunay"};
  const auto delaunay = verify(run->mesh(), run->complex(), checks);
  ASSERT_EQ(delaunay.size(), 1u);
  EXPECT_FALSE(delaunay[0].ok);
}

TEST(IntestinesInSpace, ReplayToTheMeshInBothDirections) {
  const Complex complex = example("pyramid.json");
  for (const char* algorithm : kBoth) {
    for (const Domain domain : {Domain::kBox, Domain::kClosed}) {
      Trace trace;
      trace.dimension = 3;
      Options options = intestine(algorithm);
      options.parameters["protect"] = "all";
      options.domain = domain;
      const auto run = finish(complex, options, &trace);
      ASSERT_TRUE(run);
      Replay replay(trace);
      replay.seek(trace.events.size());
      std::vector<std::vector<std::uint32_t>> replayed, meshed;
      const auto cells = replay.cells();
      for (std::size_t i = 0; i < cells.size(); i += 5) {
        if (cells[i + 4] == 2) continue;  // outside
        replayed.emplace_back(cells.begin() + static_cast<std::ptrdiff_t>(i),
                              cells.begin() + static_cast<std::ptrdiff_t>(i + 4));
        std::sort(replayed.back().begin(), replayed.back().end());
      }
      const Mesh mesh = run->mesh();
      for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        meshed.emplace_back(mesh.cell(i), mesh.cell(i) + 4);
        std::sort(meshed.back().begin(), meshed.back().end());
      }
      std::sort(replayed.begin(), replayed.end());
      std::sort(meshed.begin(), meshed.end());
      EXPECT_EQ(replayed, meshed) << algorithm;
      replay.seek(0);
      EXPECT_TRUE(replay.cells().empty());
      EXPECT_TRUE(replay.protection().empty());
    }
  }
}

/// Faces in and beside a closed domain: what is listed of them is of its cells, on either side of
/// its boundary.
TEST(MatchingRegion, ListsNoFacetsOutsideOfAClosedDomain) {
  for (const char* algorithm : kBoth) {
    const auto run = finish(example("dangling.json"), intestine(algorithm));
    ASSERT_TRUE(run);
    ASSERT_EQ(run->domain(), Domain::kClosed);
    expect_kept_promises(*run, algorithm);
    const Mesh mesh = run->mesh();
    std::set<std::set<std::uint32_t>> facets;
    for (std::size_t c = 0; c < mesh.cells.size(); c += 4) {
      for (std::size_t skip = 0; skip < 4; ++skip) {
        std::set<std::uint32_t> facet(mesh.cells.begin() + static_cast<std::ptrdiff_t>(c),
                                      mesh.cells.begin() + static_cast<std::ptrdiff_t>(c) + 4);
        facet.erase(mesh.cells[c + skip]);
        facets.insert(facet);
      }
    }
    for (const MeshFacet& f : mesh.facets) {
      EXPECT_TRUE(facets.count({f.a, f.b, f.c})) << algorithm << ", face " << f.face;
    }
  }
}

/// Two tetrahedra at a common edge: of the four wedges about it two are inside.
TEST(MatchingRegion, KnowsInsideFromOutsideAboutAnEdgeOfSeveralSolids) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const Rotation turn(&random);
    testing::Builder3 b;
    std::vector<std::uint32_t> v;
    for (const Point3& p : {Point3{0, 0, 0}, Point3{0, 0, 1}, Point3{1, 0, 0.5},
                            Point3{1, 0.3, 0.4}, Point3{-1, 0, 0.5}, Point3{-1, 0.25, 0.4}}) {
      v.push_back(b.vertex(turn(p)));
    }
    for (const std::array<std::size_t, 3>& f : {std::array<std::size_t, 3>{0, 1, 2},
                                                {0, 1, 3},
                                                {0, 2, 3},
                                                {1, 2, 3},
                                                {0, 1, 4},
                                                {0, 1, 5},
                                                {0, 4, 5},
                                                {1, 4, 5}}) {
      b.face({v[f[0]], v[f[1]], v[f[2]]});
    }
    Options options = intestine("intestine");
    options.domain = Domain::kClosed;
    const auto run = finish(b.complex(), options);
    ASSERT_TRUE(run);
    expect_kept_promises(*run, "two tetrahedra " + std::to_string(seed));
  }
}

/// Conjecture 6.16, as far as it can be observed: lfs(q) <= C r_q for every vertex inserted. Small
/// angles make C large: with the smallest one alpha, C sin(alpha) of vertices of step 3 is bounded
/// here, and C sin^2(alpha) of those before, where angles between segments and faces, and between
/// faces, come together (Lemma 6.6).
TEST(Conjecture6_16, InsertionRadiiAreNotShortAgainstFeatureSizesOnRandomComplexes) {
  std::array<std::array<double, 3>, 2> protect{}, refine{};  // C, C sin(alpha), C sin^2(alpha)
  std::size_t runs = 0, vertices = 0;
  for (std::uint64_t seed = 1; seed <= testing::cases(6); ++seed) {
    const double least[] = {5, 10, 20, 40};
    const Complex complex = random_complex3(1000 + seed, least[seed % 4], 1);
    for (std::size_t k = 0; k < 2; ++k) {
      Trace trace;
      trace.dimension = 3;
      Options options = intestine(kBoth[k]);
      options.domain = Domain::kBox;
      options.limits.max_vertices = 30000;
      const auto run = finish(complex, options, &trace);
      ASSERT_TRUE(run);
      if (run->status() != Status::kComplete) continue;
      const double alpha =
          std::min(90.0, smallest_angle_degrees(run->complex())) * elementary::kPi / 180;
      const double sine = elementary::sin(alpha);
      const FeatureSizes3 sizes(run->complex());
      ++runs;
      for (const Event& e : trace.events) {
        if (e.kind != EventKind::kInserted || e.step == 0 || !(e.value > 0)) continue;
        ++vertices;
        const double c = sizes.local({e.at[0], e.at[1], e.at[2]}).radius / e.value;
        auto& worst = (run->step_names()[e.step][0] == '2' ? protect : refine)[k];
        const double scaled[3] = {c, c * sine, c * sine * sine};
        for (std::size_t i = 0; i < 3; ++i) worst[i] = std::max(worst[i], scaled[i]);
      }
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(protect[k][2], 12) << kBoth[k];
    EXPECT_LT(refine[k][1], 40) << kBoth[k];
    std::printf("  %s: C, C sin, C sin^2 up to %.3f, %.3f, %.3f in step 2; %.3f, %.3f, %.3f in 3\n",
                kBoth[k], protect[k][0], protect[k][1], protect[k][2], refine[k][0], refine[k][1],
                refine[k][2]);
  }
  std::printf("  %zu runs, %zu vertices\n", runs, vertices);
}

}  // namespace
}  // namespace circumball
