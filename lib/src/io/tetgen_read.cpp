#include <algorithm>

#include "circumball/predicates.h"
#include "io/formats.h"
#include "io/node_file.h"
#include "io/segment_table.h"

// The files of TetGen (H. Si, https://wias-berlin.de/software/tetgen, "File formats": .node, .poly,
// .smesh, .ele, .face, .edge).
namespace circumball::io {
namespace {

/// Facets of a .poly or a .smesh file, as they make up a complex.
class FacetReader {
 public:
  FacetReader(NodeParser& p, const Base& base, bool of_mesh, Complex* complex)
      : p_(p), base_(base), of_mesh_(of_mesh), complex_(*complex), segments_(complex) {}

  bool read(bool simple, bool named) {
    std::size_t count = 0;
    bool markers = false;
    // A facet takes at least "1" and the end of its line.
    if (!p_.count("facets", std::nullopt, 2, &count)) return false;
    if (!p_.has_markers(&markers)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (!p_.next("facets", i, count)) return false;
      if (i == 0 && !named) simple = words() > 3;
      if (!(simple ? simple_facet(markers) : facet(markers))) return false;
    }
    finish_markers();
    return true;
  }

 private:
  /// Words of the current line: the first line of a facet has at most three in a .poly file.
  int words() {
    Lines line = p_.lines();
    int n = 0;
    while (!line.at_end_of_line()) line.word(), ++n;
    return n;
  }

  /// Goes on to the next line where the current one has ended: lists of corners may be wrapped.
  bool wrap() {
    if (!p_.lines().at_end_of_line() || p_.lines().next()) return true;
    return p_.fail_here("truncated", "the file ends in a list of corners: add the rest");
  }

  /// "n v1 … vn": a loop, a segment for two, an isolated vertex for one.
  bool polygon(Face* face) {
    std::int64_t corners = 0;
    if (!p_.integer("the number of corners", std::nullopt, &corners)) return false;
    if (corners < 1)
      return p_.fail_here("syntax", "a polygon has " + std::to_string(corners) +
                                        " corners: it should have 1 at least");
    const std::size_t room = p_.lines().rest_of_line() + p_.lines().remaining();
    if (static_cast<std::uint64_t>(corners) > room / 2 + 1)
      return p_.fail_here("truncated", std::to_string(corners) +
                                           " corners are promised, more than the bytes left can "
                                           "hold: the file is cut off, or the count is wrong");
    std::vector<std::uint32_t> loop(static_cast<std::size_t>(corners));
    for (std::uint32_t& corner : loop)
      if (!wrap() ||
          !vertex_index(p_, "a corner", base_, complex_.vertices.size(), of_mesh_, &corner))
        return false;
    if (loop.size() > 3 && loop.front() == loop.back()) loop.pop_back();  // closed in so many words
    if (loop.size() == 1)
      face->vertices.push_back(loop[0]);
    else if (loop.size() == 2)
      face->segments.push_back(segments_.number(loop[0], loop[1]));
    else
      face->loops.push_back(std::move(loop));
    return true;
  }

  /// Of a .poly file: "polygons [holes] [marker]", then the polygons, then points in holes.
  bool facet(bool markers) {
    std::size_t polygons = 0, holes = 0;
    std::int32_t marker = 0;
    std::int64_t number = 0;
    if (!p_.count("polygons", std::nullopt, 4, &polygons)) return false;
    if (!p_.count("holes", 0, 8, &holes)) return false;
    if (markers && !p_.marker(&marker)) return false;
    Face face;
    for (std::size_t i = 0; i < polygons; ++i)
      if (!p_.next("polygons", i, polygons) || !polygon(&face)) return false;
    for (std::size_t i = 0; i < holes; ++i) {
      Point3 at;
      if (!p_.next("holes", i, holes)) return false;
      if (!p_.integer("the hole number", std::nullopt, &number) || !p_.point(3, &at)) return false;
      face.holes.push_back(at);
    }
    add(std::move(face), marker);
    return true;
  }

  /// Of a .smesh file: one polygon, and its marker.
  bool simple_facet(bool markers) {
    Face face;
    std::int32_t marker = 0;
    if (!polygon(&face)) return false;
    if (markers && !p_.marker(&marker)) return false;
    add(std::move(face), marker);
    return true;
  }

  /// A facet without a loop is no face: its segments and vertices stand alone.
  void add(Face&& face, std::int32_t marker) {
    if (face.loops.empty()) {
      for (const std::uint32_t s : face.segments) {
        if (segment_markers_.size() <= s) segment_markers_.resize(s + 1, 0);
        segment_markers_[s] = marker;
      }
      return;
    }
    segments_.add_sides(face);
    complex_.faces.push_back(std::move(face));
    complex_.face_markers.push_back(marker);
  }

  /// A list of zeros says nothing.
  void finish_markers() {
    const auto zero = [](std::int32_t m) { return m == 0; };
    if (std::all_of(complex_.face_markers.begin(), complex_.face_markers.end(), zero))
      complex_.face_markers.clear();
    if (std::all_of(segment_markers_.begin(), segment_markers_.end(), zero)) return;
    segment_markers_.resize(complex_.segments.size(), 0);
    complex_.segment_markers = std::move(segment_markers_);
  }

  NodeParser& p_;
  const Base& base_;
  bool of_mesh_;
  Complex& complex_;
  SegmentTable segments_;
  std::vector<std::int32_t> segment_markers_;  ///< as far as any is known
};

void read_plc(std::string_view bytes, const std::string& name, const Sibling& sibling,
              ReadResult& result) {
  NodeParser p(bytes, "", result);
  Base base;
  NodeHeader header;
  Complex& complex = result.complex;
  const std::string extension = extension_of(name);
  const bool simple = extension == ".smesh", named = simple || extension == ".poly";
  result.format = simple ? "tetgen-smesh" : extension == ".poly" ? "tetgen-poly" : "tetgen-node";
  complex.dimension = 3;
  p.lines().next();
  if (!read_node_header(p, 3, &header)) return;
  if (header.vertices == 0) {
    if (!named) result.format = "tetgen-poly";
    if (!read_sibling_node(name, sibling, 3, p, &base, result)) return;
  } else if (!read_vertices(p, 3, header, &base, &complex)) {
    return;
  }
  if (!p.lines().next()) {
    if (named)
      p.fail_here("truncated", "the file ends before its facets: add their number, 0 for none");
    else
      complex.hole_rule = HoleRule::kSeeds;
    return;
  }
  if (!named) result.format = "tetgen-poly";
  if (FacetReader(p, base, false, &complex).read(simple, named)) read_seeds(p, 3, &complex);
}

/// The subsegments of the .edge file, or the facets of the .face file, beside a mesh. `corners`
/// numbers, a marker, and, where the header has a third number, the input feature.
template <std::size_t Corners, class Add>
bool read_labeled(NodeParser& p, const std::string& what, const Base& base, std::size_t vertices,
                  Add add) {
  std::size_t count = 0;
  std::int64_t number = 0, features = 0;
  bool markers = false;
  if (!p.lines().next()) return p.fail_here("truncated", "the header is missing: add it");
  if (!p.count(what, std::nullopt, 2 * Corners + 2, &count)) return false;
  if (!p.has_markers(&markers)) return false;
  if (!p.integer("the number of features", 0, &features)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, Corners> corners{};
    std::int32_t marker = 0;
    std::uint32_t feature = kNoIndex;
    bool on_feature = true;
    if (!p.next(what, i, count)) return false;
    if (!p.integer("the number in front", std::nullopt, &number)) return false;
    for (std::uint32_t& corner : corners)
      if (!vertex_index(p, "a corner", base, vertices, true, &corner)) return false;
    if (markers && !p.marker(&marker)) return false;
    if (features == 1 && !feature_number(p, "the feature", false, &feature, &on_feature))
      return false;
    if (on_feature) add(corners, marker, feature);
  }
  return true;
}

bool read_edge_and_face(const std::string& name, const Sibling& sibling, const Base& base,
                        ReadResult& result, std::vector<std::int32_t>* facet_markers) {
  Mesh& mesh = *result.mesh;
  const std::size_t n = mesh.vertices.size();
  const std::string edge_file = stem(name) + ".edge", face_file = stem(name) + ".face";
  if (const auto bytes = sibling ? sibling(edge_file) : std::nullopt) {
    NodeParser p(*bytes, edge_file, result);
    const bool ok = read_labeled<2>(p, "edges", base, n, [&](const auto& v, auto marker, auto s) {
      mesh.edges.push_back({v[0], v[1], s});
      mesh.edge_markers.push_back(marker);
    });
    if (!ok) return false;
  }
  if (const auto bytes = sibling ? sibling(face_file) : std::nullopt) {
    NodeParser p(*bytes, face_file, result);
    const bool ok = read_labeled<3>(p, "faces", base, n, [&](const auto& v, auto marker, auto f) {
      mesh.facets.push_back({v[0], v[1], v[2], f});
      facet_markers->push_back(marker);
    });
    if (!ok) return false;
  }
  return true;
}

/// The complex of a mesh: of the .poly or .smesh file beside it, else its own edges and facets.
bool read_complex_of_mesh(const std::string& name, const Sibling& sibling, const Base& base,
                          const std::vector<std::int32_t>& facet_markers, ReadResult& result) {
  Complex& complex = result.complex;
  const Mesh& mesh = *result.mesh;
  for (const char* extension : {".poly", ".smesh"}) {
    const std::string file = stem(name) + extension;
    const auto bytes = sibling ? sibling(file) : std::nullopt;
    if (!bytes) continue;
    NodeParser p(*bytes, file, result);
    NodeHeader header;
    Base own = base;
    if (!p.lines().next()) return p.fail_here("truncated", "the header is missing: add it");
    if (!read_node_header(p, 3, &header)) return false;
    if (header.vertices > 0) {
      complex.vertices.clear();
      complex.vertex_attributes.clear();
      complex.vertex_markers.clear();
      if (!read_vertices(p, 3, header, &own, &complex)) return false;
    }
    if (!p.lines().next()) return true;
    return FacetReader(p, own, true, &complex).read(file != stem(name) + ".poly", true) &&
           read_seeds(p, 3, &complex);
  }
  for (const MeshEdge& e : mesh.edges) complex.segments.push_back({e.a, e.b});
  complex.segment_markers = mesh.edge_markers;
  for (const MeshFacet& f : mesh.facets) {
    complex.faces.emplace_back();
    complex.faces.back().loops.push_back({f.a, f.b, f.c});
  }
  complex.face_markers = facet_markers;
  complex = with_sides(complex);
  return true;
}

/// The vertices of the input are the first of a mesh, and know their own number; corners of a box
/// follow them, and have none.
void take_features(std::vector<Feature>&& features, Mesh* mesh) {
  if (features.size() != mesh->vertices.size()) return;
  std::uint32_t v = 0;
  for (; v < features.size() && features[v] == Feature{FeatureKind::kVertex, v}; ++v)
    ++mesh->input_vertices;
  for (; v < features.size() && features[v] == Feature{FeatureKind::kVertex, kNoIndex}; ++v) {
    ++mesh->box_vertices;
    features[v].index = v;
  }
  mesh->vertex_features = std::move(features);
}

void read_ele(std::string_view bytes, const std::string& name, const Sibling& sibling,
              ReadResult& result) {
  result.format = "tetgen-ele";
  NodeParser p(bytes, "", result);
  std::size_t count = 0, attributes = 0;
  std::int64_t corners = 4, number = 0;
  p.lines().next();
  if (!p.count("tetrahedra", std::nullopt, 10, &count)) return;
  if (!p.integer("the number of corners", 4, &corners)) return;
  if (corners != 4 && corners != 10) {
    p.fail_here("unsupported", "the cells have " + std::to_string(corners) +
                                   " corners: only tetrahedra with 4 or 10 nodes can be read");
    return;
  }
  if (!p.count("attributes", 0, 2 * count, &attributes)) return;
  Base base;
  std::vector<Feature> features;
  Complex& complex = result.complex;
  complex.dimension = 3;
  complex.hole_rule = HoleRule::kSeeds;
  if (!read_sibling_node(name, sibling, 3, p, &base, result, &features)) return;
  result.mesh.emplace();
  Mesh& mesh = *result.mesh;
  mesh.dimension = 3;
  mesh.vertices = complex.vertices;
  mesh.vertex_markers = complex.vertex_markers;
  mesh.attributes_per_vertex = complex.attributes_per_vertex;
  mesh.vertex_attributes = complex.vertex_attributes;
  mesh.cells.reserve(4 * count);
  if (attributes > 0) mesh.cell_regions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!p.next("tetrahedra", i, count)) return;
    if (!p.integer("the number in front", std::nullopt, &number)) return;
    for (std::int64_t k = 0; k < corners; ++k) {
      std::uint32_t v = 0;
      if (!vertex_index(p, "a corner", base, mesh.vertices.size(), true, &v)) return;
      if (k < 4) mesh.cells.push_back(v);  // nodes 5 to 10 are the midpoints of the edges
    }
    for (std::size_t k = 0; k < attributes; ++k) {
      double value = 0;
      if (!p.number("the attribute", std::nullopt, &value)) return;
      if (k == 0) mesh.cell_regions.push_back(value);
    }
  }
  if (!result.ok()) return;
  orient_cells(&mesh);
  take_features(std::move(features), &mesh);
  std::vector<std::int32_t> facet_markers;
  if (!read_edge_and_face(name, sibling, base, result, &facet_markers)) return;
  read_complex_of_mesh(name, sibling, base, facet_markers, result);
}

}  // namespace

void orient_cells(Mesh* mesh) {
  for (std::size_t i = 0; i < mesh->cells.size(); i += 4) {
    std::uint32_t* const c = mesh->cells.data() + i;
    const auto& at = mesh->vertices;
    if (std::all_of(c, c + 4, [&](std::uint32_t v) { return in_exact_range(at[v]); }) &&
        orient3d(at[c[0]], at[c[1]], at[c[2]], at[c[3]]) == Sign::kNegative)
      std::swap(c[2], c[3]);
  }
}

bool is_tetgen(std::string_view bytes, const std::string& name, const Sibling& sibling) {
  // "n 3 a m" starts a .node, .poly or .smesh file of space, "n 4 a" or "n 10 a" an .ele file of
  // tetrahedra. "n 3 a" is a file of triangles' corners unless it is named otherwise, and "0" has
  // its dimension in the .node file beside it.
  const std::string extension = extension_of(name);
  if (extension == ".smesh") return true;
  Lines header(bytes);
  header.next();
  const std::string_view first = header.word(), second = header.word();
  header.word();
  const bool four_numbers = !header.at_end_of_line();
  const bool vertices = extension == ".node" || extension == ".poly";
  if (second == "4" || second == "10") return !vertices;
  if (second == "3") return extension != ".ele" && (four_numbers || vertices);
  if (first != "0" || !second.empty() || extension != ".poly" || !sibling) return false;
  const auto beside = sibling(stem(name) + ".node");
  if (!beside) return false;
  Lines nodes(*beside);
  nodes.next();
  nodes.word();
  return nodes.word() == "3";
}

void read_tetgen(std::string_view bytes, const std::string& name, const Sibling& sibling,
                 ReadResult& result) {
  const std::string extension = extension_of(name);
  Lines header(bytes);
  header.next();
  header.word();
  const std::string_view second = header.word();
  if (extension != ".smesh" && (second == "4" || second == "10"))
    read_ele(bytes, name, sibling, result);
  else
    read_plc(bytes, name, sibling, result);
}

}  // namespace circumball::io
