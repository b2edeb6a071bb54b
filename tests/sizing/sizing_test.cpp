#include "sizing/sizing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(Sizing, TheInfimumOverATriangleIsCertified) {
  const Sizing h = parsed("0.1 + (x - 0.3)^2 + (y - 0.2)^2");  // least inside of the triangle
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  EXPECT_TRUE(h.exceeded_by(0.11, a, b, c));
  EXPECT_FALSE(h.exceeded_by(0.09, a, b, c));
}

TEST(Sizing, WhatIsCertainOfAnInfimumIsTrue) {
  testing::Random random(11);
  using Infimum = Sizing::Infimum;
  for (const char* text : {"0.1 + (x - 0.3)^2 + (y - 0.2)^2", "x < 0.4 ? 0.05 : 0.5 + y",
                           "0.2 + 0.1*sin(20*x)*cos(30*y)"}) {
    const Sizing h = parsed(text);
    for (int i = 0; i < 300; ++i) {
      Point2 p[3];
      for (Point2& q : p) q = {random.unit(), random.unit()};
      const double value = 0.6 * random.unit(), radius = 0.3 * random.unit();
      double over_triangle = 10, over_disk = 10;
      for (int k = 0; k < 400; ++k) {
        double u = random.unit(), v = random.unit();
        const Point2 d{p[0].x + radius * (2 * u - 1), p[0].y + radius * (2 * v - 1)};
        if ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5) < 0.25) {
          over_disk = std::min(over_disk, h.at(d.x, d.y));
        }
        if (u + v > 1) u = 1 - u, v = 1 - v;
        over_triangle =
            std::min(over_triangle, h.at(p[0].x + u * (p[1].x - p[0].x) + v * (p[2].x - p[0].x),
                                         p[0].y + u * (p[1].y - p[0].y) + v * (p[2].y - p[0].y)));
      }
      const Infimum t = h.compare_over_triangle(value, p[0], p[1], p[2]);
      const Infimum d = h.compare_over_disk(value, p[0], radius);
      if (over_triangle < value) {
        EXPECT_NE(t, Infimum::kAtLeast) << text;
      }
      if (over_disk < value) {
        EXPECT_NE(d, Infimum::kAtLeast) << text;
      }
      if (h.at(0.39, 0) < h.at(0.41, 0) - 0.1) continue;  // samples may miss what is behind a jump
      if (over_triangle > value + 0.1) {
        EXPECT_NE(t, Infimum::kBelow) << text;
      }
      if (over_disk > value + 0.1) {
        EXPECT_NE(d, Infimum::kBelow) << text;
      }
    }
  }
}

TEST(Sizing, ATriangleThatTouchesAJumpFromAboveIsNotBelow) {
  const Sizing h = parsed("x < 0.4 ? 0.01 : 1");
  const Point2 a{0.4, 0}, b{0.7, 0.3}, c{0.4, 1.0 / 3};
  EXPECT_EQ(h.compare_over_triangle(0.9, a, b, c), Sizing::Infimum::kAtLeast);
  EXPECT_EQ(h.compare_over_triangle(0.9, {0.39999, 0}, b, c), Sizing::Infimum::kBelow);
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
