#include "complex/face_plane.h"

#include <cmath>

#include "circumball/predicates.h"

namespace circumball {
namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Twice the vector area of a loop, relative to its first vertex.
Point3 vector_area(const Complex& complex, const std::vector<std::uint32_t>& loop) {
  Point3 sum;
  const Point3& origin = complex.vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Point3 a = minus(complex.vertices[loop[i]], origin);
    const Point3 b = minus(complex.vertices[loop[i + 1]], origin);
    const Point3 c = cross(a, b);
    sum = {sum.x + c.x, sum.y + c.y, sum.z + c.z};
  }
  return sum;
}

}  // namespace

FacePlane::FacePlane(const Complex& complex, std::uint32_t face) {
  const Face& f = complex.faces[face];
  double largest2 = 0;
  Point3 area;
  for (const auto& loop : f.loops) {
    if (loop.size() < 3) continue;
    const Point3 a = vector_area(complex, loop);
    const double a2 = dot(a, a);
    if (!(a2 > largest2)) continue;
    largest2 = a2;
    area = a;
    origin_ = complex.vertices[loop[0]];
  }
  if (!(largest2 > 0) || std::isinf(largest2)) return;
  valid_ = true;
  const double length = std::sqrt(largest2);
  normal_ = {area.x / length, area.y / length, area.z / length};
  const double ax = std::fabs(normal_.x), ay = std::fabs(normal_.y), az = std::fabs(normal_.z);
  const Point3 axis = ax <= ay && ax <= az ? Point3{1, 0, 0}
                      : ay <= az           ? Point3{0, 1, 0}
                                           : Point3{0, 0, 1};
  const double along = dot(axis, normal_);
  const Point3 projected = {axis.x - along * normal_.x, axis.y - along * normal_.y,
                            axis.z - along * normal_.z};
  const double projected_length = std::sqrt(dot(projected, projected));
  first_ = {projected.x / projected_length, projected.y / projected_length,
            projected.z / projected_length};
  second_ = cross(normal_, first_);
  for (const auto& loop : f.loops) {
    if (loop.size() < 3) continue;
    loops_.emplace_back();
    for (const std::uint32_t v : loop) loops_.back().push_back(to_plane(complex.vertices[v]));
  }
  for (const Point3& hole : f.holes) {
    const Point2 at = to_plane(hole);
    holes_.emplace_back();
    for (std::size_t i = 0; i < loops_.size(); ++i) holes_.back().push_back(inside_loop(i, at));
  }
}

bool FacePlane::inside_loop(std::size_t loop, const Point2& p) const {
  const std::vector<Point2>& corners = loops_[loop];
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point2 &a = corners[j], &b = corners[i];
    // Crossings of the ray to the right: half-open in y, so that corners count once.
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const Sign turn = b.y > a.y ? orient2d(a, b, p) : orient2d(b, a, p);
    if (turn == Sign::kPositive) inside = !inside;
  }
  return inside;
}

bool FacePlane::contains(const Point2& p) const {
  std::vector<bool> signature(loops_.size());
  bool in_some = false;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    signature[i] = inside_loop(i, p);
    in_some = in_some || signature[i];
  }
  if (!in_some) return false;
  // Loops do not cross: where a point is inside of the same loops as a hole point, nothing
  // separates the two.
  for (const auto& hole : holes_) {
    if (hole == signature) return false;
  }
  return true;
}

std::optional<FaceFrame> face_frame(const Complex& complex, std::uint32_t face) {
  if (complex.dimension != 3 || face >= complex.faces.size()) return std::nullopt;
  for (const auto& loop : complex.faces[face].loops) {
    for (const std::uint32_t v : loop) {
      if (v >= complex.vertices.size()) return std::nullopt;
    }
  }
  const FacePlane plane(complex, face);
  if (!plane.valid()) return std::nullopt;
  return FaceFrame{plane.origin(), plane.first(), plane.second(), plane.normal()};
}

}  // namespace circumball
