#include <algorithm>

#include "io/formats.h"
#include "io/lines.h"
#include "io/numbers.h"

namespace circumball {
namespace io {

bool fail(ReadResult& result, const char* name, std::string message) {
  if (result.defects.size() < kMaxDefects)
    result.defects.push_back({name, {}, {}, std::move(message), false});
  return false;
}

bool fail_at(ReadResult& result, std::size_t line, const char* name, const std::string& message) {
  return fail(result, name, "line " + std::to_string(line) + ": " + message);
}

void warn(ReadResult& result, const char* name, std::string message) {
  if (result.defects.size() < kMaxDefects)
    result.defects.push_back({name, {}, {}, std::move(message), true});
}

std::string stem(const std::string& name) {
  const std::size_t slash = name.find_last_of("/\\");
  const std::size_t dot = name.find_last_of('.');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return name;
  return name.substr(0, dot);
}

std::string extension_of(const std::string& name) {
  std::string extension = name.substr(stem(name).size());
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return extension;
}

std::string in_quotes(std::string_view token) {
  std::string out = "\"";
  for (char c : token.substr(0, 32)) out += c >= 0x20 && c < 0x7f && c != '"' ? c : '?';
  return out + (token.size() > 32 ? "…\"" : "\"");
}

bool in_exact_range(const Point3& p) {
  for (const double x : {p.x, p.y, p.z}) {
    const double size = x < 0 ? -x : x;
    if (!(size == 0 || (size >= 1e-45 && size <= 1e55))) return false;
  }
  return true;
}

namespace {

bool is_white(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

void refuse_unknown(ReadResult& result) {
  fail(result, "unknown-format",
       "the content is none of the formats that can be read: give Triangle's or TetGen's .poly, "
       ".smesh, .node or .ele, OBJ, OFF, PLY, STL, SVG, GeoJSON or the project's own JSON");
}

/// Finds out what the bytes are, and reads them.
void read_any(std::string_view bytes, const std::string& name, const Sibling& sibling,
              const ReadOptions& options, ReadResult& result) {
  if (bytes.size() > kMaxBytes) {
    fail(result, "too-large",
         "the file has " + std::to_string(bytes.size()) + " bytes, more than the " +
             std::to_string(kMaxBytes) + " that are read: split it");
    return;
  }
  if (bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r")
    return read_ply(bytes, options, result);
  if (is_binary_stl(bytes)) return read_stl(bytes, options, result);
  if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3);  // byte order mark
  std::string_view body = bytes;
  while (!body.empty() && is_white(body.front())) body.remove_prefix(1);
  if (body.empty()) {
    fail(result, "empty", "the file is empty: write a complex into it");
    return;
  }
  if (bytes.find('\0') != std::string_view::npos) return refuse_unknown(result);  // binary
  if (body.front() == '{') return read_json(bytes, result);
  if (body.front() == '<') return read_svg(bytes, result);
  Lines lines(bytes);
  if (!lines.next()) {
    fail(result, "empty", "the file holds comments only: write a complex into it");
    return;
  }
  const std::string_view first = lines.word();
  if (number_length(first) == first.size())
    return is_tetgen(bytes, name, sibling) ? read_tetgen(bytes, name, sibling, result)
                                           : read_triangle(bytes, name, sibling, result);
  if (first == "OFF" || first == "COFF" || first == "NOFF") return read_off(bytes, options, result);
  if (first == "solid") return read_stl(bytes, options, result);
  // The words that an OBJ file may start with (Wavefront Advanced Visualizer, appendix B1).
  static constexpr std::string_view kWords[] = {"v", "vt", "vn", "vp", "o",      "g",
                                                "s", "l",  "f",  "p",  "mtllib", "usemtl"};
  if (std::find(std::begin(kWords), std::end(kWords), first) != std::end(kWords))
    return read_obj(bytes, options, result);
  refuse_unknown(result);
}

}  // namespace
}  // namespace io

ReadResult read(std::string_view bytes, const std::string& name, const Sibling& sibling,
                const ReadOptions& options) {
  ReadResult result;
  io::read_any(bytes, name, sibling, options, result);
  if (!result.ok()) {  // half a complex may have indices that lead nowhere: nobody gets to see it
    result.complex = Complex();
    result.mesh.reset();
  }
  return result;
}

}  // namespace circumball
