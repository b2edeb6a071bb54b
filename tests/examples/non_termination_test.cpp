#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "delaunay/constructions.h"
#include "predicates/elementary.h"
#include "support/complexes.h"
#include "support/examples.h"

namespace circumball {
namespace {

using testing::example;

/// What was split (an input segment, or kNoIndex: a triangle), and the insertion radius.
struct Insertion {
  std::uint32_t segment;
  double radius;
};

std::vector<Insertion> insertions(const Trace& trace) {
  std::vector<Insertion> list;
  for (const Event& e : trace.events) {
    if (e.kind != EventKind::kInserted) continue;
    if (e.reason == Reason::kMidpoint) list.push_back({e.simplex[3], e.value});
    if (e.reason == Reason::kCircumcenter) list.push_back({kNoIndex, e.value});
  }
  return list;
}

/// Whether the last `cycles` cycles of the given period are alike: the same simplices split in the
/// same order, each insertion radius `shrink` times the one of a cycle before.
bool repeats(const std::vector<Insertion>& list, std::size_t period, std::size_t cycles,
             double shrink) {
  if (list.size() < period * (cycles + 1)) return false;
  for (std::size_t i = list.size() - period * cycles; i < list.size(); ++i) {
    const Insertion &now = list[i], &before = list[i - period];
    if (now.segment != before.segment) return false;
    if (std::abs(now.radius / before.radius - shrink) > 1e-6) return false;
  }
  return true;
}

std::size_t shortest_period(const std::vector<Insertion>& list, std::size_t cycles, double shrink) {
  for (std::size_t period = 1; period * (cycles + 1) <= list.size(); ++period) {
    if (repeats(list, period, cycles, shrink)) return period;
  }
  return 0;
}

struct Case {
  const char* file;
  double min_angle;
  std::size_t period;  ///< insertions a cycle
};

// docs/non-termination.md has the arguments. The factor of a cycle is 1/2 in each, because a cycle
// halves every segment of the corner once.
const Case kCases[] = {{"pav.json", 31, 12}, {"pinwheel.json", 20.7, 7}, {"fan.json", 20.7, 10}};

TEST(NonTermination, EachCycleIsTheLastAtHalfTheSize) {
  for (const Case& c : kCases) {
    Options options = testing::options_of("ruppert");
    options.min_angle_degrees = c.min_angle;
    options.limits.max_vertices = 900;
    Trace trace;
    const auto run = testing::finish(example(c.file), options, &trace);
    ASSERT_TRUE(run) << c.file;
    EXPECT_EQ(run->limit(), Reason::kLimitVertices) << c.file;
    EXPECT_EQ(shortest_period(insertions(trace), 20, 0.5), c.period) << c.file;
  }
}

TEST(NonTermination, LimitsStopItAndTheReportSaysWhatRemainsAndWhy) {
  for (const Case& c : kCases) {
    for (const bool by_length : {true, false}) {
      Options options = testing::options_of("ruppert");
      options.min_angle_degrees = c.min_angle;
      if (by_length) {
        options.limits.min_edge = 1e-4;
      } else {
        options.limits.max_vertices = 300;
      }
      const auto run = testing::finish(example(c.file), options);
      ASSERT_TRUE(run) << c.file;
      EXPECT_EQ(run->status(), Status::kLimit);
      EXPECT_EQ(run->limit(), by_length ? Reason::kLimitMinEdge : Reason::kLimitVertices);
      const std::vector<Unresolved> remains = run->unresolved();
      ASSERT_FALSE(remains.empty()) << c.file;
      bool corner_named = false;
      for (const Unresolved& u : remains) {
        EXPECT_FALSE(u.rule.empty());
        EXPECT_FALSE(u.reason.empty());
        corner_named = corner_named || u.near == "input vertex 0";
      }
      EXPECT_TRUE(corner_named) << c.file;
      VerifyOptions checks;
      checks.checks = {"topology", "delaunay", "input-vertices"};
      for (const Check& check : verify(run->mesh(), run->complex(), checks)) {
        EXPECT_TRUE(check.ok) << c.file << ", " << check.name << ": " << check.detail;
      }
    }
  }
}

TEST(NonTermination, CollarsEndAllOfThem) {
  for (const Case& c : kCases) {
    Options options = testing::options_of("collar");
    options.min_angle_degrees = c.min_angle;
    if (std::string(c.file) == "pav.json") options.parameters["protect"] = "all";
    const auto run = testing::finish(example(c.file), options);
    ASSERT_TRUE(run) << c.file;
    EXPECT_EQ(run->status(), Status::kComplete) << c.file;
    for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(check.ok) << c.file << ", " << check.name << ": " << check.detail;
    }
  }
}

TEST(Pav, EndsWhereTheoremTwoTwoAppliesAndUpToThirtyDegrees) {
  for (const double degrees : {20.7, 29.0, 30.0}) {
    Options options = testing::options_of("ruppert");
    options.min_angle_degrees = degrees;
    const auto run = testing::finish(example("pav.json"), options);
    EXPECT_EQ(run->status(), Status::kComplete) << degrees;
    EXPECT_LT(run->mesh().vertices.size(), 10u) << degrees;
  }
}

// Both splits of a cycle leave the same corner, turned over, at 1 / sqrt 2 of its size.
TEST(Pav, EverySplitAtTheCornerShrinksItBySqrtTwo) {
  Options options = testing::options_of("ruppert");
  options.min_angle_degrees = 31;
  options.limits.max_vertices = 900;
  Trace trace;
  const auto run = testing::finish(example("pav.json"), options, &trace);
  std::vector<double> corner;  // radii of the midpoints of end segments at input vertex 0
  for (const Event& e : trace.events) {
    if (e.kind == EventKind::kInserted && e.reason == Reason::kMidpoint &&
        (e.simplex[0] == 0 || e.simplex[1] == 0)) {
      corner.push_back(distance(Point2{e.at[0], e.at[1]}, Point2{0, 0}));
    }
  }
  ASSERT_GT(corner.size(), 60u);
  for (std::size_t i = 1; i < 60; ++i) {
    EXPECT_NEAR(corner[i] / corner[i - 1], std::sqrt(0.5), 1e-9) << i;
  }
}

// The midpoint of each segment is inside the disk of the next where cos theta > 2^(1/n) / 2: seven
// segments do, six (60 degrees) do not.
TEST(Pinwheel, SevenSegmentsSpinAndSixDoNot) {
  for (const unsigned n : {6u, 7u}) {
    Complex c;
    c.vertices.push_back({0, 0, 0});
    for (unsigned i = 0; i < n; ++i) {
      const double length = 2 * elementary::pow(0.5, static_cast<double>(i) / n);
      const double angle = 2 * elementary::kPi * i / n;
      c.vertices.push_back({length * elementary::cos(angle), length * elementary::sin(angle), 0});
      c.segments.push_back({0, i + 1});
    }
    testing::add_square(&c, -3, -3, 6);
    Options options = testing::options_of("ruppert");
    options.limits.max_vertices = 900;
    Trace trace;
    const auto run = testing::finish(c, options, &trace);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->status() == Status::kComplete, n == 6) << n;
    if (n > 6) {
      EXPECT_EQ(shortest_period(insertions(trace), 20, 0.5), n);
    }
  }
}

}  // namespace
}  // namespace circumball
