#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/formats.h"
#include "io/polygon_soup.h"

namespace circumball::io {
namespace {

using Cell = std::array<double, 3>;

/// For each vertex the first before it (or itself) that is at most `tolerance` away and stays. Each
/// vertex that stays is kept in the cell of a grid, which is as wide as the tolerance.
std::vector<std::uint32_t> targets(const std::vector<Point3>& points, double tolerance) {
  std::vector<std::uint32_t> target(points.size());
  std::map<Cell, std::vector<std::uint32_t>> grid;
  const double reach = tolerance > 0 ? 1 : 0;
  const auto cell = [&](double x) { return tolerance > 0 ? std::floor(x / tolerance) : x + 0.0; };
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    target[i] = i;
    const Cell c{cell(p.x), cell(p.y), cell(p.z)};
    if (!std::isfinite(c[0]) || !std::isfinite(c[1]) || !std::isfinite(c[2])) continue;
    for (double x = -reach; x <= reach; ++x)
      for (double y = -reach; y <= reach; ++y)
        for (double z = -reach; z <= reach; ++z) {
          const auto found = grid.find({c[0] + x, c[1] + y, c[2] + z});
          if (found == grid.end()) continue;
          for (const std::uint32_t j : found->second) {
            const double dx = points[j].x - p.x, dy = points[j].y - p.y, dz = points[j].z - p.z;
            if (j < target[i] && dx * dx + dy * dy + dz * dz <= tolerance * tolerance)
              target[i] = j;
          }
        }
    if (target[i] == i) grid[c].push_back(i);
  }
  return target;
}

}  // namespace

void weld(double tolerance, PolygonSoup* soup, ReadResult& result) {
  const std::vector<std::uint32_t> target = targets(soup->vertices, tolerance);
  std::vector<std::uint32_t> number(target.size());
  std::vector<Point3> kept;
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    number[i] = target[i] == i ? static_cast<std::uint32_t>(kept.size()) : number[target[i]];
    if (target[i] == i) kept.push_back(soup->vertices[i]);
  }
  const auto renumber = [&](std::uint32_t v) { return v < number.size() ? number[v] : kNoIndex; };
  std::vector<std::uint32_t> corners, ends{0};
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < soup->polygon_count(); ++i) {
    const std::size_t first = corners.size();
    for (std::uint32_t k = soup->ends[i]; k < soup->ends[i + 1]; ++k) {
      const std::uint32_t v = renumber(soup->corners[k]);
      if (corners.size() == first || corners.back() != v || v == kNoIndex) corners.push_back(v);
    }
    while (corners.size() > first + 1 && corners.back() == corners[first] &&
           corners.back() != kNoIndex)
      corners.pop_back();
    if (corners.size() - first < 3) {
      corners.resize(first);
      ++dropped;
    } else {
      ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
  }
  for (auto& s : soup->segments) s = {renumber(s[0]), renumber(s[1])};
  if (tolerance > 0 && kept.size() < soup->vertices.size())
    warn(result, "welded",
         std::to_string(soup->vertices.size()) + " vertices became " + std::to_string(kept.size()) +
             ", since some are at most " + format_double(tolerance) + " apart: see --weld");
  if (dropped > 0)
    warn(result, "ignored",
         std::to_string(dropped) +
             " polygons have fewer than 3 different corners, and were left "
             "out: correct them if they mean something");
  soup->vertices = std::move(kept);
  soup->corners = std::move(corners);
  soup->ends = std::move(ends);
}

}  // namespace circumball::io
