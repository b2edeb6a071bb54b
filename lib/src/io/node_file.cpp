#include "io/node_file.h"

#include <limits>

#include "io/numbers.h"

// J. R. Shewchuk's Triangle (https://www.cs.cmu.edu/~quake/triangle.html, pages .node and .poly)
// and H. Si's TetGen (https://wias-berlin.de/software/tetgen, "File formats").
namespace circumball::io {

bool NodeParser::fail_here(const char* name, const std::string& message) {
  return fail_at(result_, lines_.number(), name, file_.empty() ? message : file_ + ": " + message);
}

void NodeParser::no_such_vertex(bool of_mesh, const std::string& message) {
  if (of_mesh) {
    fail_here("index-out-of-range", message);
  } else if (!warned_) {
    warn(result_, "index-out-of-range", "line " + std::to_string(lines_.number()) + ": " + message);
    warned_ = true;
  }
}

bool NodeParser::vertex_number(const std::string& what, std::int64_t* value) {
  Lines ahead = lines_;
  if (const auto number = parse_saturated_integer(ahead.word())) {
    lines_ = ahead;
    *value = *number;
    return true;
  }
  return integer(what, std::nullopt, value);
}

bool NodeParser::integer(const std::string& what, std::optional<std::int64_t> missing,
                         std::int64_t* value) {
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

bool NodeParser::number(const std::string& what, std::optional<double> missing, double* value) {
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

bool NodeParser::count(const std::string& what, std::optional<std::int64_t> missing,
                       std::size_t bytes_each, std::size_t* value) {
  std::int64_t n = 0;
  if (!integer("the number of " + what, missing, &n)) return false;
  if (n < 0)
    return fail_here(
        "syntax", "the number of " + what + " is " + std::to_string(n) + ": it cannot be negative");
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

bool NodeParser::next(const std::string& what, std::size_t i, std::size_t n) {
  if (lines_.next()) return true;
  return fail_here("truncated", "the file ends after " + std::to_string(i) + " of " +
                                    std::to_string(n) + " " + what + ": add the rest");
}

bool NodeParser::marker(std::int32_t* value) {
  std::int64_t wide = 0;
  if (!integer("the boundary marker", 0, &wide)) return false;
  if (wide < std::numeric_limits<std::int32_t>::min() ||
      wide > std::numeric_limits<std::int32_t>::max())
    return fail_here("too-large", "the boundary marker " + std::to_string(wide) +
                                      " does not fit in 32 bits: use a smaller one");
  *value = static_cast<std::int32_t>(wide);
  return true;
}
bool NodeParser::has_markers(bool* markers) {
  std::int64_t count = 0;
  if (!integer("the number of boundary markers", 0, &count)) return false;
  if (count < 0 || count > 1)
    return fail_here("syntax", "the number of boundary markers is " + std::to_string(count) +
                                   ": it should be 0 or 1");
  *markers = count == 1;
  return true;
}

bool NodeParser::point(int dimension, Point3* value) {
  return number("the x coordinate", std::nullopt, &value->x) &&
         number("the y coordinate", std::nullopt, &value->y) &&
         (dimension == 2 || number("the z coordinate", std::nullopt, &value->z));
}

bool read_node_header(NodeParser& p, int dimension, NodeHeader* header) {
  // A vertex takes at least "1 0 0" (in space "1 0 0 0") and the end of its line.
  const std::size_t bytes_each = 2 + 2 * static_cast<std::size_t>(dimension);
  if (!p.count("vertices", std::nullopt, bytes_each, &header->vertices)) return false;
  std::int64_t found = dimension;
  if (!p.integer("the dimension", dimension, &found)) return false;
  if (found != dimension)
    return p.fail_here("unsupported",
                       "the dimension is " + std::to_string(found) + ": it should be 2 or 3");
  if (!p.count("attributes", 0, 2 * header->vertices, &header->attributes)) return false;
  if (header->attributes > 0 &&
      header->vertices * (bytes_each + 2 * header->attributes) > p.lines().remaining() + 1)
    return p.fail_here("truncated",
                       "the vertices and attributes that are promised take more bytes "
                       "than are left: the file is cut off, or a count is wrong");
  return p.has_markers(&header->markers);
}

namespace {

/// "kind number" at the end of a line: kind as in JSON (0 vertex, 1 segment, 2 face, 3 free),
/// number as in .edge files. What others may have written there is passed over.
void read_feature(NodeParser& p, std::vector<Feature>* features) {
  const auto kind = parse_integer(p.lines().word()), number = parse_integer(p.lines().word());
  if (!kind || !number || *kind < 0 || *kind > 3 || !p.lines().at_end_of_line()) return;
  Feature feature;
  feature.kind = static_cast<FeatureKind>(*kind);
  if (*number > 0) feature.index = kept_index(*number - 1);
  features->push_back(feature);
}

}  // namespace

bool read_vertices(NodeParser& p, int dimension, const NodeHeader& header, Base* base,
                   Complex* complex, std::vector<Feature>* features) {
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
    if (!p.point(dimension, &point)) return false;
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
    if (features) read_feature(p, features);
  }
  return true;
}

namespace {

bool read_node(NodeParser& p, int dimension, Base* base, Complex* complex,
               std::vector<Feature>* features) {
  NodeHeader header;
  if (!p.lines().next()) return p.fail_here("truncated", "the header is missing: add it");
  return read_node_header(p, dimension, &header) &&
         read_vertices(p, dimension, header, base, complex, features);
}

}  // namespace

bool read_sibling_node(const std::string& name, const Sibling& sibling, int dimension,
                       NodeParser& asking, Base* base, ReadResult& result,
                       std::vector<Feature>* features) {
  const std::string file = stem(name) + ".node";
  const auto bytes = sibling ? sibling(file) : std::nullopt;
  if (!bytes)
    return asking.fail_here(
        "missing-sibling", "the vertices are in " + file + ", which is not there: give it as well");
  NodeParser p(*bytes, file, result);
  return read_node(p, dimension, base, &result.complex, features);
}

bool vertex_index(NodeParser& p, const std::string& what, const Base& base, std::size_t vertices,
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

bool feature_number(NodeParser& p, const std::string& what, bool marked, std::uint32_t* feature,
                    bool* on_feature) {
  std::int64_t number = 0;
  if (!p.integer(what, marked ? -1 : 0, &number)) return false;
  *on_feature = number != 0;
  if (number > 0 && number <= 0xfffffffeLL) *feature = static_cast<std::uint32_t>(number - 1);
  return true;
}

bool read_seeds(NodeParser& p, int dimension, Complex* complex) {
  std::size_t count = 0;
  std::int64_t number = 0;
  const std::size_t bytes_each = 2 + 2 * static_cast<std::size_t>(dimension);
  complex->hole_rule = HoleRule::kSeeds;
  if (!p.lines().next()) return true;
  if (!p.count("holes", std::nullopt, bytes_each, &count)) return false;
  complex->holes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Point3 at;
    if (!p.next("holes", i, count)) return false;
    if (!p.integer("the hole number", std::nullopt, &number)) return false;
    if (!p.point(dimension, &at)) return false;
    complex->holes.push_back(at);
  }
  if (!p.lines().next()) return true;
  if (!p.count("regions", std::nullopt, bytes_each, &count)) return false;
  complex->regions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Region region;
    if (!p.next("regions", i, count)) return false;
    if (!p.integer("the region number", std::nullopt, &number)) return false;
    if (!p.point(dimension, &region.at)) return false;
    if (!p.number("the attribute", 0, &region.label)) return false;
    if (!p.number(dimension == 2 ? "the maximum area" : "the maximum volume", 0, &region.max))
      return false;
    complex->regions.push_back(region);
  }
  return true;
}

}  // namespace circumball::io
