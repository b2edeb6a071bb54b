#include <algorithm>
#include <cmath>

#include "circumball/mesh.h"
#include "delaunay/tetrahedron_shape.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

Point3 difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

DihedralHistogram dihedral_histogram(const Mesh& mesh, double bound_degrees) {
  DihedralHistogram histogram;
  if (mesh.dimension != 3 || mesh.cells.empty()) return histogram;
  histogram.min = 180;
  const std::size_t n = mesh.vertices.size();
  for (std::size_t k = 0; k < mesh.cell_count(); ++k) {
    const std::uint32_t* v = mesh.cell(k);
    if (v[0] >= n || v[1] >= n || v[2] >= n || v[3] >= n) continue;
    const Point3 p[4] = {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]],
                         mesh.vertices[v[3]]};
    // Of a flat cell the volume is mostly rounding in plain doubles.
    const double volume6 = tetrahedron_shape(p[0], p[1], p[2], p[3]).volume6;
    double least = 180;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const int a = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2, b = 6 - i - j - a;
        const Point3 e = difference(p[j], p[i]);
        const Point3 normal = cross(e, difference(p[a], p[i])),
                     other = cross(e, difference(p[b], p[i]));
        // |normal x other| = |e| 6 V.
        const double sine = std::sqrt(dot(e, e)) * volume6;
        const double angle = elementary::atan2(sine, dot(normal, other)) * (180 / elementary::kPi);
        least = std::min(least, angle);
        histogram.max = std::max(histogram.max, angle);
        ++histogram.counts[static_cast<std::size_t>(std::clamp(angle / 10, 0.0, 17.0))];
      }
    }
    histogram.min = std::min(histogram.min, least);
    histogram.slivers += least < bound_degrees;
  }
  return histogram;
}

}  // namespace circumball
