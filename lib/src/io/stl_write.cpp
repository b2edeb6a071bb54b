#include <cmath>

#include "io/formats.h"
#include "io/mesh_parts.h"

// STL, ASCII: text holds doubles, binary files have single precision only.
namespace circumball::io {
namespace {

/// The unit normal of a triangle, counter-clockwise from its tip; 0 where it has none.
Point3 normal_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

}  // namespace

std::string write_stl_mesh(const Mesh& mesh) {
  const MeshSurface surface = surface_of(mesh);
  std::string out = "solid circumball\n";
  for (const auto& t : surface.triangles) {
    const Point3 corners[] = {surface.vertices[t[0]], surface.vertices[t[1]],
                              surface.vertices[t[2]]};
    out += "facet normal " + coordinates(normal_of(corners[0], corners[1], corners[2])) +
           "\nouter loop\n";
    for (const Point3& p : corners) out += "vertex " + coordinates(p) + "\n";
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid circumball\n";
}

}  // namespace circumball::io
