#ifndef CIRCUMBALL_REFINEMENT_SIZING_H_
#define CIRCUMBALL_REFINEMENT_SIZING_H_

#include <cstdint>
#include <string>
#include <vector>

#include "circumball/types.h"
#include "predicates/interval.h"

namespace circumball {

/// A sizing function h of x, y (and z), given as text:
///
///   numbers, pi, x, y, z, ( ), + - * / ^, < <= > >= (1 or 0), c ? a : b,
///   abs sqrt exp log sin cos (one argument), min max pow (two), if (three)
///
/// It is evaluated at points, the same bits everywhere, and over boxes in interval arithmetic, so
/// that its infimum over a triangle is a certified bound.
class Sizing {
 public:
  /// Fails with a sentence that names the place (1-based) in `error`.
  static bool parse(const std::string& text, Sizing* sizing, std::string* error);

  /// Whether neither x, y nor z occurs.
  bool is_constant() const { return constant_; }
  double at(double x, double y, double z = 0) const;
  /// An interval that contains every value of h on the box; empty where h is nowhere defined.
  Interval over(const Interval& x, const Interval& y, const Interval& z = 0.0) const;

  /// Whether `radius` > inf of h over the triangle abc. "No" is certain: a lower bound of h on
  /// boxes that cover the triangle is at least `radius`. "Yes" is either a point of the triangle
  /// where h is smaller, or a bound that stayed unclear after 256 boxes: then radius and infimum
  /// differ by little, or h is wild.
  bool exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const;

 private:
  friend class SizingParser;
  enum class Op : std::uint8_t {
    kNumber,
    kX,
    kY,
    kZ,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kPower,
    kNegate,
    kLess,
    kLessEqual,
    kAbs,
    kSqrt,
    kExp,
    kLog,
    kSin,
    kCos,
    kMin,
    kMax,
    kIf,
  };
  /// Operands come before their operator: a, b, c are indices of earlier nodes.
  struct Node {
    Op op;
    double value = 0;
    std::uint32_t a = 0, b = 0, c = 0;
  };
  template <class Value>
  Value evaluate(const Value& x, const Value& y, const Value& z, std::vector<Value>* values) const;

  std::vector<Node> nodes_;
  bool constant_ = true;
  mutable std::vector<double> point_values_;  // scratch
  mutable std::vector<Interval> box_values_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SIZING_H_
