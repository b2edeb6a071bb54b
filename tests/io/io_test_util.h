#ifndef CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_
#define CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_

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

}  // namespace circumball::io_test

#endif  // CIRCUMBALL_TESTS_IO_IO_TEST_UTIL_H_
