// The self-test passes on this build and notices what a wrong compiler or processor mode would do.

#include "predicates/self_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "circumball/predicates.h"
#include "predicates/double_bits.h"
#include "predicates/expansion.h"

namespace circumball::testing {
namespace {

using internal::Arithmetic;
using internal::check_arithmetic;
using internal::compiled_arithmetic;
using internal::two_sum;

bool mentions(const char* sentence, const std::string& word) {
  return std::string(sentence).find(word) != std::string::npos;
}

TEST(SelfTest, PassesOnThisBuild) { EXPECT_STREQ(predicate_self_test(), ""); }

TEST(SelfTest, NoticesFusedMultiplyAdd) {
  Arithmetic a = compiled_arithmetic();
  a.product_sum = [](double x, double y, double z) { return std::fma(x, y, z); };
  EXPECT_TRUE(mentions(check_arithmetic(a), "-ffp-contract=off"));
}

TEST(SelfTest, NoticesReorderedSums) {
  Arithmetic a = compiled_arithmetic();
  a.sum_error = [](double, double) { return 0.0; };
  EXPECT_TRUE(mentions(check_arithmetic(a), "-ffast-math"));
}

TEST(SelfTest, NoticesExtendedPrecision) {
  Arithmetic a = compiled_arithmetic();
  a.evaluates_in_double = false;
  EXPECT_TRUE(mentions(check_arithmetic(a), "double precision"));
  // A sum that is not rounded between its two additions.
  a = compiled_arithmetic();
  a.sum = [](double x, double y, double z) {
    const internal::TwoDoubles s = two_sum(x, y);
    return (s.high + z) + s.low;
  };
  EXPECT_TRUE(mentions(check_arithmetic(a), "double precision"));
}

/// a + b rounded up, or down.
template <bool kUp>
double directed(double a, double b) {
  const internal::TwoDoubles s = two_sum(a, b);
  if (kUp && s.low > 0) return internal::next_up(s.high);
  if (!kUp && s.low < 0) return internal::next_down(s.high);
  return s.high;
}

double toward_zero(double a, double b) {
  return a + b > 0 ? directed<false>(a, b) : directed<true>(a, b);
}

double ties_away(double a, double b) {
  const internal::TwoDoubles s = two_sum(a, b);
  const double up = internal::next_up(s.high);
  return s.low > 0 && up - s.high == 2 * s.low ? up : s.high;
}

TEST(SelfTest, NoticesEveryOtherRounding) {
  using Sum = double (*)(double, double, double);
  const Sum wrong[] = {
      [](double a, double b, double c) { return directed<true>(directed<true>(a, b), c); },
      [](double a, double b, double c) { return directed<false>(directed<false>(a, b), c); },
      [](double a, double b, double c) { return toward_zero(toward_zero(a, b), c); },
      [](double a, double b, double c) { return ties_away(ties_away(a, b), c); }};
  for (const Sum f : wrong) {
    Arithmetic a = compiled_arithmetic();
    a.sum = f;
    EXPECT_TRUE(mentions(check_arithmetic(a), "rounding mode"));
  }
}

}  // namespace
}  // namespace circumball::testing
