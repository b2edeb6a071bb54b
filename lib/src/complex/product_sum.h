#ifndef CIRCUMBALL_COMPLEX_PRODUCT_SUM_H_
#define CIRCUMBALL_COMPLEX_PRODUCT_SUM_H_

namespace circumball {

/// A sum of products of doubles in twice the precision: products are exact (Dekker, A
/// floating-point technique for extending the available precision, 1971), the sum is kept as two
/// doubles. Its error is below n 2^-100 times the largest term, so that signed areas from raw
/// coordinates are right however far from the origin they lie.
class ProductSum {
 public:
  void add(double a, double b) {
    const double p = a * b;
    double a_hi, a_lo, b_hi, b_lo;
    split(a, &a_hi, &a_lo);
    split(b, &b_hi, &b_lo);
    const double error = a_lo * b_lo - (((p - a_hi * b_hi) - a_lo * b_hi) - a_hi * b_lo);
    add_term(p);
    add_term(error);
  }
  /// Adds the cross product of two position vectors: twice the signed area of the triangle with the
  /// origin.
  void add_cross(double ax, double ay, double bx, double by) {
    add(ax, by);
    add(-ay, bx);
  }
  double value() const { return hi_ + lo_; }

 private:
  static void split(double a, double* hi, double* lo) {
    const double c = 134217729.0 * a;  // 2^27 + 1
    *hi = c - (c - a);
    *lo = a - *hi;
  }
  void add_term(double x) {  // two-sum of Knuth, then renormalize
    const double s = hi_ + x;
    const double b = s - hi_;
    const double e = (hi_ - (s - b)) + (x - b);
    lo_ += e;
    const double t = s + lo_;
    lo_ -= t - s;
    hi_ = t;
  }
  double hi_ = 0, lo_ = 0;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_PRODUCT_SUM_H_
