#include "io/json_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/numbers.h"

namespace circumball::io {
namespace {

/// Bytes of a JSON document that is read: a parsed one takes up to about thirty times as much
/// memory.
constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 28;

/// Words for numbers that no double can hold.
constexpr const char *kInfinite = "inf", *kMinusInfinite = "-inf";

/// Walks over a document without building it: finds the error, or nesting that is too deep, and
/// where.
class Scout : public nlohmann::json_sax<Json> {
 public:
  bool too_deep = false;
  bool overflow = false, ended = false;
  std::size_t position = 0;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return deeper(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return depth_-- > 0; }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_array() override { return depth_-- > 0; }
  bool parse_error(std::size_t at, const std::string&, const Json::exception& error) override {
    position = at;
    // The library tells the end of the input from other surprises in words only.
    const std::string_view what = error.what();
    ended = what.find("unexpected end of input") != std::string_view::npos ||
            what.find("missing closing quote") != std::string_view::npos;
    overflow = error.id == 406;  // out_of_range.406: a number that no double can hold
    return false;
  }

 private:
  bool deeper() {
    too_deep = ++depth_ > kMaxDepth;
    return !too_deep;
  }
  std::size_t depth_ = 0;
};

/// The document with its numbers that no double can hold replaced by words: the parser ends at
/// them, although the rest is worth reading. Such a number has as many bytes as its word in quotes
/// at least ("1e309"), so that every place stays where it is.
std::string without_overflow(std::string_view bytes) {
  std::string out(bytes);
  bool in_string = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (in_string) {
      if (out[i] == '\\')
        ++i;
      else
        in_string = out[i] != '"';
      continue;
    }
    in_string = out[i] == '"';
    const std::size_t digit = i + (out[i] == '-');
    if (digit >= out.size() || out[digit] < '0' || out[digit] > '9') continue;
    const std::size_t size = number_length(bytes.substr(i));
    const double value = parse_double(bytes.substr(i, size)).value_or(0);
    if (std::isinf(value)) {
      const std::string word = "\"" + std::string(value < 0 ? kMinusInfinite : kInfinite) + "\"";
      out.replace(i, size, word + std::string(size - word.size(), ' '));
    }
    i += size - 1;
  }
  return out;
}

std::size_t line_of(std::string_view bytes, std::size_t at) {
  return static_cast<std::size_t>(
             std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
         1;
}

}  // namespace

bool parse_json(std::string_view bytes, Json* json, ReadResult& result) {
  if (bytes.size() > kMaxJsonBytes)
    return fail(result, "too-large",
                "the file has " + std::to_string(bytes.size()) + " bytes, more than the " +
                    std::to_string(kMaxJsonBytes) + " of JSON that are read: use .poly or .ele");
  Scout scout;
  bool well_formed = Json::sax_parse(bytes.begin(), bytes.end(), &scout);
  std::string replaced;
  if (scout.overflow) {
    const std::size_t at = std::min(scout.position, bytes.size());
    warn(result, "not-finite",
         "line " + std::to_string(line_of(bytes, at)) + ": the number near byte " +
             std::to_string(at) + " is too large for a double: make it smaller");
    replaced = without_overflow(bytes);
    bytes = replaced;
    scout = Scout();
    well_formed = Json::sax_parse(bytes.begin(), bytes.end(), &scout);
  }
  if (!well_formed) {
    if (scout.too_deep)
      return fail(
          result, "too-large",
          "the JSON nests deeper than " + std::to_string(kMaxDepth) + " levels: flatten it");
    const std::size_t at = std::min(scout.position, bytes.size());
    return fail_at(result, line_of(bytes, at), scout.ended ? "truncated" : "syntax",
                   scout.ended ? "the JSON ends in the middle: the file is cut off"
                               : "the JSON is not well-formed near byte " + std::to_string(at) +
                                     ": correct it there");
  }
  *json = Json::parse(bytes.begin(), bytes.end(), nullptr, /*allow_exceptions=*/false);
  return true;
}

std::string JsonValue::describe() const {
  switch (json_->type()) {
    case Json::value_t::array:
      return "an array of " + std::to_string(json_->size());
    case Json::value_t::object:
      return "an object";
    case Json::value_t::string:
      return in_quotes(*json_->get_ptr<const std::string*>());
    case Json::value_t::null:
      return "null";
    case Json::value_t::boolean:
      return *json_->get_ptr<const bool*>() ? "true" : "false";
    default: {
      double value = 0;
      number(&value);
      return format_double(value);
    }
  }
}

bool JsonValue::number(double* value) const {
  if (const auto* d = json_->get_ptr<const double*>())
    *value = *d;
  else if (const auto* u = json_->get_ptr<const std::uint64_t*>())
    *value = static_cast<double>(*u);
  else if (const auto* i = json_->get_ptr<const std::int64_t*>())
    *value = static_cast<double>(*i);
  else if (json_->is_null())
    *value = std::numeric_limits<double>::quiet_NaN();
  else if (*json_ == kInfinite)
    *value = std::numeric_limits<double>::infinity();
  else if (*json_ == kMinusInfinite)
    *value = -std::numeric_limits<double>::infinity();
  else
    return wrong_type("a number");
  return true;
}

bool JsonValue::integer(std::int64_t* value) const {
  if (const auto* u = json_->get_ptr<const std::uint64_t*>()) {
    if (*u > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
      return fail("too-large", "the integer does not fit in 64 bits: make it smaller");
    *value = static_cast<std::int64_t>(*u);
    return true;
  }
  if (const auto* i = json_->get_ptr<const std::int64_t*>()) {
    *value = *i;
    return true;
  }
  return wrong_type("an integer");
}

bool JsonValue::marker(std::int32_t* value) const {
  std::int64_t wide = 0;
  if (!integer(&wide)) return false;
  if (wide < std::numeric_limits<std::int32_t>::min() ||
      wide > std::numeric_limits<std::int32_t>::max())
    return fail("too-large", "the marker does not fit in 32 bits: use a smaller one");
  *value = static_cast<std::int32_t>(wide);
  return true;
}

bool JsonValue::index(std::size_t count, const char* of, std::uint32_t* value) const {
  std::int64_t wide = 0;
  if (!integer(&wide)) return false;
  if (wide < 0 || wide >= static_cast<std::int64_t>(count))
    return fail("index-out-of-range", std::to_string(wide) + " is not one of the " +
                                          std::to_string(count) + " " + of +
                                          ", which are numbered from 0: correct it");
  *value = static_cast<std::uint32_t>(wide);
  return true;
}

bool JsonValue::any_index(std::uint32_t* value) const {
  if (const auto* u = json_->get_ptr<const std::uint64_t*>()) {
    *value = *u > kNoIndex ? kNoIndex : static_cast<std::uint32_t>(*u);
    return true;
  }
  std::int64_t wide = 0;
  if (!integer(&wide)) return false;
  *value = kept_index(wide);
  return true;
}

bool JsonValue::point(int dimension, Point3* value) const {
  if (!is_array_of(static_cast<std::size_t>(dimension)))
    return wrong_type(dimension == 2 ? "[x, y]" : "[x, y, z]");
  double* const coordinates[] = {&value->x, &value->y, &value->z};
  return for_each([&](const JsonValue& v, std::size_t i) { return v.number(coordinates[i]); });
}

}  // namespace circumball::io
