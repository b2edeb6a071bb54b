#include <algorithm>
#include <cmath>

#include "circumball/complex.h"

namespace circumball {

Complex with_box(const Complex& complex, double scale) {
  const bool space = complex.dimension == 3;
  Complex boxed = complex;
  Point3 low, high;
  if (!complex.vertices.empty()) low = high = complex.vertices[0];
  for (const Point3& p : complex.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (!space) low.z = high.z = 0;
  double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  if (extent == 0) {  // a single vertex: any box will do whose corners are other points
    extent = std::max(
        {1.0, 0x1p-20 * std::abs(low.x), 0x1p-20 * std::abs(low.y), 0x1p-20 * std::abs(low.z)});
  }
  const double half = 0.5 * scale * extent;
  const Point3 center{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
  const auto first = static_cast<std::uint32_t>(boxed.vertices.size());
  // Corners counter-clockwise, seen from above; in space below, then above.
  for (int level = 0; level < (space ? 2 : 1); ++level) {
    const double z = !space ? 0 : level == 0 ? center.z - half : center.z + half;
    boxed.vertices.push_back({center.x - half, center.y - half, z});
    boxed.vertices.push_back({center.x + half, center.y - half, z});
    boxed.vertices.push_back({center.x + half, center.y + half, z});
    boxed.vertices.push_back({center.x - half, center.y + half, z});
    for (std::uint32_t i = 0, at = first + 4 * level; i < 4; ++i) {
      boxed.segments.push_back({at + i, at + (i + 1) % 4});
    }
  }
  if (space) {
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      Face side;
      side.loops = {{first + a, first + b, first + c, first + d}};
      boxed.faces.push_back(std::move(side));
    };
    face(0, 3, 2, 1);
    face(4, 5, 6, 7);
    for (std::uint32_t i = 0; i < 4; ++i) {
      boxed.segments.push_back({first + i, first + i + 4});
      face(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4);
    }
    if (!boxed.face_markers.empty()) boxed.face_markers.resize(boxed.faces.size(), 0);
  }
  if (!boxed.vertex_markers.empty()) boxed.vertex_markers.resize(boxed.vertices.size(), 0);
  if (!boxed.segment_markers.empty()) boxed.segment_markers.resize(boxed.segments.size(), 0);
  if (boxed.attributes_per_vertex > 0) {
    boxed.vertex_attributes.resize(boxed.vertices.size() * boxed.attributes_per_vertex, 0);
  }
  return boxed;
}

Complex with_sides(const Complex& complex) {
  std::vector<std::array<std::uint32_t, 2>> known;
  known.reserve(complex.segments.size());
  const auto ordered = [](std::uint32_t a, std::uint32_t b) {
    return std::array<std::uint32_t, 2>{std::min(a, b), std::max(a, b)};
  };
  for (const auto& s : complex.segments) known.push_back(ordered(s[0], s[1]));
  std::sort(known.begin(), known.end());
  struct Side {
    std::array<std::uint32_t, 2> ends;
    std::size_t place;
  };
  std::vector<Side> missing;
  for (const Face& face : complex.faces) {
    for (const auto& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto ends = ordered(loop[i], loop[(i + 1) % loop.size()]);
        if (ends[1] >= complex.vertices.size() || ends[0] == ends[1]) continue;
        if (std::binary_search(known.begin(), known.end(), ends)) continue;
        missing.push_back({ends, missing.size()});
      }
    }
  }
  if (missing.empty()) return complex;
  std::sort(missing.begin(), missing.end(), [](const Side& a, const Side& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.place < b.place;
  });
  missing.erase(std::unique(missing.begin(), missing.end(),
                            [](const Side& a, const Side& b) { return a.ends == b.ends; }),
                missing.end());
  std::sort(missing.begin(), missing.end(),
            [](const Side& a, const Side& b) { return a.place < b.place; });
  Complex whole = complex;
  for (const Side& side : missing) whole.segments.push_back(side.ends);
  if (!whole.segment_markers.empty()) whole.segment_markers.resize(whole.segments.size(), 0);
  return whole;
}

}  // namespace circumball
