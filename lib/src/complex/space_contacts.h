#ifndef CIRCUMBALL_COMPLEX_SPACE_CONTACTS_H_
#define CIRCUMBALL_COMPLEX_SPACE_CONTACTS_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/types.h"

namespace circumball {

/// Whether relative interiors of points, segments and triangles of space have a point in common:
/// exact, by orient3d, and by orient2d of projections for what is coplanar. Simplices are given by
/// the numbers of their vertices; a number that two share is known to be no contact of interiors,
/// at no cost. Segments and triangles must not be degenerate.
class SpaceContacts {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  enum class Meeting : std::uint8_t { kNone, kCross, kOverlap };

  explicit SpaceContacts(const std::vector<Point3>& points) : points_(points) {}

  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// v strictly between a and b.
  bool on_segment(std::uint32_t v, std::uint32_t a, std::uint32_t b) const;
  /// v in the plane of t, strictly inside.
  bool in_triangle(std::uint32_t v, const Triangle& t) const;
  /// Open segments that cross in one point, or overlap in a segment.
  Meeting segments(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  /// The open segment and the open triangle: they cross in one point, or overlap in a segment.
  Meeting segment_triangle(std::uint32_t a, std::uint32_t b, const Triangle& t) const;
  /// Open triangles: they cross in a segment, or overlap in an area.
  Meeting triangles(const Triangle& t, const Triangle& u) const;

  /// Sign of orient3d; zero without any arithmetic where d is one of a, b, c.
  int side(const Triangle& t, std::uint32_t d) const;

 private:
  int turn(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// An axis along which the triangle is projected onto one that is not degenerate; -1 without.
  int faithful_axis(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  int volume(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  bool before(std::uint32_t a, std::uint32_t b) const;

  const std::vector<Point3>& points_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_SPACE_CONTACTS_H_
