#include <cmath>
#include <limits>

#include "circumball/fem_laboratory.h"
#include "complex/box_tree.h"
#include "fem/elements.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

/// Distance to the boundary of a mesh.
class BoundaryDistance {
 public:
  explicit BoundaryDistance(const Mesh& mesh) {
    std::vector<Box2> boxes;
    for (const auto& [a, b] : fem::boundary_edges(mesh)) {
      edges_.push_back({xy(mesh.vertices[a]), xy(mesh.vertices[b])});
      boxes.push_back(Box2::of(edges_.back()[0], edges_.back()[1]));
    }
    tree_ = BoxTree(std::move(boxes));
  }

  /// `bound` where the distance is larger.
  double at(const Point2& p, double bound) const {
    double least = bound * bound;
    tree_.query([&](const Box2& box) { return box.distance2(p) < least; },
                [&](std::uint32_t i) {
                  least = std::min(least, distance2(p, edges_[i][0], edges_[i][1]));
                  return true;
                });
    return std::sqrt(least);
  }

 private:
  static double distance2(const Point2& p, const Point2& a, const Point2& b) {
    const double x = b.x - a.x, y = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    const double length2 = x * x + y * y;
    double t = length2 > 0 ? (px * x + py * y) / length2 : 0;
    t = std::min(std::max(t, 0.0), 1.0);
    const double dx = px - t * x, dy = py - t * y;
    return dx * dx + dy * dy;
  }
  std::vector<std::array<Point2, 2>> edges_;
  BoxTree tree_;
};

struct DiskPoint {
  double x, y, weight;
};

/// Points in the unit disk with weights of the mollifier rho(x) = c e^(-1/(1 - |x|^2)) (thesis,
/// section 7.1); they sum up to one, which is the constant c of the quadrature.
std::vector<DiskPoint> mollifier_rule() {
  // Gauss-Legendre: zeros of the Legendre polynomial by Newton's method, from the guess of
  // Abramowitz and Stegun 22.16.6.
  constexpr int n = kDiskRadii;
  std::vector<DiskPoint> rule;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    double z = elementary::cos(elementary::kPi * (i + 0.75) / (n + 0.5)), derivative = 1;
    for (int step = 0; step < 20; ++step) {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      derivative = n * (z * p - before) / (z * z - 1);
      z -= p / derivative;
    }
    const double r = 0.5 * (1 + z);
    const double weight =
        r * elementary::exp(-1 / (1 - r * r)) / ((1 - z * z) * derivative * derivative);
    for (int k = 0; k < kDiskAngles; ++k) {
      // Each second ring by half a step further.
      const double angle = (2 * elementary::kPi / kDiskAngles) * (k + 0.5 * (i % 2) + 0.25);
      rule.push_back({r * elementary::cos(angle), r * elementary::sin(angle), weight});
      sum += weight;
    }
  }
  for (DiskPoint& p : rule) p.weight /= sum;
  return rule;
}

}  // namespace

AveragedField interpolate_averaged(const Mesh& mesh, const PlaneFunction& u, double h) {
  AveragedField field;
  field.error = fem::unusable(mesh);
  if (!field.error.empty()) return field;
  const double longest = mesh_size(mesh).h;
  if (h == 0) h = longest;
  field.averaging_radius = h;
  if (!(h >= longest) || h > 1e100) {
    field.error = "Theorem 7.12 needs h to be at least the longest edge, " +
                  std::to_string(longest) + ": choose h = 0 for that";
    return field;
  }
  const BoundaryDistance boundary(mesh);
  const std::vector<DiskPoint> rule = mollifier_rule();
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const std::uint32_t v : mesh.cells) used[v] = 1;
  field.nodal.assign(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!used[v]) continue;
    const Point2 center = xy(mesh.vertices[v]);
    // Points of the disk outside of the domain are within h of the boundary, where psi_h is zero:
    // u is asked inside only.
    const bool inside = boundary.at(center, 3 * h) >= 3 * h;
    double sum = 0;
    for (const DiskPoint& q : rule) {
      const Point2 p{center.x + h * q.x, center.y + h * q.y};
      const double cutoff = inside ? 1 : boundary.at(p, 2 * h) / h - 1;  // psi_h
      if (cutoff > 0) sum += q.weight * (std::min(cutoff, 1.0) * u.at(p));
    }
    if (!std::isfinite(sum)) {
      field.error = "u is not finite within " + std::to_string(h) + " of the vertex " +
                    fem::place(center) + ", at a point of the quadrature: choose another size";
      return field;
    }
    field.nodal[v] = sum;
  }
  fem::measure_error(mesh, u, &field);
  return field;
}

}  // namespace circumball
