#include <algorithm>
#include <map>

#include "circumball/verify.h"
#include "fem_test_util.h"

namespace circumball {
namespace {

using testing::family;
using testing::function;
using testing::named;

TEST(Figure7_1, TheFamiliesAreTriangulationsOfTheSquare) {
  for (const FamilyInfo& f : mesh_families()) {
    for (std::uint32_t n : {1u, 2u, 5u}) {
      for (std::uint32_t k : {1u, 2u, 3u, 10u}) {
        const Mesh mesh = family(f.family, n, k);
        const MeshSize size = mesh_size(mesh);
        EXPECT_NEAR(size.area, 1, 1e-12) << f.id;
        EXPECT_EQ(size.flat_cells, 0u);
        EXPECT_EQ(size.vertices, mesh.vertices.size());
        // Each edge has one cell on each side, or is listed as the border's, once.
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
          for (int j = 0; j < 3; ++j) ++sides[{mesh.cell(i)[j], mesh.cell(i)[(j + 1) % 3]}];
        }
        std::size_t border = 0;
        for (const auto& [edge, count] : sides) {
          EXPECT_EQ(count, 1);
          if (!sides.count({edge.second, edge.first})) ++border;
        }
        EXPECT_EQ(border, mesh.edges.size()) << f.id;
        for (const MeshEdge& e : mesh.edges) EXPECT_EQ((sides.count({e.a, e.b})), 1u) << f.id;
        // Euler: V - E + F = 1.
        const std::size_t edges = (sides.size() + border) / 2;
        EXPECT_EQ(mesh.vertices.size() + mesh.cell_count(), edges + 1);
      }
    }
  }
}

TEST(Figure7_1, AnglesAndDegreesAreWhatTheCaptionsSay) {
  const MeshSize narrow = mesh_size(family(MeshFamily::kNarrow, 4, 50));
  EXPECT_LT(narrow.min_angle_degrees, 2);
  EXPECT_NEAR(narrow.max_angle_degrees, 90, 1e-9);
  const MeshSize large = mesh_size(family(MeshFamily::kLargeAngles, 4, 50));
  EXPECT_LT(large.min_angle_degrees, 3);
  EXPECT_GT(large.max_angle_degrees, 175);
  EXPECT_GT(large.max_circumradius, 5 * large.h);
  const Mesh fans = family(MeshFamily::kHighDegree, 4, 50);
  EXPECT_LT(mesh_size(fans).max_angle_degrees, 117);
  EXPECT_LT(mesh_size(fans).h, 1.12 / 4);
  std::map<std::uint32_t, int> degree;
  for (const std::uint32_t v : fans.cells) ++degree[v];
  EXPECT_GE(std::max_element(degree.begin(), degree.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; })
                ->second,
            100);
}

TEST(Figure7_1, WithoutLargeAnglesTheErrorStaysBelowAMultipleOfH) {
  for (const MeshFamily f : {MeshFamily::kNarrow, MeshFamily::kHighDegree}) {
    for (const char* u : {"x^2", "y^2", "x*y", "sin(3*x + y) * exp(-y*x)"}) {
      for (std::uint32_t k : {1u, 8u, 64u}) {
        const ErrorField e = interpolate(family(f, 6, k), function(u));
        EXPECT_LT(e.h1, 0.7 * e.size.h * e.u.h2) << u << ' ' << k;
      }
    }
  }
}

TEST(Figure7_1, WithLargeAnglesTheErrorGrowsLikeTheCircumradius) {
  for (std::uint32_t k : {16u, 128u}) {
    const ErrorField e = interpolate(family(MeshFamily::kLargeAngles, 8, k), function("x^2"));
    EXPECT_GT(e.h1, 0.4 * e.size.max_circumradius * e.u.h2) << k;
    EXPECT_LT(e.h1, e.size.max_circumradius * e.u.h2) << k;
    EXPECT_GT(e.h1, 0.05 * k * e.size.h * e.u.h2);  // and no multiple of h bounds it
  }
}

TEST(Figure7_1, RefinementWithTheDegenerationOfTheSquareDoesNotConverge) {
  // n columns, n rows a column: the circumradius stays at 1/8, and so does the error; (a)
  // converges.
  const auto error = [](MeshFamily f, std::uint32_t n) {
    return interpolate(family(f, n, n), function("x^2")).h1;
  };
  EXPECT_NEAR(error(MeshFamily::kLargeAngles, 16) / error(MeshFamily::kLargeAngles, 8), 1, 0.1);
  const auto solution = [](std::uint32_t n) {
    return solve_poisson(family(MeshFamily::kLargeAngles, n, n), function("x^2")).h1;
  };
  EXPECT_NEAR(solution(16) / solution(8), 1, 0.05);  // nor does the finite element method
  EXPECT_NEAR(error(MeshFamily::kNarrow, 4) / error(MeshFamily::kNarrow, 16), 4, 0.01);
}

TEST(Figure7_1, ImpossibleNumbersAreAnsweredWithASentence) {
  for (const FamilyInfo& f : mesh_families()) {
    for (const auto& [n, k] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {0, 1}, {1, 0}, {0xffffffffu, 0xffffffffu}, {1, 0xffffffffu}, {100000, 1}}) {
      std::string error;
      EXPECT_TRUE(family_mesh(f.family, n, k, &error).cells.empty());
      EXPECT_NE(error, "") << n << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace circumball
