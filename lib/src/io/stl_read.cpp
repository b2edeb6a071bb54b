#include <cstring>

#include "io/formats.h"
#include "io/lines.h"
#include "io/numbers.h"
#include "io/polygon_soup.h"

// STL, ASCII and binary (3D Systems, StereoLithography Interface Specification, 1989): triangles
// that repeat their corners. Normals and attributes are passed over.
namespace circumball::io {
namespace {

constexpr std::size_t kHeader = 80, kTriangle = 50;

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

double single(const char* bytes) {
  const std::uint32_t bits = little_endian(bytes);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void add_corner(const Point3& p, PolygonSoup* soup) {
  soup->corners.push_back(static_cast<std::uint32_t>(soup->vertices.size()));
  soup->vertices.push_back(p);
}

void read_binary(std::string_view bytes, PolygonSoup* soup) {
  const std::size_t count = little_endian(bytes.data() + kHeader);
  soup->vertices.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* const t = bytes.data() + kHeader + 4 + i * kTriangle;
    for (int k = 1; k <= 3; ++k)  // the normal comes first
      add_corner({single(t + 12 * k), single(t + 12 * k + 4), single(t + 12 * k + 8)}, soup);
    soup->end_polygon();
  }
}

std::string lower(std::string_view word) {
  std::string out(word);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return out;
}

/// Reads "vertex x y z" in "outer loop … endloop", whatever stands around it.
bool read_ascii(std::string_view bytes, PolygonSoup* soup, ReadResult& result) {
  bool in_loop = false, ended = false;
  for (Lines lines(bytes); lines.next();)
    while (!lines.at_end_of_line()) {
      const std::string_view word = lines.word();
      const std::string keyword = lower(word.substr(0, 16));
      const auto bad = [&](const std::string& message) {
        return fail_at(result, lines.number(), "syntax", message);
      };
      if (keyword == "solid" || keyword == "endsolid") {
        ended = keyword == "endsolid";
        break;  // a name follows
      }
      if (keyword == "vertex") {
        Point3 p;
        for (double* coordinate : {&p.x, &p.y, &p.z}) {
          const std::string_view text = lines.word();
          const auto value = parse_double(text);
          if (!value) return bad("three coordinates are wanted, not " + in_quotes(text));
          *coordinate = *value;
        }
        if (!in_loop) return bad("a vertex stands outside of a loop: begin it with \"outer loop\"");
        add_corner(p, soup);
      } else if (keyword == "loop") {
        if (in_loop) return bad("a loop begins in a loop: end the first one with \"endloop\"");
        in_loop = true;
      } else if (keyword == "endloop") {
        const std::size_t corners = soup->corners.size() - soup->ends.back();
        if (!in_loop || corners < 3)
          return bad("the loop has " + std::to_string(corners) + " vertices: it should have 3");
        in_loop = false;
        soup->end_polygon();
      } else if (keyword == "facet") {
        if (lower(lines.word()) != "normal") return bad("\"normal\" should follow \"facet\"");
        for (int k = 0; k < 3; ++k) lines.word();  // not needed: some programs write zeros or nan
      } else if (keyword != "outer" && keyword != "endfacet") {
        return bad(in_quotes(word) + " is no word of an STL file");
      }
    }
  if (in_loop || !ended)
    return fail(result, "truncated", "the file ends before \"endsolid\": add the rest");
  return true;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHeader + 4 + kTriangle) return false;
  const std::size_t count = little_endian(bytes.data() + kHeader);
  const std::size_t needed = kHeader + 4 + kTriangle * count;
  // Text has no byte below 9, so that its "count" is more than any file holds.
  return count > 0 && bytes.size() >= needed &&
         bytes.substr(kHeader, 4).find_first_of(std::string_view("\0\1\2\3\4\5\6\7\10", 9)) !=
             std::string_view::npos;
}

void read_stl(std::string_view bytes, const ReadOptions& options, ReadResult& result) {
  result.format = "stl";
  PolygonSoup soup;
  if (is_binary_stl(bytes))
    read_binary(bytes, &soup);
  else if (!read_ascii(bytes, &soup, result))
    return;
  if (soup.polygon_count() == 0) {
    fail(result, "empty", "the STL file has no triangles: add some");
    return;
  }
  ReadOptions own = options;
  own.weld = options.weld.value_or(0);
  take_soup(std::move(soup), own, result);
}

}  // namespace circumball::io
