#include <cstdlib>
#include <string_view>

#include "expression/expression.h"
#include "predicates/elementary.h"

namespace circumball {

/// Recursive descent, with a bound on the depth.
class ExpressionParser {
 public:
  ExpressionParser(const std::string& text, Expression* expression)
      : text_(text), expression_(*expression) {}

  bool parse(std::string* error) {
    expression_ = Expression();
    std::uint32_t root;
    bool ok = conditional(&root);
    skip_space();
    if (ok && at_ != text_.size()) ok = fail("an operator or the end was expected");
    if (!ok) *error = error_ + " at character " + std::to_string(at_ + 1) + " of '" + text_ + "'";
    return ok;
  }

 private:
  using Op = ExpressionOp;
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
    if (expression_.nodes_.size() == kMaxNodes) return fail("the expression is too long");
    expression_.nodes_.push_back({op, value, a, b, c});
    *out = static_cast<Ref>(expression_.nodes_.size() - 1);
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
    if (text_.compare(at_, end - at_, "atan") == 0 && text_.compare(end, 1, "2") == 0) ++end;
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
        {"abs", Op::kAbs, 1},   {"sqrt", Op::kSqrt, 1}, {"exp", Op::kExp, 1},
        {"log", Op::kLog, 1},   {"sin", Op::kSin, 1},   {"cos", Op::kCos, 1},
        {"min", Op::kMin, 2},   {"max", Op::kMax, 2},   {"pow", Op::kPower, 2},
        {"if", Op::kIf, 3},     {"tan", Op::kTan, 1},   {"asin", Op::kAsin, 1},
        {"acos", Op::kAcos, 1}, {"atan", Op::kAtan, 1}, {"atan2", Op::kAtan2, 2},
    };
    if (name == "pi") {
      at_ = end;
      return node(Op::kNumber, out, 0, 0, 0, elementary::kPi);
    }
    if (name == "x" || name == "y" || name == "z") {
      at_ = end;
      expression_.constant_ = false;
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
  Expression& expression_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string error_;
};

bool Expression::parse(const std::string& text, Expression* expression, std::string* error) {
  return ExpressionParser(text, expression).parse(error);
}

}  // namespace circumball
