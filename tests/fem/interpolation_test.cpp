#include "fem/quadrature.h"
#include "fem_test_util.h"

namespace circumball {
namespace {

using testing::family;
using testing::function;
using testing::mesh_of;
using testing::named;
using testing::order;

TEST(Quadrature, IsExactForDegreeFive) {
  // The average of x^p y^q over the triangle (0,0), (1,0), (0,1) is 2 p! q! / (p + q + 2)!.
  const auto factorial = [](int n) {
    double f = 1;
    for (int i = 2; i <= n; ++i) f *= i;
    return f;
  };
  for (int p = 0; p <= 6; ++p) {
    for (int q = 0; p + q <= 6; ++q) {
      double sum = 0;
      for (const fem::QuadraturePoint& point : fem::quadrature_rule()) {
        sum += point.weight * std::pow(point.at[0], p) * std::pow(point.at[1], q);
      }
      const double exact = 2 * factorial(p) * factorial(q) / factorial(p + q + 2);
      if (p + q <= kQuadratureDegree) {
        EXPECT_NEAR(sum, exact, 1e-15) << p << ' ' << q;
      } else if (q == 0) {
        EXPECT_GT(std::fabs(sum - exact), 1e-5);
      }
    }
  }
}

TEST(Quadrature, DividesUntilAJumpIsResolved) {
  fem::QuadratureBudget budget;
  // 1 where the first coordinate is above 0.3: (1 - 0.3)^2 of the area.
  const auto jump = [](const fem::Barycentric& at) {
    return std::array<double, 1>{at[0] > 0.3 ? 1.0 : 0.0};
  };
  EXPECT_NEAR(fem::average<1>(jump, 1, {0}, &budget).value[0], 0.49, 0.49 * 0.01);
  EXPECT_LE(budget.spent, 400u * 28u);
}

TEST(Function, TheNamedOnesAreDefinedAndZeroWhereTheySay) {
  for (const NamedFunction& f : fem_functions()) {
    const PlaneFunction u = function(f.expression);
    for (std::size_t i = 0; i < f.outline.size(); ++i) {
      const Point2 &p = f.outline[i], &q = f.outline[(i + 1) % f.outline.size()];
      for (int k = 0; k <= 32; ++k) {
        const double t = k / 32.0;
        const double value = u.at({(1 - t) * p.x + t * q.x, (1 - t) * p.y + t * q.y});
        EXPECT_TRUE(std::isfinite(value)) << f.id;
        if (f.zero_on_boundary) {
          EXPECT_NEAR(value, 0, 1e-9) << f.id;
        }
      }
    }
    const ErrorField field = interpolate(mesh_of(testing::polygon(f.outline), "ruppert", 0.2), u);
    EXPECT_EQ(field.error, "") << f.id;
    EXPECT_GT(field.u.h1, 0) << f.id;
  }
}

TEST(Interpolation, LinearFunctionsAreTheirOwnInterpolants) {
  const Mesh mesh = mesh_of(testing::random_grid(3, 0.2), "ruppert", 0.5);
  const ErrorField field = interpolate(mesh, function("3*x - 2*y + 1"));
  EXPECT_EQ(field.error, "");
  EXPECT_LT(field.h1, 1e-11 * field.u.h1);
  EXPECT_LT(field.l2, 1e-13 * field.u.l2);
  EXPECT_EQ(field.unsettled_cells, 0u);  // rounding is not taken for an error
  EXPECT_NEAR(field.u.h1, std::sqrt(13 * field.size.area), 1e-9 * field.u.h1);
}

TEST(Interpolation, OfAParabolaOnRightTrianglesIsWhatIntegrationByHandGives) {
  // Legs a (along x) and b: u - I u = x (x - a), of which the squares integrate to a^5 b / 60 ...
  // by hand: the gradient is 2 x - a, its square has the integral a^3 b / 6.
  for (std::uint32_t k : {1u, 7u, 100u}) {
    const ErrorField field = interpolate(family(MeshFamily::kNarrow, 4, k), function("x^2"));
    const double a = 0.25, cells = 2 * 4 * 4 * k, b = a / k;
    EXPECT_NEAR(field.h1, std::sqrt(cells * a * a * a * b / 6), 1e-10 * field.h1);
    EXPECT_NEAR(field.l2, std::sqrt(cells * a * a * a * a * a * b / 60), 1e-10 * field.l2);
    EXPECT_NEAR(field.u.h2, 2, 1e-10);
  }
}

TEST(Interpolation, FallsLikeHInH1AndLikeHSquaredInL2) {
  for (const char* algorithm : {"ruppert", "chew"}) {
    const PlaneFunction u = named("smooth");
    const ErrorField coarse = interpolate(mesh_of(testing::unit_square(), algorithm, 0.05), u);
    const ErrorField fine = interpolate(mesh_of(testing::unit_square(), algorithm, 0.0125), u);
    // h is the longest edge, one of thousands: it says less exactly how fine a mesh is than its
    // number of vertices does.
    const double by = std::sqrt(double(fine.size.cells) / coarse.size.cells);
    EXPECT_NEAR(order(coarse.h1, fine.h1, by, 1), 1, 0.05) << algorithm;
    EXPECT_NEAR(order(coarse.l2, fine.l2, by, 1), 2, 0.08) << algorithm;
    EXPECT_LT(fine.h1, fine.size.max_circumradius * fine.u.h2);  // Theorem 7.10 with C = 1
  }
}

TEST(Interpolation, SingularFunctionsHaveTheOrdersOfTheirRegularity) {
  const auto measure = [](const char* id, const Complex& c, double size) {
    return interpolate(mesh_of(c, "chew", size), named(id));
  };
  Complex corner;
  for (const NamedFunction& f : fem_functions()) {
    if (f.id == "corner") corner = testing::polygon(f.outline);
  }
  const ErrorField a = measure("corner", corner, 0.1), b = measure("corner", corner, 0.025);
  EXPECT_NEAR(order(a.h1, b.h1, 4, 1), 2.0 / 3, 0.07);
  const ErrorField c = measure("roof", testing::unit_square(), 0.1),
                   d = measure("roof", testing::unit_square(), 0.025);
  EXPECT_NEAR(order(c.h1, d.h1, 4, 1), 0.5, 0.12);
  EXPECT_EQ(d.warning, "");
}

TEST(Interpolation, WhatCannotBeMeasuredIsAnsweredWithASentence) {
  const Mesh mesh = mesh_of(testing::unit_square(), "ruppert", 0.3);
  EXPECT_NE(interpolate(mesh, function("1/x")).error, "");  // at a vertex
  EXPECT_NE(interpolate(mesh, function("log(x - 0.3)")).error, "");
  EXPECT_NE(interpolate(Mesh(), function("x")).error, "");
  Mesh broken = mesh;
  broken.cells[1] = 1000000;
  EXPECT_NE(interpolate(broken, function("x")).error, "");
  broken = mesh;
  broken.vertices[0].x = std::nan("");
  EXPECT_NE(interpolate(broken, function("x")).error, "");
  broken = mesh;
  broken.dimension = 3;
  EXPECT_NE(interpolate(broken, function("x")).error, "");
  broken = mesh;
  broken.cells.pop_back();
  EXPECT_NE(interpolate(broken, function("x")).error, "");
  broken = mesh;
  for (Point3& p : broken.vertices) p.y = p.x;  // flat, all of it
  const ErrorField flat = interpolate(broken, function("x"));
  EXPECT_EQ(flat.size.flat_cells, flat.size.cells);
  EXPECT_NE(flat.warning, "");
}

TEST(Interpolation, WildFunctionsCostNoMoreThanTheBudget) {
  const ErrorField field =
      interpolate(mesh_of(testing::unit_square(), "ruppert", 0.02), function("sin(1e9*x*y)"));
  EXPECT_EQ(field.error, "");
  EXPECT_NE(field.warning, "");
  EXPECT_LT(field.points, 35 * field.size.cells + 3'000'000);
}

}  // namespace
}  // namespace circumball
