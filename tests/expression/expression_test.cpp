#include "expression/expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicates/elementary.h"
#include "support/complexes.h"

namespace circumball {
namespace {

Expression parsed(const std::string& text) {
  Expression e;
  std::string error;
  EXPECT_TRUE(Expression::parse(text, &e, &error)) << error;
  return e;
}

TEST(Expression, EvaluatesLikeArithmetic) {
  const double x = 0.75, y = -2;
  EXPECT_EQ(parsed("1 + 2*3 - 4/8").at(x, y), 6.5);
  EXPECT_EQ(parsed("-x^2").at(x, y), -0.5625);
  EXPECT_EQ(parsed("2^3^2").at(x, y), 512);
  EXPECT_EQ(parsed("2^-1").at(x, y), 0.5);
  EXPECT_EQ(parsed("max(x, abs(y)) * min(1, 2)").at(x, y), 2);
  EXPECT_EQ(parsed("sqrt(4) + exp(0) + log(1) + cos(0) + sin(0)").at(x, y), 4);
  EXPECT_EQ(parsed("x < 0.5 ? 1 : y <= -2 ? 2 : 3").at(x, y), 2);
  EXPECT_EQ(parsed("if(x > 0.5, 10, 20)").at(x, y), 10);
  EXPECT_EQ(parsed("1e-3 + .5 + 2.").at(x, y), 2.501);
  EXPECT_EQ(parsed("atan2(1, -0) + atan(0) + tan(0)").at(x, y), elementary::kPi / 2);
  EXPECT_TRUE(parsed("pi * 2").is_constant());
  EXPECT_FALSE(parsed("0*x").is_constant());
}

TEST(Expression, WhatIsNoExpressionIsNamedWithItsPlace) {
  for (const char* text : {"", "1 +", "(1", "1)", "foo(2)", "x y", "min(1)", "min(1,2,3)", "1 ? 2",
                           "2 ** 3", "sin 2", ".", "x < ", "#"}) {
    Expression s;
    std::string error;
    EXPECT_FALSE(Expression::parse(text, &s, &error)) << text;
    EXPECT_NE(error.find("character"), std::string::npos) << text;
  }
  Expression s;
  std::string error;
  EXPECT_FALSE(Expression::parse(std::string(100000, '('), &s, &error));
  EXPECT_FALSE(Expression::parse("1" + std::string(100000, '^'), &s, &error));
}

TEST(Expression, BoxesContainTheValuesAtTheirPoints) {
  testing::Random random(5);
  for (const char* text :
       {"0.1 + x*x - y/3", "sqrt(abs(x)) + 0.2", "x < y ? 1/(1+x*x) : exp(y)",
        "min(x, y)^3 + max(x, 2)^-2", "sin(3*x) * cos(y) - log(4 + x)", "pow(2 + x, 0.3)",
        "tan(2*x) + asin(x) * acos(y)", "atan(9*y) - atan2(y, x)", "atan2(x - 0.2, y + x)"}) {
    const Expression h = parsed(text);
    for (int i = 0; i < 500; ++i) {
      const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1, w = random.unit();
      const Interval box = h.over({x, x + w}, {y, y + w});
      for (int j = 0; j < 10; ++j) {
        const double value = h.at(x + w * random.unit(), y + w * random.unit());
        EXPECT_TRUE(!(value == value) || box.contains(value)) << text;
      }
    }
  }
}

/// Expressions with every operation, each defined around (0.7, 0.4).
constexpr const char* kSmooth[] = {"x*y + 3*x - y/x",
                                   "x^3 * y^-2",
                                   "(x + y)^0.7",
                                   "x^y",
                                   "sqrt(x) - abs(-y)",
                                   "exp(-x*y) * log(x + 2*y)",
                                   "sin(3*x) * cos(x - y)",
                                   "tan(x*y)",
                                   "asin(x*y) + acos(y)",
                                   "atan(x/y) * atan2(y, x)",
                                   "atan2(-x, -y) + atan2(x - 1, y*y)",
                                   "min(x, y) * max(x*x, y)",
                                   "x < y ? 1 : x*y",
                                   "if(x > 0.1, x^2, y)",
                                   "-(2 - x)^2 / (1 + y^2)"};

TEST(Jet, TheValueIsTheDoubleOfEvaluation) {
  testing::Random random(11);
  for (const char* text : kSmooth) {
    const Expression u = parsed(text);
    for (int i = 0; i < 100; ++i) {
      const double x = 0.6 + 0.2 * random.unit(), y = 0.3 + 0.2 * random.unit();
      EXPECT_EQ(u.jet(x, y).value, u.at(x, y)) << text;
    }
  }
}

TEST(Jet, DerivativesAreThoseOfDifferenceQuotients) {
  constexpr double d = 1e-5;  // truncation d^2, rounding 1e-16 / d: 1e-10, both
  testing::Random random(12);
  for (const char* text : kSmooth) {
    const Expression u = parsed(text);
    for (int i = 0; i < 50; ++i) {
      const double x = 0.6 + 0.2 * random.unit(), y = 0.3 + 0.2 * random.unit();
      const Jet j = u.jet(x, y);
      const double tolerance = 1e-7 * (10 + std::fabs(j.xx) + std::fabs(j.yy));
      EXPECT_NEAR(j.x, (u.at(x + d, y) - u.at(x - d, y)) / (2 * d), 1e-7) << text;
      EXPECT_NEAR(j.y, (u.at(x, y + d) - u.at(x, y - d)) / (2 * d), 1e-7) << text;
      EXPECT_NEAR(j.xx, (u.jet(x + d, y).x - u.jet(x - d, y).x) / (2 * d), tolerance) << text;
      EXPECT_NEAR(j.xy, (u.jet(x, y + d).x - u.jet(x, y - d).x) / (2 * d), tolerance) << text;
      EXPECT_NEAR(j.xy, (u.jet(x + d, y).y - u.jet(x - d, y).y) / (2 * d), tolerance) << text;
      EXPECT_NEAR(j.yy, (u.jet(x, y + d).y - u.jet(x, y - d).y) / (2 * d), tolerance) << text;
    }
  }
}

TEST(Jet, PolynomialsAreExactAtZero) {
  const Jet j = parsed("x^2 + 3*x*y + y^3 + (x*0)^0").jet(0, 0);
  EXPECT_EQ(j.value, 1);
  EXPECT_EQ(j.x, 0);
  EXPECT_EQ(j.xx, 2);
  EXPECT_EQ(j.xy, 3);
  EXPECT_EQ(j.yy, 0);
}

TEST(Jet, TheCornerSingularityIsHarmonic) {
  const Expression u = parsed("(x^2 + y^2)^(1/3) * sin(2/3 * (atan2(y, x) + pi/2))");
  testing::Random random(13);
  for (int i = 0; i < 200; ++i) {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
    const Jet j = u.jet(x, y);
    EXPECT_NEAR(j.xx + j.yy, 0, 1e-12 * (std::fabs(j.xx) + std::fabs(j.xy)));
  }
  EXPECT_NEAR(u.at(0, -0.5), 0, 1e-15);  // zero on both sides of the corner
  EXPECT_NEAR(u.at(-0.5, 0), 0, 1e-15);
  EXPECT_NEAR(u.at(-0.5, -0.0), 0, 1e-15);
}

TEST(Expression, SaysWhetherItIsMadeOfPieces) {
  EXPECT_FALSE(parsed("sin(x) + sqrt(y)").is_piecewise());
  for (const char* text : {"abs(x)", "min(x, y)", "x < 1 ? 1 : 2", "if(x, 1, 2)"}) {
    EXPECT_TRUE(parsed(text).is_piecewise()) << text;
  }
}

}  // namespace
}  // namespace circumball
