#include "refinement/sizing.h"

#include <gtest/gtest.h>

#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

Sizing parsed(const std::string& text) {
  Sizing s;
  std::string error;
  EXPECT_TRUE(Sizing::parse(text, &s, &error)) << error;
  return s;
}

TEST(Sizing, EvaluatesLikeArithmetic) {
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
  EXPECT_TRUE(parsed("pi * 2").is_constant());
  EXPECT_FALSE(parsed("0*x").is_constant());
}

TEST(Sizing, WhatIsNoExpressionIsNamedWithItsPlace) {
  for (const char* text : {"", "1 +", "(1", "1)", "foo(2)", "x y", "min(1)", "min(1,2,3)", "1 ? 2",
                           "2 ** 3", "sin 2", ".", "x < ", "#"}) {
    Sizing s;
    std::string error;
    EXPECT_FALSE(Sizing::parse(text, &s, &error)) << text;
    EXPECT_NE(error.find("character"), std::string::npos) << text;
  }
  Sizing s;
  std::string error;
  EXPECT_FALSE(Sizing::parse(std::string(100000, '('), &s, &error));
  EXPECT_FALSE(Sizing::parse("1" + std::string(100000, '^'), &s, &error));
}

TEST(Sizing, BoxesContainTheValuesAtTheirPoints) {
  testing::Random random(5);
  for (const char* text :
       {"0.1 + x*x - y/3", "sqrt(abs(x)) + 0.2", "x < y ? 1/(1+x*x) : exp(y)",
        "min(x, y)^3 + max(x, 2)^-2", "sin(3*x) * cos(y) - log(4 + x)", "pow(2 + x, 0.3)"}) {
    const Sizing h = parsed(text);
    for (int i = 0; i < 500; ++i) {
      const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1, w = random.unit();
      const Interval box = h.over({x, x + w}, {y, y + w});
      for (int j = 0; j < 10; ++j) {
        const double value = h.at(x + w * random.unit(), y + w * random.unit());
        EXPECT_TRUE(box.contains(value)) << text;
      }
    }
  }
}

TEST(Sizing, TheInfimumOverATriangleIsCertified) {
  const Sizing h = parsed("0.1 + (x - 0.3)^2 + (y - 0.2)^2");  // least inside of the triangle
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  EXPECT_TRUE(h.exceeded_by(0.11, a, b, c));
  EXPECT_FALSE(h.exceeded_by(0.09, a, b, c));
}

TEST(Sizing, RuppertHonorsAnExpression) {
  Options options = testing::options_of("ruppert");
  for (const char* text : {"0.02 + 0.3*x*x", "x < 0.5 ? 0.03 : 0.2"}) {
    options.size = text;
    const auto run = testing::finish(testing::unit_square(), options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->status(), Status::kComplete);
    const Sizing h = parsed(text);
    const Mesh mesh = run->mesh();
    EXPECT_GT(mesh.cell_count(), 100u);
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
      const Point3 &a = mesh.vertices[mesh.cell(i)[0]], &b = mesh.vertices[mesh.cell(i)[1]],
                   &c = mesh.vertices[mesh.cell(i)[2]];
      const double p = std::hypot(a.x - b.x, a.y - b.y), q = std::hypot(b.x - c.x, b.y - c.y),
                   r = std::hypot(c.x - a.x, c.y - a.y);
      const double area2 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      const double radius = p * q * r / (2 * area2);
      for (int u = 0; u <= 8; ++u) {
        for (int v = 0; u + v <= 8; ++v) {
          // Shrunk a little: rounding must not carry a point over a jump of h at an edge.
          const double s = 0.003 + 0.99 * u / 8.0, t = 0.003 + 0.99 * v / 8.0;
          EXPECT_LE(radius, (1 + 1e-12) * h.at(a.x + s * (b.x - a.x) + t * (c.x - a.x),
                                               a.y + s * (b.y - a.y) + t * (c.y - a.y)));
        }
      }
    }
  }
}

TEST(Sizing, AnExpressionThatIsNotPositiveIsRefused) {
  Options options = testing::options_of("ruppert");
  for (const char* text : {"x - 5", "0 * x", "log(0 - 1)", "nonsense", "chew"}) {
    options.size = text;
    EXPECT_FALSE(testing::start(testing::unit_square(), options)) << text;
  }
}

}  // namespace
}  // namespace circumball
