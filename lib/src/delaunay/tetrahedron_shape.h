#ifndef CIRCUMBALL_DELAUNAY_TETRAHEDRON_SHAPE_H_
#define CIRCUMBALL_DELAUNAY_TETRAHEDRON_SHAPE_H_

#include "circumball/types.h"

/// Measures of tetrahedra, and of triangles in space, that refinement decides by. Rounded doubles
/// made with + - * / and sqrt alone.
namespace circumball {

/// What RE(t) and R_t (thesis, Definition 2.1.2) of a tetrahedron are made of.
struct TetrahedronShape {
  double shortest2 = 0;      ///< squared length of the shortest edge
  double longest2 = 0;       ///< and of the longest
  double circumradius2 = 0;  ///< squared; infinite where it is beyond double precision
  double volume6 = 0;        ///< six times the volume
  Point3 circumcenter;       ///< not finite where the circumradius is infinite

  bool radius_edge_exceeds(double tau) const { return circumradius2 > tau * tau * shortest2; }
};

/// A cell with four vertices in a face is flat where six times its volume is less than this part of
/// the cube of its longest edge.
constexpr double kFlatVolume = 1e-9;

/// Shape of abcd, orient3d positive. In double precision where that is good for ten digits,
/// otherwise in double-double: nearly flat Delaunay tetrahedra are normal (rectangles in faces are
/// cocircular but for rounding), and the circumcenter in double precision of one whose volume is
/// mostly rounding would be anywhere. Relative errors of circumradius and center below 1e-10.
TetrahedronShape tetrahedron_shape(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d);

/// Cosine of the smallest dihedral angle of abcd; 1 where rounding flattened a facet. Good for
/// twelve digits of the cosine unless a facet is thin: it only chooses between valid meshes.
double least_dihedral_cosine(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// The smallest ball with the corners of a triangle on its boundary (centered in their plane).
struct TriangleBall {
  Point3 corner;   ///< one of them
  Point3 center;   ///< relative to it
  double radius2;  ///< squared

  /// How far p is in or out: its power. Where the triangle is not too thin, the error is a few ulp
  /// of |p - corner|^2 + R^2.
  double power(const Point3& p) const {
    const double x = p.x - corner.x, y = p.y - corner.y, z = p.z - corner.z;
    return x * x + y * y + z * z - 2 * (x * center.x + y * center.y + z * center.z);
  }
};
TriangleBall triangle_ball(const Point3& a, const Point3& b, const Point3& c);

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_TETRAHEDRON_SHAPE_H_
