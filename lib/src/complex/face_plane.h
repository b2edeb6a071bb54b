#ifndef CIRCUMBALL_COMPLEX_FACE_PLANE_H_
#define CIRCUMBALL_COMPLEX_FACE_PLANE_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "circumball/complex.h"
#include "complex/box_tree.h"

namespace circumball {

/// The plane of a face of a 3D complex, with an orthonormal frame, and the polygon in its
/// coordinates.
///
/// The normal is Newell's (the vector area, e.g. Sutherland, Sproull and Schumacker 1974) of the
/// loop of the largest area, so that a polygon that is planar only nearly has a well-defined one.
/// The first axis is the projection of the coordinate axis that is nearest to the plane: for faces
/// parallel to a coordinate plane the coordinates are exact. Made with + - * / and sqrt alone.
class FacePlane {
 public:
  /// Of a face with valid indices. O(vertices of the face).
  FacePlane(const Complex& complex, std::uint32_t face);

  /// False where the face has no area: it has no plane.
  bool valid() const { return valid_; }
  const Point3& origin() const { return origin_; }
  const Point3& normal() const { return normal_; }  ///< unit; counter-clockwise about it
  const Point3& first() const { return first_; }    ///< unit axes of the plane
  const Point3& second() const { return second_; }
  /// Coordinates of the projection of p onto the plane: within a few ulp of |p - origin|.
  Point2 to_plane(const Point3& p) const {
    const double x = p.x - origin_.x, y = p.y - origin_.y, z = p.z - origin_.z;
    return {x * first_.x + y * first_.y + z * first_.z,
            x * second_.x + y * second_.y + z * second_.z};
  }
  /// The point of the plane with these coordinates: within a few ulp of the largest coordinate.
  Point3 to_space(const Point2& p) const {
    return {origin_.x + (p.x * first_.x + p.y * second_.x),
            origin_.y + (p.x * first_.y + p.y * second_.y),
            origin_.z + (p.x * first_.z + p.y * second_.z)};
  }
  /// Signed distance from the plane, positive on the normal's side.
  double height(const Point3& p) const {
    return (p.x - origin_.x) * normal_.x + (p.y - origin_.y) * normal_.y +
           (p.z - origin_.z) * normal_.z;
  }
  /// Whether a point of the plane lies in the face: inside some loop, and not in the part around a
  /// hole point that loops cut out. Exact for the rounded coordinates; a point on the boundary
  /// counts as on one side of it, always the same. O(log n + k) for n vertices of the loops, of
  /// whose sides k are at the height of p.
  bool contains(const Point2& p) const;

 private:
  struct Side {
    Point2 a, b;
    std::uint32_t loop;
  };
  void add_sides(const Complex& complex, const Face& face);
  /// The loops that p is inside of; ascending.
  std::vector<std::uint32_t> loops_around(const Point2& p) const;

  bool valid_ = false;
  Point3 origin_, first_, second_, normal_;
  std::vector<Side> sides_;                        // of loops of three vertices and more
  BoxTree tree_;                                   // of sides_, where they are many
  std::vector<std::vector<std::uint32_t>> holes_;  // loops around each hole point; sorted
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_FACE_PLANE_H_
