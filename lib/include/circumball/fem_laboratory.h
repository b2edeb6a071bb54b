#ifndef CIRCUMBALL_FEM_LABORATORY_H_
#define CIRCUMBALL_FEM_LABORATORY_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circumball/fem.h"

/// Chapter 7 of the thesis as a laboratory: one triangle, three families of meshes, and rough
/// functions. As in circumball/fem.h, errors are answers.
namespace circumball {

/// How u is interpolated on one triangle.
struct TriangleError {
  double l2 = 0, h1 = 0;  ///< of u - I u
  Seminorms u;
};

/// One triangle, and the constant of Theorem 7.10 on it.
struct TriangleStudy {
  std::string error;                       ///< "" unless the corners are in line or not finite
  std::array<double, 3> lengths{};         ///< of the edges opposite to a, b, c
  std::array<double, 3> angles_degrees{};  ///< at a, b, c
  double h = 0;                            ///< longest edge
  double area = 0, circumradius = 0, inradius = 0;
  double radius_edge = 0;  ///< circumradius by shortest edge (Definition 2.1.2)
  Point2 circumcenter;
  /// The triangle is T_h(alpha, beta) of Figure 7.2 up to rotation, translation and reflection: the
  /// longest edge on the x axis, the apex at (beta h, alpha h), beta <= 1/2.
  double alpha = 0, beta = 0;
  double circumradius_bound = 0;  ///< Proposition 7.5: R >= h sqrt(beta^2 / (16 alpha^2) + 1/8)
  /// The largest |u - I u|_1 / |u|_2 among quadratic u (a length), the quadratic a x^2 + b x y + c
  /// y^2 that attains it, and the same for ||u - I u||_0 / |u|_2 (an area).
  double h1_constant = 0, l2_constant = 0;
  std::array<double, 3> worst_quadratic{};
  /// Kobayashi's bound on |u - I u|_1 / |u|_2 for all u in H^2 (On the interpolation constants over
  /// triangular elements, 2015): less than R.
  double kobayashi_bound = 0;
  std::optional<TriangleError> interpolation;
  std::string interpolation_error;  ///< why there is none, if u was given
};
/// `u` may be null.
TriangleStudy study_triangle(const Point2& a, const Point2& b, const Point2& c,
                             const PlaneFunction* u);

/// The families of Figure 7.1, on the unit square.
enum class MeshFamily : std::uint8_t {
  kNarrow,       ///< (a) narrow right triangles
  kLargeAngles,  ///< (b) narrow isosceles triangles, with an angle that tends to 180 degrees
  kHighDegree,   ///< (c) narrow triangles in fans: angles below 117 degrees, unbounded degrees
};
struct FamilyInfo {
  MeshFamily family;
  std::string id, title, sentence;
};
const std::vector<FamilyInfo>& mesh_families();

constexpr std::uint64_t kMaxFamilyCells = 2'000'000;
/// `n` columns of width 1/n, each cut into n * `degeneration` rows (in family (c): n rows, whose
/// edges are divided into `degeneration` in every second line). No edge is longer than sqrt 2 / n.
/// Fails for n or degeneration 0, and beyond kMaxFamilyCells, with a sentence in `error`.
Mesh family_mesh(MeshFamily family, std::uint32_t n, std::uint32_t degeneration,
                 std::string* error);

/// The averaged interpolant of Theorem 7.12: I_1 (M_h (psi_h u)), u cut off within 2 h of the
/// boundary, smoothed by convolution with the mollifier of radius h (section 7.1), interpolated. u
/// is taken as zero on the boundary, and need not have values at the vertices.
struct AveragedField : ErrorField {
  double averaging_radius = 0;  ///< h
};
/// Points of the quadrature over a disk of radius h: Gauss-Legendre in the radius, equal steps in
/// the angle; weights that sum up to one, so that constants stay.
constexpr int kDiskRadii = 8;
constexpr int kDiskAngles = 16;
/// `h` is at least the longest edge, 0 for just that. O(n) evaluations at 128 points a vertex.
AveragedField interpolate_averaged(const Mesh& mesh, const PlaneFunction& u, double h = 0);

}  // namespace circumball

#endif  // CIRCUMBALL_FEM_LABORATORY_H_
