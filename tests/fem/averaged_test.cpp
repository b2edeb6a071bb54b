#include "fem_test_util.h"

namespace circumball {
namespace {

using testing::family;
using testing::function;
using testing::named;
using testing::order;

constexpr MeshFamily kFamilies[] = {MeshFamily::kNarrow, MeshFamily::kLargeAngles,
                                    MeshFamily::kHighDegree};

TEST(AveragedInterpolation, VanishesOnTheBoundary) {
  for (const MeshFamily f : kFamilies) {
    const Mesh mesh = family(f, 8, 5);
    const AveragedField field = interpolate_averaged(mesh, function("1"));
    ASSERT_EQ(field.error, "");
    for (const MeshEdge& e : mesh.edges) {
      EXPECT_EQ(field.nodal[e.a], 0);
      EXPECT_EQ(field.nodal[e.b], 0);
    }
  }
}

TEST(AveragedInterpolation, KeepsLinearFunctionsAwayFromTheBoundary) {
  const Mesh mesh = family(MeshFamily::kNarrow, 16, 3);
  const PlaneFunction u = function("2 + x - 3*y");
  const AveragedField field = interpolate_averaged(mesh, u);
  ASSERT_EQ(field.error, "");
  int inside = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point2 p = xy(mesh.vertices[v]);
    if (std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y)) < 3 * field.averaging_radius) {
      continue;
    }
    ++inside;
    EXPECT_NEAR(field.nodal[v], u.at(p), 1e-14);  // the mollifier is even
  }
  EXPECT_GT(inside, 50);
}

TEST(Theorem7_12, TheErrorInL2IsAMultipleOfHWithoutAnyAngleCondition) {
  // One constant for all: rough functions, families, degrees of degeneration, and sizes.
  double worst = 0;
  for (const char* id : {"roof", "spike", "steep-shore"}) {
    const PlaneFunction u = named(id);
    for (const MeshFamily f : kFamilies) {
      for (const auto& [n, k] :
           std::vector<std::pair<std::uint32_t, std::uint32_t>>{{8, 1}, {8, 8}, {16, 2}}) {
        const AveragedField field = interpolate_averaged(family(f, n, k), u);
        ASSERT_EQ(field.error, "");
        worst = std::max(worst, field.l2 / (field.averaging_radius * field.u.h1));
      }
    }
  }
  EXPECT_LT(worst, 1.5);
  std::printf("greatest ||u - Iu|| / (h |u|_1): %.3f\n", worst);
}

TEST(Theorem7_12, TheObservedOrderIsOneOrAbove) {
  // Near the boundary u is like d^s, and cutting it off costs h^(s + 1/2): 1.1 for steep shores,
  // 3/2 for functions with a bounded gradient.
  struct Case {
    const char* id;
    double order;
  };
  for (const Case& c : {Case{"steep-shore", 1.1}, Case{"roof", 1.5}, Case{"smooth", 1.5}}) {
    const PlaneFunction u = named(c.id);
    for (const MeshFamily f : {MeshFamily::kLargeAngles, MeshFamily::kHighDegree}) {
      const AveragedField a = interpolate_averaged(family(f, 12, 2), u);
      const AveragedField b = interpolate_averaged(family(f, 48, 2), u);
      const double p = order(a.l2, b.l2, a.averaging_radius, b.averaging_radius);
      EXPECT_NEAR(p, c.order, 0.15) << c.id;
    }
  }
}

TEST(AveragedInterpolation, NeedsNoValuesAtTheVertices) {
  const Mesh mesh = family(MeshFamily::kLargeAngles, 8, 3);
  // Infinite at (1/2, 1/2), a vertex; in H^1.
  const PlaneFunction u =
      function("log(1 - log(sqrt((x - 0.5)^2 + (y - 0.5)^2))) * x*(1-x)*y*(1-y)");
  EXPECT_NE(interpolate(mesh, u).error, "");
  const AveragedField field = interpolate_averaged(mesh, u);
  EXPECT_EQ(field.error, "");
  EXPECT_LT(field.l2, field.averaging_radius * field.u.h1);
}

TEST(AveragedInterpolation, WhatCannotBeDoneIsAnsweredWithASentence) {
  const Mesh mesh = family(MeshFamily::kNarrow, 8, 1);
  EXPECT_NE(interpolate_averaged(mesh, function("x"), 0.01).error, "");  // below the longest edge
  EXPECT_NE(interpolate_averaged(mesh, function("x"), std::nan("")).error, "");
  EXPECT_NE(interpolate_averaged(mesh, function("log(x - 0.5)")).error, "");
  EXPECT_NE(interpolate_averaged(Mesh(), function("x")).error, "");
  EXPECT_EQ(interpolate_averaged(mesh, function("x"), 10).l2,
            interpolate_averaged(mesh, function("x"), 20).l2);  // everything is cut off
}

}  // namespace
}  // namespace circumball
