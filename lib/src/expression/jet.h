#ifndef CIRCUMBALL_EXPRESSION_JET_H_
#define CIRCUMBALL_EXPRESSION_JET_H_

/// Automatic differentiation forwards, to second order, in two variables: each operation carries
/// value, gradient and Hessian along by the chain rule (Griewank and Walther, Evaluating
/// Derivatives, 2008, chapters 3 and 13).
namespace circumball {

/// A value with its derivatives by x and y. A number is a constant.
struct Jet {
  double value = 0;
  double x = 0, y = 0;            ///< gradient
  double xx = 0, xy = 0, yy = 0;  ///< Hessian

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT: a number is a jet
  Jet(double v, double dx, double dy, double dxx, double dxy, double dyy)
      : value(v), x(dx), y(dy), xx(dxx), xy(dxy), yy(dyy) {}
  /// Whether it has no derivative but zero.
  bool is_constant() const { return x == 0 && y == 0 && xx == 0 && xy == 0 && yy == 0; }
};

Jet operator-(const Jet& a);
Jet operator+(const Jet& a, const Jet& b);
Jet operator-(const Jet& a, const Jet& b);
Jet operator*(const Jet& a, const Jet& b);
Jet operator/(const Jet& a, const Jet& b);

Jet abs(const Jet& a);
Jet min(const Jet& a, const Jet& b);
Jet max(const Jet& a, const Jet& b);
Jet sqrt(const Jet& a);
Jet exp(const Jet& a);
Jet log(const Jet& a);
Jet sin(const Jet& a);
Jet cos(const Jet& a);
Jet tan(const Jet& a);
Jet asin(const Jet& a);
Jet acos(const Jet& a);
Jet atan(const Jet& a);
Jet atan2(const Jet& y, const Jet& x);
/// a^b. Where b is constant, a may be zero or, for integers b, negative.
Jet power(const Jet& a, const Jet& b);

/// Comparisons are 1 or 0, and locally constant.
Jet less(const Jet& a, const Jet& b);
Jet less_equal(const Jet& a, const Jet& b);
Jet choose(const Jet& condition, const Jet& yes, const Jet& no);

}  // namespace circumball

#endif  // CIRCUMBALL_EXPRESSION_JET_H_
