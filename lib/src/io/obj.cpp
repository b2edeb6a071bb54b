#include <limits>

#include "io/formats.h"
#include "io/lines.h"
#include "io/numbers.h"
#include "io/polygon_soup.h"

// Wavefront OBJ (Advanced Visualizer, appendix B1): v, l, f and p; groups, materials, normals and
// textures are passed over.
namespace circumball::io {
namespace {

/// Reads "x y [z]"; z is 0 where it is missing.
bool read_vertex(Lines& lines, PolygonSoup* soup, ReadResult& result) {
  Point3 point;
  double* const coordinates[] = {&point.x, &point.y, &point.z};
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = lines.word();
    if (word.empty() && k == 2) break;
    const auto value = parse_double(word);
    if (!value)
      return fail_at(result, lines.number(), "syntax",
                     word.empty() ? "the vertex has too few coordinates: give x and y"
                                  : in_quotes(word) + " is not a number: a coordinate is wanted");
    *coordinates[k] = *value;
  }
  soup->vertices.push_back(point);
  return true;
}

/// Reads the index "i", "i/j", "i//k" or "i/j/k": from 1, or from -1 backwards from the last vertex
/// so far. One that is out of range is kept so; `missing` tells of it.
bool read_index(Lines& lines, std::size_t so_far, std::size_t vertices, std::uint32_t* index,
                std::vector<std::string>* missing, ReadResult& result) {
  const std::string_view word = lines.word();
  const auto number = parse_saturated_integer(word.substr(0, word.find('/')));
  if (!number)
    return fail_at(result, lines.number(), "syntax",
                   in_quotes(word) + " is not an index: a vertex number is wanted");
  const std::int64_t i = *number < 0 ? static_cast<std::int64_t>(so_far) + *number : *number - 1;
  *index = kept_index(i);
  if (*index >= vertices && missing->size() < kMaxDefects)
    missing->push_back("line " + std::to_string(lines.number()) + ": there is no vertex " +
                       std::to_string(*number) + ": the file has " + std::to_string(vertices) +
                       ", numbered from 1, or from -1 backwards");
  return true;
}

}  // namespace

void read_obj(std::string_view bytes, const ReadOptions& options, ReadResult& result) {
  result.format = "obj";
  PolygonSoup soup;
  for (Lines lines(bytes); lines.next();)
    if (lines.word() == "v" && !read_vertex(lines, &soup, result)) return;
  std::size_t so_far = 0;
  for (Lines lines(bytes); lines.next();) {
    const std::string_view keyword = lines.word();
    if (keyword == "v") ++so_far;
    if (keyword != "l" && keyword != "f") continue;
    const std::size_t first = soup.corners.size();
    std::uint32_t index = kNoIndex, last = kNoIndex;
    std::size_t count = 0;
    for (; !lines.at_end_of_line(); ++count, last = index) {
      auto* const missing = keyword == "f" ? &soup.missing_corners : &soup.missing_ends;
      if (!read_index(lines, so_far, soup.vertices.size(), &index, missing, result)) return;
      if (keyword == "f")
        soup.corners.push_back(index);
      else if (count > 0)
        soup.segments.push_back({last, index});
    }
    if (keyword == "f") {
      if (soup.corners.size() - first < 3) {
        fail_at(result, lines.number(), "syntax", "the face has fewer than 3 corners: add them");
        return;
      }
      soup.end_polygon();
    } else if (count < 2) {
      fail_at(result, lines.number(), "syntax", "the line has fewer than 2 vertices: add them");
      return;
    }
  }
  if (!result.ok()) return;
  if (soup.vertices.empty()) {
    fail(result, "empty", "the OBJ file has no vertices: add lines \"v x y 0\"");
    return;
  }
  take_soup(std::move(soup), options, result);
}

std::string write_obj_complex(const Complex& complex) {
  std::string out;
  for (const Point3& p : complex.vertices)
    out += "v " + format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z) + "\n";
  for (const auto& s : complex.segments)
    out += "l " + std::to_string(std::size_t{s[0]} + 1) + " " +
           std::to_string(std::size_t{s[1]} + 1) + "\n";
  return out;
}

std::string write_obj_mesh(const Mesh& mesh) {
  std::string out;
  for (const Point3& p : mesh.vertices)
    out += "v " + format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z) + "\n";
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    out += "f";
    for (int k = 0; k < 3; ++k) out += " " + std::to_string(std::size_t{mesh.cell(i)[k]} + 1);
    out += "\n";
  }
  for (const MeshEdge& e : mesh.edges)
    out += "l " + std::to_string(std::size_t{e.a} + 1) + " " +
           std::to_string(std::size_t{e.b} + 1) + "\n";
  return out;
}

}  // namespace circumball::io
