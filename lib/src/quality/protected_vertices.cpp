#include "quality/protected_vertices.h"

#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"

namespace circumball {
namespace {

/// Vertices of the complex at which two segments meet at less than 90 degrees. Exact.
std::vector<bool> acute_corners(const Complex& complex) {
  std::vector<std::vector<Point2>> ends(complex.vertices.size());
  for (const auto& s : complex.segments) {
    if (s[0] >= ends.size() || s[1] >= ends.size()) continue;
    ends[s[0]].push_back(xy(complex.vertices[s[1]]));
    ends[s[1]].push_back(xy(complex.vertices[s[0]]));
  }
  std::vector<bool> acute(ends.size(), false);
  for (std::size_t v = 0; v < ends.size(); ++v) {
    const Point2 p = xy(complex.vertices[v]);
    for (std::size_t i = 1; i < ends[v].size() && !acute[v]; ++i) {
      for (std::size_t j = 0; j < i && !acute[v]; ++j) {
        acute[v] = ends[v][i] != ends[v][j] &&
                   in_diametral_ball(ends[v][i], ends[v][j], p) == Sign::kNegative;
      }
    }
  }
  return acute;
}

}  // namespace

std::vector<double> protection_distances(const VerifyContext& context) {
  const Complex& complex = context.complex;
  const std::vector<bool> acute = context.options.protect_all
                                      ? std::vector<bool>(complex.vertices.size(), true)
                                      : acute_corners(complex);
  std::vector<bool> is_protected(context.mesh.vertices.size(), false);
  for (std::size_t i = 0; i < acute.size(); ++i) {
    if (acute[i] && context.mesh_vertex[i] != kNoIndex) is_protected[context.mesh_vertex[i]] = true;
  }
  std::vector<double> distances(context.mesh.vertices.size(), 0);
  for (const MeshEdge& e : context.mesh.edges) {
    const Point2 a = context.point(e.a), b = context.point(e.b);
    const double length = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    for (const std::uint32_t v : {e.a, e.b}) {
      if (is_protected[v]) distances[v] = std::max(distances[v], length);
    }
  }
  return distances;
}

}  // namespace circumball
