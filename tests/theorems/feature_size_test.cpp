#include <gtest/gtest.h>

#include "support/acute_complexes.h"
#include "support/feature_size_run.h"

namespace circumball {
namespace {

using testing::NearestNeighborWatch;

TEST(Theorems3_2And3_3, HoldOnTenThousandComplexesWithTheLowerBoundThroughout) {
  std::array<double, 2> range{1, 1};
  std::size_t insertions = 0;
  for (std::uint64_t number = 0; number < 10000; ++number) {
    const double least = testing::least_angle_of_run(number);
    const Complex complex = testing::random_acute_complex(number, least);
    NearestNeighborWatch watch(complex);
    const auto run = testing::finish(complex, testing::options_of("feature-size"), &watch);
    ASSERT_TRUE(run) << "complex " << number << " is not valid";
    ASSERT_EQ(run->status(), Status::kComplete) << number;
    ASSERT_TRUE(run->unresolved().empty()) << number;
    ASSERT_TRUE(watch.lower_bound_held_throughout()) << number << ": " << watch.range()[0];
    ASSERT_TRUE(watch.upper_bound_holds()) << number << ": " << watch.range()[1];
    range = {std::min(range[0], watch.range()[0]), std::max(range[1], watch.range()[1])};
    insertions += watch.insertions();
  }
  RecordProperty("smallest ratio", std::to_string(range[0]));
  RecordProperty("largest ratio", std::to_string(range[1]));
  RecordProperty("insertions", std::to_string(insertions));
  EXPECT_LT(range[0], 0.51);  // the lower bound is attained: the complexes are hard enough
  EXPECT_GT(range[1], 1.3);
}

}  // namespace
}  // namespace circumball
