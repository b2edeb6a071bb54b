#include "io/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::SplitMix64;

std::uint64_t bits(double value) {
  std::uint64_t b = 0;
  std::memcpy(&b, &value, sizeof b);
  return b;
}

double from_bits(std::uint64_t b) {
  double value = 0;
  std::memcpy(&value, &b, sizeof value);
  return value;
}

TEST(FormatDouble, IsLaidOutAsEcmaScriptDoes) {
  const struct {
    double value;
    const char* text;
  } cases[] = {{0, "0"},
               {1, "1"},
               {-2.5, "-2.5"},
               {0.1, "0.1"},
               {100, "100"},
               {1e-6, "0.000001"},
               {1e-7, "1e-7"},
               {1.5e-7, "1.5e-7"},
               {1e20, "100000000000000000000"},
               {1e21, "1e+21"},
               {1.25e22, "1.25e+22"},
               {123456789012345680000.0, "123456789012345680000"},
               {5e-324, "5e-324"},
               {1.7976931348623157e308, "1.7976931348623157e+308"},
               {1.0 / 3, "0.3333333333333333"},
               {9007199254740993.0, "9007199254740992"}};
  for (const auto& c : cases) EXPECT_EQ(format_double(c.value), c.text);
}

TEST(FormatDouble, KeepsTheSignOfZeroAndNamesWhatIsNotFinite) {
  EXPECT_EQ(format_double(-0.0), "-0.0");
  EXPECT_EQ(format_double(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(format_double(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(format_double(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(FormatDouble, ReadsBackBitForBit) {
  SplitMix64 random(1);
  for (int i = 0; i < 200000; ++i) {
    const double value = from_bits(random.next());
    if (value != value) continue;
    const auto back = io::parse_double(format_double(value));
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(bits(*back), bits(value)) << format_double(value);
  }
  for (int e = -1074; e < 1024; ++e) {
    const double value = std::ldexp(1.0, e);
    ASSERT_EQ(bits(*io::parse_double(format_double(value))), bits(value));
  }
}

TEST(FormatDouble, NoShorterDecimalReadsBack) {
  SplitMix64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const double value = from_bits(random.next() & 0x7fffffffffffffffu);
    if (!std::isfinite(value) || value == 0) continue;
    const io::Decimal decimal = io::shortest_decimal(value);
    const std::size_t n = decimal.digits.size();
    if (n == 1) continue;
    // The two decimals with one digit less around the value.
    std::string down = decimal.digits.substr(0, n - 1), up = down;
    std::size_t k = up.size();
    while (k > 0 && up[k - 1] == '9') up[--k] = '0';
    if (k == 0)
      up.insert(up.begin(), '1');
    else
      ++up[k - 1];
    const int up_exponent = decimal.exponent + (k == 0 ? 1 : 0);
    EXPECT_NE(*io::parse_double("0." + down + "e" + std::to_string(decimal.exponent)), value);
    EXPECT_NE(*io::parse_double("0." + up + "e" + std::to_string(up_exponent)), value);
  }
}

TEST(FormatDouble, TextIsTheSameOnEveryPlatform) {
  // The hash was computed with GCC 12; the same test runs with Clang and in WebAssembly.
  SplitMix64 random(3);
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (int i = 0; i < 100000; ++i) {
    const double value = from_bits(random.next());
    if (value != value) continue;
    for (const char c : format_double(value)) {
      hash ^= static_cast<unsigned char>(c);
      hash *= 0x100000001b3u;
    }
  }
  EXPECT_EQ(hash, 5493260737982287815u);
}

TEST(ParseDouble, TakesEveryDecimalAndNothingElse) {
  const double inf = std::numeric_limits<double>::infinity();
  const struct {
    const char* text;
    double value;
  } good[] = {{"1", 1},
              {"+1", 1},
              {"-1.", -1},
              {".5", 0.5},
              {"1e3", 1000},
              {"1E+3", 1000},
              {"1e-3", 0.001},
              {"00.10", 0.1},
              {"1e999", inf},
              {"-1e999", -inf},
              {"1e-999", 0},
              {"inf", inf},
              {"-Infinity", -inf},
              {"0e99999999999999999999", 0},
              {"4.9e-324", 5e-324},
              {"0.000000000000000000000000000001e330", 1e300},
              {"100000000000000000000000000000000e-330", 1e-298},
              {"2.2250738585072011e-308", 2.2250738585072011e-308}};
  for (const auto& c : good) {
    const auto value = io::parse_double(c.text);
    ASSERT_TRUE(value.has_value()) << c.text;
    EXPECT_EQ(*value, c.value) << c.text;
  }
  EXPECT_TRUE(std::isnan(*io::parse_double("nan")));
  EXPECT_TRUE(std::isnan(*io::parse_double("NaN")));
  for (const char* text : {"", " ", "+", "-", ".", "e5", "1e", "1e+", "0x10", "1.2.3", "1 ", " 1",
                           "++1", "1,5", "nan(1)", "infi", "1f", "one"})
    EXPECT_FALSE(io::parse_double(text).has_value()) << text;
  EXPECT_EQ(bits(*io::parse_double("-1e-999")), bits(-0.0));
}

TEST(ParseDouble, AnyNumberOfDigitsIsRoundedCorrectly) {
  // 2^53 + 1 lies halfway between two doubles: a last digit far away decides.
  const std::string half = "9007199254740993." + std::string(2000, '0');
  EXPECT_EQ(*io::parse_double(half), 9007199254740992.0);
  EXPECT_EQ(*io::parse_double(half + "1"), 9007199254740994.0);
  EXPECT_TRUE(std::isinf(*io::parse_double(std::string(5000, '9'))));
  EXPECT_EQ(*io::parse_double("0." + std::string(5000, '0') + "1"), 0.0);
}

TEST(ParseInteger, TakesIntegersThatFit) {
  EXPECT_EQ(io::parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(io::parse_integer("+7"), 7);
  for (const char* text : {"", "-", "+", "+-1", "9223372036854775808", "1.0", "1x", " 1"})
    EXPECT_FALSE(io::parse_integer(text).has_value()) << text;
}

}  // namespace
}  // namespace circumball
