// The tables of docs/fem.md: errors of interpolation and of Poisson's equation, and their orders.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "circumball/fem_laboratory.h"
#include "support/complexes.h"

namespace circumball {
namespace {

PlaneFunction parsed(const std::string& text) {
  PlaneFunction u;
  std::string error;
  if (!PlaneFunction::parse(text, &u, &error)) std::printf("%s\n", error.c_str());
  return u;
}

Mesh mesh_of(const Complex& complex, const char* algorithm, double size) {
  Options options = testing::options_of(algorithm);
  options.size = std::to_string(size);
  const auto run = testing::finish(complex, options);
  return run ? run->mesh() : Mesh();
}

void convergence(const char* title, const Complex& complex, const char* algorithm, double first,
                 const std::string& text) {
  std::printf("\n%s, `%s`, u = `%s`\n\n", title, algorithm, text.c_str());
  std::printf(
      "| cells | h | R | largest angle | interpolation H1 | order | L2 | order | Poisson H1 | "
      "order "
      "| L2 | order |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  ErrorField last;
  PoissonSolution last_solution;
  for (int level = 0; level < 4; ++level) {
    const Mesh mesh = mesh_of(complex, algorithm, first / (1 << level));
    const PlaneFunction u = parsed(text);
    const ErrorField i = interpolate(mesh, u);
    const PoissonSolution s = solve_poisson(mesh, u);
    if (!s.error.empty()) std::printf("%s\n", s.error.c_str());
    const auto p = [&](double before, double now) {
      char cell[20] = "";
      if (level > 0) std::snprintf(cell, sizeof cell, "%.2f", std::log2(before / now));
      return std::string(cell);
    };
    std::printf("| %d | %.4f | %.4f | %.1f | %.3e | %s | %.3e | %s | %.3e | %s | %.3e | %s |\n",
                int(i.size.cells), i.size.h, i.size.max_circumradius, i.size.max_angle_degrees,
                i.h1, p(last.h1, i.h1).c_str(), i.l2, p(last.l2, i.l2).c_str(), s.h1,
                p(last_solution.h1, s.h1).c_str(), s.l2, p(last_solution.l2, s.l2).c_str());
    last = i;
    last_solution = s;
  }
}

void functions() {
  std::printf("\nOrders between sizes 0.04 and 0.01, `chew` (the corner: `ruppert`)\n\n");
  std::printf(
      "| function | interpolation H1 | L2 | Poisson H1 | L2 | averaged L2 |\n| --- | --- | --- | "
      "--- "
      "| --- | --- |\n");
  for (const NamedFunction& f : fem_functions()) {
    const char* algorithm = f.id == "corner" ? "ruppert" : "chew";
    const Complex complex = testing::polygon(f.outline);
    const Mesh a = mesh_of(complex, algorithm, 0.04), b = mesh_of(complex, algorithm, 0.01);
    const PlaneFunction u = parsed(f.expression);
    const ErrorField i = interpolate(a, u), j = interpolate(b, u);
    const PoissonSolution s = solve_poisson(a, u), t = solve_poisson(b, u);
    std::printf("| %s | %.2f | %.2f | %.2f | %.2f |", f.id.c_str(), std::log2(i.h1 / j.h1) / 2,
                std::log2(i.l2 / j.l2) / 2, std::log2(s.h1 / t.h1) / 2, std::log2(s.l2 / t.l2) / 2);
    if (f.zero_on_boundary) {
      const AveragedField v = interpolate_averaged(a, u), w = interpolate_averaged(b, u);
      std::printf(" %.2f |\n",
                  std::log(v.l2 / w.l2) / std::log(v.averaging_radius / w.averaging_radius));
    } else {
      std::printf(" |\n");
    }
  }
}

void families() {
  const PlaneFunction u = parsed("sin(3*x + y) * exp(-x*y)");
  std::printf(
      "\nFigure 7.1 with 8 columns, u = `sin(3*x + y) * exp(-x*y)`; errors in H1 by |u|_2\n\n");
  std::printf(
      "| family | degeneration | h | R | largest angle | interpolation / h | / R | Poisson / h "
      "|\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const FamilyInfo& f : mesh_families()) {
    for (const std::uint32_t k : {1u, 4u, 16u, 64u, 256u}) {
      std::string error;
      const Mesh mesh = family_mesh(f.family, 8, k, &error);
      const ErrorField i = interpolate(mesh, u);
      const PoissonSolution s = solve_poisson(mesh, u);
      if (!s.error.empty()) std::printf("%s\n", s.error.c_str());
      std::printf("| %s | %u | %.4f | %.4f | %.2f | %.3f | %.3f | %.3f |\n", f.id.c_str(), k,
                  i.size.h, i.size.max_circumradius, i.size.max_angle_degrees,
                  i.h1 / i.size.h / i.u.h2, i.h1 / i.size.max_circumradius / i.u.h2,
                  s.h1 / i.size.h / i.u.h2);
    }
  }
}

void averaged() {
  std::printf("\nTheorem 7.12: ||u - Iu|| / (h |u|_1), and the order from the row above\n\n");
  std::printf("| family | degeneration | columns |");
  const std::vector<std::string> ids{"smooth", "roof", "spike", "steep-shore"};
  for (const std::string& id : ids) std::printf(" %s | |", id.c_str());
  std::printf("\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const FamilyInfo& f : mesh_families()) {
    if (f.family == MeshFamily::kNarrow) continue;
    for (const std::uint32_t k : {2u, 16u}) {
      std::vector<AveragedField> last(ids.size());
      for (const std::uint32_t n : {8u, 16u, 32u, 64u}) {
        std::string error;
        const Mesh mesh = family_mesh(f.family, n, k, &error);
        std::printf("| %s | %u | %u |", f.id.c_str(), k, n);
        for (std::size_t j = 0; j < ids.size(); ++j) {
          std::string text;
          for (const NamedFunction& g : fem_functions()) {
            if (g.id == ids[j]) text = g.expression;
          }
          const AveragedField v = interpolate_averaged(mesh, parsed(text));
          std::printf(" %.3f |", v.l2 / v.averaging_radius / v.u.h1);
          if (n > 8) {
            std::printf(" %.2f |", std::log(last[j].l2 / v.l2) /
                                       std::log(last[j].averaging_radius / v.averaging_radius));
          } else {
            std::printf(" |");
          }
          last[j] = v;
        }
        std::printf("\n");
      }
    }
  }
}

void triangles() {
  std::printf("\nT_1(alpha, beta): the constant of quadratics, against R and h\n\n");
  std::printf(
      "| beta | alpha | largest angle | R | bound of 7.5 | constant | / R | Kobayashi / R | L2 / "
      "h^2 |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double beta : {0.0, 0.1, 0.5}) {
    for (const double alpha : {0.8, 0.3, 0.1, 0.01, 1e-4}) {
      if (beta < 0.5 && alpha > 0.4) continue;  // the base would not be the longest edge
      const TriangleStudy t = study_triangle({0, 0}, {1, 0}, {beta, alpha}, nullptr);
      double largest = 0;
      for (const double a : t.angles_degrees) largest = std::fmax(largest, a);
      std::printf("| %g | %g | %.3f | %.4g | %.4g | %.4g | %.4f | %.4f | %.4f |\n", beta, alpha,
                  largest, t.circumradius, t.circumradius_bound, t.h1_constant,
                  t.h1_constant / t.circumradius, t.kobayashi_bound / t.circumradius,
                  t.l2_constant / (t.h * t.h));
    }
  }
}

}  // namespace
}  // namespace circumball

int main() {
  using circumball::testing::polygon;
  const std::string smooth = "sin(3*x + y) * exp(-x*y)";
  circumball::convergence("Unit square", circumball::testing::unit_square(), "ruppert", 0.08,
                          "sin(pi*x) * sin(pi*y)");
  const circumball::Complex tip = polygon({{0, 0}, {1, -0.17}, {0.8, 0.05}, {1, 0.35}});
  circumball::convergence("A notched tip of 29 degrees", tip, "collar", 0.03, smooth);
  circumball::convergence("A notched tip of 29 degrees", tip, "intestine", 0.03, smooth);
  const circumball::Complex needle = polygon({{0, 0}, {2, 0}, {2, 1}, {1.2, 0.021}});
  circumball::convergence("A needle of 1 degree", needle, "collar", 0.08, smooth);
  circumball::convergence("A needle of 1 degree", needle, "intestine", 0.08, smooth);
  circumball::functions();
  circumball::families();
  circumball::averaged();
  circumball::triangles();
  return 0;
}
