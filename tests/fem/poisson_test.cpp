#include "fem_test_util.h"

namespace circumball {
namespace {

using testing::family;
using testing::function;
using testing::mesh_of;
using testing::named;
using testing::order;

TEST(Poisson, LinearSolutionsAreExactOnEveryMesh) {  // the patch test
  std::vector<Mesh> meshes{mesh_of(testing::random_grid(5, 0.3), "ruppert", 0.5)};
  for (const FamilyInfo& f : mesh_families()) meshes.push_back(family(f.family, 5, 20));
  for (const Mesh& mesh : meshes) {
    const PoissonSolution s = solve_poisson(mesh, function("2*x - y + 3"));
    EXPECT_EQ(s.error, "");
    EXPECT_LT(s.l2, 1e-11 * s.u.l2);
  }
}

TEST(Poisson, TheSolutionIsTheBestApproximationOfItsGradient) {
  // Cea's lemma with constant 1: no other function with these boundary values is nearer in |.|_1.
  for (const char* id : {"smooth", "layer", "front"}) {
    const Mesh mesh = mesh_of(testing::unit_square(), "ruppert", 0.04);
    const ErrorField interpolant = interpolate(mesh, named(id));
    const PoissonSolution solution = solve_poisson(mesh, named(id));
    EXPECT_EQ(solution.error, "");
    // The layer is not resolved: there the load's quadrature costs a little.
    EXPECT_LE(solution.h1, interpolant.h1 * (std::string(id) == "layer" ? 1.1 : 1.001)) << id;
  }
}

/// An acute, non-convex domain: a tip of 29 degrees, and a notch.
Complex acute_domain() { return testing::polygon({{0, 0}, {1, -0.17}, {0.8, 0.05}, {1, 0.35}}); }

TEST(Poisson, ConvergesWithOrderOneInH1AndTwoInL2) {
  struct Case {
    const char* algorithm;
    Complex complex;
  };
  const std::vector<Case> cases{{"ruppert", testing::unit_square()},
                                {"chew", testing::unit_square()},
                                {"collar", testing::unit_square()},
                                {"ruppert", testing::polygon({{0, 0}, {2, 0}, {1, 1.5}})},
                                {"collar", acute_domain()},
                                {"intestine", acute_domain()}};
  for (const Case& c : cases) {
    double h1[4], l2[4], h[4];
    const double first = c.complex.vertices[2].x == 0.8 ? 0.03 : 0.08;
    for (int level = 0; level < 3; ++level) {
      const Mesh mesh = mesh_of(c.complex, c.algorithm, first / (1 << level));
      const PoissonSolution s = solve_poisson(mesh, function("sin(3*x + y) * exp(-y*x)"));
      ASSERT_EQ(s.error, "");
      EXPECT_FALSE(s.weak_load);
      h1[level] = s.h1;
      l2[level] = s.l2;
      h[level] = 1 / std::sqrt(double(s.size.cells));
    }
    EXPECT_NEAR(order(h1[0], h1[2], h[0], h[2]), 1, 0.06) << c.algorithm;
    EXPECT_NEAR(order(l2[0], l2[2], h[0], h[2]), 2, 0.15) << c.algorithm;
  }
}

TEST(Poisson, ACornerOf270DegreesCostsAThirdOfTheOrder) {
  Complex corner;
  for (const NamedFunction& f : fem_functions()) {
    if (f.id == "corner") corner = testing::polygon(f.outline);
  }
  const PoissonSolution a = solve_poisson(mesh_of(corner, "chew", 0.1), named("corner"));
  const PoissonSolution b = solve_poisson(mesh_of(corner, "chew", 0.025), named("corner"));
  EXPECT_NEAR(order(a.h1, b.h1, 4, 1), 2.0 / 3, 0.07);
  EXPECT_NEAR(order(a.l2, b.l2, 4, 1), 4.0 / 3, 0.15);
}

TEST(Poisson, PiecesAreLoadedWeakly) {
  const PlaneFunction u = named("roof");
  const PoissonSolution a = solve_poisson(mesh_of(testing::unit_square(), "chew", 0.1), u);
  const PoissonSolution b = solve_poisson(mesh_of(testing::unit_square(), "chew", 0.0125), u);
  EXPECT_TRUE(b.weak_load);
  EXPECT_NE(b.warning, "");
  EXPECT_NEAR(order(a.h1, b.h1, 8, 1), 0.5, 0.12);
}

TEST(Poisson, ALaplacianThatIsNotIntegrableIsLoadedWeakly) {
  for (const char* id : {"spike", "steep-shore"}) {
    const PoissonSolution s =
        solve_poisson(mesh_of(testing::unit_square(), "chew", 0.05), named(id));
    EXPECT_EQ(s.error, "") << id;
    EXPECT_TRUE(s.weak_load) << id;
  }
  // That of the cone, 1/r, is.
  const PoissonSolution a =
      solve_poisson(mesh_of(testing::unit_square(), "chew", 0.1), named("cone"));
  const PoissonSolution b =
      solve_poisson(mesh_of(testing::unit_square(), "chew", 0.02), named("cone"));
  EXPECT_FALSE(b.weak_load);
  EXPECT_GT(order(a.h1, b.h1, 5, 1), 0.7);
  EXPECT_GT(order(a.l2, b.l2, 5, 1), 1.5);
}

TEST(Poisson, WhatCannotBeSolvedIsAnsweredWithASentence) {
  const Mesh mesh = mesh_of(testing::unit_square(), "ruppert", 0.1);
  PoissonLimits limits;
  limits.max_unknowns = 10;
  EXPECT_NE(solve_poisson(mesh, function("x"), limits).error, "");
  limits = {};
  limits.max_bytes = 100;
  const PoissonSolution small = solve_poisson(mesh, function("x"), limits);
  EXPECT_NE(small.error, "");
  EXPECT_GT(small.factor_entries, 100u / 12);
  EXPECT_NE(solve_poisson(mesh, function("1/x")).error, "");
  EXPECT_NE(solve_poisson(mesh, function("log(x - 0.5)")).error, "");
  EXPECT_NE(solve_poisson(mesh, function("exp(1000*x)")).error, "");
  EXPECT_NE(solve_poisson(Mesh(), function("x")).error, "");
  Mesh flat = mesh;
  for (Point3& p : flat.vertices) p.y = p.x;
  EXPECT_NE(solve_poisson(flat, function("x*y")).error, "");  // no matrix at all
}

TEST(Poisson, AMeshWithoutVerticesInsideIsItsBoundaryValues) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}};
  mesh.cells = {0, 1, 2};
  const PoissonSolution s = solve_poisson(mesh, function("x^2"));
  EXPECT_EQ(s.error, "");
  EXPECT_EQ(s.unknowns, 0u);
  EXPECT_EQ(s.nodal, (std::vector<double>{0, 1, 0, 0}));
}

}  // namespace
}  // namespace circumball
