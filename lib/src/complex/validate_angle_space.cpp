#include <algorithm>
#include <cmath>

#include "complex/box_tree.h"
#include "complex/face_plane.h"
#include "complex/kahan_angle.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 times(const Point3& a, double f) { return {a.x * f, a.y * f, a.z * f}; }
Point3 unit(const Point3& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? times(a, 1 / length) : a;
}

class SpaceAngles {
 public:
  explicit SpaceAngles(const Complex& complex) : complex_(complex), view_(complex) {
    for (std::uint32_t f = 0; f < complex.faces.size(); ++f) collect(f);
    const auto by_place = [](const auto& a, const auto& b) {
      return a.at != b.at ? a.at < b.at : a.face < b.face;
    };
    std::stable_sort(wings_.begin(), wings_.end(), by_place);
    std::stable_sort(corners_.begin(), corners_.end(), by_place);
    std::sort(listed_.begin(), listed_.end());
  }

  double smallest() {
    for (std::size_t i = 0, j; i < wings_.size(); i = j) {
      for (j = i; j < wings_.size() && wings_[j].at == wings_[i].at; ++j) {
      }
      look_at_segment(i, j);
    }
    std::size_t corner = 0;
    for (std::uint32_t v = 0; v < complex_.vertices.size(); ++v) {
      const std::size_t first = corner;
      while (corner < corners_.size() && corners_[corner].at == v) ++corner;
      if (view_.degree(v) > 0) look_at_vertex(v, first, corner);
    }
    return smallest_;
  }

 private:
  struct Wing {  // a triangle of a face at a segment of the face
    std::uint32_t at, face;
    std::uint32_t a, b, apex;
  };
  struct Corner {  // a triangle of a face at a vertex
    std::uint32_t at, face;
    std::uint32_t b, c;
  };
  const Point3& point(std::uint32_t v) const { return complex_.vertices[v]; }
  void take(double angle) {
    if (angle < smallest_) smallest_ = angle;
  }

  void collect(std::uint32_t f) {
    if (!is_usable(complex_, f)) return;
    const FacePlane plane(complex_, f);
    if (!plane.valid()) return;
    const FaceLayout layout(complex_, f, FaceProjection::along(plane.normal()), {});
    if (!is_planar(layout)) return;
    const FaceTriangles parts = triangulate(layout);
    for (std::size_t k = 0; k < parts.triangles.size(); ++k) {
      const auto& t = parts.triangles[k];
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        corners_.push_back({t[i], f, b, c});
        const std::uint32_t s = parts.inner[k] >> i & 1 ? kNoIndex : view_.find(b, c);
        if (s == kNoIndex) continue;
        wings_.push_back({s, f, b, c, t[i]});
        listed_.push_back({f, s});
      }
    }
  }

  /// Between the faces at a segment: neighbors in the order around it.
  void look_at_segment(std::size_t first, std::size_t last) {
    if (last - first < 2) return;
    const auto& s = complex_.segments[wings_[first].at];
    const Point3& origin = point(s[0]);
    const Point3 axis = unit(minus(point(s[1]), origin));
    struct Direction {
      Point3 w;
      double order;
      std::uint32_t face;
    };
    std::vector<Direction> around;
    Point3 x, y;
    for (std::size_t k = first; k < last; ++k) {
      const Point3 to = minus(point(wings_[k].apex), origin);
      const Point3 w = unit(minus(to, times(axis, dot(to, axis))));
      if (k == first) x = w, y = cross(axis, w);
      // Increases with the angle from x, from -2 to 2.
      const double c = dot(w, x), d = dot(w, y), sum = std::fabs(c) + std::fabs(d);
      const double p = sum > 0 ? c / sum : 0;
      around.push_back({w, d >= 0 ? 1 - p : p - 1, wings_[k].face});
    }
    std::stable_sort(around.begin(), around.end(),
                     [](const Direction& p, const Direction& q) { return p.order < q.order; });
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Direction &p = around[k], &q = around[k + 1 < around.size() ? k + 1 : 0];
      if (p.face != q.face) take(angle_degrees(p.w, q.w));
    }
  }

  /// Between the segments at a vertex, and between them and the faces there.
  void look_at_vertex(std::uint32_t v, std::size_t first, std::size_t last) {
    const std::uint32_t begin = view_.first[v], degree = view_.degree(v);
    std::vector<Point3> to;
    std::vector<Box3> boxes;
    for (std::uint32_t k = 0; k < degree; ++k) {
      to.push_back(minus(point(view_.star[begin + k].neighbor), point(v)));
      boxes.push_back(Box3::of(unit(to.back())));
    }
    const BoxTree3 tree(boxes);  // of directions, as points of the unit sphere
    for (std::uint32_t k = 0; k < degree && degree > 1; ++k) {
      const Point3 u = unit(to[k]);
      // An angle is at least its chord; rounding is far below the slack.
      tree.query([&](const Box3& box) { return box.distance2(u) <= reach() * reach(); },
                 [&](std::uint32_t j) {
                   if (j != k) take(angle_degrees(to[k], to[j]));
                   return true;
                 });
    }
    for (std::size_t i = first; i < last; ++i) {
      const Corner& corner = corners_[i];
      const Point3 b = minus(point(corner.b), point(v)), c = minus(point(corner.c), point(v));
      const Point3 n = unit(cross(unit(b), unit(c)));
      tree.query(
          [&](const Box3& box) {  // near the plane of the corner
            const double h =
                0.5 * (std::fabs(n.x) * box.extent(0) + std::fabs(n.y) * box.extent(1) +
                       std::fabs(n.z) * box.extent(2));
            return std::fabs(0.5 * (n.x * box.middle2(0) + n.y * box.middle2(1) +
                                    n.z * box.middle2(2))) <= h + reach();
          },
          [&](std::uint32_t j) {
            if (std::binary_search(
                    listed_.begin(), listed_.end(),
                    std::array<std::uint32_t, 2>{corner.face, view_.star[begin + j].segment}))
              return true;
            const double rise = dot(n, to[j]);
            const Point3 shadow = minus(to[j], times(n, rise));
            // Beyond the corner's edges a segment or another corner of the face is nearer.
            if (dot(n, cross(b, shadow)) >= 0 && dot(n, cross(shadow, c)) >= 0) {
              // Measured from the plane or from its normal, whichever is farther: the shadow of
              // what is perpendicular is noise.
              take(dot(shadow, shadow) > rise * rise ? angle_degrees(to[j], shadow)
                                                     : 90 - angle_degrees(to[j], times(n, rise)));
            }
            return true;
          });
    }
  }
  /// The smallest angle in radians, and a little more.
  double reach() const { return smallest_ * (3.1415926535897931 / 180) + 1e-12; }

  const Complex& complex_;
  const SpaceView view_;
  std::vector<Wing> wings_;
  std::vector<Corner> corners_;
  std::vector<std::array<std::uint32_t, 2>> listed_;  // (face, segment of it)
  double smallest_ = 180;
};

}  // namespace

double smallest_angle_in_space(const Complex& complex) { return SpaceAngles(complex).smallest(); }

}  // namespace circumball
