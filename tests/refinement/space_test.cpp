#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "circumball/trace.h"
#include "circumball/verify.h"
#include "support/complexes.h"
#include "support/complexes3.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::random_complex3;
using testing::start;
using testing::unit_cube;

/// Small runs: a snapshot of every moment is kept. Those that reach the limit are stopped in the
/// middle.
Options small(const char* algorithm) {
  Options options = options_of(algorithm);
  options.limits.max_vertices = 160;
  return options;
}

using Simplices = std::vector<std::vector<std::uint32_t>>;

/// Records of `stride` numbers as sorted lists of their first `size` numbers.
Simplices sorted(const std::vector<std::uint32_t>& records, std::size_t stride, std::size_t size) {
  Simplices all;
  for (std::size_t i = 0; i < records.size(); i += stride) {
    const auto at = records.begin() + static_cast<std::ptrdiff_t>(i);
    all.emplace_back(at, at + static_cast<std::ptrdiff_t>(size));
    std::sort(all.back().begin(), all.back().end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

class SpaceReplay : public ::testing::TestWithParam<const char*> {};

TEST_P(SpaceReplay, ARunRebuildsCellsAndFacesForwardsAndBackwards) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Complex complex = random_complex3(seed, 10, 2);
    Trace trace;
    trace.dimension = 3;
    const auto run = finish(complex, small(GetParam()), &trace);
    ASSERT_TRUE(run);
    const Mesh mesh = run->mesh();

    Replay replay(trace);
    struct Snapshot {
      std::vector<std::uint32_t> cells, faces;
    };
    std::vector<Snapshot> snapshots = {{}};
    while (replay.forward()) snapshots.push_back({replay.cells(), replay.face_triangles()});
    EXPECT_EQ(sorted(replay.cells(), 5, 4), sorted(mesh.cells, 4, 4)) << seed;
    ASSERT_EQ(replay.vertices().size(), mesh.vertices.size());
    for (const auto& [v, p] : replay.vertices()) EXPECT_EQ(p, mesh.vertices[v]);

    // Facets of the mesh are triangles of the faces' own triangulations, inside of the polygons.
    std::set<std::array<std::uint32_t, 4>> inside;
    const std::vector<std::uint32_t> faces = replay.face_triangles();
    for (std::size_t i = 0; i < faces.size(); i += 5) {
      EXPECT_EQ(faces[i + 3], kNoIndex);
      if (faces[i + 4] % 4 != 1) continue;
      std::array<std::uint32_t, 4> t{faces[i], faces[i + 1], faces[i + 2], faces[i + 4] / 4};
      std::sort(t.begin(), t.begin() + 3);
      inside.insert(t);
    }
    for (const MeshFacet& f : mesh.facets) {
      std::array<std::uint32_t, 4> t{f.a, f.b, f.c, f.face};
      std::sort(t.begin(), t.begin() + 3);
      EXPECT_TRUE(inside.count(t));
    }

    for (std::size_t i = snapshots.size() - 1; i-- > 0;) {
      ASSERT_TRUE(replay.backward());
      ASSERT_EQ(replay.cells(), snapshots[i].cells) << "seed " << seed << ", before event " << i;
      ASSERT_EQ(replay.face_triangles(), snapshots[i].faces) << "seed " << seed << ", event " << i;
    }
    EXPECT_TRUE(replay.vertices().empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, SpaceReplay, ::testing::Values("delaunay", "feature-size"));

/// Two squares that meet along an edge at 25 degrees.
Complex sharp_book() {
  Complex c;
  c.dimension = 3;
  c.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0.906, 0, 0.423}, {0.906, 1, 0.423}};
  c.faces.resize(2);
  c.faces[0].loops = {{0, 1, 3, 2}};
  c.faces[1].loops = {{0, 1, 5, 4}};
  c.segments = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {1, 5}, {5, 4}, {4, 0}};
  return c;
}

using Elements = std::vector<std::array<std::uint32_t, 5>>;
Elements elements(const Replay& replay) {
  Elements all;
  for (const ProtectingElement& p : replay.protection()) {
    all.push_back({p.a, p.b, p.c, p.carrier, static_cast<std::uint32_t>(p.kind)});
  }
  return all;
}

TEST(SpaceTrace, ProtectingElementsAreEdgesOfTheirFacesAndComeBackBackwards) {
  Options options = options_of("collar");
  options.limits.max_vertices = 9000;
  Trace trace;
  trace.dimension = 3;
  const auto run = finish(sharp_book(), options, &trace);
  ASSERT_EQ(run->status(), Status::kComplete);
  Replay replay(trace);
  std::map<std::size_t, Elements> after;
  std::array<std::size_t, kProtectingKinds> born{};
  std::size_t changes = 0;
  while (replay.forward()) {
    if (trace.events[replay.position() - 1].kind != EventKind::kProtection) continue;
    if (++changes % 50 == 1) after[replay.position()] = elements(replay);
  }
  // At the end each is an edge of a triangle of its face, or of the mesh on its segment.
  std::set<std::array<std::uint32_t, 3>> edges;
  const std::vector<std::uint32_t> faces = replay.face_triangles();
  for (std::size_t i = 0; i < faces.size(); i += 5) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = faces[i + k], b = faces[i + (k + 1) % 3];
      edges.insert({std::min(a, b), std::max(a, b), faces[i + 4] / 4});
    }
  }
  std::set<std::array<std::uint32_t, 3>> pieces;
  for (const MeshEdge& e : run->mesh().edges) {
    pieces.insert({std::min(e.a, e.b), std::max(e.a, e.b), e.segment});
  }
  for (const auto& [a, b, c, carrier, kind] : elements(replay)) {
    ++born[kind];
    const auto& known = kind == 5 ? pieces : edges;
    EXPECT_TRUE(known.count({std::min(a, b), std::max(a, b), carrier})) << kind << ": " << a;
    EXPECT_EQ(c != kNoIndex, static_cast<ProtectingKind>(kind) == ProtectingKind::kCollarArc);
  }
  EXPECT_GT(born[0], 0u);
  EXPECT_GT(born[1], 0u);
  EXPECT_GT(born[5], 0u);
  while (replay.backward()) {
    const auto found = after.find(replay.position());
    if (found != after.end()) {
      ASSERT_EQ(elements(replay), found->second);
    }
  }
  EXPECT_TRUE(elements(replay).empty());
  // As text each has its kind and its carrier; as bytes it reads back, and a kind unknown does not.
  EXPECT_NE(to_jsonl(trace).find(R"("kind":"collar-arc")"), std::string::npos);
  Trace back;
  std::string error;
  ASSERT_TRUE(trace_from_bytes(to_bytes(trace), &back, &error)) << error;
  EXPECT_EQ(back.simplices, trace.simplices);
  std::size_t at = 0;
  for (const Event& e : trace.events) {
    if (e.kind == EventKind::kProtection) break;
    const bool has = e.kind == EventKind::kInserted || e.kind == EventKind::kRelabeled ||
                     e.kind == EventKind::kFaceChanged;
    if (has) at += 5 * std::size_t{e.other[0] + e.other[1]};
  }
  back.simplices[at + 4] = kProtectingKinds;
  EXPECT_FALSE(trace_from_bytes(to_bytes(back), &trace, &error));
  EXPECT_NE(error.find("protects"), std::string::npos) << error;
}

TEST(SpaceTrace, RecordingDoesNotChangeTheMesh) {
  for (std::uint64_t seed = 100; seed < 108; ++seed) {
    const Complex complex = random_complex3(seed, 20, 2);
    Options options = options_of("feature-size");
    options.limits.max_vertices = 3000;
    Trace trace;
    trace.dimension = 3;
    const auto recorded = finish(complex, options, &trace);
    const auto silent = finish(complex, options);
    ASSERT_TRUE(recorded && silent) << seed;
    EXPECT_EQ(fingerprint(recorded->mesh()), fingerprint(silent->mesh()));
    // Bytes read back.
    trace.steps = recorded->step_names();
    Trace back;
    std::string error;
    ASSERT_TRUE(trace_from_bytes(to_bytes(trace), &back, &error)) << error;
    EXPECT_EQ(to_bytes(back), to_bytes(trace));
    for (const Event& e : trace.events) {
      EXPECT_GT(describe(e, trace.steps).size(), 10u);
      EXPECT_STRNE(name(e.kind), "unknown");
      EXPECT_STRNE(name(e.reason), "unknown");
    }
  }
}

TEST(SpaceTrace, AdvancingOneIterationAtATimeGivesTheSameMesh) {
  const Complex complex = random_complex3(3, 20, 1);
  const auto whole = finish(complex, options_of("feature-size"));
  const auto stepped = start(complex, options_of("feature-size"));
  while (stepped->status() == Status::kRunning) stepped->advance(1);
  EXPECT_EQ(fingerprint(whole->mesh()), fingerprint(stepped->mesh()));
  EXPECT_EQ(whole->steps().size(), 5u);
}

/// The mesh is a valid Delaunay mesh, whatever else is left to do.
void expect_valid(const Run& run) {
  VerifyOptions options;
  options.domain = "hull";
  options.checks = {"topology", "delaunay", "input-vertices", "volume"};
  for (const Check& c : verify(run.mesh(), run.complex(), options)) {
    EXPECT_TRUE(c.ok) << c.name << ": " << c.detail;
  }
}

TEST(SpaceLimits, StopARunWithAValidMeshAndAnAccount) {
  const Complex complex = random_complex3(5, 3, 3);
  Options options = options_of("feature-size");
  for (const std::uint64_t most : {50, 100, 200, 400}) {
    options.limits.max_vertices = most;
    const auto run = finish(complex, options);
    ASSERT_EQ(run->status(), Status::kLimit);
    EXPECT_EQ(run->limit(), Reason::kLimitVertices);
    EXPECT_EQ(run->mesh().vertices.size(), std::max<std::size_t>(most, complex.vertices.size()));
    expect_valid(*run);
    for (const Unresolved& u : run->unresolved()) {
      EXPECT_TRUE(u.reason == "limit-vertices" || u.reason == "outside-face" ||
                  u.reason == "near-segment")
          << u.reason;
    }
  }
}

TEST(SpaceLimits, ShortestEdgeIsKeptAndReported) {
  const Complex complex = random_complex3(5, 3, 3);
  Options options = options_of("feature-size");
  options.limits.min_edge = 0.02;
  const auto run = finish(complex, options);
  EXPECT_EQ(run->status(), Status::kLimit);
  EXPECT_EQ(run->limit(), Reason::kLimitMinEdge);
  const Mesh mesh = run->mesh();
  for (const MeshEdge& e : mesh.edges) {
    const Point3 &a = mesh.vertices[e.a], &b = mesh.vertices[e.b];
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    EXPECT_GE(std::sqrt(x * x + y * y + z * z), 0.02 * (1 - 1e-12));
  }
  expect_valid(*run);
}

TEST(SpaceLimits, CancellationLeavesAValidMesh) {
  const auto run = start(random_complex3(5, 3, 3), options_of("feature-size"));
  run->advance(50);
  run->cancel();
  run->advance();
  EXPECT_EQ(run->status(), Status::kCancelled);
  expect_valid(*run);
}

TEST(FeatureSizeInSpace, EndsWithNothingThatIsUnacceptableAndSafe) {
  // What is left unacceptable was refused by Safety, and is refused still.
  for (std::uint64_t seed = 200; seed < 212; ++seed) {
    const auto run = finish(random_complex3(seed, 20, 2), options_of("feature-size"));
    ASSERT_TRUE(run) << seed;
    ASSERT_EQ(run->status(), Status::kComplete) << seed;
    for (const Unresolved& u : run->unresolved(100000)) {
      EXPECT_EQ(u.simplex.size(), 3u);
      EXPECT_TRUE(u.reason == "outside-face" || u.reason == "near-segment") << u.reason;
    }
  }
}

TEST(FeatureSizeInSpace, IsTheSameAtEveryPowerOfTwo) {
  const Complex complex = random_complex3(7, 20, 2);
  const Mesh one = finish(complex, options_of("feature-size"))->mesh();
  for (const int power : {-100, -3, 40}) {
    Complex scaled = complex;
    const auto scale = [&](Point3& p) {
      p = {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
    };
    for (Point3& p : scaled.vertices) scale(p);
    for (Face& f : scaled.faces) {
      for (Point3& p : f.holes) scale(p);
    }
    const Mesh other = finish(scaled, options_of("feature-size"))->mesh();
    ASSERT_EQ(one.vertices.size(), other.vertices.size());
    for (std::size_t i = 0; i < one.vertices.size(); ++i) {
      Point3 p = one.vertices[i];
      scale(p);
      ASSERT_EQ(p, other.vertices[i]) << i;
    }
    EXPECT_EQ(one.cells, other.cells);
  }
}

TEST(FeatureSizeInSpace, WorksInEveryDimensionOfTheInput) {
  Complex complex;
  complex.dimension = 3;
  complex.vertices = {{1, 2, 3}};
  EXPECT_EQ(finish(complex, options_of("feature-size"))->mesh().vertices.size(), 1u);
  complex.vertices = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  complex.segments = {{0, 1}};
  auto run = finish(complex, options_of("feature-size"));
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_GT(run->mesh().edges.size(), 8u);
  EXPECT_TRUE(run->mesh().cells.empty());
  Complex flat;  // one face alone
  flat.dimension = 3;
  flat.vertices = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0}};
  flat.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  flat.faces.resize(1);
  flat.faces[0].loops = {{0, 1, 2, 3}};
  run = finish(flat, options_of("feature-size"));
  EXPECT_EQ(run->status(), Status::kComplete);
  EXPECT_GE(run->mesh().edges.size(), 48u);
}

TEST(FeatureSizeInSpace, MeshesTheBoxAroundTheInput) {
  Options options = options_of("feature-size");
  options.domain = Domain::kBox;
  const auto run = finish(unit_cube(), options);
  ASSERT_EQ(run->status(), Status::kComplete);
  const Mesh mesh = run->mesh();
  EXPECT_EQ(mesh.input_vertices, 8u);
  EXPECT_EQ(mesh.box_vertices, 8u);
  EXPECT_EQ(run->complex().faces.size(), 12u);
  expect_valid(*run);
}

TEST(SpaceOptions, TheDomainClosedIsRefusedWithAReason) {
  Options options = options_of("feature-size");
  options.domain = Domain::kClosed;
  std::vector<Defect> defects;
  std::string error;
  EXPECT_FALSE(Run::create(unit_cube(), options, nullptr, &defects, &error));
  EXPECT_NE(error.find("conform"), std::string::npos) << error;
}

}  // namespace
}  // namespace circumball
