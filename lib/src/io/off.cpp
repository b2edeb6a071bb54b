#include "io/formats.h"
#include "io/lines.h"
#include "io/mesh_parts.h"
#include "io/numbers.h"
#include "io/polygon_soup.h"

// Geomview's OFF (http://www.geomview.org/docs/html/OFF.html), without colors, normals or further
// coordinates.
namespace circumball::io {

void read_off(std::string_view bytes, const ReadOptions& options, ReadResult& result) {
  result.format = "off";
  Lines lines(bytes);
  lines.next();
  lines.word();  // OFF; the counts follow on this line or on the next
  const auto bad = [&](const char* name, const std::string& message) {
    fail_at(result, lines.number(), name, message);
  };
  if (lines.at_end_of_line() && !lines.next())
    return bad("truncated", "the file ends before its counts: add vertices, faces and edges");
  const auto vertices = parse_integer(lines.word());
  const auto faces = parse_integer(lines.word());
  if (!vertices || !faces || *vertices < 0 || *faces < 0)
    return bad("syntax", "the numbers of vertices and faces are wanted here");
  // A vertex takes "0 0 0" and the end of the line, a face "1 0" and the end.
  const auto room = static_cast<std::int64_t>(lines.remaining()) + 1;
  if (*vertices > room / 6 || *faces > room / 4 || 6 * *vertices + 4 * *faces > room)
    return bad("truncated", std::to_string(*vertices) + " vertices and " + std::to_string(*faces) +
                                " faces are promised, which do not fit in the " +
                                std::to_string(lines.remaining()) +
                                " bytes left: the file is cut off, or a count is wrong");
  PolygonSoup soup;
  soup.vertices.reserve(static_cast<std::size_t>(*vertices));
  for (std::int64_t i = 0; i < *vertices; ++i) {
    Point3 p;
    if (!lines.next())
      return bad("truncated", "the file ends after " + std::to_string(i) + " of " +
                                  std::to_string(*vertices) + " vertices: add the rest");
    for (double* coordinate : {&p.x, &p.y, &p.z}) {
      const std::string_view word = lines.word();
      const auto value = parse_double(word);
      if (!value) return bad("syntax", "three coordinates are wanted, not " + in_quotes(word));
      *coordinate = *value;
    }
    soup.vertices.push_back(p);
  }
  for (std::int64_t i = 0; i < *faces; ++i) {
    if (!lines.next())
      return bad("truncated", "the file ends after " + std::to_string(i) + " of " +
                                  std::to_string(*faces) + " faces: add the rest");
    const auto corners = parse_integer(lines.word());
    if (!corners || *corners < 2)
      return bad("syntax", "a face begins with the number of its corners, 2 at least");
    std::uint32_t last = 0;
    for (std::int64_t k = 0; k < *corners; ++k) {
      const std::string_view word = lines.word();
      const auto v = parse_saturated_integer(word);
      if (!v)
        return bad("syntax", "corner " + std::to_string(k + 1) + " of " + std::to_string(*corners) +
                                 " should be a vertex number, not " + in_quotes(word));
      auto& missing = *corners > 2 ? soup.missing_corners : soup.missing_ends;
      if ((*v < 0 || *v >= *vertices) && missing.size() < kMaxDefects)
        missing.push_back("line " + std::to_string(lines.number()) + ": there is no vertex " +
                          std::to_string(*v) + ": the file has " + std::to_string(*vertices) +
                          ", numbered from 0");
      const std::uint32_t corner = kept_index(*v);
      if (*corners > 2)
        soup.corners.push_back(corner);
      else if (k == 1)  // a polygon of two corners is a line
        soup.segments.push_back({last, corner});
      last = corner;
    }
    if (*corners > 2) soup.end_polygon();
  }
  take_soup(std::move(soup), options, result);
}

namespace {

template <class Polygon>
std::string polygon(const Polygon& corners) {
  std::string out = std::to_string(corners.size());
  for (const std::uint32_t v : corners) out += " " + std::to_string(v);
  return out + "\n";
}

std::string head(const std::vector<Point3>& vertices, std::size_t polygons) {
  std::string out =
      "OFF\n" + std::to_string(vertices.size()) + " " + std::to_string(polygons) + " 0\n";
  for (const Point3& p : vertices) out += coordinates(p) + "\n";
  return out;
}

}  // namespace

std::string write_off_mesh(const Mesh& mesh) {
  const MeshSurface surface = surface_of(mesh);
  std::string out = head(surface.vertices, surface.triangles.size());
  for (const auto& t : surface.triangles) out += polygon(t);
  return out;
}

std::string write_off_complex(const Complex& complex, std::string* error) {
  if (!only_polygons(complex, error)) return {};
  const std::vector<std::uint32_t> lines = segments_of_no_face(complex);
  std::string out = head(complex.vertices, complex.faces.size() + lines.size());
  for (const Face& face : complex.faces) out += polygon(face.loops[0]);
  for (const std::uint32_t s : lines) out += polygon(complex.segments[s]);
  return out;
}

}  // namespace circumball::io
