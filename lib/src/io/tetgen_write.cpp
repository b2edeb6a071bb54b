#include <algorithm>

#include "io/formats.h"
#include "io/mesh_parts.h"
#include "io/segment_table.h"

// Writes the files of TetGen (https://wias-berlin.de/software/tetgen, "File formats"), numbered
// from 1.
namespace circumball::io {
namespace {

std::string number(std::size_t n) { return std::to_string(n); }

/// " v1 … vn", from 1.
template <class Vertices>
std::string corners(const Vertices& vertices) {
  std::string out;
  for (const std::uint32_t v : vertices) out += " " + number(std::size_t{v} + 1);
  return out;
}

/// Whether the segments of a complex have to be written as facets of their own: where they have
/// markers, where some are in no face, and where reading the faces would number them otherwise.
bool segments_apart(const Complex& complex) {
  if (!complex.segment_markers.empty()) return true;
  Complex read;
  read.vertices.resize(complex.vertices.size());
  SegmentTable table(&read);
  for (const Face& face : complex.faces) {
    for (const std::uint32_t s : face.segments)
      table.number(complex.segments[s][0], complex.segments[s][1]);
    table.add_sides(face);
  }
  return read.segments != complex.segments;
}

/// "1 0 marker" and the polygons of a face, as .poly files have them.
std::string facet(const Face& face, const Complex& complex, const std::string& marker) {
  std::string out = number(face.loops.size() + face.segments.size() + face.vertices.size()) + " " +
                    number(face.holes.size()) + marker + "\n";
  for (const auto& loop : face.loops) out += number(loop.size()) + corners(loop) + "\n";
  for (const std::uint32_t s : face.segments) out += "2" + corners(complex.segments[s]) + "\n";
  for (const std::uint32_t v : face.vertices) out += "1 " + number(std::size_t{v} + 1) + "\n";
  for (std::size_t i = 0; i < face.holes.size(); ++i)
    out += number(i + 1) + " " + coordinates(face.holes[i]) + "\n";
  return out;
}

std::string seeds(const Complex& complex) {
  std::string out = number(complex.holes.size()) + "\n";
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    out += number(i + 1) + " " + coordinates(complex.holes[i]) + "\n";
  if (complex.regions.empty()) return out;
  out += number(complex.regions.size()) + "\n";
  for (std::size_t i = 0; i < complex.regions.size(); ++i) {
    const Region& r = complex.regions[i];
    out += number(i + 1) + " " + coordinates(r.at) + " " + format_double(r.label) + " " +
           format_double(r.max) + "\n";
  }
  return out;
}

/// A .poly or .smesh file. A segment that stands alone is written between `before` and `after`, a
/// face by `facet`; each gets its marker as " 5", or nothing where there are none.
template <class Before, class After, class WriteFacet>
std::string plc(const Complex& complex, Before before, After after, WriteFacet facet) {
  const std::size_t lone = segments_apart(complex) ? complex.segments.size() : 0;
  const bool marked = !complex.face_markers.empty() || !complex.segment_markers.empty();
  const auto marker = [&](const std::vector<std::int32_t>& markers, std::size_t i) {
    return !marked ? std::string() : " " + std::to_string(i < markers.size() ? markers[i] : 0);
  };
  std::string out = write_nodes(3, complex.vertices, complex.attributes_per_vertex,
                                complex.vertex_attributes, complex.vertex_markers);
  out += number(lone + complex.faces.size()) + (marked ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < lone; ++i) {
    const std::string m = marker(complex.segment_markers, i);
    out += before(m) + corners(complex.segments[i]) + after(m);
  }
  for (std::size_t i = 0; i < complex.faces.size(); ++i)
    out += facet(complex.faces[i], marker(complex.face_markers, i));
  return out + seeds(complex);
}

/// The facets on input faces, then those of the hull that are not among them. Column 5 is the
/// marker, as TetGen has it (1 on an input face without a marker, 0 elsewhere); column 6, which the
/// third number of the header announces, is ours: the number of the input face, 0 for none, -1 for
/// one that is not numbered (the box, or unknown).
std::string faces(const Mesh& mesh, const Complex& complex) {
  const auto key = [](std::array<std::uint32_t, 3> v) {
    std::sort(v.begin(), v.end());
    return v;
  };
  std::vector<std::array<std::uint32_t, 3>> known;
  for (const MeshFacet& f : mesh.facets) known.push_back(key({f.a, f.b, f.c}));
  std::sort(known.begin(), known.end());
  std::vector<std::array<std::uint32_t, 3>> hull = hull_facets(mesh);
  hull.erase(std::remove_if(hull.begin(), hull.end(),
                            [&](const auto& f) {
                              return std::binary_search(known.begin(), known.end(), key(f));
                            }),
             hull.end());
  std::string out = number(mesh.facets.size() + hull.size()) + " 1 1\n";
  std::size_t row = 0;
  for (const MeshFacet& f : mesh.facets) {
    out += number(++row) + corners(std::array<std::uint32_t, 3>{f.a, f.b, f.c}) + " " +
           (complex.face_markers.empty() ? "1" : std::to_string(facet_marker(f, complex))) + " " +
           (f.face == kNoIndex ? "-1" : number(std::size_t{f.face} + 1)) + "\n";
  }
  for (const auto& f : hull) out += number(++row) + corners(f) + " 0 0\n";
  return out;
}

/// The subsegments, with columns as in .face files.
std::string edges(const Mesh& mesh) {
  std::string out = number(mesh.edges.size()) + " 1 1\n";
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const MeshEdge& e = mesh.edges[i];
    out += number(i + 1) + corners(std::array<std::uint32_t, 2>{e.a, e.b}) + " " +
           (mesh.edge_markers.empty() ? "1" : std::to_string(mesh.edge_markers[i])) + " " +
           (e.segment == kNoIndex ? "-1" : number(std::size_t{e.segment} + 1)) + "\n";
  }
  return out;
}

std::string elements(const Mesh& mesh) {
  const bool regions = !mesh.cell_regions.empty();
  std::string out = number(mesh.cell_count()) + " 4 " + (regions ? "1\n" : "0\n");
  for (std::size_t i = 0; i < mesh.cell_count(); ++i)
    out += number(i + 1) + corners(right_handed(mesh, i)) +
           (regions ? " " + format_double(mesh.cell_regions[i]) : "") + "\n";
  return out;
}

/// Two columns after the marker: the kind of the smallest feature that has the vertex (0 vertex, 1
/// segment, 2 face, 3 free), and its number, 0 for none, -1 for a corner of the box.
std::vector<std::string> feature_columns(const Mesh& mesh) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < mesh.vertex_features.size(); ++i) {
    const Feature& f = mesh.vertex_features[i];
    const bool of_box = i >= mesh.input_vertices && i - mesh.input_vertices < mesh.box_vertices;
    out.push_back(" " + std::to_string(static_cast<int>(f.kind)) + " " +
                  (of_box                ? "-1"
                   : f.index == kNoIndex ? "0"
                                         : number(std::size_t{f.index} + 1)));
  }
  return out;
}

}  // namespace

std::string write_tetgen_poly(const Complex& complex) {
  return plc(
      complex, [](const std::string& marker) { return "1 0" + marker + "\n2"; },
      [](const std::string&) { return "\n"; },
      [&](const Face& face, const std::string& marker) { return facet(face, complex, marker); });
}

std::string write_tetgen_smesh(const Complex& complex, std::string* error) {
  for (const Face& face : complex.faces)
    if (face.loops.size() != 1 || !face.segments.empty() || !face.vertices.empty()) {
      *error =
          "a facet of a .smesh file is one polygon, but a face of the complex has several loops, "
          "or "
          "segments or vertices in it: use .poly or .json";
      return {};
    }
  return plc(
      complex, [](const std::string&) { return "2"; },
      [](const std::string& marker) { return marker + "\n"; },
      [&](const Face& face, const std::string& marker) {
        return number(face.loops[0].size()) + corners(face.loops[0]) + marker + "\n";
      });
}

std::vector<OutputFile> write_tetgen_mesh(const Mesh& mesh, const Complex& complex) {
  return {
      {".node", write_nodes(3, mesh.vertices, mesh.attributes_per_vertex, mesh.vertex_attributes,
                            mesh.vertex_markers, feature_columns(mesh))},
      {".ele", elements(mesh)},
      {".face", faces(mesh, complex)},
      {".edge", edges(mesh)}};
}

}  // namespace circumball::io
