#include "sizing/sizing.h"

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
