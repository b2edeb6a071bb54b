#include "circumball/mesh.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace circumball {
namespace {

/// FNV-1a, 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv).
class Fnv {
 public:
  void add32(std::uint32_t value) { add(value, 4); }
  void add_double(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits, 8);
  }
  std::string hex() const {
    std::string text(16, '0');
    for (int i = 0; i < 16; ++i)
      text[static_cast<std::size_t>(i)] = "0123456789abcdef"[(hash_ >> (60 - 4 * i)) & 15];
    return text;
  }

 private:
  void add(std::uint64_t value, int bytes) {  // little-endian whatever the machine is
    for (int i = 0; i < bytes; ++i) {
      hash_ ^= (value >> (8 * i)) & 0xff;
      hash_ *= 0x100000001b3u;
    }
  }
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::string fingerprint(const Mesh& mesh) {
  Fnv hash;
  hash.add32(static_cast<std::uint32_t>(mesh.vertices.size()));
  for (const Point3& p : mesh.vertices) {
    hash.add_double(p.x);
    hash.add_double(p.y);
    if (mesh.dimension == 3) hash.add_double(p.z);
  }
  const std::size_t corners = static_cast<std::size_t>(mesh.dimension) + 1;
  std::vector<std::array<std::uint32_t, 4>> cells(mesh.cell_count());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].fill(0);
    std::copy_n(mesh.cell(i), corners, cells[i].begin());
    std::sort(cells[i].begin(), cells[i].begin() + static_cast<std::ptrdiff_t>(corners));
  }
  std::sort(cells.begin(), cells.end());
  hash.add32(static_cast<std::uint32_t>(cells.size()));
  for (const auto& cell : cells)
    for (std::size_t k = 0; k < corners; ++k) hash.add32(cell[k]);
  return hash.hex();
}

Mesh compact(const Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNoIndex);
  for (std::uint32_t v : mesh.cells) number[v] = 0;
  Mesh out = mesh;
  const auto attributes = static_cast<std::size_t>(mesh.attributes_per_vertex);
  const bool has_attributes = mesh.vertex_attributes.size() == attributes * mesh.vertices.size();
  const std::uint32_t box_end = mesh.input_vertices + mesh.box_vertices;
  out.input_vertices = out.box_vertices = 0;
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    number[v] = kept;
    out.vertices[kept] = mesh.vertices[v];
    if (!mesh.vertex_features.empty()) out.vertex_features[kept] = mesh.vertex_features[v];
    if (!mesh.vertex_markers.empty()) out.vertex_markers[kept] = mesh.vertex_markers[v];
    if (has_attributes)
      std::copy_n(mesh.vertex_attributes.begin() + static_cast<std::ptrdiff_t>(v * attributes),
                  attributes,
                  out.vertex_attributes.begin() + static_cast<std::ptrdiff_t>(kept * attributes));
    if (v < mesh.input_vertices)
      ++out.input_vertices;
    else if (v < box_end)
      ++out.box_vertices;
    ++kept;
  }
  out.vertices.resize(kept);
  if (!mesh.vertex_features.empty()) out.vertex_features.resize(kept);
  if (!mesh.vertex_markers.empty()) out.vertex_markers.resize(kept);
  if (has_attributes) out.vertex_attributes.resize(kept * attributes);
  for (std::uint32_t& v : out.cells) v = number[v];

  // Subsegments and facets without a cell (outside the domain) go with their vertices.
  out.edges.clear();
  out.edge_markers.clear();
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const MeshEdge& e = mesh.edges[i];
    if (number[e.a] == kNoIndex || number[e.b] == kNoIndex) continue;
    out.edges.push_back({number[e.a], number[e.b], e.segment});
    if (!mesh.edge_markers.empty()) out.edge_markers.push_back(mesh.edge_markers[i]);
  }
  out.facets.clear();
  for (const MeshFacet& f : mesh.facets)
    if (number[f.a] != kNoIndex && number[f.b] != kNoIndex && number[f.c] != kNoIndex)
      out.facets.push_back({number[f.a], number[f.b], number[f.c], f.face});
  return out;
}

}  // namespace circumball
