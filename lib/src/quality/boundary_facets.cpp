#include "quality/boundary_facets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "complex/box_tree.h"
#include "feature_size/face_pieces.h"
#include "feature_size/vectors.h"

namespace circumball {
namespace {

using Triangle = std::array<Point3, 3>;

double distance2_to_side(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 d = b - a, w = p - a;
  const double dd = dot(d, d);
  const double t = dd > 0 ? std::clamp(dot(w, d) / dd, 0.0, 1.0) : 0;
  const Point3 q = along(w, -t, d);
  return dot(q, q);
}

bool is_near(const Point3& p, const Triangle& t, double reach) {
  const Point3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double n2 = dot(n, n), height = dot(p - t[0], n);
  bool above = n2 > 0;  // its projection is in the triangle
  for (std::size_t k = 0; k < 3; ++k) {
    above = above && dot(cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0;
  }
  if (above) return height * height <= reach * reach * n2;
  for (std::size_t k = 0; k < 3; ++k) {
    if (distance2_to_side(p, t[k], t[(k + 1) % 3]) <= reach * reach) return true;
  }
  return false;
}

Point3 mean(const Point3& a, const Point3& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}

}  // namespace

std::size_t boundary_facets_off_faces(const VerifyContext3& context,
                                      std::vector<std::uint32_t>* worst) {
  const double reach = 2 * context.on_segment();
  std::vector<Triangle> triangles;
  std::vector<Box3> boxes;
  for (std::uint32_t f = 0; f < context.complex.faces.size(); ++f) {
    for (const Triangle& t : face_pieces(context.complex, f).triangles) {
      const Box3 box = Box3::of(t[0], t[1], t[2]);
      triangles.push_back(t);
      boxes.push_back(Box3::of({box.lo_x - reach, box.lo_y - reach, box.lo_z - reach},
                               {box.hi_x + reach, box.hi_y + reach, box.hi_z + reach}));
    }
  }
  const BoxTree3 tree(std::move(boxes));
  const auto in_a_face = [&](const Point3& p) {
    bool found = false;
    tree.query([&](const Box3& box) { return !found && box.meets(Box3::of(p)); },
               [&](std::uint32_t i) {
                 found = found || is_near(p, triangles[i], reach);
                 return !found;
               });
    return found;
  };
  std::vector<std::uint8_t> corner(context.mesh.vertices.size(), 2);  // 2: not asked yet
  const auto corner_in_a_face = [&](std::uint32_t v) {
    if (corner[v] == 2) corner[v] = in_a_face(context.point(v));
    return corner[v] == 1;
  };
  std::size_t off = 0;
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    if (context.twin[f] != kNoIndex) continue;
    const auto v = context.corners(f);
    const Point3 &a = context.point(v[0]), &b = context.point(v[1]), &c = context.point(v[2]);
    const bool in =
        corner_in_a_face(v[0]) && corner_in_a_face(v[1]) && corner_in_a_face(v[2]) &&
        in_a_face(mean(a, b)) && in_a_face(mean(b, c)) && in_a_face(mean(c, a)) &&
        in_a_face({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
    if (!in && off++ == 0) *worst = {v[0], v[1], v[2]};
  }
  return off;
}

}  // namespace circumball
