#include "circumball/registry.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/complexes.h"

namespace circumball {
namespace {

TEST(Registry, EveryAlgorithmStatesItsFourRulesAndRuns) {
  for (const AlgorithmInfo& info : registry()) {
    for (const std::string* text :
         {&info.id, &info.title, &info.thesis, &info.action, &info.priority, &info.unacceptability,
          &info.safety, &info.guarantee, &info.default_domain}) {
      EXPECT_FALSE(text->empty()) << info.id;
    }
    EXPECT_FALSE(info.checks.empty());
    EXPECT_EQ(find_algorithm(info.id, info.dimension), &info);
    const auto run =
        testing::finish(testing::unit_box(info.dimension), testing::options_of(info.id));
    ASSERT_TRUE(run) << info.id;
    EXPECT_EQ(run->status(), Status::kComplete);
  }
}

TEST(Registry, DefaultsOfParametersAreInRangeAndAccepted) {
  for (const AlgorithmInfo& info : registry()) {
    for (const ParameterInfo& p : info.parameters) {
      Options options = testing::options_of(info.id);
      options.parameters[p.name] = p.default_value;
      EXPECT_TRUE(testing::finish(testing::unit_box(info.dimension), options))
          << info.id << " " << p.name;
      EXPECT_FALSE(p.help.empty());
    }
  }
}

TEST(Registry, JsonHoldsWhatTheRegistryHolds) {
  const auto list = nlohmann::json::parse(registry_json());
  ASSERT_EQ(list.size(), registry().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["id"], registry()[i].id);
    EXPECT_EQ(list[i]["rules"]["safety"], registry()[i].safety);
    EXPECT_EQ(list[i]["parameters"].size(), registry()[i].parameters.size());
    EXPECT_EQ(list[i]["checks"].size(), registry()[i].checks.size());
  }
}

TEST(DefaultAlgorithm, IsCollarInSpace) {
  Complex complex;
  complex.dimension = 3;
  EXPECT_EQ(default_algorithm(complex), "collar");
}

TEST(DefaultAlgorithm, IsRuppertUnlessAnAngleIsSmall) {
  EXPECT_EQ(default_algorithm(testing::polygon({{0, 0}, {1, 0}, {1, 0.5}})), "collar");
  EXPECT_EQ(default_algorithm(testing::unit_square()), "ruppert");
}

}  // namespace
}  // namespace circumball
