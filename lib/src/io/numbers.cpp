#include "io/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include "circumball/io.h"

// libc++ has no from_chars for doubles before version 20, and that of Emscripten 3.1 no to_chars
// either. There musl's strtod rounds correctly and knows no other decimal point; fmt finds the same
// shortest digits (Jeon's Dragonbox).
#ifndef __cpp_lib_to_chars
#define FMT_HEADER_ONLY
#include <fmt/format.h>
#endif

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
#ifndef __cpp_lib_to_chars
  (void)is_large;
  return std::strtod(std::string(text).c_str(),
                     nullptr);  // the grammar leaves it nothing but a decimal
#else
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range)
    return is_large(text) ? std::numeric_limits<double>::infinity() : 0.0;
  return value;
#endif
}

/// The integer that is all of `text`, or the nearest of 64 bits.
std::optional<std::int64_t> integer(std::string_view text, bool* saturated) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  std::int64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ptr != text.data() + text.size()) return std::nullopt;
  *saturated = result.ec == std::errc::result_out_of_range;
  if (*saturated)
    return text.front() == '-' ? std::numeric_limits<std::int64_t>::min()
                               : std::numeric_limits<std::int64_t>::max();
  if (result.ec != std::errc()) return std::nullopt;
  return value;
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
  bool saturated = false;
  const auto value = integer(text, &saturated);
  return saturated ? std::nullopt : value;
}

std::optional<std::int64_t> parse_saturated_integer(std::string_view text) {
  bool saturated = false;
  return integer(text, &saturated);
}

Decimal shortest_decimal(double value) {
  char buffer[64];
#ifndef __cpp_lib_to_chars
  char* const end = fmt::format_to(buffer, "{}", value);
#else
  char* const end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
#endif
  // Whatever the layout: digits with a point somewhere, and perhaps an exponent.
  std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  if (text.front() == '-') text.remove_prefix(1);
  const std::size_t e = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.substr(0, e).find('.'), e);
  Decimal decimal;
  decimal.exponent = static_cast<int>(point);
  if (e < text.size()) decimal.exponent += static_cast<int>(*parse_integer(text.substr(e + 1)));
  for (const char c : text.substr(0, e)) {
    if (c == '.') continue;
    if (c == '0' && decimal.digits.empty())
      --decimal.exponent;
    else
      decimal.digits += c;
  }
  decimal.digits.resize(decimal.digits.find_last_not_of('0') + 1);
  return decimal;
}

}  // namespace io

// The shortest digits that read back are unique, their layout is not: it is laid out here as
// ECMAScript does (ECMA-262, Number::toString), so that the page and the command print the same
// text; but zero keeps its sign.
std::string format_double(double value) {
  if (value != value) return "nan";
  if (value > std::numeric_limits<double>::max()) return "inf";
  if (value < -std::numeric_limits<double>::max()) return "-inf";
  std::string out = value < 0 ? "-" : "";
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  const auto [digits, point] = io::shortest_decimal(value);
  const int count = static_cast<int>(digits.size());
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
