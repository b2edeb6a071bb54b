#ifndef CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_
#define CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "circumball/io.h"

namespace circumball::io_test {

/// The same numbers everywhere (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
/// 2014).
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

/// A folder in memory.
inline Sibling folder(std::map<std::string, std::string> files) {
  return [files = std::move(files)](const std::string& name) -> std::optional<std::string> {
    const auto it = files.find(name);
    if (it == files.end()) return std::nullopt;
    return it->second;
  };
}

/// Names of the defects, parted by blanks; warnings in parentheses.
inline std::string names(const ReadResult& result) {
  std::string out;
  for (const Defect& d : result.defects)
    out += (out.empty() ? "" : " ") + (d.warning ? "(" + d.name + ")" : d.name);
  return out;
}

/// Names and messages of the defects of `check`, one a line; no warnings.
inline std::string check_text(const Complex& complex) {
  std::string out;
  for (const Defect& d : check(complex))
    if (!d.warning) out += d.name + ": " + d.message + "\n";
  return out;
}

/// The family that a mesh was written as, by extension, under one stem.
inline std::map<std::string, std::string> files(const std::vector<OutputFile>& output,
                                                const std::string& stem) {
  std::map<std::string, std::string> out;
  for (const OutputFile& file : output) out[stem + file.extension] = file.bytes;
  return out;
}

/// A square with a hole, two regions, markers, attributes and awkward coordinates.
inline Complex sample_complex() {
  Complex c;
  c.vertices = {{0, 0, 0},     {1.0 / 3, 0, 0}, {1e6 + 1e-9, 1, 0}, {-0.1, 5e-324, 0},
                {1e-45, 2, 0}, {7, 1e55, 0},    {0.5, 0.5, 0},      {1e22, -1e-7, 0}};
  c.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}};
  c.holes = {{0.1, 0.2, 0}};
  c.hole_rule = HoleRule::kSeeds;
  c.regions = {{{0.3, 0.3, 0}, 2, 0.25}, {{4, 4, 0}, -1.5, 0}};
  c.vertex_markers = {1, 0, -1, 4, 5, 6, 2147483647, -2147483647};
  c.segment_markers = {3, 2, 1, 0, -1};
  return c;
}

/// Two triangles of a unit square and a third beside it, with everything that a mesh may carry.
inline Mesh sample_mesh() {
  Mesh m;
  m.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.0 / 3 + 1, 0.1, 0}};
  m.input_vertices = 4;
  m.cells = {0, 1, 2, 0, 2, 3, 1, 4, 2};
  m.cell_regions = {1, 2, 1};
  m.vertex_features = {{FeatureKind::kVertex, 0},
                       {FeatureKind::kVertex, 1},
                       {FeatureKind::kVertex, 2},
                       {FeatureKind::kVertex, 3},
                       {FeatureKind::kFree, kNoIndex}};
  m.edges = {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, kNoIndex}};
  return m;
}

/// A face with a hole, a segment and a vertex in it, a triangle beside it, a segment that stands
/// alone, and everything else that a complex of space may carry.
inline Complex sample_space_complex() {
  Complex c;
  c.dimension = 3;
  c.vertices = {{0, 0, 0},        {3, 0, 0},         {3, 3, 0},          {0, 3, 0},    {1, 1, 0},
                {2, 1, 0},        {1.5, 2, 0},       {1.0 / 3, 2, 0},    {.5, 2.5, 0}, {2.5, 2, 0},
                {1e6, 1e-45, 1.}, {-0.1, 5e-324, 9}, {1e22, -1e-7, 1e55}};
  c.segments = {{3, 2}, {10, 11}, {0, 1}, {1, 2},  {3, 0}, {4, 5},
                {5, 6}, {6, 4},   {7, 8}, {2, 12}, {12, 3}};
  c.faces.resize(2);
  c.faces[0].loops = {{0, 1, 2, 3}, {4, 5, 6}};
  c.faces[0].holes = {{1.5, 1.25, 0}};
  c.faces[0].segments = {8};
  c.faces[0].vertices = {9};
  c.faces[1].loops = {{3, 2, 12}};
  c.holes = {{0.1, 0.2, 1.0 / 7}};
  c.hole_rule = HoleRule::kSeeds;
  c.regions = {{{0.3, 0.3, -4}, 2, 0.25}, {{4, 4, 1e-9}, -1.5, 0}};
  c.vertex_markers = {1, 0, -1, 4, 5, 6, 2147483647, -2147483647, 0, 0, 7, 8, 9};
  c.segment_markers = {3, 2, 1, 0, -1, 7, 0, 0, 5, 0, 0};
  c.face_markers = {-4, 11};
  return c;
}

/// Two tetrahedra over one input face of two facets, with everything that a mesh may carry.
inline Mesh sample_space_mesh() {
  Mesh m;
  m.dimension = 3;
  m.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {0.5, 0.5, 0}, {0.1, 0.2, 1}};
  m.input_vertices = 3;
  m.box_vertices = 1;
  m.cells = {0, 4, 1, 5, 0, 2, 4, 5};
  m.cell_regions = {1.5, 2};
  m.vertex_features = {{FeatureKind::kVertex, 0},  {FeatureKind::kVertex, 1},
                       {FeatureKind::kVertex, 2},  {FeatureKind::kVertex, 3},
                       {FeatureKind::kSegment, 1}, {FeatureKind::kFree, kNoIndex}};
  m.edges = {{0, 1, 0}, {1, 4, 1}, {4, 2, 1}, {2, 0, kNoIndex}};
  m.facets = {{0, 1, 4, 0}, {0, 4, 2, 0}, {0, 2, 5, kNoIndex}};
  m.vertex_markers = {3, 0, -2, 0, 5, 6};
  m.edge_markers = {8, 0, -9, 1};
  m.attributes_per_vertex = 2;
  for (int i = 0; i < 12; ++i) m.vertex_attributes.push_back(1.0 / (i + 3));
  return m;
}

/// The complex of that mesh.
inline Complex sample_complex_of_space_mesh() {
  Complex c;
  c.dimension = 3;
  c.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  c.segments = {{0, 1}, {1, 2}, {2, 0}};
  c.faces.resize(1);
  c.faces[0].loops = {{0, 1, 2}};
  c.face_markers = {17};
  c.segment_markers = {8, 0, 1};
  c.hole_rule = HoleRule::kSeeds;
  return c;
}

/// A number as its bytes, in either order; little-endian machines only, as all that run the tests.
inline void put(std::string* out, const void* value, std::size_t size, bool big = false) {
  std::string bytes(static_cast<const char*>(value), size);
  if (big) std::reverse(bytes.begin(), bytes.end());
  *out += bytes;
}

/// `count` triangles, each with corners of its own.
inline std::string binary_stl(std::uint32_t count) {
  std::string out = "solid but binary" + std::string(64, ' ');
  put(&out, &count, 4);
  for (std::uint32_t i = 0; i < count; ++i) {
    out += std::string(12, '\0');
    for (std::uint32_t k = 0; k < 9; ++k) {
      const auto x = static_cast<float>((i * 7 + k * k * 5) % 64);
      put(&out, &x, 4);
    }
    out += std::string(2, '\0');
  }
  return out;
}

/// A tetrahedron.
inline std::string binary_ply(bool big) {
  std::string out = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                    "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 4\nproperty list uchar ushort "
                    "vertex_indices\nend_header\n";
  for (int v = 0; v < 4; ++v)
    for (int k = 0; k < 3; ++k) {
      const float x = v == k + 1 ? 1.5f : 0;
      put(&out, &x, 4, big);
    }
  for (std::uint16_t skipped = 0; skipped < 4; ++skipped) {
    out += '\3';
    for (std::uint16_t v = 0; v < 4; ++v)
      if (v != skipped) put(&out, &v, 2, big);
  }
  return out;
}

}  // namespace circumball::io_test

#endif  // CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_
