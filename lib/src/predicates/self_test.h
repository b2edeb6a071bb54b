#ifndef CIRCUMBALL_PREDICATES_SELF_TEST_H_
#define CIRCUMBALL_PREDICATES_SELF_TEST_H_

namespace circumball::internal {

/// The arithmetic that a build really does, as functions, so that the tests can hand in what a
/// wrong compiler would have made of them.
struct Arithmetic {
  double (*sum)(double a, double b, double c);          ///< (a + b) + c
  double (*product_sum)(double a, double b, double c);  ///< a * b + c
  double (*sum_error)(double a, double b);              ///< the low part of two_sum(a, b)
  bool evaluates_in_double;                             ///< FLT_EVAL_METHOD is 0
};

/// Empty if the arithmetic is what the predicates need, else a sentence that says what is wrong.
const char* check_arithmetic(const Arithmetic& arithmetic);

/// The arithmetic of the library's own build.
Arithmetic compiled_arithmetic();

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_SELF_TEST_H_
