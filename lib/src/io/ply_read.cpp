#include <algorithm>
#include <cstring>
#include <limits>

#include "io/formats.h"
#include "io/lines.h"
#include "io/numbers.h"
#include "io/polygon_soup.h"

// PLY, ASCII and binary in both orders (G. Turk, The PLY Polygon File Format, 1994). Of the
// elements those named vertex (x, y, z), face (vertex_indices) and edge (vertex1, vertex2) are
// read; others, and other properties, are passed over.
namespace circumball::io {
namespace {

enum class Type : std::uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr TypeName kTypes[] = {
    {"char", Type::kInt8},     {"int8", Type::kInt8},     {"uchar", Type::kUint8},
    {"uint8", Type::kUint8},   {"short", Type::kInt16},   {"int16", Type::kInt16},
    {"ushort", Type::kUint16}, {"uint16", Type::kUint16}, {"int", Type::kInt32},
    {"int32", Type::kInt32},   {"uint", Type::kUint32},   {"uint32", Type::kUint32},
    {"float", Type::kFloat},   {"float32", Type::kFloat}, {"double", Type::kDouble},
    {"float64", Type::kDouble}};

std::size_t size_of(Type type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::kFloat;
  bool list = false;
  Type count = Type::kUint8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding : std::uint8_t { kAscii, kLittle, kBig };

/// The bytes after the header, as one number after the other.
class Data {
 public:
  Data(std::string_view bytes, Encoding encoding)
      : bytes_(bytes), encoding_(encoding), lines_(bytes) {
    lines_.next();
  }

  /// The least that a number of this type takes.
  std::size_t least(Type type) const { return encoding_ == Encoding::kAscii ? 2 : size_of(type); }
  std::size_t remaining() const {
    return encoding_ == Encoding::kAscii ? lines_.rest_of_line() + lines_.remaining() + 1
                                         : bytes_.size() - at_;
  }

  bool next(Type type, double* value) {
    if (encoding_ == Encoding::kAscii) {
      if (lines_.at_end_of_line() && !lines_.next()) return false;
      const auto number = parse_double(lines_.word());
      if (number) *value = *number;
      return number.has_value();
    }
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) return false;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t place = encoding_ == Encoding::kBig ? k : size - 1 - k;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + place]);
    }
    at_ += size;
    *value = as_double(type, bits);
    return true;
  }

 private:
  static double as_double(Type type, std::uint64_t bits) {
    switch (type) {
      case Type::kInt8:
        return static_cast<std::int8_t>(bits);
      case Type::kInt16:
        return static_cast<std::int16_t>(bits);
      case Type::kInt32:
        return static_cast<std::int32_t>(bits);
      case Type::kFloat: {
        const auto low = static_cast<std::uint32_t>(bits);
        float value = 0;
        std::memcpy(&value, &low, sizeof value);
        return value;
      }
      case Type::kDouble: {
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      default:
        return static_cast<double>(bits);
    }
  }

  std::string_view bytes_;
  Encoding encoding_;
  std::size_t at_ = 0;
  Lines lines_;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, ReadResult& result) : bytes_(bytes), result_(result) {}

  bool read(PolygonSoup* soup) {
    if (!header()) return false;
    Data data(bytes_, encoding_);
    for (const Element& element : elements_)
      if (element.name == "vertex") vertices_ += element.count;
    for (const Element& element : elements_)
      if (!rows(element, data, soup)) return false;
    return true;
  }

 private:
  bool bad(const char* name, const std::string& message) {
    return fail(result_, name, "line " + std::to_string(line_) + ": " + message);
  }

  /// Cuts the next line off the bytes, as words.
  bool header_line(std::vector<std::string_view>* words) {
    words->clear();
    const std::size_t end = bytes_.find('\n');
    if (end == std::string_view::npos || end > 4096)
      return bad("truncated", "the header has no \"end_header\": add it");
    std::string_view line = bytes_.substr(0, end);
    bytes_.remove_prefix(end + 1);
    ++line_;
    constexpr std::string_view kWhite = " \t\r";
    for (;;) {
      const std::size_t begin = line.find_first_not_of(kWhite);
      if (begin == std::string_view::npos) return true;
      line.remove_prefix(begin);
      const std::string_view word = line.substr(0, line.find_first_of(kWhite));
      words->push_back(word);
      line.remove_prefix(word.size());
    }
  }

  bool type(std::string_view word, Type* type) {
    for (const TypeName& known : kTypes)
      if (known.name == word) {
        *type = known.type;
        return true;
      }
    return bad("syntax", in_quotes(word) + " is no type of a property");
  }

  bool header() {
    std::vector<std::string_view> words;
    if (!header_line(&words)) return false;  // ply
    for (bool formatted = false;;) {
      if (!header_line(&words)) return false;
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header" && formatted) return true;
      if (words[0] == "format" && words.size() >= 2) {
        formatted = true;
        if (words[1] == "binary_little_endian")
          encoding_ = Encoding::kLittle;
        else if (words[1] == "binary_big_endian")
          encoding_ = Encoding::kBig;
        else if (words[1] != "ascii")
          return bad("unsupported", "the format " + in_quotes(words[1]) +
                                        " is not known: use ascii, binary_little_endian or "
                                        "binary_big_endian");
      } else if (words[0] == "element" && words.size() == 3) {
        const auto count = parse_integer(words[2]);
        if (!count || *count < 0 || *count > std::numeric_limits<std::int32_t>::max())
          return bad("syntax", in_quotes(words[2]) + " is no number of elements");
        elements_.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
      } else if (words[0] == "property" && words.size() >= 3 && !elements_.empty()) {
        Property property;
        property.list = words[1] == "list";
        if (property.list && words.size() != 5)
          return bad("syntax", "a list has a type of its length, a type and a name");
        if (property.list && !type(words[2], &property.count)) return false;
        if (!type(words[property.list ? 3 : 1], &property.type)) return false;
        property.name = std::string(words.back());
        elements_.back().properties.push_back(std::move(property));
      } else {
        return bad("syntax", in_quotes(words[0]) + " is not what the header should have here");
      }
    }
  }

  bool truncated(const Element& element, std::size_t row) {
    return fail(result_, "truncated",
                "the data end, or are no numbers, in row " + std::to_string(row + 1) + " of " +
                    std::to_string(element.count) + " of element " + in_quotes(element.name) +
                    ": add the rest, or correct the count");
  }

  bool rows(const Element& element, Data& data, PolygonSoup* soup) {
    if (element.properties.empty() || element.count == 0) return true;
    std::size_t least = 0;
    for (const Property& p : element.properties) least += data.least(p.list ? p.count : p.type);
    if (element.count > data.remaining() / least)
      return fail(result_, "truncated",
                  std::to_string(element.count) + " rows of element " + in_quotes(element.name) +
                      " are promised, more than the " + std::to_string(data.remaining()) +
                      " bytes left can hold: the file is cut off, or the count is wrong");
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face",
               is_edge = element.name == "edge";
    const auto has = [&](std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const Property& p) { return p.name == name && !p.list; });
    };
    const bool has_ends = has("vertex1") && has("vertex2");
    if (is_vertex && !(has("x") && has("y")))
      return fail(result_, "unsupported", "the vertices have no x and y: add them");
    for (std::size_t row = 0; row < element.count; ++row) {
      Point3 at;
      double ends[2] = {-1, -1};
      for (const Property& p : element.properties) {
        double value = 0;
        if (!data.next(p.list ? p.count : p.type, &value)) return truncated(element, row);
        if (p.list) {
          const bool corners = is_face && (p.name == "vertex_indices" || p.name == "vertex_index");
          if (!list(p, value, corners ? soup : nullptr, data)) return truncated(element, row);
        } else if (is_vertex) {
          if (p.name == "x") at.x = value;
          if (p.name == "y") at.y = value;
          if (p.name == "z") at.z = value;
        } else if (is_edge) {
          if (p.name == "vertex1") ends[0] = value;
          if (p.name == "vertex2") ends[1] = value;
        }
      }
      if (is_vertex) soup->vertices.push_back(at);
      if (is_edge && has_ends)
        soup->segments.push_back(
            {index(ends[0], &soup->missing_ends), index(ends[1], &soup->missing_ends)});
      if (is_face && !end_face(soup, row)) return false;
    }
    if (!is_vertex && !is_face && !is_edge)
      warn(result_, "ignored", "the element " + in_quotes(element.name) + " is passed over");
    return true;
  }

  /// A list of `length` numbers: corners of a polygon, or (soup is nullptr) passed over.
  bool list(const Property& p, double length, PolygonSoup* soup, Data& data) {
    if (!(length >= 0) ||
        length * static_cast<double>(data.least(p.type)) > static_cast<double>(data.remaining()))
      return false;
    for (double k = 0; k < length; ++k) {
      double value = 0;
      if (!data.next(p.type, &value)) return false;
      if (soup) soup->corners.push_back(index(value, &soup->missing_corners));
    }
    return true;
  }

  std::uint32_t index(double value, std::vector<std::string>* missing) const {
    const bool fits = value >= 0 && value < 4294967295.0;
    const std::uint32_t number = fits ? static_cast<std::uint32_t>(value) : kNoIndex;
    if (number >= vertices_ && missing->size() < kMaxDefects)
      missing->push_back("there is no vertex " + format_double(value) + ": the file has " +
                         std::to_string(vertices_) + ", numbered from 0");
    return number;
  }

  /// A polygon of two corners is a line, of one it says nothing.
  bool end_face(PolygonSoup* soup, std::size_t row) {
    const std::size_t first = soup->ends.back(), corners = soup->corners.size() - first;
    if (corners >= 3) {
      soup->end_polygon();
      return true;
    }
    if (corners != 2)
      return fail(result_, "syntax",
                  "face " + std::to_string(row) + " has " + std::to_string(corners) +
                      " corners: it should have 3 at least, in \"vertex_indices\"");
    soup->segments.push_back({soup->corners[first], soup->corners[first + 1]});
    soup->corners.resize(first);
    return true;
  }

  std::string_view bytes_;
  ReadResult& result_;
  Encoding encoding_ = Encoding::kAscii;
  std::vector<Element> elements_;
  std::size_t line_ = 0, vertices_ = 0;
};

}  // namespace

void read_ply(std::string_view bytes, const ReadOptions& options, ReadResult& result) {
  result.format = "ply";
  PolygonSoup soup;
  if (!PlyReader(bytes, result).read(&soup)) return;
  if (soup.vertices.empty()) {
    fail(result, "empty", "the PLY file has no vertices: add an element \"vertex\"");
    return;
  }
  take_soup(std::move(soup), options, result);
}

}  // namespace circumball::io
