// The self-test against real hardware: a fused multiply-add that the compiler made of a product and
// a sum, and the processor's other rounding modes.

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#include "circumball/predicates.h"
#include "predicates/self_test.h"

namespace circumball::testing {
namespace {

#if defined(__x86_64__)

// What -ffp-contract=fast -mfma would make of the library's own expression.
#if defined(__clang__)
__attribute__((target("fma"), noinline)) double contracted(double a, double b, double c) {
#pragma clang fp contract(fast)
  return a * b + c;
}
#else
__attribute__((target("fma"), optimize("fp-contract=fast"), noinline)) double contracted(double a,
                                                                                         double b,
                                                                                         double c) {
  return a * b + c;
}
#endif

TEST(SelfTestOnHardware, NoticesThatTheCompilerContracts) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
  internal::Arithmetic a = internal::compiled_arithmetic();
  a.product_sum = contracted;
  EXPECT_NE(std::string(check_arithmetic(a)).find("-ffp-contract=off"), std::string::npos);
}

#endif

TEST(SelfTestOnHardware, NoticesRoundingModes) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::string sentence = predicate_self_test();
    std::fesetround(FE_TONEAREST);
    EXPECT_NE(sentence.find("rounding mode"), std::string::npos);
  }
  EXPECT_STREQ(predicate_self_test(), "");
}

}  // namespace
}  // namespace circumball::testing
