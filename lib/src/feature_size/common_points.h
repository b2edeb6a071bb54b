#ifndef CIRCUMBALL_FEATURE_SIZE_COMMON_POINTS_H_
#define CIRCUMBALL_FEATURE_SIZE_COMMON_POINTS_H_

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace circumball {

/// The input vertices that all features of a growing list have in common. At a hub of many segments
/// or an axis of many faces it spares comparing each with all: a feature that has such a vertex is
/// disjoint from none of them.
class CommonPoints {
 public:
  /// Adds a feature by its vertices (ascending). False if it is surely disjoint from none of those
  /// before.
  bool add(const std::vector<std::uint32_t>& points) {
    if (first_) {
      first_ = false;
      common_ = points;
      return false;
    }
    if (common_.empty()) return true;
    std::vector<std::uint32_t> both;
    std::set_intersection(common_.begin(), common_.end(), points.begin(), points.end(),
                          std::back_inserter(both));
    common_ = std::move(both);
    return common_.empty();
  }

 private:
  bool first_ = true;
  std::vector<std::uint32_t> common_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_COMMON_POINTS_H_
