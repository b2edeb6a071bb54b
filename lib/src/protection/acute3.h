#ifndef CIRCUMBALL_PROTECTION_ACUTE3_H_
#define CIRCUMBALL_PROTECTION_ACUTE3_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "complex/live3.h"

namespace circumball {

/// Which features of a 3D complex need protection, because others meet them at less than 90
/// degrees (thesis, 6.2: "acutely adjacent"):
/// - a segment, if two faces, or sides of faces, make such a dihedral angle at it;
/// - a vertex, if it is an end of such a segment, or if two features at it make such an angle: two
///   segments, a segment and a face that does not contain it. (Two faces that share the vertex
///   alone come nearest to each other at a side of one of them, as they do not cross.)
///
/// Right angles are not acute, also where rounding of the coordinates bent them: cosines count from
/// twice what `check` lets a face deviate from its plane, and what Live3::rounding of the ends
/// makes of the lengths involved. Let delta be this cosine; then a vertex on one of two such
/// features, at a distance r of what they share, is in balls of the other only if these have a
/// radius of at least r / (2 delta): no refinement is graded like that.
class Acute3 {
 public:
  /// `complex` must be valid (see `check`). O(n log n), beside the triangulation of the faces.
  Acute3(const Complex& complex, const Incidence3& incidence);

  bool vertex(std::uint32_t input_vertex) const { return vertices_[input_vertex]; }
  /// Both ends of such a segment are such vertices.
  bool segment(std::uint32_t input_segment) const { return segments_[input_segment]; }
  bool any() const {
    return std::find(vertices_.begin(), vertices_.end(), true) != vertices_.end();
  }

 private:
  /// A triangle of a face, seen from one of its corners.
  struct Corner {
    std::uint32_t at, face, b, c;
  };
  /// A side of a face at a segment of it.
  struct Wing {
    std::uint32_t segment;
    Point3 out;    // unit, in the face, perpendicular to the segment
    double error;  // of its direction
  };
  struct Ray {
    Point3 out;  // unit
    double error;
    std::uint32_t other;  // its other end
  };

  void collect(std::uint32_t face, const std::vector<std::array<std::uint32_t, 3>>& by_ends);
  void look_at_segments();
  bool is_acute_at(std::uint32_t v, const Incidence3& incidence, const Corner* first,
                   const Corner* last) const;
  Ray ray(std::uint32_t from, std::uint32_t to) const;
  bool is_acute(const Ray& ray, const Corner& corner) const;

  const Complex& complex_;
  double rounding_ = 0;
  std::vector<Point3> normals_;  // of the faces, unit
  std::vector<Corner> corners_;
  std::vector<Wing> wings_;
  std::vector<bool> vertices_, segments_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_PROTECTION_ACUTE3_H_
