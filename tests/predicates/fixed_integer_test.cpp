#include "predicates/fixed_integer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "predicates/support.h"

namespace circumball::testing {
namespace {

using boost::multiprecision::cpp_int;
using internal::FixedInteger;

template <int N>
cpp_int value(const FixedInteger<N>& a) {
  cpp_int v = 0;
  for (int i = N; i-- > 0;) v = (v << 64) + a.limb[i];
  return a.negative() ? v - (cpp_int(1) << 64 * N) : v;
}

/// Limbs of all zeros, all ones, and random ones.
template <int N>
FixedInteger<N> random_integer(Random& random) {
  FixedInteger<N> a;
  for (std::uint64_t& limb : a.limb) {
    const auto kind = random.below(4);
    limb = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random.bits();
  }
  return a;
}

template <int N, int M>
void expect_exact_arithmetic() {
  Random random(64 * N + M);
  for (int trial = 0; trial < 5000; ++trial) {
    const FixedInteger<N> a = random_integer<N>(random);
    const FixedInteger<M> b = random_integer<M>(random);
    ASSERT_EQ(value(a * b), value(a) * value(b));
    ASSERT_EQ(a.sign(), value(a).sign());
    // Halved, so that the sum has room.
    FixedInteger<N> c = a, d = random_integer<N>(random);
    for (FixedInteger<N>* e : {&c, &d})
      e->limb[N - 1] = static_cast<std::uint64_t>(static_cast<std::int64_t>(e->limb[N - 1]) / 2);
    ASSERT_EQ(value(c + d), value(c) + value(d));
    ASSERT_EQ(value(c - d), value(c) - value(d));
  }
}

TEST(FixedInteger, SumsAndProductsAreThoseOfIntegers) {
  expect_exact_arithmetic<1, 1>();
  expect_exact_arithmetic<1, 2>();
  expect_exact_arithmetic<2, 1>();
  expect_exact_arithmetic<2, 3>();
  expect_exact_arithmetic<3, 2>();
}

}  // namespace
}  // namespace circumball::testing
