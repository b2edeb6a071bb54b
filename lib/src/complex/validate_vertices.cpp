#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "complex/box_tree.h"
#include "complex/validate_defects.h"

namespace circumball {
namespace {

/// Vertices closer than this, relative to the diameter of the input, draw a warning
/// (architecture.md, "Numbers").
constexpr double kNearDuplicate = 1e-9;

bool finite(const Point3& p, int dimension) {
  return std::isfinite(p.x) && std::isfinite(p.y) && (dimension == 2 || std::isfinite(p.z));
}
bool in_range(const Point3& p, int dimension) {
  return usable(p.x) && usable(p.y) && (dimension == 2 || usable(p.z));
}

std::string vertex_text(std::uint32_t v) { return "vertex " + std::to_string(v); }

/// Usable vertices in lexicographic order, ties by number.
std::vector<std::uint32_t> sorted_vertices(const Complex& complex) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i)
    if (in_range(complex.vertices[i], complex.dimension)) order.push_back(i);
  const bool space = complex.dimension == 3;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Point3 &p = complex.vertices[a], &q = complex.vertices[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (space && p.z != q.z) return p.z < q.z;
    return a < b;
  });
  return order;
}

Box2 box_of(const Point3& p, Box2) { return Box2::of(xy(p)); }
Box3 box_of(const Point3& p, Box3) { return Box3::of(p); }
Point2 point_of(const Point3& p, Box2) { return xy(p); }
Point3 point_of(const Point3& p, Box3) { return p; }

/// Pairs closer than kNearDuplicate in which one is the other's nearest, sorted. `Box` is of the
/// dimension.
template <class Box>
std::vector<std::array<std::uint32_t, 2>> near_pairs(const Complex& complex,
                                                     const std::vector<std::uint32_t>& distinct) {
  std::vector<Box> boxes;
  boxes.reserve(distinct.size());
  for (const std::uint32_t v : distinct) boxes.push_back(box_of(complex.vertices[v], Box{}));
  Box all = boxes[0];
  for (const Box& b : boxes) all.extend(b);
  double diameter2 = 0;
  for (int axis = 0; axis < complex.dimension; ++axis)
    diameter2 += all.extent(axis) * all.extent(axis);
  const double limit2 = diameter2 * (kNearDuplicate * kNearDuplicate);
  const BoxTreeOf<Box> tree(std::move(boxes));

  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t i = 0; i < distinct.size(); ++i) {
    const auto p = point_of(complex.vertices[distinct[i]], Box{});
    std::uint32_t best = kNoIndex;
    tree.nearest(
        p, [&](std::uint32_t j) { return tree.box(j).distance2(p); },
        [&](std::uint32_t j, double distance2) {
          if (j == i) return true;
          if (distance2 < limit2) best = j;
          return false;
        });
    if (best != kNoIndex)
      pairs.push_back(
          {std::min(distinct[i], distinct[best]), std::max(distinct[i], distinct[best])});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// A cluster of n vertices draws at most n warnings.
void check_near_duplicates(const Complex& complex, const std::vector<std::uint32_t>& distinct,
                           std::size_t max, std::vector<Defect>* defects) {
  if (distinct.size() < 2) return;
  const auto pairs = complex.dimension == 2 ? near_pairs<Box2>(complex, distinct)
                                            : near_pairs<Box3>(complex, distinct);
  DefectList near("near-duplicate-vertices", true, max);
  for (const auto& pair : pairs) {
    if (!near.has_room()) {
      near.count_only();
      continue;
    }
    const Point3 &p = complex.vertices[pair[0]], &q = complex.vertices[pair[1]];
    const double dz = complex.dimension == 3 ? q.z - p.z : 0;
    const double distance =
        std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) + dz * dz);
    near.add({{FeatureKind::kVertex, pair[0]}, {FeatureKind::kVertex, pair[1]}}, {p, q},
             "vertices " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]) +
                 " are only " + number_text(distance) +
                 " apart: the mesh there is graded down to that length; merge them if they are "
                 "meant to be one");
  }
  near.append_to(defects);
}

}  // namespace

void check_vertices(const Complex& complex, std::size_t max, std::vector<Defect>* defects) {
  const int dimension = complex.dimension;
  if (complex.vertices.empty()) {
    DefectList few("too-few-vertices", false, max);
    few.add({}, {}, "the complex has no vertices: nothing can be meshed; add at least one");
    few.append_to(defects);
  }
  DefectList magnitude("magnitude", false, max);
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    const Point3& p = complex.vertices[i];
    if (finite(p, dimension) && !in_range(p, dimension))
      magnitude.add(
          {{FeatureKind::kVertex, i}}, {p},
          vertex_text(i) + " has coordinates " + point_text(p, dimension) +
              ": scale the input so that every coordinate is 0 or of magnitude 1e-45 to 1e55");
  }
  magnitude.append_to(defects);

  const std::vector<std::uint32_t> order = sorted_vertices(complex);
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    const Point3 &p = complex.vertices[a], &q = complex.vertices[b];
    return p.x == q.x && p.y == q.y && (dimension == 2 || p.z == q.z);
  };
  std::vector<std::uint32_t> distinct;
  std::vector<std::array<std::uint32_t, 2>> duplicates;  // (first, later)
  for (const std::uint32_t v : order) {
    if (!distinct.empty() && same(distinct.back(), v))
      duplicates.push_back({distinct.back(), v});
    else
      distinct.push_back(v);
  }
  std::sort(duplicates.begin(), duplicates.end());
  DefectList duplicate("duplicate-vertices", false, max);
  for (const auto& pair : duplicates) {
    const Point3& p = complex.vertices[pair[0]];
    duplicate.add({{FeatureKind::kVertex, pair[0]}, {FeatureKind::kVertex, pair[1]}}, {p},
                  "vertices " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]) +
                      " are both at " + point_text(p, dimension) + ": remove one of them");
  }
  duplicate.append_to(defects);
  check_near_duplicates(complex, distinct, max, defects);
}

}  // namespace circumball
