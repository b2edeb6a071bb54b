#include <algorithm>

#include "fem_test_util.h"

namespace circumball {
namespace {

using testing::function;

/// Triangles of all shapes: with apex uniform, flat down to 1e-9, and needles; anywhere, any size.
template <class F>
void for_random_triangles(std::uint64_t seed, int count, F visit) {
  testing::Random random(seed);
  for (int i = 0; i < count; ++i) {
    const double flat = i % 3 == 0 ? 1 : std::pow(10.0, -9 * random.unit());
    const double foot = i % 5 == 0 ? std::pow(10.0, -9 * random.unit()) : random.unit();
    const double angle = 6.3 * random.unit(), size = std::pow(10.0, 4 * random.unit() - 2);
    const double c = std::cos(angle) * size, s = std::sin(angle) * size;
    const double x = 0.5 * size, y = flat * random.unit();
    const auto turned = [&](double u, double v) {
      return Point2{x + c * u - s * v, c * v + s * u};
    };
    visit(study_triangle(turned(0, 0), turned(1, 0), turned(foot, y), nullptr));
  }
}

TEST(Triangle, MeasuresOfAKnownOne) {
  const TriangleStudy t = study_triangle({0, 0}, {4, 0}, {0, 3}, nullptr);
  EXPECT_EQ(t.error, "");
  EXPECT_EQ(t.lengths, (std::array<double, 3>{5, 3, 4}));
  EXPECT_DOUBLE_EQ(t.h, 5);
  EXPECT_DOUBLE_EQ(t.area, 6);
  EXPECT_DOUBLE_EQ(t.circumradius, 2.5);
  EXPECT_DOUBLE_EQ(t.inradius, 1);
  EXPECT_DOUBLE_EQ(t.radius_edge, 2.5 / 3);
  EXPECT_NEAR(t.angles_degrees[0], 90, 1e-12);
  EXPECT_NEAR(t.circumcenter.x, 2, 1e-14);
  EXPECT_NEAR(t.circumcenter.y, 1.5, 1e-14);
  EXPECT_NEAR(t.alpha, 2.4 / 5, 1e-15);
  EXPECT_NEAR(t.beta, 1.8 / 5, 1e-15);
  const TriangleStudy back = study_triangle({0, 0}, {0, 3}, {4, 0}, nullptr);  // clockwise
  EXPECT_EQ(back.lengths, (std::array<double, 3>{5, 4, 3}));
  EXPECT_DOUBLE_EQ(back.h1_constant, t.h1_constant);
}

TEST(Proposition7_5, TheCircumradiusIsAtLeastWhatAlphaAndBetaSay) {
  double least = 1e300, greatest = 0;
  for_random_triangles(1, 20000, [&](const TriangleStudy& t) {
    ASSERT_EQ(t.error, "");
    EXPECT_GE(t.circumradius, t.circumradius_bound);
    least = std::min(least, t.circumradius / t.circumradius_bound);
    greatest = std::max(greatest, t.circumradius / t.circumradius_bound);
  });
  // Both sides are of one order: R is at most 2 times the bound, so (7.3) holds.
  EXPECT_LT(greatest, 2);
  std::printf("R / (bound of Proposition 7.5): %.4f to %.4f\n", least, greatest);
}

TEST(Theorem7_10, TheConstantOfQuadraticsIsBoundedByTheCircumradiusNotByTheLongestEdge) {
  double least = 1e300, greatest = 0, by_h = 0, value = 0;
  for_random_triangles(2, 20000, [&](const TriangleStudy& t) {
    ASSERT_EQ(t.error, "");
    EXPECT_LE(t.h1_constant, t.kobayashi_bound * (1 + 1e-9));  // which holds for all u in H^2
    EXPECT_LT(t.kobayashi_bound, t.circumradius * (1 + 1e-12));
    least = std::min(least, t.h1_constant / t.circumradius);
    greatest = std::max(greatest, t.h1_constant / t.circumradius);
    by_h = std::max(by_h, t.h1_constant / t.h);
    value = std::max(value, t.l2_constant / (t.h * t.h));
  });
  EXPECT_LT(greatest, 1 + 1e-12);  // attained in the limit of flat triangles
  EXPECT_GT(least, 0.5);           // the circumradius is the right measure, from below as well
  EXPECT_GT(by_h, 1e6);            // h is not
  EXPECT_LE(value, std::sqrt(1.0 / 120) *
                       (1 + 1e-12));  // in L2 h is enough: needles are as bad as intervals
  std::printf("|u - Iu|_1 / |u|_2: %.4f R to %.4f R, up to %.3g h; L2: up to %.4f h^2\n", least,
              greatest, by_h, value);
}

TEST(Theorem7_10, TheConstantIsAttainedByTheWorstQuadraticAndByNoOther) {
  testing::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Point2 a{random.unit(), random.unit()}, b{random.unit(), random.unit()},
        c{random.unit(), random.unit()};
    const TriangleStudy t = study_triangle(a, b, c, nullptr);
    if (!t.error.empty() || t.alpha < 1e-3) continue;
    const auto quotient = [&](const std::array<double, 3>& q) {
      char text[160];
      std::snprintf(text, sizeof text, "(%.17g)*x^2 + (%.17g)*x*y + (%.17g)*y^2", q[0], q[1], q[2]);
      const PlaneFunction u = function(text);
      const TriangleStudy s = study_triangle(a, b, c, &u);
      EXPECT_EQ(s.interpolation_error, "");
      return std::array<double, 2>{s.interpolation->h1 / s.interpolation->u.h2,
                                   s.interpolation->l2 / s.interpolation->u.h2};
    };
    EXPECT_NEAR(quotient(t.worst_quadratic)[0], t.h1_constant, 1e-8 * t.h1_constant);
    for (int j = 0; j < 5; ++j) {
      const auto other = quotient({random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5});
      EXPECT_LE(other[0], t.h1_constant * (1 + 1e-9));
      EXPECT_LE(other[1], t.l2_constant * (1 + 1e-9));
    }
  }
}

TEST(Theorem7_10, TheExampleAfterItScalesLikeTheCircumradius) {
  // u = x^2 on T_h(alpha, beta): |u|_2^2 = 2 alpha h^2, and |u - I u|_1^2 over h^2 alpha h^2 / 2
  // tends to (beta (1 - beta) / alpha)^2 as alpha does to 0.
  const PlaneFunction u = function("x^2");
  for (const double beta : {0.1, 0.3, 0.5}) {
    for (const double alpha : {1e-2, 1e-4}) {
      const double h = 0.7;
      const TriangleStudy t = study_triangle({0, 0}, {h, 0}, {beta * h, alpha * h}, &u);
      ASSERT_TRUE(t.interpolation);
      EXPECT_NEAR(t.alpha, alpha, 1e-12);
      EXPECT_NEAR(t.beta, beta, 1e-12);
      EXPECT_NEAR(t.interpolation->u.h2, std::sqrt(2 * alpha) * h, 1e-9);
      const double expected = h * std::sqrt(alpha * h * h / 2) * beta * (1 - beta) / alpha;
      EXPECT_NEAR(t.interpolation->h1 / expected, 1, 10 * alpha);
    }
  }
}

TEST(Triangle, WhatIsNoTriangleIsAnsweredWithASentence) {
  EXPECT_NE(study_triangle({0, 0}, {1, 1}, {2, 2}, nullptr).error, "");
  EXPECT_NE(study_triangle({0, 0}, {0, 0}, {2, 2}, nullptr).error, "");
  EXPECT_NE(study_triangle({0, 0}, {1, std::nan("")}, {2, 2}, nullptr).error, "");
  EXPECT_NE(study_triangle({0, 0}, {1, 0}, {2, 1e60}, nullptr).error, "");
  const PlaneFunction u = function("log(x - 1)");
  const TriangleStudy t = study_triangle({0, 0}, {1, 0}, {0, 1}, &u);
  EXPECT_EQ(t.error, "");
  EXPECT_FALSE(t.interpolation);
  EXPECT_NE(t.interpolation_error, "");
}

}  // namespace
}  // namespace circumball
