#include <algorithm>

#include "io/formats.h"
#include "io/node_file.h"

// The files of Triangle (J. R. Shewchuk, https://www.cs.cmu.edu/~quake/triangle.html, pages .node,
// .poly, .ele, .edge).
namespace circumball::io {
namespace {

bool read_segments(NodeParser& p, const Base& base, bool of_mesh, Complex* complex) {
  std::size_t count = 0;
  std::int64_t number = 0;
  bool markers = false;
  if (!p.count("segments", std::nullopt, 6, &count)) return false;
  if (!p.has_markers(&markers)) return false;
  complex->segments.reserve(count);
  if (markers) complex->segment_markers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, 2> segment{};
    if (!p.next("segments", i, count)) return false;
    if (!p.integer("the segment number", std::nullopt, &number)) return false;
    for (std::size_t k = 0; k < 2; ++k)
      if (!vertex_index(p, k == 0 ? "the first end" : "the second end", base,
                        complex->vertices.size(), of_mesh, &segment[k]))
        return false;
    complex->segments.push_back(segment);
    if (markers) {
      std::int32_t marker = 0;
      if (!p.marker(&marker)) return false;
      complex->segment_markers.push_back(marker);
    }
  }
  return true;
}

void read_node_or_poly(std::string_view bytes, const std::string& name, const Sibling& sibling,
                       ReadResult& result) {
  NodeParser p(bytes, "", result);
  Base base;
  NodeHeader header;
  const bool called_poly = extension_of(name) == ".poly";
  result.format = called_poly ? "triangle-poly" : "triangle-node";
  p.lines().next();
  if (!read_node_header(p, 2, &header)) return;
  if (header.vertices == 0) {
    result.format = "triangle-poly";
    if (!read_sibling_node(name, sibling, 2, p, &base, result)) return;
  } else if (!read_vertices(p, 2, header, &base, &result.complex)) {
    return;
  }
  if (!p.lines().next()) {
    if (result.format == "triangle-poly")
      p.fail_here("truncated", "the file ends before its segments: add their number, 0 for none");
    else
      result.complex.hole_rule = HoleRule::kSeeds;
    return;
  }
  result.format = "triangle-poly";
  if (read_segments(p, base, false, &result.complex)) read_seeds(p, 2, &result.complex);
}

/// Segments of the .edge file beside a mesh: edges with a marker, or with a segment number in a
/// fifth column.
bool read_edges(NodeParser& p, const Base& base, ReadResult& result) {
  std::size_t count = 0;
  std::int64_t markers = 0, number = 0;
  if (!p.lines().next()) return p.fail_here("truncated", "the header is missing: add it");
  if (!p.count("edges", std::nullopt, 6, &count)) return false;
  if (!p.integer("the number of boundary markers", 0, &markers)) return false;
  Mesh& mesh = *result.mesh;
  for (std::size_t i = 0; i < count; ++i) {
    MeshEdge edge{kNoIndex, kNoIndex, kNoIndex};
    std::int32_t marker = 0;
    if (!p.next("edges", i, count)) return false;
    if (!p.integer("the edge number", std::nullopt, &number)) return false;
    if (!vertex_index(p, "the first end", base, mesh.vertices.size(), true, &edge.a)) return false;
    if (p.lines().at_end_of_line())
      return p.fail_here("syntax", "the edge has one end: add the other");
    std::int64_t second = 0;
    bool on_segment = false;
    if (!p.integer("the second end", std::nullopt, &second)) return false;
    if (second == -1) continue;  // an infinite ray of a Voronoi diagram
    if (second < base.first ||
        second - base.first >= static_cast<std::int64_t>(mesh.vertices.size())) {
      p.fail_here("index-out-of-range",
                  "the second end is vertex " + std::to_string(second) +
                      ", which the .node file does not have: correct the number");
      continue;
    }
    edge.b = static_cast<std::uint32_t>(second - base.first);
    if (markers > 0 && !p.marker(&marker)) return false;
    if (!feature_number(p, "the segment number", marker != 0, &edge.segment, &on_segment))
      return false;
    if (!on_segment) continue;
    mesh.edges.push_back(edge);
    mesh.edge_markers.push_back(marker);
  }
  return true;
}

void read_ele(std::string_view bytes, const std::string& name, const Sibling& sibling,
              ReadResult& result) {
  result.format = "triangle-ele";
  NodeParser p(bytes, "", result);
  std::size_t count = 0, attributes = 0;
  std::int64_t corners = 3, number = 0;
  p.lines().next();
  if (!p.count("triangles", std::nullopt, 8, &count)) return;
  if (!p.integer("the number of corners", 3, &corners)) return;
  if (corners != 3 && corners != 6) {
    p.fail_here("unsupported", "the cells have " + std::to_string(corners) +
                                   " corners: only triangles with 3 or 6 nodes can be read");
    return;
  }
  if (!p.count("attributes", 0, 2 * count, &attributes)) return;
  Base base;
  if (!read_sibling_node(name, sibling, 2, p, &base, result)) return;
  result.mesh.emplace();
  Mesh& mesh = *result.mesh;
  Complex& complex = result.complex;
  mesh.vertices = complex.vertices;
  mesh.vertex_markers = complex.vertex_markers;
  mesh.attributes_per_vertex = complex.attributes_per_vertex;
  mesh.vertex_attributes = complex.vertex_attributes;
  mesh.cells.reserve(3 * count);
  if (attributes > 0) mesh.cell_regions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!p.next("triangles", i, count)) return;
    if (!p.integer("the triangle number", std::nullopt, &number)) return;
    for (std::int64_t k = 0; k < corners; ++k) {
      std::uint32_t v = 0;
      if (!vertex_index(p, "a corner", base, mesh.vertices.size(), true, &v)) return;
      if (k < 3) mesh.cells.push_back(v);  // nodes 4 to 6 are the midpoints of the edges
    }
    for (std::size_t k = 0; k < attributes; ++k) {
      double value = 0;
      if (!p.number("the attribute", std::nullopt, &value)) return;
      if (k == 0) mesh.cell_regions.push_back(value);
    }
  }
  // Subsegments: of the .edge file where there is one, else of the .poly file; both may be missing.
  const std::string edge_file = stem(name) + ".edge", poly_file = stem(name) + ".poly";
  if (const auto edges = sibling ? sibling(edge_file) : std::nullopt) {
    NodeParser edge_parser(*edges, edge_file, result);
    if (!read_edges(edge_parser, base, result)) return;
  }
  if (const auto poly = sibling ? sibling(poly_file) : std::nullopt) {
    NodeParser poly_parser(*poly, poly_file, result);
    NodeHeader header;
    if (!poly_parser.lines().next()) {
      poly_parser.fail_here("truncated", "the header is missing: add it");
      return;
    }
    if (!read_node_header(poly_parser, 2, &header)) return;
    if (header.vertices > 0) {  // the input of the mesh: its vertices are the first of the mesh
      complex.vertices.clear();
      complex.vertex_attributes.clear();
      complex.vertex_markers.clear();
      if (!read_vertices(poly_parser, 2, header, &base, &complex)) return;
    }
    if (!poly_parser.lines().next()) return;
    if (!read_segments(poly_parser, base, true, &complex) || !read_seeds(poly_parser, 2, &complex))
      return;
    if (header.vertices == 0 && mesh.edges.empty()) {
      for (const auto& s : complex.segments) mesh.edges.push_back({s[0], s[1], kNoIndex});
      mesh.edge_markers = complex.segment_markers;
    }
  } else {
    for (const MeshEdge& e : mesh.edges) complex.segments.push_back({e.a, e.b});
    complex.segment_markers = mesh.edge_markers;
  }
}

}  // namespace

void read_triangle(std::string_view bytes, const std::string& name, const Sibling& sibling,
                   ReadResult& result) {
  // "n 2 …" starts a .node or .poly file, "n 3 a" or "n 6 a" an .ele file; a line of a .ele file
  // has nothing but integers up to its corners, and a file of space ("n 3 a m") has four numbers.
  // The name settles "n 3 a".
  Lines header(bytes);
  header.next();
  header.word();
  const std::string_view second = header.word();
  header.word();
  const bool four_numbers = !header.at_end_of_line();
  const std::string extension = extension_of(name);
  const bool named_otherwise = extension == ".node" || extension == ".poly";
  if (extension == ".ele" ||
      ((second == "3" || second == "6") && !four_numbers && !named_otherwise))
    read_ele(bytes, name, sibling, result);
  else
    read_node_or_poly(bytes, name, sibling, result);
}

}  // namespace circumball::io