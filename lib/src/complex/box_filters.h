#ifndef CIRCUMBALL_COMPLEX_BOX_FILTERS_H_
#define CIRCUMBALL_COMPLEX_BOX_FILTERS_H_

#include <cmath>

#include "complex/box_tree.h"

namespace circumball {

/// Filters for queries of a box tree: they are false only if the box is surely apart.

/// A line of the plane, by two points.
struct LineFilter {
  double ax, ay, ux, uy;
  double grown = 0;  // a distance, within which of the line counts as well
  static LineFilter through(double ax, double ay, double bx, double by) {
    return {ax, ay, bx - ax, by - ay, 0};
  }
  bool may_meet(double lo_x, double lo_y, double hi_x, double hi_y) const {
    const double cx = 0.5 * lo_x + 0.5 * hi_x - ax, cy = 0.5 * lo_y + 0.5 * hi_y - ay;
    const double hx = 0.5 * hi_x - 0.5 * lo_x, hy = 0.5 * hi_y - 0.5 * lo_y;
    const double side = std::fabs(ux * cy - uy * cx);
    const double reach = std::fabs(ux) * hy + std::fabs(uy) * hx;
    // 2^-48 of the magnitudes that enter is far above the rounding of the few operations.
    const double slack =
        3.6e-15 * (std::fabs(ux) * (std::fabs(lo_y) + std::fabs(hi_y) + std::fabs(ay)) +
                   std::fabs(uy) * (std::fabs(lo_x) + std::fabs(hi_x) + std::fabs(ax)));
    return side <= reach + grown * (std::fabs(ux) + std::fabs(uy)) + slack;
  }
};

/// A segment of space: its box, and the line's projection onto each coordinate plane.
struct SegmentFilter {
  Box3 box;
  LineFilter x, y, z;
  SegmentFilter(const Point3& a, const Point3& b)
      : box(Box3::of(a, b)),
        x(LineFilter::through(a.y, a.z, b.y, b.z)),
        y(LineFilter::through(a.z, a.x, b.z, b.x)),
        z(LineFilter::through(a.x, a.y, b.x, b.y)) {}
  /// Makes it a filter for what is within a distance of the segment.
  void grow(double distance) {
    box = box.grown(distance);
    x.grown = y.grown = z.grown = distance;
  }
  bool may_meet(const Box3& o) const {
    return o.meets(box) && x.may_meet(o.lo_y, o.lo_z, o.hi_y, o.hi_z) &&
           y.may_meet(o.lo_z, o.lo_x, o.hi_z, o.hi_x) && z.may_meet(o.lo_x, o.lo_y, o.hi_x, o.hi_y);
  }
};

/// A triangle of space: its box and its plane.
struct TriangleFilter {
  Box3 box;
  Point3 a, n;
  double error;  // of n, times a length: relative to the edges' lengths in place of n's own
  double grown = 0;
  TriangleFilter(const Point3& p, const Point3& q, const Point3& r) : box(Box3::of(p, q, r)), a(p) {
    const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
    const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
    n = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
    error = 3.6e-15 * (std::fabs(ux) + std::fabs(uy) + std::fabs(uz)) *
            (std::fabs(vx) + std::fabs(vy) + std::fabs(vz));
  }
  /// Makes it a filter for what is within a distance of the triangle.
  void grow(double distance) {
    box = box.grown(distance);
    grown = distance * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
  }
  bool may_meet(const Box3& o) const {
    if (!o.meets(box)) return false;
    const double cx = 0.5 * o.lo_x + 0.5 * o.hi_x - a.x, cy = 0.5 * o.lo_y + 0.5 * o.hi_y - a.y,
                 cz = 0.5 * o.lo_z + 0.5 * o.hi_z - a.z;
    const double hx = 0.5 * o.hi_x - 0.5 * o.lo_x, hy = 0.5 * o.hi_y - 0.5 * o.lo_y,
                 hz = 0.5 * o.hi_z - 0.5 * o.lo_z;
    const double side = std::fabs(n.x * cx + n.y * cy + n.z * cz);
    const double reach = std::fabs(n.x) * hx + std::fabs(n.y) * hy + std::fabs(n.z) * hz;
    const double size = std::fabs(o.lo_x) + std::fabs(o.hi_x) + std::fabs(a.x) + std::fabs(o.lo_y) +
                        std::fabs(o.hi_y) + std::fabs(a.y) + std::fabs(o.lo_z) + std::fabs(o.hi_z) +
                        std::fabs(a.z);
    return side <= reach + grown + error * size;
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_BOX_FILTERS_H_
