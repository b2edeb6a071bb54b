#ifndef CIRCUMBALL_EXPRESSION_EXPRESSION_H_
#define CIRCUMBALL_EXPRESSION_EXPRESSION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "expression/jet.h"
#include "predicates/interval.h"

namespace circumball {

/// What a node of an expression does with the nodes a, b, c.
enum class ExpressionOp : std::uint8_t {
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
  kTan,
  kAsin,
  kAcos,
  kAtan,
  kAtan2,
  kMin,
  kMax,
  kIf,
};

/// A function of x, y (and z), given as text:
///
///   numbers, pi, x, y, z, ( ), + - * / ^, < <= > >= (1 or 0), c ? a : b,
///   abs sqrt exp log sin cos tan asin acos atan (one argument), min max pow atan2 (two), if
///   (three)
///
/// Angles are in radians; atan2(y, x) is the angle of (x, y) in (-pi, pi], with the branch cut just
/// below the negative x axis, and 0 at the origin.
///
/// It is evaluated at points, the same bits everywhere; over boxes in interval arithmetic, so that
/// its range has certain bounds; and with its first and second derivatives.
class Expression {
 public:
  /// Fails with a sentence that names the place (1-based) in `error`.
  static bool parse(const std::string& text, Expression* expression, std::string* error);

  /// Whether neither x, y nor z occurs.
  bool is_constant() const { return constant_; }
  /// Whether it chooses between pieces (abs, min, max, if, comparisons): its derivatives may jump
  /// where the pieces meet, and `jet` does not see that.
  bool is_piecewise() const;

  double at(double x, double y, double z = 0) const;
  /// An interval that contains every value on the box; empty where it is nowhere defined.
  Interval over(const Interval& x, const Interval& y, const Interval& z = 0.0) const;
  /// Value, gradient and Hessian at (x, y); where pieces meet, those of the piece that is chosen.
  /// NaN or infinite where the function or its derivatives are not defined.
  Jet jet(double x, double y) const;

 private:
  friend class ExpressionParser;
  /// Operands come before their operator: a, b, c are indices of earlier nodes.
  struct Node {
    ExpressionOp op;
    double value = 0;
    std::uint32_t a = 0, b = 0, c = 0;
  };
  template <class Value>
  Value evaluate(const Value& x, const Value& y, const Value& z, std::vector<Value>* values) const;

  std::vector<Node> nodes_;
  bool constant_ = true;
  mutable std::vector<double> point_values_;  // scratch
  mutable std::vector<Interval> box_values_;
  mutable std::vector<Jet> jet_values_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_EXPRESSION_EXPRESSION_H_
