#ifndef CIRCUMBALL_SIZING_GRID_H_
#define CIRCUMBALL_SIZING_GRID_H_

#include <cstddef>
#include <string>
#include <vector>

#include "predicates/interval.h"

namespace circumball {

/// A positive function sampled on a regular grid of the plane: bilinear between the samples,
/// outside of the grid the value of the nearest point of it.
class SampledGrid {
 public:
  /// {"grid": {"origin": [x, y], "spacing": [dx, dy], "columns": n, "values": [...]}}: values row
  /// by row, from the lowest y and in each row from the lowest x; sample (i, j) is at origin + (i
  /// dx, j dy). Spacings and values are positive; at most 10^7 values. Fails with a sentence in
  /// `error`.
  static bool parse(const std::string& json, SampledGrid* grid, std::string* error);

  bool empty() const { return columns_ == 0; }
  /// Rounded: a few units in the last place.
  double at(double x, double y) const;
  /// Contains every value on the box, also those that `at` returns. On boxes of a few cells it is
  /// tight (a bilinear function has its extrema over a rectangle at the corners), on larger ones it
  /// is the range of the samples around. O(log n).
  Interval over(const Interval& x, const Interval& y) const;

 private:
  struct Level {  // ranges of blocks of 2^k x 2^k samples; level 0 is the samples themselves
    std::size_t columns, rows;
    std::vector<Interval> range;
  };
  void build();
  double sample(std::size_t i, std::size_t j) const { return values_[j * columns_ + i]; }
  Interval samples_between(std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) const;
  Interval over_cell(std::size_t i, std::size_t j, const Interval& u, const Interval& v) const;

  double origin_[2] = {0, 0}, spacing_[2] = {1, 1};
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> values_;
  std::vector<Level> levels_;  // from blocks of 2 x 2 on
};

}  // namespace circumball

#endif  // CIRCUMBALL_SIZING_GRID_H_
