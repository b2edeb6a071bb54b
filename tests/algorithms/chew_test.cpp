#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::random_grid;
using testing::unit_square;

TEST(Algorithm7_2, AllAnglesAreAtLeast30DegreesOnSuitableInput) {
  for (const char* h : {"0.5", "0.3", "0.1", "0.04", "0.0123"}) {
    const Complex complex = unit_square();
    Options options = options_of("chew");
    options.size = h;
    const auto run = finish(complex, options);
    EXPECT_EQ(run->status(), Status::kComplete);
    EXPECT_TRUE(run->unresolved().empty()) << h;
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(c.ok) << "h = " << h << ", " << c.name << ": " << c.detail;
    }
  }
}

TEST(Algorithm7_2, TheDefaultDivisionSuitsUnevenComplexes) {
  int verified = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Complex complex = random_grid(seed, 0, 0.3, false);
    Options options = options_of("chew");
    options.limits.max_vertices = 100000;
    const auto run = finish(complex, options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->status(), Status::kComplete) << "seed " << seed;
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      // The promise of 30 degrees needs every pair of disjoint features to be h apart; conformity
      // does not.
      if (c.name != "min-angle" && c.name != "size") {
        EXPECT_TRUE(c.ok) << c.name << ": " << c.detail;
      }
      verified += c.name == "min-angle" && c.ok;
    }
  }
  EXPECT_GE(verified, 50);
}

TEST(Algorithm7_2, EndsWhereTheInputDoesNotSuitIt) {
  Complex needle = testing::polygon({{0, 0}, {1, 0}, {0.996194698091746, 0.0871557427476582}});
  Options options = options_of("chew");
  for (const char* h : {"0.3", "0.05", "0.01"}) {
    options.size = h;
    const auto run = finish(needle, options);
    EXPECT_EQ(run->status(), Status::kComplete);
  }
}

TEST(Algorithm7_2, TheLargestCircumradiusGoesFirst) {
  Trace trace;
  Options options = options_of("chew");
  options.size = "0.1";
  const auto run = finish(unit_square(), options, &trace);
  // Queued values of the triangles that are alive, by their vertices: what is split next must hold
  // the largest.
  std::map<std::vector<std::uint32_t>, double> queued;
  const auto key = [](const Event& e) {
    std::vector<std::uint32_t> k(e.simplex, e.simplex + 3);
    std::sort(k.begin(), k.end());
    return k;
  };
  std::size_t at = 0;
  for (const Event& e : trace.events) {
    if (e.dimension == 2 && e.kind == EventKind::kQueued) queued[key(e)] = e.value;
    if (e.kind != EventKind::kInserted && e.kind != EventKind::kRelabeled) continue;
    if (e.dimension == 2) {
      const double value = queued.at(key(e));
      for (const auto& [k, v] : queued) EXPECT_LE(v, value);
    }
    for (std::uint32_t i = 0; i < e.other[0]; ++i) {
      std::vector<std::uint32_t> dead(&trace.simplices[at + 4 * i],
                                      &trace.simplices[at + 4 * i] + 3);
      std::sort(dead.begin(), dead.end());
      if (e.kind == EventKind::kInserted) queued.erase(dead);
    }
    at += 4 * (std::size_t{e.other[0]} + e.other[1]);
  }
  EXPECT_TRUE(queued.empty());
}

}  // namespace
}  // namespace circumball
