#include <algorithm>
#include <limits>
#include <optional>

#include "io/formats.h"
#include "io/lines.h"
#include "io/numbers.h"

// The files of Triangle (J. R. Shewchuk, https://www.cs.cmu.edu/~quake/triangle.html, pages .node,
// .poly, .ele, .edge).
namespace circumball::io {
namespace {

/// One file of the family: its lines, and what to call it in a message ("" for the file that was
/// asked for).
class Parser {
 public:
  Parser(std::string_view bytes, std::string file, ReadResult& result)
      : lines_(bytes), file_(std::move(file)), result_(result) {}

  Lines& lines() { return lines_; }

  bool fail_here(const char* name, const std::string& message) {
    return fail_at(result_, lines_.number(), name,
                   file_.empty() ? message : file_ + ": " + message);
  }

  /// A vertex number that is not there: in a complex it is kept for `check` to tell of, and a
  /// warning names the line of the first; in a mesh it is a defect.
  void no_such_vertex(bool of_mesh, const std::string& message) {
    if (of_mesh) {
      fail_here("index-out-of-range", message);
    } else if (!warned_) {
      warn(result_, "index-out-of-range",
           "line " + std::to_string(lines_.number()) + ": " + message);
      warned_ = true;
    }
  }

  /// The next word as a vertex number; one that does not fit in 64 bits is the nearest that does.
  bool vertex_number(const std::string& what, std::int64_t* value) {
    Lines ahead = lines_;
    if (const auto number = parse_saturated_integer(ahead.word())) {
      lines_ = ahead;
      *value = *number;
      return true;
    }
    return integer(what, std::nullopt, value);
  }

  /// The next word as an integer; `missing` where the line has ended (nothing: that is a defect).
  bool integer(const std::string& what, std::optional<std::int64_t> missing, std::int64_t* value) {
    const std::string_view word = lines_.word();
    if (word.empty()) {
      if (!missing) return fail_here("syntax", "the line ends before " + what + ": add it");
      *value = *missing;
      return true;
    }
    if (const auto parsed = parse_integer(word)) {
      *value = *parsed;
      return true;
    }
    // Some programs write markers and counts as 1.0 or 1e0.
    const auto number = parse_double(word);
    if (number && *number >= -9007199254740992.0 && *number <= 9007199254740992.0 &&
        *number == static_cast<double>(static_cast<std::int64_t>(*number))) {
      *value = static_cast<std::int64_t>(*number);
      return true;
    }
    if (number && (*number > 9007199254740992.0 || *number < -9007199254740992.0))
      return fail_here("too-large", what + " is " + in_quotes(word) + ": make it smaller");
    return fail_here("syntax", what + " should be an integer, not " + in_quotes(word));
  }

  bool number(const std::string& what, std::optional<double> missing, double* value) {
    const std::string_view word = lines_.word();
    if (word.empty() && missing) {
      *value = *missing;
      return true;
    }
    if (word.empty()) return fail_here("syntax", "the line ends before " + what + ": add it");
    const auto parsed = parse_double(word);
    if (!parsed) return fail_here("syntax", what + " should be a number, not " + in_quotes(word));
    *value = *parsed;
    return true;
  }

  /// The next word as the count of things that take at least `bytes_each` bytes in the lines that
  /// follow.
  bool count(const std::string& what, std::optional<std::int64_t> missing, std::size_t bytes_each,
             std::size_t* value) {
    std::int64_t n = 0;
    if (!integer("the number of " + what, missing, &n)) return false;
    if (n < 0)
      return fail_here("syntax", "the number of " + what + " is " + std::to_string(n) +
                                     ": it cannot be negative");
    if (n > std::numeric_limits<std::int32_t>::max())
      return fail_here("too-large", std::to_string(n) + " " + what +
                                        " are more than can be numbered: correct the count");
    // The last line needs no newline: hence the one byte that is granted.
    const std::uint64_t needed = static_cast<std::uint64_t>(n) * bytes_each;
    if (needed > static_cast<std::uint64_t>(lines_.remaining()) + 1)
      return fail_here("truncated", std::to_string(n) + " " + what + " are promised, which take " +
                                        std::to_string(needed) + " bytes at least, but " +
                                        std::to_string(lines_.remaining()) +
                                        " are left: the file is cut off, or the count is wrong");
    *value = static_cast<std::size_t>(n);
    return true;
  }

  /// Goes to line `i` of `n` that list `what`.
  bool next(const std::string& what, std::size_t i, std::size_t n) {
    if (lines_.next()) return true;
    return fail_here("truncated", "the file ends after " + std::to_string(i) + " of " +
                                      std::to_string(n) + " " + what + ": add the rest");
  }

  /// A marker: an integer, of which 32 bits are kept; 0 where it is missing.
  bool marker(std::int32_t* value) {
    std::int64_t wide = 0;
    if (!integer("the boundary marker", 0, &wide)) return false;
    if (wide < std::numeric_limits<std::int32_t>::min() ||
        wide > std::numeric_limits<std::int32_t>::max())
      return fail_here("too-large", "the boundary marker " + std::to_string(wide) +
                                        " does not fit in 32 bits: use a smaller one");
    *value = static_cast<std::int32_t>(wide);
    return true;
  }

 private:
  Lines lines_;
  std::string file_;
  ReadResult& result_;
  bool warned_ = false;
};

/// Number of the first vertex in the files of a family: 0 or 1.
struct Base {
  std::int64_t first = 1;
};

/// The header of a .node or .poly file, of which the first line has been reached.
struct NodeHeader {
  std::size_t vertices = 0, attributes = 0;
  bool markers = false;
};

bool read_node_header(Parser& p, NodeHeader* header) {
  // A vertex takes at least "1 0 0" and the end of its line.
  if (!p.count("vertices", std::nullopt, 6, &header->vertices)) return false;
  std::int64_t dimension = 2, markers = 0;
  if (!p.integer("the dimension", 2, &dimension)) return false;
  if (dimension != 2)
    return p.fail_here("unsupported", "the dimension is " + std::to_string(dimension) +
                                          ": only files of the plane (2) can be read");
  if (!p.count("attributes", 0, 2 * header->vertices, &header->attributes)) return false;
  if (header->attributes > 0 &&
      header->vertices * (6 + 2 * header->attributes) > p.lines().remaining() + 1)
    return p.fail_here("truncated",
                       "the vertices and attributes that are promised take more bytes "
                       "than are left: the file is cut off, or a count is wrong");
  if (!p.integer("the number of boundary markers", 0, &markers)) return false;
  if (markers < 0 || markers > 1)
    return p.fail_here("syntax", "the number of boundary markers is " + std::to_string(markers) +
                                     ": it should be 0 or 1");
  header->markers = markers == 1;
  return true;
}

bool read_vertices(Parser& p, const NodeHeader& header, Base* base, Complex* complex) {
  complex->attributes_per_vertex = static_cast<int>(header.vertices ? header.attributes : 0);
  complex->vertices.reserve(header.vertices);
  complex->vertex_attributes.reserve(header.vertices * header.attributes);
  if (header.markers) complex->vertex_markers.reserve(header.vertices);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    std::int64_t number = 0;
    Point3 point;
    if (!p.next("vertices", i, header.vertices)) return false;
    if (!p.integer("the vertex number", std::nullopt, &number)) return false;
    if (i == 0) base->first = number;
    if (base->first != 0 && base->first != 1)
      return p.fail_here("numbering", "the first vertex has number " + std::to_string(number) +
                                          ": number from 0 or from 1");
    if (number != base->first + static_cast<std::int64_t>(i))
      return p.fail_here("numbering",
                         "vertex number " + std::to_string(number) + " should be " +
                             std::to_string(base->first + static_cast<std::int64_t>(i)) +
                             ": number the vertices without gaps");
    if (!p.number("the x coordinate", std::nullopt, &point.x)) return false;
    if (!p.number("the y coordinate", std::nullopt, &point.y)) return false;
    complex->vertices.push_back(point);
    for (std::size_t k = 0; k < header.attributes; ++k) {
      double value = 0;
      if (!p.number("attribute " + std::to_string(k + 1), std::nullopt, &value)) return false;
      complex->vertex_attributes.push_back(value);
    }
    if (header.markers) {
      std::int32_t marker = 0;
      if (!p.marker(&marker)) return false;
      complex->vertex_markers.push_back(marker);
    }
  }
  return true;
}

bool read_node(Parser& p, Base* base, Complex* complex) {
  NodeHeader header;
  if (!p.lines().next()) return p.fail_here("truncated", "the header is missing: add it");
  return read_node_header(p, &header) && read_vertices(p, header, base, complex);
}

/// A vertex number of the file as an index. Reading goes on after one that is out of range.
bool vertex_index(Parser& p, const std::string& what, const Base& base, std::size_t vertices,
                  bool of_mesh, std::uint32_t* index) {
  std::int64_t number = 0;
  if (!p.vertex_number(what, &number)) return false;
  *index = number < base.first ? kNoIndex : kept_index(number - base.first);
  if (*index < vertices) return true;
  p.no_such_vertex(
      of_mesh, what + " is vertex " + std::to_string(number) + ", but " +
                   (vertices == 0 ? std::string("there are none")
                                  : "the vertices are " + std::to_string(base.first) + " to " +
                                        std::to_string(base.first +
                                                       static_cast<std::int64_t>(vertices) - 1)) +
                   ": correct the number");
  return true;
}

bool read_segments(Parser& p, const Base& base, bool of_mesh, Complex* complex) {
  std::size_t count = 0;
  std::int64_t markers = 0, number = 0;
  if (!p.count("segments", std::nullopt, 6, &count)) return false;
  if (!p.integer("the number of boundary markers", 0, &markers)) return false;
  if (markers < 0 || markers > 1)
    return p.fail_here("syntax", "the number of boundary markers is " + std::to_string(markers) +
                                     ": it should be 0 or 1");
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

/// Holes and regions; either section may be missing at the end of the file.
bool read_seeds(Parser& p, Complex* complex) {
  std::size_t count = 0;
  std::int64_t number = 0;
  complex->hole_rule = HoleRule::kSeeds;
  if (!p.lines().next()) return true;
  if (!p.count("holes", std::nullopt, 6, &count)) return false;
  complex->holes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Point3 at;
    if (!p.next("holes", i, count)) return false;
    if (!p.integer("the hole number", std::nullopt, &number)) return false;
    if (!p.number("the x coordinate", std::nullopt, &at.x)) return false;
    if (!p.number("the y coordinate", std::nullopt, &at.y)) return false;
    complex->holes.push_back(at);
  }
  if (!p.lines().next()) return true;
  if (!p.count("regions", std::nullopt, 6, &count)) return false;
  complex->regions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Region region;
    if (!p.next("regions", i, count)) return false;
    if (!p.integer("the region number", std::nullopt, &number)) return false;
    if (!p.number("the x coordinate", std::nullopt, &region.at.x)) return false;
    if (!p.number("the y coordinate", std::nullopt, &region.at.y)) return false;
    if (!p.number("the attribute", 0, &region.label)) return false;
    if (!p.number("the maximum area", 0, &region.max)) return false;
    complex->regions.push_back(region);
  }
  return true;
}

/// The vertices of the .node file beside a file that has none.
bool read_sibling_node(const std::string& name, const Sibling& sibling, Parser& asking, Base* base,
                       ReadResult& result) {
  const std::string file = stem(name) + ".node";
  const auto bytes = sibling ? sibling(file) : std::nullopt;
  if (!bytes)
    return asking.fail_here(
        "missing-sibling", "the vertices are in " + file + ", which is not there: give it as well");
  Parser p(*bytes, file, result);
  return read_node(p, base, &result.complex);
}

void read_node_or_poly(std::string_view bytes, const std::string& name, const Sibling& sibling,
                       ReadResult& result) {
  Parser p(bytes, "", result);
  Base base;
  NodeHeader header;
  const bool called_poly = extension_of(name) == ".poly";
  result.format = called_poly ? "triangle-poly" : "triangle-node";
  p.lines().next();
  if (!read_node_header(p, &header)) return;
  if (header.vertices == 0) {
    result.format = "triangle-poly";
    if (!read_sibling_node(name, sibling, p, &base, result)) return;
  } else if (!read_vertices(p, header, &base, &result.complex)) {
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
  if (read_segments(p, base, false, &result.complex)) read_seeds(p, &result.complex);
}

/// Segments of the .edge file beside a mesh: edges with a marker, or with a segment number in a
/// fifth column.
bool read_edges(Parser& p, const Base& base, ReadResult& result) {
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
    std::int64_t second = 0, feature = 0;
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
    if (!p.integer("the segment number", marker != 0 ? -1 : 0, &feature)) return false;
    if (feature == 0) continue;
    if (feature > 0 && feature <= 0xfffffffeLL)
      edge.segment = static_cast<std::uint32_t>(feature - 1);
    mesh.edges.push_back(edge);
    mesh.edge_markers.push_back(marker);
  }
  return true;
}

void read_ele(std::string_view bytes, const std::string& name, const Sibling& sibling,
              ReadResult& result) {
  result.format = "triangle-ele";
  Parser p(bytes, "", result);
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
  if (!read_sibling_node(name, sibling, p, &base, result)) return;
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
    Parser edge_parser(*edges, edge_file, result);
    if (!read_edges(edge_parser, base, result)) return;
  }
  if (const auto poly = sibling ? sibling(poly_file) : std::nullopt) {
    Parser poly_parser(*poly, poly_file, result);
    NodeHeader header;
    if (!poly_parser.lines().next()) {
      poly_parser.fail_here("truncated", "the header is missing: add it");
      return;
    }
    if (!read_node_header(poly_parser, &header)) return;
    if (header.vertices > 0) {  // the input of the mesh: its vertices are the first of the mesh
      complex.vertices.clear();
      complex.vertex_attributes.clear();
      complex.vertex_markers.clear();
      if (!read_vertices(poly_parser, header, &base, &complex)) return;
    }
    if (!poly_parser.lines().next()) return;
    if (!read_segments(poly_parser, base, true, &complex) || !read_seeds(poly_parser, &complex))
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
