#include "predicates/self_test.h"

#include <cfloat>

#include "circumball/predicates.h"
#include "predicates/expansion.h"

namespace circumball {
namespace internal {
namespace {

// Operands pass through volatile, so that nothing is computed at compile time, where other rules
// may hold.
double sum_as_compiled(double a, double b, double c) {
  volatile double va = a, vb = b, vc = c;
  const double x = va, y = vb, z = vc;
  return (x + y) + z;
}

double product_sum_as_compiled(double a, double b, double c) {
  volatile double va = a, vb = b, vc = c;
  const double x = va, y = vb, z = vc;
  return x * y + z;
}

double sum_error_as_compiled(double a, double b) {
  volatile double va = a, vb = b;
  const double x = va, y = vb;
  return two_sum(x, y).low;
}

}  // namespace

Arithmetic compiled_arithmetic() {
  return {sum_as_compiled, product_sum_as_compiled, sum_error_as_compiled, FLT_EVAL_METHOD == 0};
}

const char* check_arithmetic(const Arithmetic& f) {
  constexpr double kUlp = 0x1p-52;  // the last place of numbers in [1, 2)
  constexpr double kHalf = 0x1p-53;

  // 1 + 3/4 ulp rounds to 1 + ulp in double; 64 bits would keep the 3/4. And 1 + (1/2 + 2^-12) ulp
  // rounds up at once, but falls on a tie, and down to even, when rounded to 64 bits first.
  if (!f.evaluates_in_double ||
      (f.sum(1, 0.75 * kUlp, -1) != kUlp && f.sum(1, 0.75 * kUlp, -1) != 0) ||
      f.sum(1, kHalf + 0x1p-64, -1) == kHalf || f.sum(1, kHalf + 0x1p-64, -1) == kHalf + 0x1p-64) {
    return "Floating-point expressions are evaluated in more than double precision (x87): compile "
           "for SSE2 (-msse2 -mfpmath=sse).";
  }
  // To nearest, ties to even, on both sides of zero: each of the other modes fails one of these.
  if (f.sum(1, 0.25 * kUlp, -1) != 0 || f.sum(1, 0.75 * kUlp, -1) != kUlp ||
      f.sum(-1, -0.25 * kUlp, 1) != 0 || f.sum(-1, -0.75 * kUlp, 1) != -kUlp ||
      f.sum(1, kHalf, -1) != 0 || f.sum(1 + kUlp, kHalf, -1) != 2 * kUlp) {
    return "The floating-point rounding mode is not to nearest, ties to even: call "
           "fesetround(FE_TONEAREST) before using the library.";
  }
  // (1 + h)^2 = 1 + 2h + h^2 loses h^2 when the product is rounded; a fused multiply-add would give
  // it back.
  constexpr double kFactor = 1 + 0x1p-30, kProduct = 1 + 0x1p-29;
  if (f.product_sum(kFactor, kFactor, -kProduct) != 0 ||
      f.product_sum(-kFactor, kFactor, kProduct) != 0) {
    return "The compiler contracted a product and a sum into one fused multiply-add: compile with "
           "-ffp-contract=off.";
  }
  // Algebra would simplify the error of a sum to zero.
  if (f.sum_error(1, 0x1p-60) != 0x1p-60 || f.sum_error(0x1p-60, -1) != 0x1p-60) {
    return "The compiler reordered floating-point sums: compile without -ffast-math, -Ofast and "
           "-fassociative-math.";
  }
  return "";
}

}  // namespace internal

const char* predicate_self_test() {
  return internal::check_arithmetic(internal::compiled_arithmetic());
}

}  // namespace circumball
