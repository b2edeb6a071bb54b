#include "io/polygon_soup.h"

#include <algorithm>
#include <array>

#include "io/coplanar_faces.h"
#include "io/formats.h"
#include "io/segment_table.h"

namespace circumball::io {
namespace {

using Side = std::array<std::uint32_t, 2>;

/// All sides of the polygons, in order, with their ends as they run.
std::vector<Side> sides(const PolygonSoup& soup) {
  std::vector<Side> out;
  out.reserve(soup.corners.size());
  for (std::size_t i = 0; i < soup.polygon_count(); ++i) {
    const std::uint32_t first = soup.ends[i], last = soup.ends[i + 1];
    for (std::uint32_t k = first; k < last; ++k)
      out.push_back({soup.corners[k], soup.corners[k + 1 < last ? k + 1 : first]});
  }
  return out;
}

/// The sides that occur once (`boundary`), or all of them once; in the order of their first
/// occurrence. Those with an end that is none of the `vertices` are all kept: what they were meant
/// to be is not known.
std::vector<Side> distinct(const std::vector<Side>& all, std::size_t vertices, bool boundary) {
  struct Entry {
    Side key;
    std::size_t place;
  };
  std::vector<Entry> entries;
  entries.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    entries.push_back({{std::min(all[i][0], all[i][1]), std::max(all[i][0], all[i][1])}, i});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.place < b.place;
  });
  std::vector<std::size_t> places;
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    for (j = i; j < entries.size() && entries[j].key == entries[i].key;) ++j;
    if (entries[i].key[1] >= vertices)
      for (std::size_t k = i; k < j; ++k) places.push_back(entries[k].place);
    else if (entries[i].key[0] != entries[i].key[1] && (!boundary || j == i + 1))
      places.push_back(entries[i].place);
  }
  std::sort(places.begin(), places.end());
  std::vector<Side> out;
  out.reserve(places.size());
  for (const std::size_t place : places) out.push_back(all[place]);
  return out;
}

/// Polygons of space are faces.
void take_faces(const PolygonSoup& soup, bool merge, ReadResult& result) {
  Complex& complex = result.complex;
  if (merge && soup.missing_corners.empty()) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(soup.polygon_count());
    for (std::size_t i = 0; i + 2 < soup.corners.size(); i += 3)
      triangles.push_back({soup.corners[i], soup.corners[i + 1], soup.corners[i + 2]});
    add_merged_faces(triangles, &complex);
    if (complex.faces.size() < triangles.size())
      warn(result, "merged",
           std::to_string(triangles.size()) + " triangles make " +
               std::to_string(complex.faces.size()) +
               " faces, since neighbors that are exactly coplanar are one face: see --no-merge to "
               "keep each");
    return;
  }
  for (std::size_t i = 0; i < soup.polygon_count(); ++i) {
    Face face;
    face.loops.emplace_back(soup.corners.begin() + soup.ends[i],
                            soup.corners.begin() + soup.ends[i + 1]);
    complex.faces.push_back(std::move(face));
  }
  complex = with_sides(complex);
}

}  // namespace

void take_soup(PolygonSoup&& soup, const ReadOptions& options, ReadResult& result) {
  if (options.weld) weld(*options.weld, &soup, result);
  Complex& complex = result.complex;
  complex.hole_rule = HoleRule::kParity;
  // Not z != 0: a coordinate that is not a number must not make a complex of space.
  const bool plane = std::none_of(soup.vertices.begin(), soup.vertices.end(),
                                  [](const Point3& p) { return p.z < 0 || p.z > 0; });
  complex.dimension = plane ? 2 : 3;
  complex.vertices = std::move(soup.vertices);
  const std::size_t n = complex.vertices.size();
  complex.segments = distinct(soup.segments, n, false);
  bool triangles = soup.polygon_count() > 0;
  for (std::size_t i = 0; i < soup.polygon_count(); ++i)
    triangles = triangles && soup.ends[i + 1] - soup.ends[i] == 3;
  if (plane && triangles && !soup.missing_corners.empty()) {
    for (const std::string& message : soup.missing_corners)
      fail(result, "index-out-of-range", message);
    return;
  }
  for (const auto* missing : {&soup.missing_ends, &soup.missing_corners})
    if (!missing->empty()) {
      warn(result, "index-out-of-range", missing->front());
      break;
    }
  if (!plane) return take_faces(soup, triangles && options.merge_coplanar, result);
  for (Point3& p : complex.vertices) {
    if (p.z != 0) p.x = p.z;  // not a number: the plane has no other place to say so
    p.z = 0;
  }
  if (soup.polygon_count() == 0) return;
  if (!triangles) {
    std::vector<Side> all = std::move(complex.segments);
    const std::vector<Side> more = sides(soup);
    all.insert(all.end(), more.begin(), more.end());
    complex.segments = distinct(all, n, false);
    return;
  }
  result.mesh.emplace();
  Mesh& mesh = *result.mesh;
  mesh.vertices = complex.vertices;
  mesh.cells = std::move(soup.corners);
  if (complex.segments.empty()) {
    PolygonSoup cells;
    cells.corners = mesh.cells;
    cells.ends = std::move(soup.ends);
    complex.segments = distinct(sides(cells), n, true);
  }
  for (const Side& s : complex.segments)
    if (s[0] < n && s[1] < n) mesh.edges.push_back({s[0], s[1], kNoIndex});
}

}  // namespace circumball::io
