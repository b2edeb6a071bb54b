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

/// Integrals over the cell of f v for the three hat functions v; of grad u . grad v if `weak`.
std::array<double, 3> load(const Element& t, const PlaneFunction& u, bool weak) {
  std::array<double, 3> sum{};
  for (const fem::QuadraturePoint& q : fem::quadrature_rule()) {
    const PlaneFunction::Derivatives d = u.derivatives(t.at(q.at));
    for (int k = 0; k < 3; ++k) {
      // grad v = (-e.y, e.x) / (2 area), e the opposite edge.
      const double v =
          weak ? (d.y * t.edge[k].x - d.x * t.edge[k].y) / (2 * t.area) : -(d.xx + d.yy) * q.at[k];
      sum[k] += q.weight * t.area * v;
    }
  }
  return sum;
}

constexpr const char* kNoMemory =
    "there is not enough memory for the factorization: choose a mesh with fewer vertices";

/// Solves for the nodal values inside; those on the boundary are there.
std::string solve(const Mesh& mesh, const PlaneFunction& u, const PoissonLimits& limits,
                  const std::vector<int>& number, PoissonSolution* solution) {
  const auto n = static_cast<Eigen::Index>(solution->unknowns);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const Element t = fem::element(mesh, i);
    if (!(t.area > 0)) continue;
    const std::uint32_t* v = mesh.cell(i);
    const std::array<double, 3> f = load(t, u, solution->weak_load);
    for (int j = 0; j < 3; ++j) {
      const int row = number[v[j]];
      if (row < 0) continue;
      right[row] += f[j];
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
    return "the second derivatives of u are not finite everywhere on the mesh: choose another "
           "function, or another mesh";
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
  solution.weak_load = u.is_piecewise();
  try {
    if (solution.unknowns > 0) solution.error = solve(mesh, u, limits, number, &solution);
  } catch (const std::bad_alloc&) {
    solution.error = kNoMemory;
  }
  if (!solution.error.empty()) return solution;
  fem::measure_error(mesh, u, &solution);
  if (solution.weak_load && solution.warning.empty()) {
    solution.warning =
        "u is made of pieces, so the load is the integral of grad u . grad v, not of f v.";
  }
  return solution;
}

}  // namespace circumball
