#include <algorithm>
#include <array>

#include "io/formats.h"

// Writes the files of Triangle (https://www.cs.cmu.edu/~quake/triangle.html), numbered from 1.
namespace circumball::io {
namespace {

std::string number(std::size_t n) { return std::to_string(n); }

/// The sections of a .poly file after its vertices. `segment(i)` gives the ends of segment i.
template <class Segment>
std::string segments_and_seeds(std::size_t count, Segment segment,
                               const std::vector<std::int32_t>& markers, const Complex& complex) {
  const bool marked = count > 0 && markers.size() == count;
  std::string out = number(count) + (marked ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<std::uint32_t, 2> ends = segment(i);
    out += number(i + 1) + " " + number(std::size_t{ends[0]} + 1) + " " +
           number(std::size_t{ends[1]} + 1);
    if (marked) out += " " + std::to_string(markers[i]);
    out += "\n";
  }
  out += number(complex.holes.size()) + "\n";
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    out += number(i + 1) + " " + format_double(complex.holes[i].x) + " " +
           format_double(complex.holes[i].y) + "\n";
  if (complex.regions.empty()) return out;
  out += number(complex.regions.size()) + "\n";
  for (std::size_t i = 0; i < complex.regions.size(); ++i) {
    const Region& r = complex.regions[i];
    out += number(i + 1) + " " + format_double(r.at.x) + " " + format_double(r.at.y) + " " +
           format_double(r.label) + " " + format_double(r.max) + "\n";
  }
  return out;
}

std::string elements(const Mesh& mesh) {
  const bool regions = !mesh.cell_regions.empty();
  std::string out = number(mesh.cell_count()) + " 3 " + (regions ? "1\n" : "0\n");
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    out += number(i + 1);
    for (int k = 0; k < 3; ++k) out += " " + number(std::size_t{mesh.cell(i)[k]} + 1);
    if (regions) out += " " + format_double(mesh.cell_regions[i]);
    out += "\n";
  }
  return out;
}

/// All edges of the mesh. Column 4 is the boundary marker, as Triangle has it; column 5 is ours:
/// the number of the input segment that the edge lies on, 0 for none, -1 for one that is not
/// numbered (the box, or unknown).
std::string edges(const Mesh& mesh) {
  struct Row {
    std::uint32_t a, b;
    std::size_t subsegment;
  };
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<Row> rows;
  rows.reserve(mesh.cells.size() + mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    rows.push_back({mesh.edges[i].a, mesh.edges[i].b, i});
  for (std::size_t i = 0; i < mesh.cell_count(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.cell(i)[k], b = mesh.cell(i)[(k + 1) % 3];
      rows.push_back({std::min(a, b), std::max(a, b), kNone});
    }
  const auto key = [](const Row& r) {
    return std::array<std::uint32_t, 2>{std::min(r.a, r.b), std::max(r.a, r.b)};
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const Row& r, const Row& s) {
    return key(r) != key(s) ? key(r) < key(s) : r.subsegment < s.subsegment;
  });
  rows.erase(std::unique(rows.begin(), rows.end(),
                         [&](const Row& r, const Row& s) { return key(r) == key(s); }),
             rows.end());
  std::string out = number(rows.size()) + " 1\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    out += number(i + 1) + " " + number(std::size_t{r.a} + 1) + " " + number(std::size_t{r.b} + 1);
    if (r.subsegment == kNone) {
      out += " 0 0\n";
      continue;
    }
    const std::uint32_t segment = mesh.edges[r.subsegment].segment;
    out += " " +
           (mesh.edge_markers.empty() ? "1" : std::to_string(mesh.edge_markers[r.subsegment])) +
           " " + (segment == kNoIndex ? "-1" : number(std::size_t{segment} + 1)) + "\n";
  }
  return out;
}

}  // namespace

std::string write_nodes(int dimension, const std::vector<Point3>& vertices,
                        int attributes_per_vertex, const std::vector<double>& all_attributes,
                        const std::vector<std::int32_t>& markers,
                        const std::vector<std::string>& more) {
  auto attributes = static_cast<std::size_t>(std::max(attributes_per_vertex, 0));
  if (all_attributes.size() != attributes * vertices.size()) attributes = 0;
  const bool has_markers = !vertices.empty() && markers.size() == vertices.size();
  const bool has_more = !vertices.empty() && more.size() == vertices.size();
  std::string out = number(vertices.size()) + " " + std::to_string(dimension) + " " +
                    number(attributes) + (has_markers || has_more ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    out += number(i + 1) + " " + format_double(vertices[i].x) + " " + format_double(vertices[i].y);
    if (dimension == 3) out += " " + format_double(vertices[i].z);
    for (std::size_t k = 0; k < attributes; ++k)
      out += " " + format_double(all_attributes[i * attributes + k]);
    if (has_markers || has_more) out += " " + std::to_string(has_markers ? markers[i] : 0);
    if (has_more) out += more[i];
    out += "\n";
  }
  return out;
}

std::string write_triangle_node(const Complex& complex) {
  return write_nodes(2, complex.vertices, complex.attributes_per_vertex, complex.vertex_attributes,
                     complex.vertex_markers);
}

std::string write_triangle_poly(const Complex& complex) {
  return write_triangle_node(complex) + segments_and_seeds(
                                            complex.segments.size(),
                                            [&](std::size_t i) { return complex.segments[i]; },
                                            complex.segment_markers, complex);
}

std::vector<OutputFile> write_triangle_mesh(const Mesh& mesh, const Complex& complex) {
  const auto subsegment = [&](std::size_t i) {
    return std::array<std::uint32_t, 2>{mesh.edges[i].a, mesh.edges[i].b};
  };
  return {{".node", write_nodes(2, mesh.vertices, mesh.attributes_per_vertex,
                                mesh.vertex_attributes, mesh.vertex_markers)},
          {".ele", elements(mesh)},
          {".poly", "0 2 0 0\n" + segments_and_seeds(mesh.edges.size(), subsegment,
                                                     mesh.edge_markers, complex)},
          {".edge", edges(mesh)}};
}

}  // namespace circumball::io
