// The arithmetic under the predicates: expansions and wide integers against Boost's integers.

#include "predicates/expansion.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "predicates/support.h"
#include "predicates/wide_integer.h"

namespace circumball::testing {
namespace {

using internal::expansion;
using internal::Expansion;
using internal::WideInteger;
using Integer = boost::multiprecision::cpp_int;

constexpr int kUnit = -1000;  // of the exact values below

Integer exact(double x) {
  const internal::Decoded d(x);
  if (d.mantissa == 0) return 0;
  Integer i(d.mantissa);
  i <<= d.exponent - kUnit;
  return d.negative ? Integer(-i) : i;
}

template <int N>
Integer exact(const Expansion<N>& e) {
  Integer sum = 0;
  for (int i = 0; i < e.size; ++i) sum += exact(e.component[i]);
  return sum;
}

/// No zeros, and each component is less than a unit in the last bit of the next that is set.
template <int N>
void expect_nonoverlapping(const Expansion<N>& e) {
  for (int i = 0; i < e.size; ++i) ASSERT_NE(e.component[i], 0);
  for (int i = 0; i + 1 < e.size; ++i) {
    const internal::Decoded next(e.component[i + 1]);
    const std::uint64_t lowest_bit = next.mantissa & (~next.mantissa + 1);
    ASSERT_LT(std::fabs(e.component[i]),
              internal::scale(static_cast<double>(lowest_bit), next.exponent));
  }
}

/// Doubles whose sums and products cancel, overlap and vanish.
double number(Random& random) {
  switch (random.below(4)) {
    case 0:
      return random.between(-2, 2);
    case 1:
      return random.any_magnitude(-60, 60);
    case 2:
      return step(random.between(-1, 1) * internal::power_of_two(random.between(-40, 40)),
                  random.between(-1, 1)) *
             0x1p-1;
    default:
      return random.uniform();
  }
}

/// number(), but never so small that products of four leave the exact values' unit.
double bounded_number(Random& random) {
  const double x = number(random);
  return std::fabs(x) < 0x1p-100 ? 0 : x;
}

Expansion<8> random_expansion(Random& random) {
  const auto pair = [&] {
    const double a = bounded_number(random), b = bounded_number(random);
    return internal::difference(a, b);
  };
  const Expansion<2> a = pair(), b = pair(), c = pair(), d = pair();
  return (a + b) - (c + d);
}

TEST(Expansion, SumsAndProductsAreExactAndNonoverlapping) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Expansion<8> e = random_expansion(random), f = random_expansion(random);
    const double b = bounded_number(random);
    const auto sum = e + f, difference = e - f;
    const auto scaled = e * b;
    const auto product = e * f;
    ASSERT_EQ(exact(sum), exact(e) + exact(f));
    ASSERT_EQ(exact(difference), exact(e) - exact(f));
    ASSERT_EQ(exact(scaled), exact(e) * exact(b) >> -kUnit);
    ASSERT_EQ(exact(product), exact(e) * exact(f) >> -kUnit);
    expect_nonoverlapping(sum);
    expect_nonoverlapping(difference);
    expect_nonoverlapping(scaled);
    expect_nonoverlapping(product);
    const double s = product.sign();
    ASSERT_EQ((s > 0) - (s < 0), exact(product).sign());
  }
}

TEST(Expansion, OfEqualNumbersHasNoComponents) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Expansion<8> e = random_expansion(random);
    EXPECT_EQ((e - e).size, 0);
    EXPECT_EQ((e * expansion(0)).size, 0);
    EXPECT_EQ((e * 0.0).size, 0);
  }
}

TEST(WideInteger, HasTheSignOfTheExactValue) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    double x[6];
    for (double& v : x) v = random.below(5) == 0 ? 0 : random.any_magnitude(-140, 140);
    if (random.below(3) == 0) {  // equal, or as near as can be
      for (int k = 0; k < 3; ++k) x[3 + k] = x[k];
      if (x[5] != 0 && random.below(2) == 0) x[5] = step(x[5], 1);
    }
    const auto wide = [](double v) { return WideInteger(internal::Decoded(v), kUnit); };
    const WideInteger value =
        wide(x[0]) * wide(x[1]) * wide(x[2]) - wide(x[3]) * wide(x[4]) * wide(x[5]);
    const Integer reference =
        exact(x[0]) * exact(x[1]) * exact(x[2]) - exact(x[3]) * exact(x[4]) * exact(x[5]);
    ASSERT_EQ(value.sign(), reference.sign());
    ASSERT_EQ((value - value).sign(), 0);
    ASSERT_EQ((-value).sign(), -reference.sign());
  }
}

}  // namespace
}  // namespace circumball::testing
