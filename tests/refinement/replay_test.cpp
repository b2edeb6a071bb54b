#include <gtest/gtest.h>

#include <algorithm>

#include "circumball/trace.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::random_grid;

/// The cells of a mesh in the form of Replay::cells, without the labels.
std::vector<std::vector<std::uint32_t>> sorted_cells(const std::uint32_t* data, std::size_t count,
                                                     std::size_t stride) {
  std::vector<std::vector<std::uint32_t>> cells;
  for (std::size_t i = 0; i < count; ++i) {
    cells.emplace_back(data + i * stride, data + i * stride + 3);
    std::sort(cells.back().begin(), cells.back().end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The triangles of a replay that are not outside the domain.
std::vector<std::vector<std::uint32_t>> inside(const Replay& replay) {
  const std::vector<std::uint32_t> all = replay.cells();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < all.size(); i += 4) {
    if (all[i + 3] != 2) kept.insert(kept.end(), &all[i], &all[i] + 4);
  }
  return sorted_cells(kept.data(), kept.size() / 4, 4);
}

/// Small runs: a snapshot of every moment is kept. Those that reach the limit are stopped in the
/// middle.
Options small(const char* algorithm) {
  Options options = options_of(algorithm);
  options.limits.max_vertices = 250;
  return options;
}

class ReplayOf : public ::testing::TestWithParam<const char*> {};

TEST_P(ReplayOf, ARunRebuildsTheMeshForwardsAndBackwards) {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const Complex complex = random_grid(seed, seed % 2 ? 0 : 0.3);
    Trace trace;
    const auto run = finish(complex, small(GetParam()), &trace);
    ASSERT_TRUE(run);
    const Mesh mesh = run->mesh();

    Replay replay(trace);
    std::vector<std::vector<std::uint32_t>> snapshots;
    snapshots.push_back(replay.cells());
    while (replay.forward()) snapshots.push_back(replay.cells());
    EXPECT_EQ(inside(replay), sorted_cells(mesh.cells.data(), mesh.cell_count(), 3));
    ASSERT_EQ(replay.vertices().size(), mesh.vertices.size());
    for (const auto& [v, p] : replay.vertices()) EXPECT_EQ(p, mesh.vertices[v]);
    EXPECT_EQ(replay.position(), trace.events.size());

    for (std::size_t i = snapshots.size() - 1; i-- > 0;) {
      ASSERT_TRUE(replay.backward());
      ASSERT_EQ(replay.cells(), snapshots[i]) << "seed " << seed << ", before event " << i;
    }
    EXPECT_FALSE(replay.backward());
    EXPECT_TRUE(replay.vertices().empty());
    replay.seek(trace.events.size() / 2);
    EXPECT_EQ(replay.cells(), snapshots[trace.events.size() / 2]);
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, ReplayOf, ::testing::Values("delaunay", "ruppert", "chew"));

TEST(Trace, RecordingDoesNotChangeTheMesh) {
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    const Complex complex = random_grid(seed, 0.25);
    Trace trace;
    const auto recorded = finish(complex, options_of("ruppert"), &trace);
    const auto silent = finish(complex, options_of("ruppert"));
    EXPECT_EQ(fingerprint(recorded->mesh()), fingerprint(silent->mesh()));
  }
}

TEST(Trace, BytesReadBack) {
  Trace trace;
  const auto run = finish(random_grid(7, 0), options_of("ruppert"), &trace);
  trace.steps = run->step_names();
  const std::string bytes = to_bytes(trace);
  Trace back;
  std::string error;
  ASSERT_TRUE(trace_from_bytes(bytes, &back, &error)) << error;
  EXPECT_EQ(back.steps, trace.steps);
  EXPECT_EQ(back.simplices, trace.simplices);
  EXPECT_EQ(to_bytes(back), bytes);
  EXPECT_EQ(to_jsonl(back), to_jsonl(trace));
}

TEST(Trace, TruncatedOrLyingBytesAreRefusedWithoutTakingMemory) {
  Trace trace;
  finish(random_grid(3, 0), options_of("ruppert"), &trace);
  const std::string bytes = to_bytes(trace);
  Trace back;
  std::string error;
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 200) {
    EXPECT_FALSE(trace_from_bytes(bytes.substr(0, size), &back, &error));
    EXPECT_FALSE(error.empty());
  }
  for (std::size_t at = 19; at < 51; ++at) {  // the counts in the header
    std::string lie = bytes;
    lie[at] = static_cast<char>(0xff);
    EXPECT_FALSE(trace_from_bytes(lie, &back, &error));
  }
}

TEST(Trace, EveryEventHasASentence) {
  Trace trace;
  const auto run = finish(random_grid(11, 0.2), options_of("ruppert"), &trace);
  for (const Event& e : trace.events) {
    const std::string sentence = describe(e, run->step_names());
    EXPECT_GT(sentence.size(), 10u);
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_STRNE(name(e.kind), "unknown");
    EXPECT_STRNE(name(e.reason), "unknown");
  }
}

TEST(Trace, InsertionRadiusIsTheDistanceToTheNearestVertex) {
  Trace trace;
  finish(random_grid(23, 0), options_of("ruppert"), &trace);
  std::vector<Point3> present;
  for (const Event& e : trace.events) {
    if (e.kind != EventKind::kInserted) continue;
    if (e.dimension > 0) {
      double nearest2 = HUGE_VAL;
      for (const Point3& p : present) {
        nearest2 = std::min(nearest2,
                            (p.x - e.at[0]) * (p.x - e.at[0]) + (p.y - e.at[1]) * (p.y - e.at[1]));
      }
      EXPECT_DOUBLE_EQ(e.value, std::sqrt(nearest2));
    }
    present.push_back({e.at[0], e.at[1], 0});
  }
}

}  // namespace
}  // namespace circumball
