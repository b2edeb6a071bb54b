#include "complex/face_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "circumball/predicates.h"

namespace circumball {
namespace {

/// Up to so many sides a tree is not worth its memory.
constexpr std::size_t kFewSides = 16;

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
  add_sides(complex, f);
  for (const Point3& hole : f.holes) holes_.push_back(loops_around(to_plane(hole)));
  std::sort(holes_.begin(), holes_.end());
}

void FacePlane::add_sides(const Complex& complex, const Face& face) {
  for (std::uint32_t l = 0; l < face.loops.size(); ++l) {
    const auto& loop = face.loops[l];
    if (loop.size() < 3) continue;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      sides_.push_back(
          {to_plane(complex.vertices[loop[j]]), to_plane(complex.vertices[loop[i]]), l});
    }
  }
  if (sides_.size() <= kFewSides) return;
  std::vector<Box2> boxes;
  boxes.reserve(sides_.size());
  for (const Side& side : sides_) boxes.push_back(Box2::of(side.a, side.b));
  tree_ = BoxTree(std::move(boxes));
}

std::vector<std::uint32_t> FacePlane::loops_around(const Point2& p) const {
  std::vector<std::uint32_t> crossed;
  const auto look_at = [&](const Side& side) {
    // Crossings of the ray to the right: half-open in y, so that corners count once.
    const Point2 &a = side.a, &b = side.b;
    if ((a.y > p.y) == (b.y > p.y)) return;
    const Sign turn = b.y > a.y ? orient2d(a, b, p) : orient2d(b, a, p);
    if (turn == Sign::kPositive) crossed.push_back(side.loop);
  };
  if (tree_.size() == 0) {
    for (const Side& side : sides_) look_at(side);
  } else {
    tree_.query(
        [&](const Box2& box) { return box.lo_y <= p.y && p.y <= box.hi_y && p.x <= box.hi_x; },
        [&](std::uint32_t i) {
          look_at(sides_[i]);
          return true;
        });
    std::sort(crossed.begin(), crossed.end());
  }
  // Inside of a loop is what it is crossed from an odd number of times.
  std::size_t kept = 0;
  for (std::size_t i = 0, j; i < crossed.size(); i = j) {
    for (j = i; j < crossed.size() && crossed[j] == crossed[i]; ++j) {
    }
    if ((j - i) % 2 == 1) crossed[kept++] = crossed[i];
  }
  crossed.resize(kept);
  return crossed;
}

bool FacePlane::contains(const Point2& p) const {
  const std::vector<std::uint32_t> around = loops_around(p);
  // Loops do not cross: where a point is inside of the same loops as a hole point, nothing
  // separates the two.
  return !around.empty() && !std::binary_search(holes_.begin(), holes_.end(), around);
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
