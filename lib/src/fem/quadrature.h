#ifndef CIRCUMBALL_FEM_QUADRATURE_H_
#define CIRCUMBALL_FEM_QUADRATURE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "circumball/fem.h"
#include "circumball/types.h"

namespace circumball::fem {

using Barycentric = std::array<double, 3>;

struct QuadraturePoint {
  Barycentric at;
  double weight;  ///< part of the area
};

/// Seven points, exact for polynomials of degree 5 (Radon, Zur mechanischen Kubatur, 1948; Strang
/// and Fix, An analysis of the finite element method, 1973, table 4.1; Dunavant 1985).
inline const std::array<QuadraturePoint, 7>& quadrature_rule() {
  static const std::array<QuadraturePoint, 7> rule = [] {
    const double root = std::sqrt(15.0);
    const double p = (6 - root) / 21, q = (6 + root) / 21;
    const double u = (155 - root) / 1200, v = (155 + root) / 1200;
    return std::array<QuadraturePoint, 7>{{{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 40},
                                           {{p, p, 1 - 2 * p}, u},
                                           {{p, 1 - 2 * p, p}, u},
                                           {{1 - 2 * p, p, p}, u},
                                           {{q, q, 1 - 2 * q}, v},
                                           {{q, 1 - 2 * q, q}, v},
                                           {{1 - 2 * q, q, q}, v}}};
  }();
  return rule;
}

/// How many points may still be spent beyond the first two levels of each cell.
struct QuadratureBudget {
  std::uint64_t spent = 0;
  std::uint64_t extra = 2'000'000;
};

template <std::size_t n>
struct Integral {
  std::array<double, n> value{};
  bool settled = true;
};

/// Averages over a triangle of the n functions that f(barycentric) returns. Pieces are quartered
/// until the sum over the quarters differs from the piece by at most kQuadratureTolerance of the
/// average found so far (plus `floor`: what rounding leaves), for the first `controlled` functions;
/// at most kMaxPieces pieces.
template <std::size_t n, class F>
Integral<n> average(const F& f, std::size_t controlled, const std::array<double, n>& floor,
                    QuadratureBudget* budget) {
  constexpr int kMaxPieces = 400;
  constexpr int kMaxDepth = 12;
  struct Piece {
    std::array<Barycentric, 3> corners;
    std::array<double, n> value;  // of its share in the whole
    double share;
    int depth;
  };
  const auto evaluate = [&](Piece* piece) {
    piece->value = {};
    for (const QuadraturePoint& q : quadrature_rule()) {
      Barycentric at{};
      for (int k = 0; k < 3; ++k) {
        at[k] = q.at[0] * piece->corners[0][k] + q.at[1] * piece->corners[1][k] +
                q.at[2] * piece->corners[2][k];
      }
      const std::array<double, n> v = f(at);
      for (std::size_t i = 0; i < n; ++i) piece->value[i] += piece->share * q.weight * v[i];
    }
    budget->spent += quadrature_rule().size();
  };
  const auto middle = [](const Barycentric& a, const Barycentric& b) {
    return Barycentric{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
  };

  Integral<n> result;
  // Depth first: three siblings wait at each depth.
  std::array<Piece, 3 * kMaxDepth + 4> open;
  int count = 0, pieces = 1;
  open[count++] = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}, 1, 0};
  evaluate(&open[0]);
  std::array<double, n> total = open[0].value;  // the best estimate of the whole
  while (count > 0) {
    const Piece piece = open[--count];
    const auto& [a, b, c] = piece.corners;
    const Barycentric ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    std::array<Piece, 4> quarters{{{{{a, ab, ca}}, {}, piece.share / 4, piece.depth + 1},
                                   {{{ab, b, bc}}, {}, piece.share / 4, piece.depth + 1},
                                   {{{ca, bc, c}}, {}, piece.share / 4, piece.depth + 1},
                                   {{{ab, bc, ca}}, {}, piece.share / 4, piece.depth + 1}}};
    std::array<double, n> sum{};
    for (Piece& quarter : quarters) {
      evaluate(&quarter);
      for (std::size_t i = 0; i < n; ++i) sum[i] += quarter.value[i];
    }
    bool agree = true;
    for (std::size_t i = 0; i < n; ++i) {
      const double change = sum[i] - piece.value[i];
      total[i] += change;
      if (i < controlled && !(std::fabs(change) <= kQuadratureTolerance * total[i] + floor[i])) {
        agree = false;
      }
    }
    const bool may_divide = piece.depth < kMaxDepth && pieces + 4 <= kMaxPieces &&
                            (piece.depth == 0 || budget->extra >= 28);
    if (agree || !may_divide) {
      if (!agree) result.settled = false;
      for (std::size_t i = 0; i < n; ++i) result.value[i] += sum[i];
      continue;
    }
    pieces += 4;
    budget->extra -= std::min<std::uint64_t>(budget->extra, 4 * 28);
    for (const Piece& quarter : quarters) open[count++] = quarter;
  }
  return result;
}

}  // namespace circumball::fem

#endif  // CIRCUMBALL_FEM_QUADRATURE_H_
