#ifndef CIRCUMBALL_FEM_H_
#define CIRCUMBALL_FEM_H_

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "circumball/mesh.h"
#include "circumball/types.h"

/// Linear finite elements on the meshes that are made here (thesis, chapter 7): how well a given
/// function is interpolated, and how well Poisson's equation is solved. Errors are answers: where
/// `error` is not empty, the other members mean nothing.
namespace circumball {

class Expression;

/// A function u of x and y, given as text; the syntax is that of sizing functions (docs/fem.md).
/// Not to be evaluated by two threads at the same time.
class PlaneFunction {
 public:
  PlaneFunction();  ///< zero
  /// Fails with a sentence that names the place in `error`.
  static bool parse(const std::string& text, PlaneFunction* function, std::string* error);

  /// Value, gradient (x, y) and Hessian (xx, xy, yy).
  struct Derivatives {
    double value = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  double at(const Point2& p) const;
  /// By automatic differentiation: exact but for rounding. Where pieces meet, of one of them.
  Derivatives derivatives(const Point2& p) const;
  /// Whether u is made of pieces (abs, min, ?:), so that its gradient may jump between them.
  bool is_piecewise() const;

 private:
  std::shared_ptr<const Expression> expression_;
};

/// A function worth looking at.
struct NamedFunction {
  std::string id, title, expression;
  std::string sentence;           ///< what is to be seen with it
  std::string regularity;         ///< in which Sobolev spaces it is
  std::vector<Point2> outline;    ///< corners of the domain that it is meant for, counter-clockwise
  bool zero_on_boundary = false;  ///< of that domain
};
const std::vector<NamedFunction>& fem_functions();

/// The sizes that error estimates speak of.
struct MeshSize {
  std::uint64_t vertices = 0;  ///< those that a cell uses
  std::uint64_t cells = 0;
  std::uint64_t flat_cells = 0;  ///< whose area is zero in double precision: left out of integrals
  double h = 0;                  ///< longest edge
  double max_circumradius = 0;
  double min_angle_degrees = 0, max_angle_degrees = 0;
  double area = 0;
};
/// O(n).
MeshSize mesh_size(const Mesh& mesh);

/// Seminorms over the domain of the mesh: of u in L2, and of its first and second derivatives, with
/// |u|_2^2 the integral of u_xx^2 + 2 u_xy^2 + u_yy^2 as in Lemma 7.7 of the thesis (its
/// section 7.1 counts u_xy once, which is not invariant under rotation).
struct Seminorms {
  double l2 = 0, h1 = 0, h2 = 0;
};

/// A continuous, piecewise linear function on a mesh, and its distance from u.
struct ErrorField {
  std::string error;    ///< a sentence with advice, if it could not be had
  std::string warning;  ///< a sentence, if what was measured needs one
  MeshSize size;
  double l2 = 0, h1 = 0;      ///< norm of the error in L2, seminorm in H1
  Seminorms u;                ///< of u itself. Infinite ones come out as some large number
  std::vector<double> nodal;  ///< a value for each vertex of the mesh
  std::vector<double> cell_l2,
      cell_h1;  ///< the error on each cell: their squares sum up to l2^2, h1^2
  /// How far quadrature went: points at which u was evaluated; cells on which two levels of
  /// subdivision still differed by more than kQuadratureTolerance when the limit was reached.
  std::uint64_t points = 0, unsettled_cells = 0;
};

/// Integrals are taken by a rule that is exact for degree 5, on a triangle and on its quarters,
/// which are divided further until both agree to this part of the integral over the cell.
constexpr double kQuadratureTolerance = 1e-3;
constexpr int kQuadratureDegree = 5;

/// The linear interpolant I u, and u - I u. Fails where u is not finite at a vertex. O(n)
/// evaluations.
ErrorField interpolate(const Mesh& mesh, const PlaneFunction& u);

struct PoissonLimits {
  std::uint64_t max_unknowns = 1'000'000;
  std::uint64_t max_bytes = std::uint64_t{1} << 30;  ///< of the factor, known before it is computed
};
struct PoissonSolution : ErrorField {
  std::uint64_t unknowns = 0;        ///< vertices inside
  std::uint64_t factor_entries = 0;  ///< of the Cholesky factor
  /// Whether the load was taken as the integral of grad u . grad v instead of f v, which is the
  /// same for smooth u: where u is made of pieces, f has parts on the lines between them that no
  /// value of it shows; and where the quadrature of f does not settle, f is hardly integrable, or
  /// not at all.
  bool weak_load = false;
};
/// Solves -Laplace(u_h) = f with u_h = u on the boundary of the mesh, f = -Laplace(u) from the
/// second derivatives of u (a manufactured solution): linear elements, sparse Cholesky
/// factorization. Boundary are the edges of a single cell. The error is that of u_h against u.
PoissonSolution solve_poisson(const Mesh& mesh, const PlaneFunction& u,
                              const PoissonLimits& limits = {});

}  // namespace circumball

#endif  // CIRCUMBALL_FEM_H_
