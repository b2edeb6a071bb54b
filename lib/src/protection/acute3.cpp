#include "protection/acute3.h"

#include <cmath>
#include <limits>

#include "complex/face_plane.h"

namespace circumball {
namespace {

/// Cosines up to this are those of right angles: twice the deviation from its plane that `check`
/// allows a face (1e-9 of its size).
constexpr double kRightAngle = 2e-9;

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 times(double f, const Point3& a) { return {f * a.x, f * a.y, f * a.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

Acute3::Acute3(const Complex& complex, const Incidence3& incidence)
    : complex_(complex),
      vertices_(complex.vertices.size(), false),
      segments_(complex.segments.size(), false) {
  for (const Point3& p : complex.vertices) {
    rounding_ = std::max({rounding_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  rounding_ *= 8 * std::numeric_limits<double>::epsilon();
  std::vector<std::array<std::uint32_t, 3>> by_ends;  // lower, higher, number
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
    const auto [low, high] = std::minmax(complex.segments[s][0], complex.segments[s][1]);
    by_ends.push_back({low, high, s});
  }
  std::sort(by_ends.begin(), by_ends.end());
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) collect(f, by_ends);
  look_at_segments();
  std::stable_sort(corners_.begin(), corners_.end(),
                   [](const Corner& a, const Corner& b) { return a.at < b.at; });
  const Corner* next = corners_.data();
  const Corner* const end = next + corners_.size();
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    const Corner* first = next;
    while (next != end && next->at == v) ++next;
    if (!vertices_[v]) vertices_[v] = is_acute_at(v, incidence, first, next);
  }
}

void Acute3::collect(std::uint32_t face, const std::vector<std::array<std::uint32_t, 3>>& by_ends) {
  const Point3 n = FacePlane(complex_, face).normal();
  normals_.push_back(n);
  for (const auto& t : triangulate_face(complex_, face)) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      corners_.push_back({a, face, b, c});
      const auto [low, high] = std::minmax(a, b);
      const std::array<std::uint32_t, 3> key{low, high, 0};
      const auto at = std::lower_bound(by_ends.begin(), by_ends.end(), key);
      if (at == by_ends.end() || (*at)[0] != low || (*at)[1] != high) continue;
      const Point3 &p = complex_.vertices[a], &q = complex_.vertices[b];
      Point3 out = cross(n, minus(q, p));
      const double length = std::sqrt(dot(out, out));
      if (length == 0) continue;
      out = times(1 / length, out);
      double height = dot(out, minus(complex_.vertices[c], p));
      if (height < 0) {
        out = times(-1, out);
        height = -height;
      }
      if (height > 0) wings_.push_back({(*at)[2], out, rounding_ / height});
    }
  }
}

void Acute3::look_at_segments() {
  std::stable_sort(wings_.begin(), wings_.end(),
                   [](const Wing& a, const Wing& b) { return a.segment < b.segment; });
  for (std::size_t i = 0, j; i < wings_.size(); i = j) {
    const std::uint32_t s = wings_[i].segment;
    for (j = i + 1; j < wings_.size() && wings_[j].segment == s; ++j) {
      // Of more than four directions in a plane some two make an acute angle: what is looked at is
      // bounded.
      for (std::size_t k = i; k < j && !segments_[s]; ++k) {
        const double slack = kRightAngle + wings_[j].error + wings_[k].error;
        if (dot(wings_[j].out, wings_[k].out) > slack) segments_[s] = true;
      }
    }
    if (!segments_[s]) continue;
    for (const std::uint32_t v : complex_.segments[s]) vertices_[v] = true;
  }
}

Acute3::Ray Acute3::ray(std::uint32_t from, std::uint32_t to) const {
  const Point3 d = minus(complex_.vertices[to], complex_.vertices[from]);
  const double length = std::sqrt(dot(d, d));
  return {times(1 / length, d), rounding_ / length, to};
}

bool Acute3::is_acute_at(std::uint32_t v, const Incidence3& incidence, const Corner* first,
                         const Corner* last) const {
  std::vector<Ray> rays;
  for (const std::uint32_t s : incidence.segments_of_vertex(v)) {
    const auto& ends = complex_.segments[s];
    const Ray next = ray(v, ends[0] == v ? ends[1] : ends[0]);
    bool twice = false;  // a segment given twice, which `check` warns of
    for (const Ray& r : rays) {
      twice = twice || r.other == next.other;
      // Of more than six directions some two make an acute angle: what is looked at is bounded.
      if (!twice && dot(r.out, next.out) > kRightAngle + r.error + next.error) return true;
    }
    if (!twice) rays.push_back(next);
  }
  for (const Ray& r : rays) {
    for (const Corner* c = first; c != last; ++c) {
      if (is_acute(r, *c)) return true;
    }
  }
  return false;
}

/// Whether the ray makes an acute angle with the inside of a corner of a triangle. With the sides
/// of the triangle only if the projection of the ray onto it is between them: what bounds the face
/// there are segments, and rays.
bool Acute3::is_acute(const Ray& r, const Corner& corner) const {
  if (r.other == corner.b || r.other == corner.c) return false;  // a segment of the face, or a ray
  const Ray b = ray(corner.at, corner.b), c = ray(corner.at, corner.c);
  const Point3& n = normals_[corner.face];
  const double height = dot(r.out, n);
  const Point3 p = minus(r.out, times(height, n));
  const double slack = kRightAngle + r.error + b.error + c.error;
  if (dot(p, p) <= slack * slack) return false;
  // Left of the one side and right of the other, or on them.
  const double turn = dot(cross(b.out, c.out), n) < 0 ? -1 : 1;
  return turn * dot(cross(b.out, p), n) >= -slack && turn * dot(cross(p, c.out), n) >= -slack &&
         dot(p, b.out) + dot(p, c.out) > 0;
}

}  // namespace circumball
