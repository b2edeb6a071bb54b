#include "refinement/sizing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "predicates/elementary.h"

namespace circumball {
namespace {

// The same names for points and boxes.
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
Value Sizing::evaluate(const Value& x, const Value& y, const Value& z,
                       std::vector<Value>* values) const {
  using elementary::cos;
  using elementary::exp;
  using elementary::log;
  using elementary::sin;
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

double Sizing::at(double x, double y, double z) const {
  return evaluate<double>(x, y, z, &point_values_);
}

Interval Sizing::over(const Interval& x, const Interval& y, const Interval& z) const {
  return evaluate<Interval>(x, y, z, &box_values_);
}

bool Sizing::exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const {
  constexpr int kBoxes = 256;
  struct Piece {
    Point2 a, b, c;
  };
  std::array<Piece, 3 * kBoxes + 4> open;
  int count = 0;
  open[count++] = {a, b, c};
  for (int boxes = 0; count > 0; ++boxes) {
    if (boxes == kBoxes) return true;
    const Piece t = open[--count];
    const auto extent = [](double u, double v, double w) {
      return Interval(std::min(u, std::min(v, w)), std::max(u, std::max(v, w)));
    };
    const Interval h = over(extent(t.a.x, t.b.x, t.c.x), extent(t.a.y, t.b.y, t.c.y));
    if (h.lo >= radius) continue;
    for (const Point2& p : {t.a, t.b, t.c}) {
      if (at(p.x, p.y) < radius) return true;
    }
    const auto mid = [](const Point2& p, const Point2& q) {
      return Point2{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
    };
    const Point2 ab = mid(t.a, t.b), bc = mid(t.b, t.c), ca = mid(t.c, t.a);
    open[count++] = {t.a, ab, ca};
    open[count++] = {ab, t.b, bc};
    open[count++] = {ca, bc, t.c};
    open[count++] = {ab, bc, ca};
  }
  return false;
}

/// Recursive descent, with a bound on the depth.
class SizingParser {
 public:
  SizingParser(const std::string& text, Sizing* sizing) : text_(text), sizing_(*sizing) {}

  bool parse(std::string* error) {
    sizing_ = Sizing();
    std::uint32_t root;
    bool ok = conditional(&root);
    skip_space();
    if (ok && at_ != text_.size()) ok = fail("an operator or the end was expected");
    if (!ok) *error = error_ + " at character " + std::to_string(at_ + 1) + " of '" + text_ + "'";
    return ok;
  }

 private:
  using Op = Sizing::Op;
  using Ref = std::uint32_t;
  static constexpr int kMaxDepth = 100;
  static constexpr std::size_t kMaxNodes = 10000;

  bool fail(const char* what) {
    if (error_.empty()) error_ = what;
    return false;
  }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(const char* token) {
    skip_space();
    const std::string_view t(token);
    if (std::string_view(text_).substr(at_, t.size()) != t) return false;
    at_ += t.size();
    return true;
  }
  bool node(Op op, Ref* out, Ref a = 0, Ref b = 0, Ref c = 0, double value = 0) {
    if (sizing_.nodes_.size() == kMaxNodes) return fail("the expression is too long");
    sizing_.nodes_.push_back({op, value, a, b, c});
    *out = static_cast<Ref>(sizing_.nodes_.size() - 1);
    return true;
  }

  bool conditional(Ref* out) {
    if (++depth_ > kMaxDepth) return fail("the expression is nested too deeply");
    Ref condition, yes, no;
    if (!comparison(out)) return false;
    if (take("?")) {
      condition = *out;
      if (!conditional(&yes)) return false;
      if (!take(":")) return fail("':' was expected");
      if (!conditional(&no) || !node(Op::kIf, out, condition, yes, no)) return false;
    }
    --depth_;
    return true;
  }
  bool comparison(Ref* out) {
    if (!sum(out)) return false;
    Ref right;
    const Ref left = *out;
    if (take("<=")) return sum(&right) && node(Op::kLessEqual, out, left, right);
    if (take(">=")) return sum(&right) && node(Op::kLessEqual, out, right, left);
    if (take("<")) return sum(&right) && node(Op::kLess, out, left, right);
    if (take(">")) return sum(&right) && node(Op::kLess, out, right, left);
    return true;
  }
  bool sum(Ref* out) {
    if (!product(out)) return false;
    for (;;) {
      const bool add = take("+");
      if (!add && !take("-")) return true;
      Ref right;
      if (!product(&right) || !node(add ? Op::kAdd : Op::kSubtract, out, *out, right)) return false;
    }
  }
  bool product(Ref* out) {
    if (!sign(out)) return false;
    for (;;) {
      const bool multiply = take("*");
      if (!multiply && !take("/")) return true;
      Ref right;
      if (!sign(&right) || !node(multiply ? Op::kMultiply : Op::kDivide, out, *out, right)) {
        return false;
      }
    }
  }
  bool sign(Ref* out) {
    bool negative = false;
    for (;;) {
      if (take("-")) {
        negative = !negative;
      } else if (!take("+")) {
        break;
      }
    }
    return exponent(out) && (!negative || node(Op::kNegate, out, *out));
  }
  bool exponent(Ref* out) {
    if (!primary(out)) return false;
    if (!take("^")) return true;
    if (++depth_ > kMaxDepth) return fail("the expression is nested too deeply");
    const Ref base = *out;
    Ref power;
    if (!sign(&power)) return false;  // to the right: a^b^c = a^(b^c)
    --depth_;
    return node(Op::kPower, out, base, power);
  }
  bool primary(Ref* out) {
    if (take("(")) return conditional(out) && (take(")") || fail("')' was expected"));
    skip_space();
    std::size_t end = at_;
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    while (end < text_.size() && letter(text_[end])) ++end;
    if (end > at_) return word(text_.substr(at_, end - at_), end, out);
    return number(out);
  }
  bool number(Ref* out) {
    const auto digit = [&](std::size_t i) {
      return i < text_.size() && text_[i] >= '0' && text_[i] <= '9';
    };
    std::size_t end = at_;
    while (digit(end)) ++end;
    if (end < text_.size() && text_[end] == '.') ++end;
    while (digit(end)) ++end;
    if (!digit(at_) && !digit(at_ + 1)) return fail("a number, a name or '(' was expected");
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t e = end + 1;
      if (e < text_.size() && (text_[e] == '+' || text_[e] == '-')) ++e;
      if (digit(e)) {
        while (digit(e)) ++e;
        end = e;
      }
    }
    const double value = std::strtod(text_.substr(at_, end - at_).c_str(), nullptr);
    at_ = end;
    return node(Op::kNumber, out, 0, 0, 0, value);
  }
  bool word(const std::string& name, std::size_t end, Ref* out) {
    struct Function {
      const char* name;
      Op op;
      int arguments;
    };
    static constexpr Function kFunctions[] = {
        {"abs", Op::kAbs, 1},   {"sqrt", Op::kSqrt, 1}, {"exp", Op::kExp, 1}, {"log", Op::kLog, 1},
        {"sin", Op::kSin, 1},   {"cos", Op::kCos, 1},   {"min", Op::kMin, 2}, {"max", Op::kMax, 2},
        {"pow", Op::kPower, 2}, {"if", Op::kIf, 3},
    };
    if (name == "pi") {
      at_ = end;
      return node(Op::kNumber, out, 0, 0, 0, elementary::kPi);
    }
    if (name == "x" || name == "y" || name == "z") {
      at_ = end;
      sizing_.constant_ = false;
      return node(name == "x" ? Op::kX : name == "y" ? Op::kY : Op::kZ, out);
    }
    for (const Function& f : kFunctions) {
      if (name != f.name) continue;
      at_ = end;
      if (!take("(")) return fail("'(' was expected");
      Ref arguments[3] = {0, 0, 0};
      for (int i = 0; i < f.arguments; ++i) {
        if (i > 0 && !take(",")) return fail("',' was expected");
        if (!conditional(&arguments[i])) return false;
      }
      if (!take(")")) return fail("')' was expected");
      return node(f.op, out, arguments[0], arguments[1], arguments[2]);
    }
    return fail("there is no such name");
  }

  const std::string& text_;
  Sizing& sizing_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string error_;
};

bool Sizing::parse(const std::string& text, Sizing* sizing, std::string* error) {
  return SizingParser(text, sizing).parse(error);
}

}  // namespace circumball
