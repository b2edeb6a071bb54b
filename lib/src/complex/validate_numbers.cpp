#include <cmath>

#include "complex/validate_defects.h"

namespace circumball {
namespace {

bool finite(const Point3& p, int dimension) {
  return std::isfinite(p.x) && std::isfinite(p.y) && (dimension == 2 || std::isfinite(p.z));
}

void check_finite(const Complex& complex, std::size_t max, std::vector<Defect>* defects) {
  DefectList list("not-finite", false, max);
  const auto look = [&](const Point3& p, int dimension, std::vector<Feature> features,
                        const std::string& name) {
    if (finite(p, dimension)) return;
    list.add(std::move(features), {p},
             name + " has coordinates " + point_text(p, dimension) + ": give it finite numbers");
  };
  const int dimension = complex.dimension;
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i)
    if (!finite(complex.vertices[i], dimension))
      look(complex.vertices[i], dimension, {{FeatureKind::kVertex, i}},
           "vertex " + std::to_string(i));
  for (std::uint32_t i = 0; i < complex.faces.size(); ++i)
    for (std::size_t k = 0; k < complex.faces[i].holes.size(); ++k)
      look(complex.faces[i].holes[k], 3, {{FeatureKind::kFace, i}},
           "hole seed " + std::to_string(k) + " of face " + std::to_string(i));
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    look(complex.holes[i], dimension, {}, "hole seed " + std::to_string(i));
  for (std::size_t i = 0; i < complex.regions.size(); ++i) {
    const Region& region = complex.regions[i];
    const std::string name = "region seed " + std::to_string(i);
    look(region.at, dimension, {}, name);
    if (!std::isfinite(region.max))
      list.add({}, {region.at},
               name + " bounds the size of cells by " + number_text(region.max) +
                   ": give a positive number, or 0 for no bound");
  }
  list.append_to(defects);
}

/// A number that no index can hold is kept as kNoIndex.
std::string index_text(std::uint32_t index) {
  return index == kNoIndex ? "none" : std::to_string(index);
}

std::string range_text(std::size_t count, const char* of) {
  return count == 0 ? std::string("there are no ") + of
                    : "there are only " + std::to_string(count) + " " + of + ", numbered from 0";
}

void check_indices(const Complex& complex, std::size_t max, std::vector<Defect>* defects) {
  const std::size_t n = complex.vertices.size(), m = complex.segments.size();
  DefectList list("index-out-of-range", false, max);
  for (std::uint32_t i = 0; i < m; ++i) {
    const auto& s = complex.segments[i];
    if (s[0] < n && s[1] < n) continue;
    list.add({{FeatureKind::kSegment, i}}, {},
             "segment " + std::to_string(i) + " joins vertices " + index_text(s[0]) + " and " +
                 index_text(s[1]) + ", but " + range_text(n, "vertices") + ": correct its ends");
  }
  for (std::uint32_t i = 0; i < complex.faces.size(); ++i) {
    const Face& face = complex.faces[i];
    const auto look = [&](const std::vector<std::uint32_t>& indices, std::size_t count,
                          const char* one, const char* many) {
      for (const std::uint32_t index : indices)
        if (index >= count)
          list.add({{FeatureKind::kFace, i}}, {},
                   "face " + std::to_string(i) + " refers to " + one + " " + index_text(index) +
                       ", but " + range_text(count, many) + ": correct the number");
    };
    for (const auto& loop : face.loops) look(loop, n, "vertex", "vertices");
    look(face.vertices, n, "vertex", "vertices");
    look(face.segments, m, "segment", "segments");
  }
  list.append_to(defects);
}

}  // namespace

std::vector<Defect> check_numbers(const Complex& complex, std::size_t max_defects) {
  std::vector<Defect> defects;
  check_finite(complex, max_defects, &defects);
  check_indices(complex, max_defects, &defects);
  return defects;
}

}  // namespace circumball
