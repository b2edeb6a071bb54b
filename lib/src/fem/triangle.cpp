#define EIGEN_DONT_VECTORIZE

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "circumball/fem_laboratory.h"
#include "fem/elements.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// For a quadratic u with Hessian H = (H11, H12, H22) on T_h(alpha, beta), with barycentric
/// coordinates a, b at the ends of the longest edge and c at the apex, u - I u is
/// -1/2 sum over the edges t of (t . H t) times the product of the two coordinates that are not
/// zero on t. Expanded, the gradient is linear in H and in (a, b, c), with coefficients in which
/// nothing cancels however flat the triangle is:
///   d/dx = -h/2 (a - b + (1 - 2 beta) c) H11                  + h alpha c H12
///   d/dy = h beta (1 - beta) / (2 alpha) H11 - h (beta a - (1 - beta) b) H12 - h alpha/2 (1 - 2 c)
///   H22
/// (The 1/alpha is where the large angle enters: Theorem 7.10.) The square of the gradient has
/// degree 2, for which the midpoints of the edges are an exact quadrature rule. With |H|^2 = H11^2
/// + 2 H12^2 + H22^2 and w = (H11, sqrt 2 H12, H22), |u - I u|_1^2 / |u|_2^2 is w . G w / w . w.
Matrix3d gradient_form(double h, double alpha, double beta) {
  constexpr double kMidpoints[3][3] = {{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  const double half_root = std::sqrt(0.5);  // H12 by the second component of w
  Matrix3d form = Matrix3d::Zero();
  for (const auto& [a, b, c] : kMidpoints) {
    const Vector3d x(-h / 2 * (a - b + (1 - 2 * beta) * c), half_root * (h * alpha * c), 0);
    const Vector3d y(h * beta * (1 - beta) / (2 * alpha),
                     half_root * (-h * (beta * a - (1 - beta) * b)), -h * alpha / 2 * (1 - 2 * c));
    form += (x * x.transpose() + y * y.transpose()) / 3;
  }
  return form;
}

/// The same for ||u - I u||_0^2. Integrals over T of products of the a b, b c, c a are area / 90 (a
/// square) and area / 180.
Matrix3d value_form(double h, double alpha, double beta) {
  const auto edge = [](double x, double y) {  // t . H t as a function of w
    return Vector3d(x * x, std::sqrt(2.0) * x * y, y * y);
  };
  const Vector3d d[3] = {edge(h, 0), edge(beta * h, alpha * h), edge((beta - 1) * h, alpha * h)};
  Matrix3d form = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) form += d[i] * d[j].transpose() / (i == j ? 360.0 : 720.0);
  }
  return form;
}

double length(const Point2& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

void set_constants(const Point2& along, const Point2& across, TriangleStudy* study) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver(
      gradient_form(study->h, study->alpha, study->beta));
  study->h1_constant = std::sqrt(std::max(solver.eigenvalues()[2], 0.0));
  const Vector3d w = solver.eigenvectors().col(2);
  // The Hessian from the triangle's frame to that of the plane.
  const double h11 = w[0], h12 = w[1] * std::sqrt(0.5), h22 = w[2];
  const auto turned = [&](double px, double py, double qx, double qy) {
    return px * h11 * qx + (px * qy + py * qx) * h12 + py * h22 * qy;
  };
  std::array<double, 3> q{0.5 * turned(along.x, across.x, along.x, across.x),
                          turned(along.x, across.x, along.y, across.y),
                          0.5 * turned(along.y, across.y, along.y, across.y)};
  // Of the multiples the one whose largest coefficient is 1.
  double largest = 0;
  for (const double v : q) {
    if (std::fabs(v) > std::fabs(largest)) largest = v;
  }
  for (double& v : q) v /= largest;
  study->worst_quadratic = q;
  Eigen::SelfAdjointEigenSolver<Matrix3d> values(value_form(study->h, study->alpha, study->beta),
                                                 Eigen::EigenvaluesOnly);
  study->l2_constant = std::sqrt(std::max(values.eigenvalues()[2], 0.0));
}

void set_interpolation(const fem::Element& t, const PlaneFunction& u, TriangleStudy* study) {
  std::array<double, 3> values;
  for (int k = 0; k < 3; ++k) values[k] = u.at(t.corner[k]);
  fem::QuadratureBudget budget;
  const fem::CellError e = fem::cell_error(t, values, u, &budget);
  if (!std::isfinite(e.l2 + e.h1)) {
    study->interpolation_error = "u or its gradient is not finite on the triangle";
    return;
  }
  study->interpolation = TriangleError{
      std::sqrt(e.l2), std::sqrt(e.h1), {std::sqrt(e.u_l2), std::sqrt(e.u_h1), std::sqrt(e.u_h2)}};
}

}  // namespace

TriangleStudy study_triangle(const Point2& a, const Point2& b, const Point2& c,
                             const PlaneFunction* u) {
  TriangleStudy study;
  for (const Point2& p : {a, b, c}) {
    if (!(std::fabs(p.x) <= 1e50 && std::fabs(p.y) <= 1e50)) {
      study.error = "a corner of the triangle is not finite, or beyond 1e50";
      return study;
    }
  }
  fem::Element t = fem::element(a, b, c);
  const bool clockwise = t.area < 0;
  if (clockwise) t = fem::element(a, c, b);
  const double two_area = 2 * t.area;
  for (int k = 0; k < 3; ++k) study.lengths[k] = length(t.edge[k]);
  const auto [shortest, longest] = std::minmax_element(study.lengths.begin(), study.lengths.end());
  // Shorter than this the squares of lengths and areas are not normal numbers.
  if (!(two_area > 0) || !(*shortest > 1e-70)) {
    study.error = "the corners lie on a line, or coincide: move one of them";
    return study;
  }
  const int base = static_cast<int>(longest - study.lengths.begin());
  study.h = *longest;
  study.area = t.area;
  const double sum = study.lengths[0] + study.lengths[1] + study.lengths[2];
  study.inradius = two_area / sum;
  const Point2 &p = t.edge[(base + 1) % 3], &q = t.edge[(base + 2) % 3];
  const double lp = length(p), lq = length(q);
  study.circumradius = study.h * lp * lq / (2 * two_area);
  study.radius_edge = study.circumradius / *shortest;
  for (int k = 0; k < 3; ++k) {
    const Point2 &v = t.edge[(k + 1) % 3], &w = t.edge[(k + 2) % 3];
    study.angles_degrees[k] =
        elementary::atan2(two_area, -(v.x * w.x + v.y * w.y)) * (180 / elementary::kPi);
  }
  // T_h(alpha, beta): `along` the longest edge from the foot's nearer end, `across` to the apex.
  Point2 along{t.edge[base].x / study.h, t.edge[base].y / study.h};
  const Point2 across{-along.y, along.x};
  const double from_end = p.x * along.x + p.y * along.y;  // p: from the edge's end to the apex
  const double to_start = q.x * along.x + q.y * along.y;  // q: from the apex to its start
  study.alpha = two_area / (study.h * study.h);
  study.beta = std::max(0.0, std::min(-from_end, -to_start) / study.h);
  if (-from_end < -to_start) along = {-along.x, -along.y};
  const double ratio = study.beta / study.alpha;
  study.circumradius_bound = study.h * std::sqrt(ratio * ratio / 16 + 0.125);
  // Over the middle of the longest edge, at l of equation (7.5).
  const double l = study.h * ((1 - study.beta) * study.beta / (2 * study.alpha) - study.alpha / 2);
  const Point2& start = t.corner[(base + 1) % 3];
  study.circumcenter = {start.x + 0.5 * t.edge[base].x - l * across.x,
                        start.y + 0.5 * t.edge[base].y - l * across.y};
  set_constants(along, across, &study);
  double squares = 0, inverses = 0;
  for (const double e : study.lengths) {
    squares += e * e;
    inverses += 1 / (e * e);
  }
  study.kobayashi_bound =
      std::sqrt(std::max(0.0, study.circumradius * study.circumradius - squares / 30 -
                                  study.area * study.area / 5 * inverses));
  if (u) set_interpolation(t, *u, &study);
  if (clockwise) {
    std::swap(study.lengths[1], study.lengths[2]);
    std::swap(study.angles_degrees[1], study.angles_degrees[2]);
  }
  return study;
}

}  // namespace circumball
