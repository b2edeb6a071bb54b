#include "feature_size/face_pieces.h"

#include <algorithm>

#include "circumball/predicates.h"
#include "complex/face_plane.h"

namespace circumball {
namespace {

bool convex(const std::vector<Point2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    if (orient2d(corners[k], corners[(k + 1) % n], corners[(k + 2) % n]) != Sign::kPositive)
      return false;
  return true;
}

}  // namespace

std::vector<std::array<Point3, 3>> face_pieces(const Complex& complex, std::uint32_t face) {
  std::vector<std::array<Point3, 3>> pieces;
  const FacePlane plane(complex, face);
  if (!plane.valid()) return pieces;
  struct Side {
    Point2 low, high;
    Point2 at(double y) const {
      if (y <= low.y) return low;
      if (y >= high.y) return high;
      return {low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x), y};
    }
  };
  std::vector<Side> sides;
  std::vector<double> levels;
  std::vector<Point2> corners;
  std::size_t polygons = 0;
  for (const auto& loop : complex.faces[face].loops) {
    if (loop.size() < 3) continue;
    ++polygons;
    corners.clear();
    for (const std::uint32_t v : loop) corners.push_back(plane.to_plane(complex.vertices[v]));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      Point2 a = corners[k], b = corners[(k + 1) % corners.size()];
      levels.push_back(a.y);
      if (b.y < a.y) std::swap(a, b);
      if (a.y < b.y) sides.push_back({a, b});
    }
  }
  if (polygons == 1 && convex(corners)) {
    for (const auto& loop : complex.faces[face].loops) {
      for (std::size_t k = 1; loop.size() >= 3 && k + 1 < loop.size(); ++k)
        pieces.push_back(
            {complex.vertices[loop[0]], complex.vertices[loop[k]], complex.vertices[loop[k + 1]]});
    }
    return pieces;
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double low = levels[k], high = levels[k + 1], middle = 0.5 * (low + high);
    std::vector<Side> across;
    for (const Side& side : sides)
      if (side.low.y <= low && side.high.y >= high) across.push_back(side);
    std::sort(across.begin(), across.end(),
              [&](const Side& s, const Side& t) { return s.at(middle).x < t.at(middle).x; });
    for (std::size_t s = 0; s + 1 < across.size(); ++s) {
      const Point2 between = {0.5 * (across[s].at(middle).x + across[s + 1].at(middle).x), middle};
      if (!plane.contains(between)) continue;
      const Point3 a = plane.to_space(across[s].at(low)), b = plane.to_space(across[s + 1].at(low)),
                   c = plane.to_space(across[s + 1].at(high)),
                   d = plane.to_space(across[s].at(high));
      pieces.push_back({a, b, c});
      pieces.push_back({a, c, d});
    }
  }
  return pieces;
}

}  // namespace circumball
