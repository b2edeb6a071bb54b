#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "circumball/io.h"
#include "circumball/registry.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/acute.h"
#include "support/feature_size_run3.h"

namespace circumball {
namespace {

using testing::Chapter4Watch;

const std::vector<std::string> kSteps = {"0", "1a", "1b", "2a", "2b"};

/// Small angles between faces cost the square of their inverse in vertices: the smallest come
/// rarely.
double least_angle(std::uint64_t number) {
  return number % 40 == 0 ? 5 : number % 8 == 1 ? 10 : 20;
}
constexpr std::uint64_t kMaxVertices = 6000;

std::string all_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& s : sentences) text += s + "\n";
  return text;
}

// As printed, step 2b drops a segment whose witness was hidden while it waited, and Lemma 4.18
// fails here with 1.12 times its bound.
TEST(Lemma4_18, HoldsWhereAWitnessIsHiddenByAnotherFace) {
  const Complex complex = testing::random_complex3(1344, 10, 2);
  const auto run = testing::finish(complex, testing::options_of("feature-size"));
  ASSERT_TRUE(run);
  VerifyOptions options = promised_checks(*run);
  options.checks = {"segment-lower", "segment-upper"};
  for (const Check& c : verify(run->mesh(), run->complex(), options)) {
    EXPECT_TRUE(c.ok) << c.detail;
  }
}

// Not proved: the thesis asks whether it is so (4.2, last paragraphs).
TEST(Theorems4_1And4_2, HoldAlsoWhereStep2aSplitsIntoHalvesOrAdaptively) {
  for (const char* how : {"halves", "adaptive"}) {
    Options options = testing::options_of("feature-size");
    options.parameters["step2a"] = how;
    options.limits.max_vertices = kMaxVertices;
    const std::uint64_t count = testing::cases(20);
    for (std::uint64_t number = 3000; number < 3000 + count; ++number) {
      const Complex complex = testing::random_complex3(number, 15, 1 + number % 2);
      const auto run = testing::finish(complex, options);
      ASSERT_TRUE(run) << "complex " << number << " is not valid";
      if (run->status() != Status::kComplete) continue;  // the limit
      VerifyOptions checks = promised_checks(*run);
      checks.checks = {"segment-lower", "segment-upper"};
      for (const Check& c : verify(run->mesh(), run->complex(), checks)) {
        EXPECT_TRUE(c.ok) << how << " " << number << ": " << c.detail;
      }
    }
  }
}

TEST(Theorems4_1And4_2, HoldWithTheLemmasAfterEachStepOnHundredsOfRandomComplexes) {
  Chapter4Watch::Range after_1b, after_2a, lower, upper;
  std::size_t looked_at = 0, complete = 0;
  const std::uint64_t count = testing::cases(120);
  Options options = testing::options_of("feature-size");
  options.limits.max_vertices = kMaxVertices;
  for (std::uint64_t number = 0; number < count; ++number) {
    const Complex complex = testing::random_complex3(number, least_angle(number), 1 + number % 2);
    Chapter4Watch watch(complex, kSteps);
    const auto run = testing::finish(complex, options, watch.sink());
    ASSERT_TRUE(run) << "complex " << number << " is not valid";
    complete += run->status() == Status::kComplete ? 1 : 0;  // else the limit
    ASSERT_EQ(run->step_names(), kSteps);
    ASSERT_EQ(watch.history().unknown(), 0u) << number;
    ASSERT_TRUE(watch.failures().empty()) << number << "\n" << all_of(watch.failures());
    for (const auto& [sum, one] : {std::pair{&after_1b, &watch.after_1b},
                                   {&after_2a, &watch.after_2a},
                                   {&lower, &watch.lower},
                                   {&upper, &watch.upper}}) {
      sum->least = std::min(sum->least, one->least);
      sum->most = std::max(sum->most, one->most);
    }
    looked_at += watch.looked_at;
  }
  RecordProperty("after 1b, |s| / fs_1",
                 std::to_string(after_1b.least) + " to " + std::to_string(after_1b.most));
  RecordProperty("after 2a, |s| / lfs_1, most", std::to_string(after_2a.most));
  RecordProperty("after 2b, |s| over the bound of 4.1, least", std::to_string(lower.least));
  RecordProperty("after 2b, |s| over the bound of 4.2, most", std::to_string(upper.most));
  RecordProperty("statements", std::to_string(looked_at));
  EXPECT_GE(complete, count - count / 8);
  EXPECT_LT(after_1b.least, 0.4);  // the complexes are hard enough to come near the bounds
  EXPECT_GT(after_1b.most, 1.0);
}

TEST(Theorems4_1And4_2, HoldWithTheLemmasOnTheExamples) {
  const std::string folder = std::string(CIRCUMBALL_SOURCE_DIR) + "/examples/";
  const auto bytes_of = [&](const std::string& name) {
    std::ifstream file(folder + name, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  };
  int examples = 0;
  for (const auto& entry : nlohmann::json::parse(bytes_of("index.json"))) {
    if (entry.value("dimension", 2) != 3) continue;
    const std::string file = entry["file"];
    // Those at whose segments faces rise by a degree are the hardest for Theorem 4.2.
    if (entry["algorithm"] != "feature-size" && file != "segments-at-a-face.json") continue;
    const ReadResult input = read(bytes_of(file), file);
    ASSERT_TRUE(input.ok()) << file;
    Chapter4Watch watch(input.complex, kSteps);
    Options options = testing::options_of("feature-size");
    // Faces at one degree take many vertices in 2b. What is stated throughout holds where it stops.
    options.limits.max_vertices = kMaxVertices;
    const auto run = testing::finish(input.complex, options, watch.sink());
    ASSERT_TRUE(run) << file;
    EXPECT_TRUE(watch.failures().empty()) << file << "\n" << all_of(watch.failures());
    ++examples;
  }
  EXPECT_GE(examples, 8);
}

TEST(Theorems4_1And4_2, AreVerifiedOnTheMeshesOfRandomComplexes) {
  std::size_t complete = 0;
  Options options = testing::options_of("feature-size");
  options.limits.max_vertices = kMaxVertices;
  const std::uint64_t count = testing::cases(16);
  for (std::uint64_t number = 1000; number < 1000 + count; ++number) {
    const Complex complex = testing::random_complex3(number, 20, 1);
    const auto run = testing::finish(complex, options);
    ASSERT_TRUE(run) << number;
    if (run->status() != Status::kComplete) continue;
    ++complete;
    const Mesh mesh = run->mesh();
    for (const Check& check : verify(mesh, run->complex(), promised_checks(*run)))
      EXPECT_TRUE(check.ok) << number << " " << check.name << ": " << check.detail;
  }
  EXPECT_GE(complete, count / 2);
}

}  // namespace
}  // namespace circumball
