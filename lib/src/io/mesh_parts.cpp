#include "io/mesh_parts.h"

#include <algorithm>

#include "circumball/io.h"
#include "io/segment_table.h"

namespace circumball::io {
namespace {

/// Facet k of a positive tetrahedron, counter-clockwise from outside: the one without corner k.
constexpr int kFacets[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

}  // namespace

std::array<std::uint32_t, 4> right_handed(const Mesh& mesh, std::size_t cell) {
  const std::uint32_t* const c = mesh.cell(cell);
  if (mesh.dimension == 2) return {c[0], c[1], c[2], kNoIndex};
  return {c[0], c[1], c[3], c[2]};
}

std::vector<std::array<std::uint32_t, 3>> hull_facets(const Mesh& mesh) {
  struct Entry {
    std::array<std::uint32_t, 3> key;
    std::size_t place;
  };
  std::vector<Entry> entries;
  entries.reserve(4 * mesh.cell_count());
  const auto facet = [&](std::size_t place) {
    const std::uint32_t* const c = mesh.cell(place / 4);
    const int* const k = kFacets[place % 4];
    return std::array<std::uint32_t, 3>{c[k[0]], c[k[1]], c[k[2]]};
  };
  for (std::size_t place = 0; place < 4 * mesh.cell_count(); ++place) {
    std::array<std::uint32_t, 3> key = facet(place);
    std::sort(key.begin(), key.end());
    entries.push_back({key, place});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.place < b.place;
  });
  std::vector<std::size_t> places;
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    for (j = i; j < entries.size() && entries[j].key == entries[i].key;) ++j;
    if (j == i + 1) places.push_back(entries[i].place);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::array<std::uint32_t, 3>> out;
  out.reserve(places.size());
  for (const std::size_t place : places) out.push_back(facet(place));
  return out;
}

std::int32_t facet_marker(const MeshFacet& facet, const Complex& complex) {
  return facet.face < complex.face_markers.size() ? complex.face_markers[facet.face] : 0;
}

MeshSurface surface_of(const Mesh& mesh) {
  MeshSurface out;
  if (mesh.dimension == 2) {
    for (std::size_t i = 0; i < mesh.cell_count(); ++i)
      out.triangles.push_back({mesh.cell(i)[0], mesh.cell(i)[1], mesh.cell(i)[2]});
  } else if (mesh.facets.empty()) {
    out.triangles = hull_facets(mesh);
  } else {
    for (const MeshFacet& f : mesh.facets) {
      out.triangles.push_back({f.a, f.b, f.c});
      out.faces.push_back(f.face);
    }
  }
  out.faces.resize(out.triangles.size(), kNoIndex);
  out.edges = mesh.edges;
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNoIndex);
  for (const auto& t : out.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  for (const MeshEdge& e : out.edges) number[e.a] = number[e.b] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    // In the plane all vertices stay: they are the mesh's, whether a cell uses them or not.
    if (number[v] == kNoIndex && mesh.dimension == 3) continue;
    number[v] = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back(mesh.vertices[v]);
  }
  for (auto& t : out.triangles)
    for (std::uint32_t& v : t) v = number[v];
  for (MeshEdge& e : out.edges) e = {number[e.a], number[e.b], e.segment};
  return out;
}

bool only_polygons(const Complex& complex, std::string* error) {
  for (const Face& face : complex.faces)
    if (face.loops.size() != 1 || !face.holes.empty() || !face.segments.empty() ||
        !face.vertices.empty()) {
      *error =
          "the format holds faces of one loop, but a face of the complex has several, or segments "
          "or vertices in it: use .poly or .json";
      return false;
    }
  return true;
}

std::vector<std::uint32_t> segments_of_no_face(const Complex& complex) {
  Complex sides;
  sides.vertices.resize(complex.vertices.size());
  SegmentTable table(&sides);
  for (const Face& face : complex.faces) table.add_sides(face);
  const std::size_t known = sides.segments.size();
  std::vector<std::uint32_t> out;
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s)
    if (table.number(complex.segments[s][0], complex.segments[s][1]) >= known) out.push_back(s);
  return out;
}

std::string coordinates(const Point3& p) {
  return format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z);
}

}  // namespace circumball::io
