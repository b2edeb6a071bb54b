#include "io/numbers.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include "circumball/io.h"

namespace circumball {
namespace io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Length of `word` (lower case) if `text` starts with it in any case, else 0.
std::size_t starts_with_word(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return 0;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((text[i] | 0x20) != word[i]) return 0;
  return word.size();
}

/// Whether the decimal number `text` (without sign, not zero) is above 1: tells overflow from
/// underflow.
bool is_large(std::string_view text) {
  std::int64_t magnitude = 0;  // power of ten of the first digit that is not zero
  bool point = false, nonzero = false;
  std::size_t i = 0;
  for (; i < text.size() && (is_digit(text[i]) || text[i] == '.'); ++i) {
    if (text[i] == '.') {
      point = true;
    } else if (nonzero) {
      if (!point) ++magnitude;
    } else {
      nonzero = text[i] != '0';
      if (point) --magnitude;
    }
  }
  if (i == text.size()) return magnitude > 0;
  const bool negative = i + 1 < text.size() && text[i + 1] == '-';
  std::int64_t exponent = 0;
  for (++i; i < text.size(); ++i)
    if (is_digit(text[i]) && exponent < (std::int64_t{1} << 50))
      exponent = 10 * exponent + (text[i] - '0');
  return magnitude + (negative ? -exponent : exponent) > 0;
}

/// Correctly rounded value of an unsigned decimal number whose grammar has been checked.
double convert(std::string_view text) {
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
  // libc++ has no from_chars for doubles before version 20. musl's strtod rounds correctly, knows
  // no other decimal point, and the grammar leaves it nothing else to understand (no hexadecimal,
  // no white space).
  (void)is_large;
  return std::strtod(std::string(text).c_str(), nullptr);
#else
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range)
    return is_large(text) ? std::numeric_limits<double>::infinity() : 0.0;
  return value;
#endif
}

}  // namespace

std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  for (const char* word : {"infinity", "inf", "nan"})
    if (const std::size_t n = starts_with_word(text.substr(i), word)) return i + n;
  std::size_t digits = 0;
  for (; i < text.size() && is_digit(text[i]); ++i) ++digits;
  if (i < text.size() && text[i] == '.') {
    ++i;
    for (; i < text.size() && is_digit(text[i]); ++i) ++digits;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] | 0x20) == 'e') {
    std::size_t j = i + 1;
    if (j < text.size() && (text[j] == '+' || text[j] == '-')) ++j;
    if (j < text.size() && is_digit(text[j])) {
      for (; j < text.size() && is_digit(text[j]);) ++j;
      i = j;
    }
  }
  return i;
}

std::optional<double> parse_double(std::string_view text) {
  if (text.empty() || number_length(text) != text.size()) return std::nullopt;
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  double value = 0;
  if ((text.front() | 0x20) == 'n')
    value = std::numeric_limits<double>::quiet_NaN();
  else if ((text.front() | 0x20) == 'i')
    value = std::numeric_limits<double>::infinity();
  else
    value = convert(text);
  return negative ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  std::int64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace io

// The shortest digits that read back are unique, their layout is not: it is laid out here as
// ECMAScript does (ECMA-262, Number::toString), so that the page and the command print the same
// text; but zero keeps its sign.
std::string format_double(double value) {
  if (value != value) return "nan";
  if (value > std::numeric_limits<double>::max()) return "inf";
  if (value < -std::numeric_limits<double>::max()) return "-inf";
  char buffer[40];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  std::string_view text(buffer, static_cast<std::size_t>(result.ptr - buffer));
  std::string out;
  if (text.front() == '-') {
    out = "-";
    text.remove_prefix(1);
  }
  if (value == 0) return out.empty() ? "0" : "-0.0";
  const std::size_t e = text.find('e');
  std::string digits(1, text[0]);
  if (e > 2) digits += text.substr(2, e - 2);
  const int count = static_cast<int>(digits.size());
  const int point =
      static_cast<int>(*io::parse_integer(text.substr(e + 1))) + 1;  // digits before it
  if (point > 21 || point < -5) {
    out += digits[0];
    if (count > 1) out.append(".").append(digits, 1, std::string::npos);
    return out + (point > 0 ? "e+" : "e") + std::to_string(point - 1);
  }
  if (point <= 0) return out + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (count <= point)
    return out + digits + std::string(static_cast<std::size_t>(point - count), '0');
  return out + digits.substr(0, static_cast<std::size_t>(point)) + "." +
         digits.substr(static_cast<std::size_t>(point));
}

}  // namespace circumball
