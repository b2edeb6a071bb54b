#include <limits>

#include "io/formats.h"
#include "io/lines.h"
#include "io/mesh_parts.h"
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

namespace {

/// "f 1 2 3" or "l 1 2".
template <class Vertices>
std::string element(const char* keyword, const Vertices& vertices) {
  std::string out = keyword;
  for (const std::uint32_t v : vertices) out += " " + std::to_string(std::size_t{v} + 1);
  return out + "\n";
}

}  // namespace

std::string write_obj_complex(const Complex& complex, std::string* error) {
  if (!only_polygons(complex, error)) return {};
  std::string out;
  for (const Point3& p : complex.vertices) out += "v " + coordinates(p) + "\n";
  for (const Face& face : complex.faces) out += element("f", face.loops[0]);
  for (const std::uint32_t s : segments_of_no_face(complex))
    out += element("l", complex.segments[s]);
  return out;
}

std::string write_obj_mesh(const Mesh& mesh) {
  const MeshSurface surface = surface_of(mesh);
  std::string out;
  for (const Point3& p : surface.vertices) out += "v " + coordinates(p) + "\n";
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::uint32_t face = surface.faces[i];
    if (face != kNoIndex && (i == 0 || face != surface.faces[i - 1]))
      out += "g face_" + std::to_string(face) + "\n";
    out += element("f", surface.triangles[i]);
  }
  for (const MeshEdge& e : surface.edges)
    out += element("l", std::array<std::uint32_t, 2>{e.a, e.b});
  return out;
}

}  // namespace circumball::io
