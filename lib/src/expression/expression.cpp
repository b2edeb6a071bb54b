#include "expression/expression.h"

#include <algorithm>
#include <cmath>

#include "predicates/elementary.h"

namespace circumball {
namespace {

// The same names for points, boxes and jets.
double less(double a, double b) { return a < b ? 1 : 0; }
double less_equal(double a, double b) { return a <= b ? 1 : 0; }
double choose(double condition, double yes, double no) { return condition != 0 ? yes : no; }
double power(double a, double b) { return elementary::pow(a, b); }

Interval decided(bool surely, bool never) {
  return surely ? Interval(1) : never ? Interval(0) : Interval(0, 1);
}
Interval less(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return decided(a.hi < b.lo, a.lo >= b.hi);
}
Interval less_equal(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return decided(a.hi <= b.lo, a.lo > b.hi);
}
Interval choose(const Interval& condition, const Interval& yes, const Interval& no) {
  if (condition.is_empty()) return Interval::empty();
  if (!condition.contains(0)) return yes;
  if (condition.lo == 0 && condition.hi == 0) return no;
  if (yes.is_empty()) return no;
  if (no.is_empty()) return yes;
  return {std::min(yes.lo, no.lo), std::max(yes.hi, no.hi)};
}
Interval power(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  if (b.lo == b.hi && b.lo == std::floor(b.lo) && std::fabs(b.lo) <= 1000) {
    return pow(a, static_cast<int>(b.lo));
  }
  return exp(b * log(a));  // real exponents: of positive numbers only
}

}  // namespace

template <class Value>
Value Expression::evaluate(const Value& x, const Value& y, const Value& z,
                           std::vector<Value>* values) const {
  using Op = ExpressionOp;
  using elementary::acos;
  using elementary::asin;
  using elementary::atan;
  using elementary::atan2;
  using elementary::cos;
  using elementary::exp;
  using elementary::log;
  using elementary::sin;
  using elementary::tan;
  using std::abs;
  using std::max;
  using std::min;
  using std::sqrt;
  values->clear();
  for (const Node& n : nodes_) {
    const auto a = [&] { return (*values)[n.a]; };
    const auto b = [&] { return (*values)[n.b]; };
    Value v = n.value;
    switch (n.op) {
      case Op::kNumber:
        break;
      case Op::kX:
        v = x;
        break;
      case Op::kY:
        v = y;
        break;
      case Op::kZ:
        v = z;
        break;
      case Op::kAdd:
        v = a() + b();
        break;
      case Op::kSubtract:
        v = a() - b();
        break;
      case Op::kMultiply:
        v = a() * b();
        break;
      case Op::kDivide:
        v = a() / b();
        break;
      case Op::kPower:
        v = power(a(), b());
        break;
      case Op::kNegate:
        v = -a();
        break;
      case Op::kLess:
        v = less(a(), b());
        break;
      case Op::kLessEqual:
        v = less_equal(a(), b());
        break;
      case Op::kAbs:
        v = abs(a());
        break;
      case Op::kSqrt:
        v = sqrt(a());
        break;
      case Op::kExp:
        v = exp(a());
        break;
      case Op::kLog:
        v = log(a());
        break;
      case Op::kSin:
        v = sin(a());
        break;
      case Op::kCos:
        v = cos(a());
        break;
      case Op::kTan:
        v = tan(a());
        break;
      case Op::kAsin:
        v = asin(a());
        break;
      case Op::kAcos:
        v = acos(a());
        break;
      case Op::kAtan:
        v = atan(a());
        break;
      case Op::kAtan2:
        v = atan2(a(), b());
        break;
      case Op::kMin:
        v = min(a(), b());
        break;
      case Op::kMax:
        v = max(a(), b());
        break;
      case Op::kIf:
        v = choose(a(), b(), (*values)[n.c]);
        break;
    }
    values->push_back(v);
  }
  return values->back();
}

double Expression::at(double x, double y, double z) const {
  return evaluate<double>(x, y, z, &point_values_);
}

Interval Expression::over(const Interval& x, const Interval& y, const Interval& z) const {
  return evaluate<Interval>(x, y, z, &box_values_);
}

Jet Expression::jet(double x, double y) const {
  return evaluate<Jet>(Jet(x, 1, 0, 0, 0, 0), Jet(y, 0, 1, 0, 0, 0), Jet(0), &jet_values_);
}

bool Expression::is_piecewise() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& n) {
    using Op = ExpressionOp;
    return n.op == Op::kAbs || n.op == Op::kMin || n.op == Op::kMax || n.op == Op::kIf ||
           n.op == Op::kLess || n.op == Op::kLessEqual;
  });
}

}  // namespace circumball
