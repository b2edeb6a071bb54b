#ifndef CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN_H_
#define CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "circumball/feature_size.h"
#include "circumball/refine.h"
#include "circumball/trace.h"
#include "support/complexes.h"

namespace circumball::testing {

/// Watches a run of `feature-size` with nothing but the oracle and the places of the vertices that
/// are inserted: N(q0) of every input vertex q0 after every insertion.
class NearestNeighborWatch final : public TraceSink {
 public:
  explicit NearestNeighborWatch(const Complex& complex) {
    const FeatureSizes sizes(complex);
    double largest = 0;
    for (const Point3& p : complex.vertices) {
      vertices_.push_back(xy(p));
      lfs_.push_back(sizes.local_by_brute_force(xy(p)).radius);
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
    n2_.assign(vertices_.size(), std::numeric_limits<double>::infinity());
    rounding_ = 8 * std::numeric_limits<double>::epsilon() * largest;
  }

  /// N changes by the new vertex only: it is the least distance so far.
  void event(const Event& e, const std::uint32_t*, std::size_t) override {
    if (e.kind != EventKind::kInserted) return;
    ++insertions_;
    for (std::size_t q = 0; q < vertices_.size(); ++q) {
      const double dx = e.at[0] - vertices_[q].x, dy = e.at[1] - vertices_[q].y;
      const double d2 = dx * dx + dy * dy;
      if (d2 >= n2_[q] || e.subject == q) continue;
      n2_[q] = d2;
      lower_held_ = lower_held_ && std::sqrt(d2) >= 0.5 * lfs_[q] * (1 - 1e-10) - rounding_;
    }
  }

  std::size_t insertions() const { return insertions_; }
  bool lower_bound_held_throughout() const { return lower_held_; }
  bool upper_bound_holds() const {
    for (std::size_t q = 0; q < vertices_.size(); ++q) {
      if (std::isfinite(lfs_[q]) &&
          std::sqrt(n2_[q]) > std::sqrt(2.0) * lfs_[q] * (1 + 1e-10) + rounding_)
        return false;
    }
    return true;
  }
  /// Least and largest N(q0) / lfs(q0) so far.
  std::array<double, 2> range() const {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t q = 0; q < vertices_.size(); ++q) {
      if (!std::isfinite(lfs_[q])) continue;
      const double ratio = std::sqrt(n2_[q]) / lfs_[q];
      range = {std::min(range[0], ratio), std::max(range[1], ratio)};
    }
    return range;
  }

 private:
  std::vector<Point2> vertices_;
  std::vector<double> lfs_, n2_;
  double rounding_ = 0;  ///< what rounding of coordinates moves a vertex by, at most
  std::size_t insertions_ = 0;
  bool lower_held_ = true;
};

/// Two segments at an angle of theta end in about 1 / theta pieces: the smallest angles come
/// rarely, so that ten thousand complexes take seconds.
inline double least_angle_of_run(std::uint64_t number) {
  return number % 100 == 0 ? 0.01 : number % 20 == 1 ? 0.1 : number % 4 == 2 ? 1 : 5;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN_H_
