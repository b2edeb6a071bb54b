#ifndef CIRCUMBALL_IO_NUMBERS_H_
#define CIRCUMBALL_IO_NUMBERS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers in text, the same on every platform and in every locale.
namespace circumball::io {

/// Length of the longest prefix of `text` that is a decimal number: an optional sign, digits with
/// at most one point among or around them, an optional exponent; or "nan", "inf", "infinity" in any
/// case. 0 if there is none.
std::size_t number_length(std::string_view text);

/// The double nearest to the decimal number that is *all* of `text` (correctly rounded; too large:
/// infinite, too small: zero, both with the sign). Nothing if `text` is anything else.
std::optional<double> parse_double(std::string_view text);

/// The integer that is all of `text`; nothing if it is anything else or does not fit.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// The same, but an integer that does not fit is the nearest that does: for indices, which are out
/// of range either way.
std::optional<std::int64_t> parse_saturated_integer(std::string_view text);

/// The shortest decimal that reads back as the same double, and among those the nearest: 0.d1d2d3…
/// * 10^exponent.
struct Decimal {
  std::string digits;
  int exponent = 0;
};
/// Of a finite value that is not zero; its sign is left out.
Decimal shortest_decimal(double value);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_NUMBERS_H_
