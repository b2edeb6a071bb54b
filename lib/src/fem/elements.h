#ifndef CIRCUMBALL_FEM_ELEMENTS_H_
#define CIRCUMBALL_FEM_ELEMENTS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/fem.h"
#include "circumball/mesh.h"
#include "circumball/types.h"
#include "fem/quadrature.h"

/// Linear elements on triangles.
namespace circumball::fem {

/// A triangle, ready for linear elements.
struct Element {
  std::array<Point2, 3> corner;
  std::array<Point2, 3> edge;  ///< vectors of the edges opposite to the corners, counter-clockwise
  double area;                 ///< in double precision; not positive for what rounding made flat
  Point2 at(const std::array<double, 3>& barycentric) const {
    return {
        barycentric[0] * corner[0].x + barycentric[1] * corner[1].x + barycentric[2] * corner[2].x,
        barycentric[0] * corner[0].y + barycentric[1] * corner[1].y + barycentric[2] * corner[2].y};
  }
  /// Gradient of the linear function with these values at the corners.
  Point2 gradient(const std::array<double, 3>& values) const;
};
Element element(const Point2& a, const Point2& b, const Point2& c);
Element element(const Mesh& mesh, std::size_t cell);

/// Why no elements can be made of this mesh; empty if they can.
std::string unusable(const Mesh& mesh);

/// Ends of the edges that belong to one cell only, in order.
std::vector<std::array<std::uint32_t, 2>> boundary_edges(const Mesh& mesh);

/// Integrals over a cell, of squares.
struct CellError {
  double l2 = 0, h1 = 0;  // of u - (the linear function with these values)
  double u_l2 = 0, u_h1 = 0, u_h2 = 0;
  bool settled = true;
};
/// `values` at the corners; `budget` bounds the quadrature of all cells together.
CellError cell_error(const Element& element, const std::array<double, 3>& values,
                     const PlaneFunction& u, QuadratureBudget* budget);

/// Fills errors, seminorms, sizes and warnings of `field`, whose nodal values are there.
void measure_error(const Mesh& mesh, const PlaneFunction& u, ErrorField* field);

/// "(x, y)" for sentences.
std::string place(const Point2& p);

}  // namespace circumball::fem

#endif  // CIRCUMBALL_FEM_ELEMENTS_H_
