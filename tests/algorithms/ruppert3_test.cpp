#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::finish;
using testing::Placement;
using testing::Random;
using testing::Rotation;
using testing::Solid;
using testing::SolidBuilder;

Complex complex_of(const Solid& solid, const Placement& placement) {
  SolidBuilder builder(placement);
  solid.build(&builder);
  return builder.complex();
}

Options ruppert(double size) {
  Options options = testing::options_of("ruppert");
  options.limits.max_vertices = 20000;
  if (size > 0) options.size = std::to_string(size);
  return options;
}

double volume_of(const Mesh& mesh, std::size_t cell) {
  const Point3 &o = mesh.vertices[mesh.cell(cell)[0]], &a = mesh.vertices[mesh.cell(cell)[1]],
               &b = mesh.vertices[mesh.cell(cell)[2]], &c = mesh.vertices[mesh.cell(cell)[3]];
  const double ax = a.x - o.x, ay = a.y - o.y, az = a.z - o.z;
  const double bx = b.x - o.x, by = b.y - o.y, bz = b.z - o.z;
  const double cx = c.x - o.x, cy = c.y - o.y, cz = c.z - o.z;
  return std::fabs(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) /
         6;
}

double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) sum += volume_of(mesh, i);
  return sum;
}

/// Complete, nothing left over, all that is promised holds.
void expect_kept_promises(const Run& run, const std::string& what) {
  EXPECT_EQ(run.status(), Status::kComplete) << what;
  EXPECT_TRUE(run.unresolved().empty()) << what;
  for (const Check& check : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(check.ok) << what << ", " << check.name << ": " << check.detail;
  }
}

class RuppertInSpace : public ::testing::TestWithParam<Solid> {};

/// Vertices of a turned or moved solid are not in its faces exactly: who belongs to a face, and
/// what tiles it, must not depend on that.
TEST_P(RuppertInSpace, KeepsItsPromisesOnSolidsAnywhereInSpace) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Random random(seed + 1);
    const Rotation turn(&random);
    const std::array<Placement, 5> placements = {
        Placement{1, nullptr, {0, 0, 0}}, Placement{1, &turn, {0.3, -7.1, 2.2}},
        Placement{1e-6, &turn, {0, 0, 0}}, Placement{1e6, &turn, {0, 0, 0}},
        Placement{1, &turn, {1e6, 3e5, -1e5}}};
    for (std::size_t k = seed == 0 ? 0 : 1; k < placements.size(); ++k) {
      const Placement& placement = placements[k];
      const Complex complex = complex_of(GetParam(), placement);
      const double size = seed % 2 == 0 ? 0 : 0.4;
      Options options = ruppert(0);
      if (size > 0) options.size = std::to_string(size * placement.scale);
      const auto run = finish(complex, options);
      const std::string what =
          GetParam().name + ", seed " + std::to_string(seed) + ", placement " + std::to_string(k);
      ASSERT_TRUE(run) << what;
      EXPECT_EQ(run->domain(), Domain::kClosed) << what;
      expect_kept_promises(*run, what);
      const double volume = GetParam().volume * std::pow(placement.scale, 3);
      EXPECT_NEAR(volume_of(run->mesh()), volume, 1e-8 * volume) << what;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, RuppertInSpace, ::testing::ValuesIn(testing::solids()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(RuppertInSpaceTest, CellsHaveTheLabelsOfTheirRegionsAndObeyTheirBounds) {
  Random random(5);
  const Rotation turn(&random);
  SolidBuilder b({1, &turn, {0, 0, 0}});
  b.lattice(3, 1, 1);
  b.regions.push_back({b.placed({0.5, 0.5, 0.5}), 7, 0.01});
  b.regions.push_back({b.placed({1.5, 0.5, 0.5}), 9, 0.002});
  const auto run = finish(b.complex(), ruppert(0));
  ASSERT_TRUE(run);
  expect_kept_promises(*run, "regions");
  const Mesh mesh = run->mesh();
  ASSERT_EQ(mesh.cell_regions.size(), mesh.cell_count());
  double volume[3] = {0, 0, 0}, largest[3] = {0, 0, 0};
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const int k = mesh.cell_regions[i] == 7 ? 0 : mesh.cell_regions[i] == 9 ? 1 : 2;
    volume[k] += volume_of(mesh, i);
    largest[k] = std::max(largest[k], volume_of(mesh, i));
  }
  for (const double v : volume) EXPECT_NEAR(v, 1, 1e-9);
  EXPECT_LE(largest[0], 0.01);
  EXPECT_LE(largest[1], 0.002);
  EXPECT_GT(largest[2], 0.01);
}

TEST(RuppertInSpaceTest, HolesByParityAreEverySecondShell) {
  SolidBuilder b({1, nullptr, {0, 0, 0}});
  b.box({0, 0, 0}, {7, 7, 7});
  b.box({1, 1, 1}, {6, 6, 6});
  b.box({2, 2, 2}, {5, 5, 5});
  const auto run = finish(b.complex(), ruppert(0));
  ASSERT_TRUE(run);
  expect_kept_promises(*run, "shells");
  EXPECT_NEAR(volume_of(run->mesh()), 343 - 125 + 27, 1e-9);
}

/// Its two apexes lie on the smallest balls of the square's triangles: the edge between them is one
/// way to settle the tie.
TEST(RuppertInSpaceTest, FacesThatAnEdgeCrossesByATieAreRecovered) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    const Rotation turn(&random);
    SolidBuilder b({1, seed % 2 ? &turn : nullptr, {0, 0, 0}});
    const bool first = seed & 2;
    std::uint32_t ring[4];
    if (first) b.vertex({0, 0, 1}), b.vertex({0, 0, -1});
    for (int k = 0; k < 4; ++k)
      ring[k] = b.vertex({k == 0 ? 1.0 : k == 2 ? -1.0 : 0, k == 1 ? 1.0 : k == 3 ? -1.0 : 0, 0});
    if (!first) b.vertex({0, 0, 1}), b.vertex({0, 0, -1});
    b.builder().face({ring[0], ring[1], ring[2], ring[3]});
    const auto run = finish(b.complex(), ruppert(0));
    ASSERT_TRUE(run);
    EXPECT_EQ(run->domain(), Domain::kBox);
    expect_kept_promises(*run, "octahedron " + std::to_string(seed));
  }
}

TEST(RuppertInSpaceTest, IsTheSameWithATraceAndReplaysToItsMesh) {
  for (const Solid& solid : testing::solids()) {
    Random random(7);
    const Rotation turn(&random);
    const Complex complex = complex_of(solid, {1, &turn, {0, 0, 0}});
    Trace trace;
    trace.dimension = 3;
    const auto run = finish(complex, ruppert(0.5), &trace);
    const auto silent = finish(complex, ruppert(0.5));
    ASSERT_TRUE(run && silent);
    const Mesh mesh = run->mesh();
    EXPECT_EQ(fingerprint(mesh), fingerprint(silent->mesh())) << solid.name;
    Replay replay(trace);
    replay.seek(trace.events.size());
    std::set<std::array<std::uint32_t, 4>> replayed, made;
    const auto cells = replay.cells();
    for (std::size_t i = 0; i < cells.size(); i += 5) {
      if (cells[i + 4] == 2) continue;
      std::array<std::uint32_t, 4> c = {cells[i], cells[i + 1], cells[i + 2], cells[i + 3]};
      std::sort(c.begin(), c.end());
      replayed.insert(c);
    }
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
      std::array<std::uint32_t, 4> c;
      std::copy_n(mesh.cell(i), 4, c.begin());
      std::sort(c.begin(), c.end());
      made.insert(c);
    }
    EXPECT_EQ(replayed, made) << solid.name;
    replay.seek(0);
    EXPECT_TRUE(replay.cells().empty());
    for (const Event& e : trace.events) EXPECT_FALSE(describe(e, trace.steps).empty());
  }
}

/// Sharp complexes may keep it from ending: a limit does, and what there is is valid and says what
/// is left.
TEST(RuppertInSpaceTest, StopsAtItsLimitsOnSharpComplexes) {
  int stopped = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Complex complex = testing::random_complex3(seed, 5, 2);
    Options options = ruppert(0);
    options.limits.max_vertices = 800;
    options.domain = Domain::kBox;
    const auto run = finish(complex, options);
    ASSERT_TRUE(run) << seed;
    if (run->status() != Status::kComplete) {
      ++stopped;
      EXPECT_EQ(run->limit(), Reason::kLimitVertices) << seed;
      EXPECT_FALSE(run->unresolved().empty()) << seed;
    }
    for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      if (run->status() == Status::kComplete || check.name == "topology" ||
          check.name == "delaunay" || check.name == "input-vertices") {
        EXPECT_TRUE(check.ok) << seed << ", " << check.name << ": " << check.detail;
      }
    }
  }
  EXPECT_GT(stopped, 10);
}

/// Wherever a run is stopped, the mesh is valid and Delaunay as far as it goes; once faces have
/// kept inside and outside apart, nearly all of the domain is there and labelled, before all of the
/// hull.
TEST(RuppertInSpaceTest, AStoppedRunSaysWhetherTheDomainIsKnownAndLosesNothingOfIt) {
  Random random(11);
  const Rotation turn(&random);
  SolidBuilder b({1, &turn, {0, 0, 0}});
  b.box({0, 0, 0}, {3, 3, 3});
  b.box({1, 1, 1}, {1.7, 2, 2.2});
  b.box({3.5, 0, 0}, {4, 3, 3});
  b.regions.push_back({b.placed({0.5, 0.5, 0.5}), 4, 0});
  b.holes.push_back(b.placed({1.3, 1.5, 1.5}));
  const double volume = 27 - 0.7 * 1.2 + 4.5, hull = 36;
  int known = 0, unknown = 0;
  for (std::uint64_t most = 24; most < 700; most += most / 4) {
    Options options = ruppert(0.35);
    options.limits.max_vertices = most;
    const auto run = finish(b.complex(), options);
    ASSERT_TRUE(run);
    const Mesh mesh = run->mesh();
    VerifyOptions asked;
    asked.checks = {"topology", "input-vertices"};
    for (const Check& c : verify(mesh, run->complex(), asked)) EXPECT_TRUE(c.ok) << c.detail;
    if (!run->domain_known()) {
      ++unknown;
      EXPECT_EQ(run->status(), Status::kLimit);
      EXPECT_FALSE(run->unresolved().empty());
      EXPECT_NEAR(volume_of(mesh), hull, 1e-6) << most;
      EXPECT_TRUE(mesh.cell_regions.empty()) << most;
      continue;
    }
    ++known;
    EXPECT_NEAR(volume_of(mesh), volume, run->status() == Status::kComplete ? 1e-9 : 1.5) << most;
    double labelled = 0;
    for (std::size_t i = 0; i < mesh.cell_count(); ++i)
      labelled += mesh.cell_regions[i] == 4 ? volume_of(mesh, i) : 0;
    EXPECT_NEAR(labelled, volume - 4.5, run->status() == Status::kComplete ? 1e-9 : 1.5) << most;
  }
  EXPECT_GT(known, 2);
  EXPECT_GT(unknown, 2);
}

/// Where the shortest edge allowed leaves a face with a gap, nothing floods through it.
TEST(RuppertInSpaceTest, AFaceThatWasRefusedLeaksNothing) {
  SolidBuilder b({1, nullptr, {0, 0, 0}});
  b.box({0, 0, 0}, {3, 3, 3});
  b.box({0.01, 1, 1}, {2, 2, 2});  // a wall of a hundredth
  Options options = ruppert(0);
  options.limits.min_edge = 0.1;
  const auto run = finish(b.complex(), options);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_FALSE(run->domain_known());
  EXPECT_NEAR(volume_of(run->mesh()), 27, 1e-9);
}

TEST(RuppertInSpaceTest, DomainClosedIsRefusedWhereFacesEncloseNothing) {
  SolidBuilder b({1, nullptr, {0, 0, 0}});
  b.builder().face(b.square(0, 1, 0));
  Options options = ruppert(0);
  options.domain = Domain::kClosed;
  std::vector<Defect> defects;
  std::string error;
  EXPECT_EQ(Run::create(b.complex(), options, nullptr, &defects, &error), nullptr);
  EXPECT_NE(error.find("enclose nothing"), std::string::npos) << error;
}

}  // namespace
}  // namespace circumball
