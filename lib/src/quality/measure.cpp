#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "circumball/verify.h"
#include "complex/product_sum.h"
#include "predicates/elementary.h"
#include "quality/measure3.h"
#include "quality/triangle_measure.h"

namespace circumball {

TriangleMeasure measure_triangle(const Point2& a, const Point2& b, const Point2& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y, wx = a.x - c.x,
               wy = a.y - c.y;
  const double u2 = ux * ux + uy * uy, v2 = vx * vx + vy * vy, w2 = wx * wx + wy * wy;
  TriangleMeasure m;
  m.shortest = std::sqrt(std::min({u2, v2, w2}));
  m.longest = std::sqrt(std::max({u2, v2, w2}));
  // The cross product of the two shorter edges. With unit roundoff e = 2^-53 differences have
  // relative errors of e, products of 3 e, so that the cross product is off by at most 4 e of the
  // sum of its two products.
  double px, py, qx, qy;
  if (u2 >= v2 && u2 >= w2)
    px = vx, py = vy, qx = wx, qy = wy;
  else if (v2 >= w2)
    px = wx, py = wy, qx = ux, qy = uy;
  else
    px = ux, py = uy, qx = vx, qy = vy;
  m.cross = px * qy - py * qx;
  double cross_error = 0x1p-51 * ((std::fabs(px * qy) + std::fabs(py * qx)) / std::fabs(m.cross));
  if (!(cross_error < 1e-13)) {
    ProductSum sum;
    sum.add_cross(a.x, a.y, b.x, b.y);
    sum.add_cross(b.x, b.y, c.x, c.y);
    sum.add_cross(c.x, c.y, a.x, a.y);
    m.cross = sum.value();
    // Another evaluation need not have taken this care; what it can be off by is granted up to
    // 1e-11.
    cross_error = std::min(std::max(cross_error, 0.0), 1e-11);
    if (!(cross_error <= 1e-11)) cross_error = 1e-11;  // NaN
  }
  m.error = cross_error + 0x1p-49;  // three lengths at 2.5 e each, their products, the quotients
  if (m.cross == 0) {
    m.circumradius = m.radius_edge = std::numeric_limits<double>::infinity();
    return m;
  }
  m.circumradius = std::sqrt(u2) * std::sqrt(v2) / (2 * std::fabs(m.cross)) * std::sqrt(w2);
  m.radius_edge = m.circumradius / m.shortest;
  return m;
}

double degrees_of_cosine(double cosine) {
  const double clipped = std::min(1.0, std::max(-1.0, cosine));
  return elementary::acos(clipped) * (180 / elementary::kPi);
}

AngleRange angles_degrees(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kDegrees = 57.295779513082320877;
  const double cross = std::fabs(measure_triangle(a, b, c).cross);
  const auto angle = [&](const Point2& p, const Point2& q, const Point2& r) {
    const double dot = (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
    if (std::fabs(dot) < cross) return 90 - kDegrees * elementary::atan(dot / cross);
    const double acute = dot != 0 ? kDegrees * elementary::atan(cross / std::fabs(dot)) : 0;
    return dot < 0 ? 180 - acute : acute;
  };
  const std::array<double, 3> all = {angle(a, b, c), angle(b, c, a), angle(c, a, b)};
  return {*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end())};
}

Quality measure(const Mesh& mesh) {
  if (mesh.dimension == 3) return measure3(mesh);
  Quality q;
  if (mesh.dimension != 2) return q;
  ProductSum twice_area;
  bool first = true;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    const std::size_t n = mesh.vertices.size();
    if (v[0] >= n || v[1] >= n || v[2] >= n) continue;
    const Point2 a = xy(mesh.vertices[v[0]]), b = xy(mesh.vertices[v[1]]),
                 c = xy(mesh.vertices[v[2]]);
    const TriangleMeasure m = measure_triangle(a, b, c);
    const AngleRange angles = angles_degrees(a, b, c);
    twice_area.add(1, m.cross);
    if (first) {
      q.min_angle_degrees = angles.min;
      q.max_angle_degrees = angles.max;
      q.max_radius_edge = m.radius_edge;
      q.shortest_edge = m.shortest;
      first = false;
      continue;
    }
    q.min_angle_degrees = std::min(q.min_angle_degrees, angles.min);
    q.max_angle_degrees = std::max(q.max_angle_degrees, angles.max);
    q.max_radius_edge = std::max(q.max_radius_edge, m.radius_edge);
    q.shortest_edge = std::min(q.shortest_edge, m.shortest);
  }
  q.area = 0.5 * twice_area.value();
  return q;
}

}  // namespace circumball
