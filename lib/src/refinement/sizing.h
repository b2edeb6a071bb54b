#ifndef CIRCUMBALL_REFINEMENT_SIZING_H_
#define CIRCUMBALL_REFINEMENT_SIZING_H_

#include <string>

#include "circumball/types.h"
#include "expression/expression.h"

namespace circumball {

/// A sizing function h of x, y (and z), given as the text of an expression. Its infimum over a
/// triangle is a certified bound.
class Sizing {
 public:
  /// Fails with a sentence that names the place (1-based) in `error`.
  static bool parse(const std::string& text, Sizing* sizing, std::string* error) {
    return Expression::parse(text, &sizing->expression_, error);
  }

  bool is_constant() const { return expression_.is_constant(); }
  double at(double x, double y, double z = 0) const { return expression_.at(x, y, z); }
  Interval over(const Interval& x, const Interval& y, const Interval& z = 0.0) const {
    return expression_.over(x, y, z);
  }

  /// Whether `radius` > inf of h over the triangle abc. "No" is certain: a lower bound of h on
  /// boxes that cover the triangle is at least `radius`. "Yes" is either a point of the triangle
  /// where h is smaller, or a bound that stayed unclear after 256 boxes: then radius and infimum
  /// differ by little, or h is wild.
  bool exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const;

 private:
  Expression expression_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SIZING_H_
