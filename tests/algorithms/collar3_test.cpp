#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/acute.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::finish;
using testing::Random;
using testing::random_complex3;
using testing::Rotation;

Options collar() {
  Options options = testing::options_of("collar");
  options.limits.max_vertices = 40000;
  return options;
}

Complex example(const std::string& name) {
  std::ifstream file(std::string(CIRCUMBALL_SOURCE_DIR) + "/examples/" + name, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return read(bytes, name).complex;
}

/// It ended, it conforms, and Theorem 6.11 holds of what is left above tau.
void expect_kept_promises(const Run& run, const std::string& what) {
  EXPECT_EQ(run.status(), Status::kComplete) << what;
  for (const Unresolved& u : run.unresolved(100000)) {
    EXPECT_EQ(u.simplex.size(), 4u) << what << ": " << u.rule;
    EXPECT_EQ(u.reason, "protected") << what;
  }
  for (const Check& check : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(check.ok) << what << ", " << check.name << ": " << check.detail;
  }
}

/// Books, fans, spikes, plates and more, at angles from 1 degree; by all settings in turn.
TEST(CollarInSpace, EndsConformsAndKeepsTheorem611OnRandomAcuteComplexes) {
  for (std::uint64_t seed = 1; seed <= testing::cases(40); ++seed) {
    Options options = collar();
    options.domain = Domain::kBox;
    options.parameters["protect"] = seed % 5 ? "acute" : "all";
    const double least[] = {1, 3, 8, 15, 30, 60};
    const auto run = finish(random_complex3(seed, least[seed % 6], 2), options);
    ASSERT_TRUE(run) << seed;
    expect_kept_promises(*run, "seed " + std::to_string(seed));
  }
}

TEST(CollarInSpace, IsRuppertsAlgorithmWhereNothingIsAcute) {
  Random random(7);
  for (const testing::Solid& solid : testing::solids()) {
    const Rotation turn(&random);
    testing::SolidBuilder builder({1, &turn, {0, 0, 0}});
    solid.build(&builder);
    Options options = collar();
    options.tau = 2.2;
    const auto protected_run = finish(builder.complex(), options);
    options.algorithm = "ruppert";
    const auto run = finish(builder.complex(), options);
    ASSERT_TRUE(run && protected_run) << solid.name;
    EXPECT_EQ(fingerprint(run->mesh()), fingerprint(protected_run->mesh())) << solid.name;
  }
}

TEST(CollarInSpace, MeshesThePyramidAndSchoenhardtsPrism) {
  for (const char* name : {"pyramid.json", "schoenhardt.json"}) {
    const auto run = finish(example(name), collar());
    ASSERT_TRUE(run) << name;
    EXPECT_EQ(run->domain(), Domain::kClosed) << name;
    expect_kept_promises(*run, name);
  }
}

/// The pyramid after steps 2b and 2c: as many vertices as an independent implementation has.
TEST(CollarInSpace, DrawsTheCollarsOfThePyramidBySizesOfAlgorithm41) {
  Options options = collar();
  options.parameters["protect"] = "all";
  options.parameters["sizes"] = "estimate";
  const auto run = finish(example("pyramid.json"), options);
  ASSERT_TRUE(run);
  ASSERT_GE(run->steps().size(), 3u);
  EXPECT_EQ(run->steps()[1].vertices, 271u);
  EXPECT_EQ(run->steps()[2].vertices, 751u);
}

TEST(CollarInSpace, ConformsWhereverTheComplexStands) {
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
    const auto run = finish(complex, collar());
    ASSERT_TRUE(run) << seed;
    expect_kept_promises(*run, "placement " + std::to_string(seed));
  }
}

TEST(CollarInSpace, IsTheSameWithATraceThatReplaysToItsMesh) {
  const Complex complex = example("pyramid.json");
  Trace trace;
  trace.dimension = 3;
  const auto run = finish(complex, collar(), &trace);
  const auto silent = finish(complex, collar());
  ASSERT_TRUE(run && silent);
  EXPECT_EQ(fingerprint(run->mesh()), fingerprint(silent->mesh()));
  Replay replay(trace);
  replay.seek(trace.events.size());
  const auto cells = replay.cells();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < cells.size(); i += 5) inside += cells[i + 4] != 2;
  EXPECT_EQ(inside, run->mesh().cell_count());
  replay.seek(0);
  EXPECT_TRUE(replay.cells().empty());
  for (const Event& e : trace.events) EXPECT_FALSE(describe(e, trace.steps).empty());
}

TEST(CollarInSpace, StopsAtALimitWithWhatItHas) {
  Options options = collar();
  options.parameters["protect"] = "all";
  for (const std::uint64_t limit : {20, 45, 70, 91}) {
    options.limits.max_vertices = limit;
    const auto run = finish(example("pyramid.json"), options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->limit(), Reason::kLimitVertices) << limit;
    for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      if (check.name != "delaunay") continue;
      EXPECT_TRUE(check.ok) << limit << ": " << check.detail;
    }
  }
}

}  // namespace
}  // namespace circumball
