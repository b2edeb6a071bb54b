#ifndef CIRCUMBALL_COMPLEX_FACE_TRIANGULATION_H_
#define CIRCUMBALL_COMPLEX_FACE_TRIANGULATION_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"
#include "complex/planar_sweep.h"

namespace circumball {

/// The projection of a face onto a coordinate plane, along the axis of the largest component of its
/// normal: coordinates are exact, lengths shrink by at most sqrt(3). Mirrored where needed, so that
/// the face is counter-clockwise about its normal.
struct FaceProjection {
  int axis = 2;
  bool mirrored = false;
  static FaceProjection along(const Point3& normal);
  Point2 operator()(const Point3& p) const {
    const double u = axis == 0 ? p.y : axis == 1 ? p.z : p.x;
    const double v = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
    return mirrored ? Point2{v, u} : Point2{u, v};
  }
};

/// What a face of a 3D complex consists of, in its projection. For faces with valid indices and
/// usable coordinates.
struct FaceLayout {
  enum class Kind : std::uint8_t {
    kSide,      ///< of a loop of three vertices or more
    kSegment,   ///< of the list of segments (or a loop of two vertices)
    kInferred,  ///< a segment that the face does not list, between vertices of the face
  };
  struct Edge {
    std::uint32_t a, b;     ///< members; a < b
    Kind kind;              ///< the strongest of equal edges
    std::uint32_t segment;  ///< of the complex; kNoIndex for a side, which has no number
  };
  FaceProjection projection;
  std::vector<std::uint32_t> members;  ///< vertex numbers, ascending: of loops, segments, alone
  std::vector<Point2> points;          ///< of members, projected
  std::vector<Edge> edges;             ///< sorted by ends; no two have the same
  std::vector<Point2> holes;

  FaceLayout(const Complex& complex, std::uint32_t face, const FaceProjection& along,
             const std::vector<std::uint32_t>& inferred);
  /// As a complex of the plane, for planar_sweep.h: vertices are members, segments are edges.
  Complex planar() const;
};

/// A face in triangles: see triangulate_face.
struct FaceTriangles {
  bool valid = false;  ///< else there is nothing
  /// Vertices of the complex, counter-clockwise about the face's normal.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// For each triangle: bit i is set where the edge opposite vertex i is inside the face, no
  /// segment of it.
  std::vector<std::uint8_t> inner;

  /// What of the layout is not in the closed face: indices of edges (sides too, where they bound
  /// nothing) and of members.
  std::vector<std::uint32_t> edges_outside, members_outside;
  /// Edges of kind kInferred that are in the face, not on its boundary alone.
  std::vector<std::uint32_t> inferred_inside;
  /// Of each hole: whether it lies in a part of the face (which it removes); if not, `hole_on` is
  /// the edge that it lies on, or kNoIndex.
  std::vector<std::uint8_t> hole_inside;
  std::vector<std::uint32_t> hole_on;
};

/// Whether sides and segments meet in common ends only, no member lies on one of them, and no two
/// members coincide, in the projection. Exact.
bool is_planar(const FaceLayout& layout);

/// Of a layout that is_planar.
FaceTriangles triangulate(const FaceLayout& layout);

/// Whether every index of the face is in range and every coordinate usable (complex.h, `check`).
bool is_usable(const Complex& complex, std::uint32_t face);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_FACE_TRIANGULATION_H_
