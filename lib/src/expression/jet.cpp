#include "expression/jet.h"

#include <cmath>

#include "predicates/elementary.h"

namespace circumball {
namespace {

/// A derivative that is zero stays zero where the factor is infinite or undefined: a constant
/// argument has no derivatives, wherever it is.
double times(double factor, double derivative) { return derivative == 0 ? 0 : factor * derivative; }

/// f(a) for a function of one variable with value f, first and second derivative there.
Jet chain(const Jet& a, double f, double f1, double f2) {
  return {f,
          times(f1, a.x),
          times(f1, a.y),
          times(f1, a.xx) + times(f2, a.x * a.x),
          times(f1, a.xy) + times(f2, a.x * a.y),
          times(f1, a.yy) + times(f2, a.y * a.y)};
}

}  // namespace

Jet operator-(const Jet& a) { return {-a.value, -a.x, -a.y, -a.xx, -a.xy, -a.yy}; }
Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value,
          a.x * b.value + a.value * b.x,
          a.y * b.value + a.value * b.y,
          a.xx * b.value + 2 * (a.x * b.x) + a.value * b.xx,
          a.xy * b.value + (a.x * b.y + a.y * b.x) + a.value * b.xy,
          a.yy * b.value + 2 * (a.y * b.y) + a.value * b.yy};
}
Jet operator/(const Jet& a, const Jet& b) {
  // Of q b = a: the value is the same double as that of the division.
  const double q = a.value / b.value;
  const double x = (a.x - q * b.x) / b.value, y = (a.y - q * b.y) / b.value;
  return {q,
          x,
          y,
          (a.xx - 2 * x * b.x - q * b.xx) / b.value,
          (a.xy - x * b.y - y * b.x - q * b.xy) / b.value,
          (a.yy - 2 * y * b.y - q * b.yy) / b.value};
}

Jet abs(const Jet& a) { return std::signbit(a.value) ? -a : a; }
Jet min(const Jet& a, const Jet& b) { return b.value < a.value ? b : a; }
Jet max(const Jet& a, const Jet& b) { return a.value < b.value ? b : a; }

Jet sqrt(const Jet& a) {
  const double r = std::sqrt(a.value);
  return chain(a, r, 0.5 / r, -0.25 / (r * a.value));
}
Jet exp(const Jet& a) {
  const double e = elementary::exp(a.value);
  return chain(a, e, e, e);
}
Jet log(const Jet& a) {
  return chain(a, elementary::log(a.value), 1 / a.value, -1 / (a.value * a.value));
}
Jet sin(const Jet& a) {
  const double s = elementary::sin(a.value);
  return chain(a, s, elementary::cos(a.value), -s);
}
Jet cos(const Jet& a) {
  const double c = elementary::cos(a.value);
  return chain(a, c, -elementary::sin(a.value), -c);
}
Jet tan(const Jet& a) {
  const double t = elementary::tan(a.value), d = 1 + t * t;
  return chain(a, t, d, 2 * t * d);
}
Jet asin(const Jet& a) {
  const double v = a.value, s = (1 - v) * (1 + v), r = std::sqrt(s);
  return chain(a, elementary::asin(v), 1 / r, v / (s * r));
}
Jet acos(const Jet& a) {
  const double v = a.value, s = (1 - v) * (1 + v), r = std::sqrt(s);
  return chain(a, elementary::acos(v), -1 / r, -v / (s * r));
}
Jet atan(const Jet& a) {
  const double d = 1 / (1 + a.value * a.value);
  return chain(a, elementary::atan(a.value), d, -2 * a.value * d * d);
}
Jet atan2(const Jet& y, const Jet& x) {
  // The differential (x dy - y dx) / r^2, for r > 0; its coefficients p dy + q dx once more.
  const double r2 = x.value * x.value + y.value * y.value;
  const double p = x.value / r2, q = -y.value / r2;
  const double pp = -2 * p * (y.value / r2);  // by y twice
  const double qq = -pp;                      // by x twice
  const double pq = (q - p) * (q + p);        // mixed: (y^2 - x^2) / r^4
  const auto second = [&](double y1, double y2, double x1, double x2, double y12, double x12) {
    return times(p, y12) + times(q, x12) + times(pp, y1 * y2) + times(qq, x1 * x2) +
           times(pq, y1 * x2 + y2 * x1);
  };
  return {elementary::atan2(y.value, x.value),    times(p, y.x) + times(q, x.x),
          times(p, y.y) + times(q, x.y),          second(y.x, y.x, x.x, x.x, y.xx, x.xx),
          second(y.x, y.y, x.x, x.y, y.xy, x.xy), second(y.y, y.y, x.y, x.y, y.yy, x.yy)};
}

Jet power(const Jet& a, const Jet& b) {
  const double value = elementary::pow(a.value, b.value);
  if (b.is_constant()) {
    // A coefficient of zero wins over a pole: derivatives of x^2 at 0.
    const double n = b.value;
    double first = 0, second = 0;
    if (a.value != 0 && std::fabs(value) > 1e-290 && std::fabs(value) < 1e290) {
      first = n * value / a.value;
      second = (n - 1) * first / a.value;
    } else {
      if (n != 0) first = n * elementary::pow(a.value, n - 1);
      if (n * (n - 1) != 0) second = n * (n - 1) * elementary::pow(a.value, n - 2);
    }
    return chain(a, value, first, second);
  }
  Jet result = exp(b * log(a));
  result.value = value;
  return result;
}

Jet less(const Jet& a, const Jet& b) { return a.value < b.value ? 1.0 : 0.0; }
Jet less_equal(const Jet& a, const Jet& b) { return a.value <= b.value ? 1.0 : 0.0; }
Jet choose(const Jet& condition, const Jet& yes, const Jet& no) {
  return condition.value != 0 ? yes : no;
}

}  // namespace circumball
