#include <algorithm>
#include <cmath>
#include <limits>

#include "circumball/verify.h"
#include "feature_size/vectors.h"
#include "predicates/elementary.h"
#include "predicates/expansion.h"
#include "quality/measure3.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {

Twofold operator+(const Twofold& a, const Twofold& b) {
  const internal::TwoDoubles s = internal::two_sum(a.high, b.high);
  const internal::TwoDoubles t = internal::two_sum(a.low, b.low);
  const internal::TwoDoubles u = internal::fast_two_sum(s.high, s.low + t.high);
  const internal::TwoDoubles v = internal::fast_two_sum(u.high, u.low + t.low);
  return {v.high, v.low};
}

Twofold operator*(const Twofold& a, const Twofold& b) {
  const internal::TwoDoubles p = internal::two_product(a.high, b.high);
  const internal::TwoDoubles s =
      internal::fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  return {s.high, s.low};
}

namespace {

struct Vector {
  Twofold x, y, z;
};

Twofold minus(const Twofold& a) { return {-a.high, -a.low}; }
Twofold difference(double a, double b) {
  const internal::TwoDoubles d = internal::two_difference(a, b);
  return {d.high, d.low};
}
Vector exact(const Point3& a, const Point3& b) {  // a - b
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z + minus(a.z * b.y), a.z * b.x + minus(a.x * b.z), a.x * b.y + minus(a.y * b.x)};
}
Twofold dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector operator*(const Twofold& t, const Vector& a) { return {t * a.x, t * a.y, t * a.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

}  // namespace

TetrahedronMeasure measure_tetrahedron(const Point3& o, const Point3& p, const Point3& q,
                                       const Point3& r) {
  TetrahedronMeasure m;
  const Point3* corner[4] = {&o, &p, &q, &r};
  double least2 = std::numeric_limits<double>::infinity(), most2 = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      const Point3 &a = *corner[i], &b = *corner[j];
      const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
      const double d2 = dx * dx + dy * dy + dz * dz;
      least2 = std::min(least2, d2);
      most2 = std::max(most2, d2);
    }
  }
  m.shortest = std::sqrt(least2);
  m.longest = std::sqrt(most2);
  // The circumcenter minus o is (|a|^2 b x c + |b|^2 c x a + |c|^2 a x b) / (2 a . b x c).
  const Vector a = exact(p, o), b = exact(q, o), c = exact(r, o);
  const Vector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Twofold det = dot(a, bc);
  // orient3d(o, p, q, r) is positive where r is below the plane of a counter-clockwise o, p, q.
  m.six_volume = minus(det);
  const Vector center = dot(a, a) * bc + dot(b, b) * ca + dot(c, c) * ab;
  const double numerator = length(center.x.high, center.y.high, center.z.high);
  if (det.high == 0) {
    m.circumradius = m.radius_edge = std::numeric_limits<double>::infinity();
    m.error = 1e-10;
    return m;
  }
  m.circumradius = numerator / (2 * std::fabs(det.high));
  m.radius_edge = m.circumradius / m.shortest;
  // What plain doubles would be off by, up to what care can reach.
  const double abc =
      std::sqrt(dot(a, a).high) * std::sqrt(dot(b, b).high) * std::sqrt(dot(c, c).high);
  const double plain =
      0x1p-48 * (abc / std::fabs(det.high) + abc * 3 * m.longest / std::max(numerator, 1e-300));
  m.error = 0x1p-48 + (plain < 1e-10 ? plain : 1e-10 - 0x1p-48);
  return m;
}

DihedralRange dihedrals_degrees(const Point3& a, const Point3& b, const Point3& c,
                                const Point3& d) {
  const Point3 p[4] = {a, b, c, d};
  const double volume = std::fabs(measure_tetrahedron(a, b, c, d).six_volume.high);
  DihedralRange range{180, 0};
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const int k = (i != 0 && j != 0) ? 0 : (i != 1 && j != 1) ? 1 : 2;
      const int l = 6 - i - j - k;
      const Point3 e = p[j] - p[i];
      const Point3 n = circumball::cross(e, p[k] - p[i]);
      const Point3 m = circumball::cross(e, p[l] - p[i]);
      // |n x m| = |e| 6 V, and n . m is |n| |m| times the cosine of the angle at e.
      const double sine = std::sqrt(circumball::dot(e, e)) * volume;
      const double angle = elementary::atan2(sine, circumball::dot(n, m)) * (180 / elementary::kPi);
      range.min = std::min(range.min, angle);
      range.max = std::max(range.max, angle);
    }
  }
  return range;
}

Quality measure3(const Mesh& mesh) {
  Quality q;
  Twofold six_volume;
  bool first = true;
  const std::size_t n = mesh.vertices.size();
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    if (v[0] >= n || v[1] >= n || v[2] >= n || v[3] >= n) continue;
    const Point3 &a = mesh.vertices[v[0]], &b = mesh.vertices[v[1]], &c = mesh.vertices[v[2]],
                 &d = mesh.vertices[v[3]];
    const TetrahedronMeasure m = measure_tetrahedron(a, b, c, d);
    const DihedralRange angles = dihedrals_degrees(a, b, c, d);
    six_volume = six_volume + m.six_volume;
    if (first) {
      q.min_dihedral_degrees = angles.min;
      q.max_dihedral_degrees = angles.max;
      q.max_radius_edge = m.radius_edge;
      q.shortest_edge = m.shortest;
      first = false;
      continue;
    }
    q.min_dihedral_degrees = std::min(q.min_dihedral_degrees, angles.min);
    q.max_dihedral_degrees = std::max(q.max_dihedral_degrees, angles.max);
    q.max_radius_edge = std::max(q.max_radius_edge, m.radius_edge);
    q.shortest_edge = std::min(q.shortest_edge, m.shortest);
  }
  q.volume = six_volume.high / 6;
  return q;
}

}  // namespace circumball
