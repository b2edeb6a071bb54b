#include "sizing/grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "circumball/report.h"
#include "circumball/verify.h"
#include "sizing/sizing.h"
#include "support/complexes.h"

namespace circumball {
namespace {

/// Samples of f on n x m points of [0, 1]^2.
template <class F>
std::string grid_text(int n, int m, F f) {
  std::string values;
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      if (!values.empty()) values += ",";
      values += std::to_string(f(i / (n - 1.0), j / (m - 1.0)));
    }
  }
  return "{\"grid\": {\"origin\": [0, 0], \"spacing\": [" + std::to_string(1 / (n - 1.0)) + ", " +
         std::to_string(1 / (m - 1.0)) + "], \"columns\": " + std::to_string(n) +
         ", \"values\": [" + values + "]}}";
}

Sizing parsed(const std::string& text) {
  Sizing s;
  std::string error;
  EXPECT_TRUE(Sizing::parse(text, &s, &error)) << error;
  return s;
}

TEST(SampledGrid, IsBilinearAndConstantOutside) {
  const Sizing h = parsed(
      R"({"grid": {"origin": [1, 2], "spacing": [2, 0.5], "columns": 2, "values": [1, 3, 5, 11]}})");
  EXPECT_EQ(h.at(1, 2), 1);
  EXPECT_EQ(h.at(3, 2), 3);
  EXPECT_EQ(h.at(1, 2.5), 5);
  EXPECT_EQ(h.at(3, 2.5), 11);
  EXPECT_EQ(h.at(2, 2.25), 5);
  EXPECT_EQ(h.at(-100, -100), 1);
  EXPECT_EQ(h.at(100, 2.25), 7);
  EXPECT_EQ(h.at(2, 1e9), 8);
  EXPECT_FALSE(h.is_constant());
  EXPECT_EQ(
      parsed(R"({"grid":{"origin":[0,0],"spacing":[1,1],"columns":1,"values":[7]}})").at(3, 4), 7);
}

TEST(SampledGrid, ReproducesBilinearFunctionsOnEveryGrid) {
  for (const int n : {2, 3, 9, 65}) {
    const Sizing h = parsed(grid_text(n, n / 2 + 2, [](double x, double y) {
      return std::round(4096 * (1 + x + 2 * y + 3 * x * y)) / 4096;
    }));
    testing::Random random(7);
    for (int i = 0; i < 200; ++i) {
      const double x = random.unit(), y = random.unit();
      EXPECT_NEAR(h.at(x, y), 1 + x + 2 * y + 3 * x * y, 1e-3);
    }
  }
}

TEST(SampledGrid, BoxesContainTheValuesAtTheirPoints) {
  for (const int n : {2, 5, 33, 200}) {
    testing::Random values(static_cast<std::uint64_t>(n));
    const Sizing h = parsed(grid_text(n, 2 * n, [&](double, double) {
      return values.below(5) == 0 ? 1e-6 : 1e3 * values.unit() + 1e-3;
    }));
    testing::Random random(3);
    for (int i = 0; i < 300; ++i) {
      const double w = random.below(2) ? random.unit() : 0.02 * random.unit();
      const double x = 1.4 * random.unit() - 0.2, y = 1.4 * random.unit() - 0.2;
      const Interval box = h.over({x, x + w}, {y, y + w});
      for (int j = 0; j < 10; ++j) {
        EXPECT_TRUE(box.contains(h.at(x + w * random.unit(), y + w * random.unit())));
      }
      const Interval point = h.over(x, y);
      EXPECT_TRUE(point.contains(h.at(x, y)));
      EXPECT_LT(point.hi - point.lo, 1e-9 * point.hi);
    }
  }
}

TEST(SampledGrid, WhatIsNoGridIsNamed) {
  const char* const kGrids[] = {
      "{",
      "{}",
      R"({"grid": 3})",
      R"({"grid": {}})",
      R"({"grid": {"origin": [0], "spacing": [1, 1], "columns": 1, "values": [1]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 0], "columns": 1, "values": [1]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, -1], "columns": 1, "values": [1]}})",
      R"({"grid": {"origin": [0, "a"], "spacing": [1, 1], "columns": 1, "values": [1]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 0, "values": [1]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": -2, "values": [1, 2]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 1e30, "values": [1]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 2, "values": [1, 2, 3]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 1, "values": []}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 1, "values": [0]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 1, "values": [null]}})",
      R"({"grid": {"origin": [0, 0], "spacing": [1, 1], "columns": 1, "values": [1e999]}})"};
  for (const char* text : kGrids) {
    Sizing s;
    std::string error;
    EXPECT_FALSE(Sizing::parse(text, &s, &error)) << text;
    EXPECT_NE(error.find("grid"), std::string::npos) << text << ": " << error;
    Options options = testing::options_of("fem-size");
    options.size = text;
    EXPECT_FALSE(testing::start(testing::unit_square(), options)) << text;
  }
}

TEST(SampledGrid, MeshesHonorAndVerifyIt) {
  const std::string text =
      grid_text(9, 9, [](double x, double y) { return x < 0.5 ? 0.02 : 0.05 + 0.1 * y; });
  for (const char* algorithm : {"fem-size", "ruppert", "collar"}) {
    Options options = testing::options_of(algorithm);
    options.size = text;
    const auto run = testing::finish(testing::unit_square(), options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->status(), Status::kComplete);
    bool looked = false;
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      EXPECT_TRUE(c.ok) << c.name << ": " << c.detail;
      looked = looked || c.name == "sizing";
    }
    EXPECT_TRUE(looked) << algorithm;
  }
}

}  // namespace
}  // namespace circumball
