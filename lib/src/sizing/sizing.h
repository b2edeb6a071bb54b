#ifndef CIRCUMBALL_SIZING_SIZING_H_
#define CIRCUMBALL_SIZING_SIZING_H_

#include <string>

#include "circumball/types.h"
#include "expression/expression.h"
#include "sizing/grid.h"

namespace circumball {

/// A sizing function h of x, y (and z): an expression (a number is one), or a sampled grid. It can
/// be evaluated at points, the same bits everywhere, and over boxes in interval arithmetic; by
/// that, bounds of its infimum are certain. Mesher and verification share it, as they share the
/// predicates.
class Sizing {
 public:
  /// Text that begins with { is a grid (see SampledGrid), any other an expression. Fails with a
  /// sentence in `error`.
  static bool parse(const std::string& text, Sizing* sizing, std::string* error);

  /// Whether it is an expression without x, y and z.
  bool is_constant() const { return grid_.empty() && expression_.is_constant(); }
  double at(double x, double y, double z = 0) const {
    return grid_.empty() ? expression_.at(x, y, z) : grid_.at(x, y);
  }
  /// Contains every value on the box; empty where h is nowhere defined.
  Interval over(const Interval& x, const Interval& y, const Interval& z = 0.0) const {
    return grid_.empty() ? expression_.over(x, y, z) : grid_.over(x, y);
  }

  /// Whether `radius` > inf of h over the triangle abc. "No" is certain: a lower bound of h on
  /// boxes that cover the triangle is at least `radius`. "Yes" is either a point of the triangle
  /// where h is smaller, or a bound that stayed unclear after 256 boxes: then radius and infimum
  /// differ by little, or h is wild.
  bool exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const;

  /// What is certain of an infimum. kUnclear: nothing, after so many boxes.
  enum class Infimum { kAtLeast, kBelow, kUnclear };
  /// Whether inf of h over the closed triangle abc is at least, or below `value`; the latter
  /// because of a point that is in the triangle for sure.
  Infimum compare_over_triangle(double value, const Point2& a, const Point2& b,
                                const Point2& c) const;
  /// The same over the closed disk, but for rounding at its border: a relative 2^-51 of its radius.
  Infimum compare_over_disk(double value, const Point2& center, double radius) const;

 private:
  Expression expression_;
  SampledGrid grid_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_SIZING_SIZING_H_
