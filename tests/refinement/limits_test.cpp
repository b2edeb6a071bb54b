#include <gtest/gtest.h>

#include "circumball/verify.h"
#include "support/acute.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::polygon;
using testing::random_grid;
using testing::start;
using testing::unit_square;

/// Two segments at 5 degrees: Ruppert's algorithm runs into the corner for ever.
Complex needle() { return polygon({{0, 0}, {1, 0}, {0.996194698091746, 0.0871557427476582}}); }

/// The mesh is a valid Delaunay mesh, whatever else is left to do.
void expect_valid(const Run& run) {
  VerifyOptions options;
  options.checks = {"topology", "delaunay", "input-vertices"};
  for (const Check& c : verify(run.mesh(), run.complex(), options)) {
    EXPECT_TRUE(c.ok) << c.name << ": " << c.detail;
  }
}

TEST(Limits, VerticesStopARunThatWouldNotEnd) {
  Options options = options_of("ruppert");
  options.limits.max_vertices = 500;
  const auto run = finish(needle(), options);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_EQ(run->limit(), Reason::kLimitVertices);
  EXPECT_EQ(run->mesh().vertices.size(), 500u);
  expect_valid(*run);
  const auto unresolved = run->unresolved();
  ASSERT_FALSE(unresolved.empty());
  for (const Unresolved& u : unresolved) {
    EXPECT_EQ(u.reason, "limit-vertices");
    EXPECT_TRUE(u.rule == "encroached" || u.rule == "radius-edge" || u.rule == "missing") << u.rule;
  }
}

TEST(Limits, ShortestEdgeIsKeptAndReported) {
  Options options = options_of("ruppert");
  options.limits.min_edge = 1e-4;
  const auto run = finish(needle(), options);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_EQ(run->limit(), Reason::kLimitMinEdge);
  const Mesh mesh = run->mesh();
  EXPECT_GE(measure(mesh).shortest_edge, 1e-4);
  expect_valid(*run);
  bool refused = false;
  for (const Unresolved& u : run->unresolved()) refused |= u.reason == "min-edge";
  EXPECT_TRUE(refused);
}

TEST(Limits, ShortestEdgeIsKeptWhereSegmentsAreSplitBeforehand) {
  Complex angle;  // protected, or split at equal lengths, nearer to its vertex than the limit
  angle.vertices = {{0, 0, 0}, {1, 0, 0}, {1.7, 0.3, 0}};
  angle.segments = {{0, 1}, {0, 2}};
  for (const char* algorithm : {"chew", "collar", "intestine", "terminator", "fem-size"}) {
    Options options = options_of(algorithm);
    options.limits.min_edge = 0.5;
    const auto run = finish(angle, options);
    EXPECT_EQ(run->limit(), Reason::kLimitMinEdge) << algorithm;
    EXPECT_GE(measure(run->mesh()).shortest_edge, 0.5) << algorithm;
    expect_valid(*run);
  }
}

TEST(Limits, AFeatureSizeThatWasStoppedSaysWhatRemains) {
  const Complex fan = testing::dense_fan(1, 12, 1);
  Options options = options_of("feature-size");
  options.limits.max_vertices = 100;
  const auto run = finish(fan, options);
  ASSERT_EQ(run->status(), Status::kLimit);
  const auto unresolved = run->unresolved();
  EXPECT_FALSE(unresolved.empty());
  for (const Unresolved& u : unresolved) {
    EXPECT_EQ(u.reason, "limit-vertices");
    EXPECT_TRUE(u.rule == "witness" || u.rule == "too-long") << u.rule;
  }
  const auto unborn = start(fan, options);  // asked before there is anything to ask
  EXPECT_TRUE(unborn->unresolved().empty());
}

TEST(Limits, SecondsStopARun) {
  Options options = options_of("ruppert");
  options.limits.max_seconds = 1e-6;
  options.limits.max_vertices = 1000000;
  const auto run = finish(needle(), options);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_EQ(run->limit(), Reason::kLimitSeconds);
  expect_valid(*run);
}

TEST(Limits, MemoryStopsARun) {
  Options options = options_of("ruppert");
  options.limits.max_bytes = 2000000;
  options.size = "0.001";
  const auto run = finish(unit_square(), options);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_EQ(run->limit(), Reason::kLimitMemory);
  expect_valid(*run);
}

TEST(Limits, ACancelledRunReturnsTheMeshThatItHas) {
  const auto run = start(needle(), options_of("ruppert"));
  run->advance(100);
  EXPECT_EQ(run->status(), Status::kRunning);
  run->cancel();
  EXPECT_EQ(run->advance(), Status::kCancelled);
  expect_valid(*run);
  EXPECT_EQ(run->unresolved().front().reason, "cancelled");
}

TEST(Stepping, OneIterationAtATimeIsTheSameRun) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Complex complex = random_grid(seed, 0);
    for (const char* algorithm : {"delaunay", "ruppert", "chew"}) {
      Trace whole, stepped;
      Options options = options_of(algorithm);
      options.limits.max_vertices = 2000;
      const auto once = finish(complex, options, &whole);
      const auto run = start(complex, options, &stepped);
      std::uint64_t calls = 0;
      while (run->advance(1) == Status::kRunning) {
        const std::uint64_t before = run->progress().iterations;
        EXPECT_LE(before, ++calls);
      }
      EXPECT_EQ(fingerprint(run->mesh()), fingerprint(once->mesh()));
      EXPECT_EQ(to_bytes(stepped), to_bytes(whole));
    }
  }
}

TEST(Stepping, TheMeshIsDelaunayAtEveryMoment) {
  const Complex complex = random_grid(5, 0.3);
  const auto run = start(complex, options_of("ruppert"));
  while (run->advance(7) == Status::kRunning) expect_valid(*run);
}

TEST(Run, AnInvalidComplexIsRefusedWithItsDefects) {
  Complex complex = unit_square();
  complex.segments.push_back({0, 2});
  complex.segments.push_back({1, 3});
  std::vector<Defect> defects;
  std::string error;
  EXPECT_FALSE(Run::create(complex, options_of("ruppert"), nullptr, &defects, &error));
  ASSERT_FALSE(defects.empty());
  EXPECT_EQ(defects.front().name, "segments-cross");
}

TEST(Run, OptionsOutOfRangeAreRefusedWithASentence) {
  const auto error_of = [](const Options& options) {
    std::vector<Defect> defects;
    std::string error;
    EXPECT_FALSE(Run::create(unit_square(), options, nullptr, &defects, &error));
    return error;
  };
  EXPECT_NE(error_of(options_of("nonsense")), "");
  Options options = options_of("ruppert");
  options.tau = 0.1;
  EXPECT_NE(error_of(options), "");
  options.tau = 2;
  options.min_angle_degrees = 20;
  EXPECT_NE(error_of(options), "");
  options = options_of("ruppert");
  options.parameters["nonsense"] = "1";
  EXPECT_NE(error_of(options), "");
  options.parameters = {{"size", "-1"}};
  EXPECT_NE(error_of(options), "");
}

TEST(Run, NothingEnclosedAndDomainClosedIsSaid) {
  Complex complex;
  complex.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  complex.segments = {{0, 1}, {1, 2}};
  Options options = options_of("ruppert");
  options.domain = Domain::kClosed;
  EXPECT_FALSE(start(complex, options));
  options.domain = Domain::kDefault;
  const auto run = finish(complex, options);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->domain(), Domain::kBox);
  EXPECT_EQ(run->status(), Status::kComplete);
}

}  // namespace
}  // namespace circumball
