// SSE would sum in another order than WebAssembly does.
#define EIGEN_DONT_VECTORIZE

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <new>

#include "fem/elements.h"

namespace circumball {
namespace {

using fem::Element;
using Matrix = Eigen::SparseMatrix<double>;

/// The factorization, which knows its size before it takes the memory.
class Factor : public Eigen::SimplicialLDLT<Matrix> {
 public:
  std::uint64_t entries() const {
    std::uint64_t sum = 0;
    for (Eigen::Index i = 0; i < m_nonZerosPerCol.size(); ++i) {
      sum += static_cast<std::uint64_t>(m_nonZerosPerCol[i]);
    }
    return sum;
  }
};

struct Load {
  std::array<double, 3> value;
  bool settled;  ///< whether the quadrature was
};

/// Integrals over the cell of f v for the three hat functions v.
Load strong_load(const Element& t, const PlaneFunction& u, fem::QuadratureBudget* budget) {
  const auto integral = fem::average<4>(
      [&](const fem::Barycentric& at) {
        const PlaneFunction::Derivatives d = u.derivatives(t.at(at));
        const double f = -(d.xx + d.yy);
        return std::array<double, 4>{std::fabs(f), f * at[0], f * at[1], f * at[2]};
      },
      1, {}, budget);
  const auto& [size, a, b, c] = integral.value;
  return {{t.area * a, t.area * b, t.area * c}, integral.settled};
}

/// Integrals over the cell of grad u . grad v.
Load weak_load(const Element& t, const PlaneFunction& u, fem::QuadratureBudget* budget) {
  const auto integral = fem::average<3>(
      [&](const fem::Barycentric& at) {
        const PlaneFunction::Derivatives d = u.derivatives(t.at(at));
        return std::array<double, 3>{std::sqrt(d.x * d.x + d.y * d.y), d.x, d.y};
      },
      1, {}, budget);
  const auto& [size, x, y] = integral.value;
  Load load{{}, integral.settled};
  // grad v = (-e.y, e.x) / (2 area), e the opposite edge.
  for (int k = 0; k < 3; ++k) load.value[k] = 0.5 * (y * t.edge[k].x - x * t.edge[k].y);
  return load;
}

/// Loads of all cells, three each. Strong ones, if their quadrature settles everywhere: a Laplacian
/// that is not integrable, or nearly so, shows in that.
std::vector<double> loads(const Mesh& mesh, const PlaneFunction& u, PoissonSolution* solution) {
  solution->weak_load = u.is_piecewise();
  for (;;) {
    std::vector<double> all(mesh.cells.size(), 0);
    fem::QuadratureBudget budget;
    bool settled = true;
    for (std::size_t i = 0; i < mesh.cell_count() && (settled || solution->weak_load); ++i) {
      const Element t = fem::element(mesh, i);
      if (!(t.area > 0)) continue;
      const Load load = solution->weak_load ? weak_load(t, u, &budget) : strong_load(t, u, &budget);
      settled = settled && load.settled;
      for (int k = 0; k < 3; ++k) all[3 * i + k] = load.value[k];
    }
    if (settled || solution->weak_load) return all;
    solution->weak_load = true;
  }
}

constexpr const char* kNoMemory =
    "there is not enough memory for the factorization: choose a mesh with fewer vertices";

/// Solves for the nodal values inside; those on the boundary are there.
std::string solve(const Mesh& mesh, const PlaneFunction& u, const PoissonLimits& limits,
                  const std::vector<int>& number, PoissonSolution* solution) {
  const auto n = static_cast<Eigen::Index>(solution->unknowns);
  const std::vector<double> load = loads(mesh, u, solution);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const Element t = fem::element(mesh, i);
    if (!(t.area > 0)) continue;
    const std::uint32_t* v = mesh.cell(i);
    for (int j = 0; j < 3; ++j) {
      const int row = number[v[j]];
      if (row < 0) continue;
      right[row] += load[3 * i + j];
      for (int k = 0; k < 3; ++k) {
        const double stiffness =
            (t.edge[j].x * t.edge[k].x + t.edge[j].y * t.edge[k].y) / (4 * t.area);
        const int column = number[v[k]];
        if (column < 0) {
          right[row] -= stiffness * solution->nodal[v[k]];
        } else if (column <= row) {
          entries.emplace_back(row, column, stiffness);  // the lower triangle
        }
      }
    }
  }
  if (!right.allFinite()) {
    return "the derivatives of u are not finite everywhere on the mesh: choose another function, "
           "or "
           "another mesh";
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Eigen::Triplet<double>>().swap(entries);

  Factor factor;
  factor.analyzePattern(matrix);
  solution->factor_entries = factor.entries();
  // A number and a row index each.
  if (solution->factor_entries > limits.max_bytes / (sizeof(double) + sizeof(int))) {
    return kNoMemory;
  }
  factor.factorize(matrix);
  if (factor.info() != Eigen::Success) {
    return "the matrix of the problem is singular in double precision: the mesh has triangles that "
           "are too flat";
  }
  const Eigen::VectorXd x = factor.solve(right);
  if (factor.info() != Eigen::Success || !x.allFinite()) {
    return "the solution overflows double precision: the mesh has triangles that are too flat";
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] >= 0) solution->nodal[v] = x[number[v]];
  }
  return "";
}

}  // namespace

PoissonSolution solve_poisson(const Mesh& mesh, const PlaneFunction& u,
                              const PoissonLimits& limits) {
  PoissonSolution solution;
  solution.error = fem::unusable(mesh);
  if (!solution.error.empty()) return solution;
  constexpr int kUnused = -1, kInside = -2, kBoundary = -3;
  std::vector<int> number(mesh.vertices.size(), kUnused);
  for (const std::uint32_t v : mesh.cells) number[v] = kInside;
  for (const auto& edge : fem::boundary_edges(mesh)) {
    for (const std::uint32_t v : edge) number[v] = kBoundary;
  }
  solution.nodal.assign(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kInside) {
      number[v] = static_cast<int>(solution.unknowns++);
    } else if (number[v] == kBoundary) {
      const Point2 p = xy(mesh.vertices[v]);
      solution.nodal[v] = u.at(p);
      if (!std::isfinite(solution.nodal[v])) {
        solution.error = "u has no finite value at the boundary vertex " + fem::place(p) +
                         ": choose a function that has boundary values";
        return solution;
      }
    }
    if (solution.unknowns > limits.max_unknowns) {
      solution.error = "the mesh has more than " + std::to_string(limits.max_unknowns) +
                       " vertices inside, the limit: choose a larger size";
      return solution;
    }
  }
  try {
    if (solution.unknowns > 0) solution.error = solve(mesh, u, limits, number, &solution);
  } catch (const std::bad_alloc&) {
    solution.error = kNoMemory;
  }
  if (!solution.error.empty()) return solution;
  fem::measure_error(mesh, u, &solution);
  if (solution.weak_load && solution.warning.empty()) {
    solution.warning = std::string(u.is_piecewise() ? "u is made of pieces"
                                                    : "the Laplacian of u is hardly integrable") +
                       ", so the load is the integral of grad u . grad v, not of f v.";
  }
  return solution;
}

}  // namespace circumball
