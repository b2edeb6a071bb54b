#include "circumball/fem.h"
#include "expression/expression.h"

namespace circumball {

PlaneFunction::PlaneFunction() {
  std::string error;
  parse("0", this, &error);
}

bool PlaneFunction::parse(const std::string& text, PlaneFunction* function, std::string* error) {
  auto expression = std::make_shared<Expression>();
  if (!Expression::parse(text, expression.get(), error)) return false;
  function->expression_ = std::move(expression);
  return true;
}

double PlaneFunction::at(const Point2& p) const { return expression_->at(p.x, p.y); }

PlaneFunction::Derivatives PlaneFunction::derivatives(const Point2& p) const {
  const Jet j = expression_->jet(p.x, p.y);
  return {j.value, j.x, j.y, j.xx, j.xy, j.yy};
}

bool PlaneFunction::is_piecewise() const { return expression_->is_piecewise(); }

const std::vector<NamedFunction>& fem_functions() {
  static const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  // The branch cut of atan2 lies in the quarter that is missing.
  static const std::vector<Point2> corner{{0, 0}, {0, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  static const std::vector<NamedFunction> functions{
      {"smooth", "Waves", "sin(pi*x) * sin(pi*y)",
       "As smooth as can be: the error falls like h in H1 and like h^2 in L2.", "analytic", square,
       true},
      {"quadratic", "A parabola", "x^2",
       "The simplest function that is not linear, and the thesis' example after Theorem 7.10.",
       "analytic", square, false},
      {"layer", "A boundary layer", "(1 - exp(-x/0.02)) * (1 - x) * sin(pi*y)",
       "Steep near the left side: nothing falls before h has come down to the width of the layer.",
       "analytic, |u|_2 is large", square, true},
      {"front", "An inner front", "atan(40 * (sqrt((x + 0.1)^2 + (y + 0.1)^2) - 0.8))",
       "A steep circular front: the error gathers along it.", "analytic, |u|_2 is large", square,
       false},
      {"corner", "A corner singularity", "(x^2 + y^2)^(1/3) * sin(2/3 * (atan2(y, x) + pi/2))",
       "Harmonic, zero on the two sides of a corner of 270 degrees, and its gradient is infinite "
       "there: order 2/3 in H1.",
       "H^s for s < 5/3, not H^2", corner, false},
      {"roof", "A roof", "min(min(x, 1 - x), min(y, 1 - y))",
       "The gradient jumps across the diagonals: order 1/2 in H1.", "H^s for s < 3/2, not H^2",
       square, true},
      {"cone", "A cone", "sqrt((x - 0.41)^2 + (y - 0.53)^2)",
       "Its second derivatives grow like 1/r: just not in H^2.", "H^s for s < 2, not H^2", square,
       false},
      {"spike", "A spike", "((x - 0.41)^2 + (y - 0.53)^2)^0.1 * x*(1-x)*y*(1-y)",
       "r^(1/5) at a point: barely in H^1, and the gradient is infinite.", "H^s for s < 6/5",
       square, true},
      {"steep-shore", "Steep shores", "(x*(1-x)*y*(1-y))^0.6",
       "Rises from the boundary with an infinite gradient: what Theorem 7.12 is for.",
       "H^s for s < 1.1, zero on the boundary", square, true},
  };
  return functions;
}

}  // namespace circumball
