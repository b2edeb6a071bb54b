#ifndef CIRCUMBALL_IO_JSON_VALUE_H_
#define CIRCUMBALL_IO_JSON_VALUE_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/formats.h"

/// Typed access to parsed JSON where every surprise is a defect that names the path
/// ("segments[3][1]").
namespace circumball::io {

using Json = nlohmann::json;

/// Parses `bytes`. Nesting, size and syntax are checked before anything is built; false after a
/// defect. A number that no double can hold becomes the text "inf" or "-inf", and a warning names
/// its line.
bool parse_json(std::string_view bytes, Json* json, ReadResult& result);

/// A value inside a document, with its path for messages.
class JsonValue {
 public:
  JsonValue(const Json& json, std::string path, ReadResult& result)
      : json_(&json), path_(std::move(path)), result_(&result) {}

  const Json& json() const { return *json_; }
  /// "segments[3][1]"; "the document" for the whole.
  std::string path() const {
    return parent_ ? (parent_->parent_ || !parent_->path_.empty() ? parent_->path() : "") + "[" +
                         std::to_string(index_) + "]"
           : path_.empty() ? "the document"
                           : path_;
  }

  /// "path: message", under `name`. Returns false.
  bool fail(const char* name, const std::string& message) const {
    return io::fail(*result_, name, path() + ": " + message);
  }
  /// A defect: it should be `wanted`. Returns false.
  bool wrong_type(const char* wanted) const {
    return fail("type",
                std::string("should be ") + wanted + ", but is " + describe() + ": correct it");
  }

  bool is_array_of(std::size_t size) const { return json_->is_array() && json_->size() == size; }

  /// Calls f(element, index) for each element of an array until it returns false. The path is made
  /// on demand only.
  template <class F>
  bool for_each(F f) const {
    if (!json_->is_array()) return wrong_type("an array");
    std::size_t i = 0;
    for (const Json& element : *json_) {
      if (!f(JsonValue(element, *this, i), i)) return false;
      ++i;
    }
    return true;
  }

  /// Member `key` of an object; a null value counts as missing.
  const Json* find(const char* key) const {
    if (!json_->is_object()) return nullptr;
    const auto it = json_->find(key);
    return it == json_->end() || it->is_null() ? nullptr : &*it;
  }
  JsonValue member(const Json& json, const char* key) const {
    const bool root = !parent_ && path_.empty();
    return JsonValue(json, root ? key : path() + "." + key, *result_);
  }

  /// A number; null stands for one that is not finite (JSON has no other word for it), "inf" and
  /// "-inf" for one that is too large.
  bool number(double* value) const;
  bool integer(std::int64_t* value) const;
  bool marker(std::int32_t* value) const;
  /// An index below `count` into `of` ("vertices").
  bool index(std::size_t count, const char* of, std::uint32_t* value) const;
  /// An index that may be out of range: see kept_index.
  bool any_index(std::uint32_t* value) const;
  /// A point with `dimension` coordinates.
  bool point(int dimension, Point3* value) const;

 private:
  JsonValue(const Json& json, const JsonValue& parent, std::size_t i)
      : json_(&json), parent_(&parent), index_(i), result_(parent.result_) {}
  std::string describe() const;

  const Json* json_;
  std::string path_;
  const JsonValue* parent_ = nullptr;
  std::size_t index_ = 0;
  ReadResult* result_;
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_JSON_VALUE_H_
