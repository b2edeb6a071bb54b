#ifndef CIRCUMBALL_PREDICATES_DOUBLE_BITS_H_
#define CIRCUMBALL_PREDICATES_DOUBLE_BITS_H_

#include <cstdint>
#include <cstring>
#include <limits>

/// Doubles (IEEE 754 binary64) as bits: what frexp, ldexp and nextafter do, without libm, the same
/// everywhere.
namespace circumball::internal {

inline std::uint64_t to_bits(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline double from_bits(std::uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The one NaN that this library makes: processors differ in the sign of theirs.
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A finite double as +-mantissa * 2^exponent.
struct Decoded {
  std::uint64_t mantissa;  ///< below 2^53
  int exponent;            ///< -1074 to 971
  bool negative;

  explicit Decoded(double value) {
    const std::uint64_t bits = to_bits(value);
    const int biased = static_cast<int>(bits >> 52) & 0x7ff;
    mantissa = bits & 0xfffffffffffffu;
    if (biased != 0) mantissa |= std::uint64_t{1} << 52;
    exponent = (biased == 0 ? 1 : biased) - 1075;
    negative = (bits >> 63) != 0;
  }
};

/// 2^k, for k from -1022 to 1023.
inline double power_of_two(int k) { return from_bits(static_cast<std::uint64_t>(k + 1023) << 52); }

/// value * 2^k, for k from -2044 to 2046: rounded once where the result is subnormal and value is
/// in [1/2, 4].
inline double scale(double value, int k) {
  if (k > 1023) return value * power_of_two(1023) * power_of_two(k - 1023);
  if (k < -1022) return value * power_of_two(k + 1022) * power_of_two(-1022);
  return value * power_of_two(k);
}

/// The least double above x; infinity and NaN stay.
inline double next_up(double x) {
  if (!(x < kInfinity)) return x;
  if (x == 0) return from_bits(1);
  return from_bits(x > 0 ? to_bits(x) + 1 : to_bits(x) - 1);
}

/// The greatest double below x; minus infinity and NaN stay.
inline double next_down(double x) { return -next_up(-x); }

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_DOUBLE_BITS_H_
