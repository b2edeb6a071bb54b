#ifndef CIRCUMBALL_TESTS_QUALITY_VERIFY_TEST_UTIL_H_
#define CIRCUMBALL_TESTS_QUALITY_VERIFY_TEST_UTIL_H_

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball::testing {

/// A complex and a mesh of it, to be verified.
struct Subject {
  Complex complex;
  Mesh mesh;
  VerifyOptions options;

  std::vector<Check> verified() const { return verify(mesh, complex, options); }
  Check check(const std::string& name) const {
    VerifyOptions only = options;
    only.checks = {name};
    const std::vector<Check> all = verify(mesh, complex, only);
    return all.empty() ? Check{} : all[0];
  }
  /// Names of the checks that fail.
  std::set<std::string> failing() const {
    std::set<std::string> names;
    for (const Check& c : verified()) {
      if (!c.ok) names.insert(c.name);
    }
    return names;
  }
  /// The same mesh as somebody else would hand it in: without labels, and not knowing its input.
  Subject foreign() const {
    Subject s = *this;
    s.mesh.input_vertices = s.mesh.box_vertices = 0;
    s.mesh.vertex_features.clear();
    s.mesh.edges.clear();
    s.mesh.edge_markers.clear();
    return s;
  }
};

inline std::string failures(const std::vector<Check>& checks) {
  std::string text;
  for (const Check& c : checks) {
    if (!c.ok) text += c.name + ": " + c.detail + "\n";
  }
  return text;
}

inline Subject refined(const Complex& complex, Domain domain = Domain::kClosed, double size = 0) {
  Options options = options_of("ruppert");
  options.domain = domain;
  if (size > 0) options.size = std::to_string(size);
  const auto run = finish(complex, options);
  Subject s;
  if (!run) return s;
  s.complex = run->complex();
  s.mesh = run->mesh();
  s.options.tau = run->tau();
  s.options.domain = run->domain() == Domain::kBox    ? "box"
                     : run->domain() == Domain::kHull ? "hull"
                                                      : "closed";
  return s;
}

/// A square with a square hole, refined; about 300 cells.
inline Subject square_with_hole(Domain domain = Domain::kClosed) {
  Complex c = unit_square();
  add_square(&c, 0.3, 0.25, 0.3);
  return refined(c, domain, 0.07);
}

inline std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> v) {
  std::sort(v.begin(), v.end());
  return v;
}
inline std::vector<std::uint32_t> cell_vertices(const Mesh& mesh, std::size_t cell) {
  const std::uint32_t* c = mesh.cell(cell);
  return {c[0], c[1], c[2]};
}
inline void remove_cell(Mesh* mesh, std::size_t cell) {
  mesh->cells.erase(mesh->cells.begin() + static_cast<std::ptrdiff_t>(3 * cell),
                    mesh->cells.begin() + static_cast<std::ptrdiff_t>(3 * cell + 3));
}
/// The cell, and the place in it, that has the directed edge; cell count if none.
inline std::size_t find_cell(const Mesh& mesh, std::uint32_t a, std::uint32_t b, int* apex) {
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.cell(i)[(k + 1) % 3] != a || mesh.cell(i)[(k + 2) % 3] != b) continue;
      *apex = k;
      return i;
    }
  }
  return mesh.cell_count();
}
/// Replaces edge ab between cells abc and bad by cd. False if ab is on the boundary.
inline bool flip(Mesh* mesh, std::uint32_t a, std::uint32_t b) {
  int i = 0, j = 0;
  const std::size_t left = find_cell(*mesh, a, b, &i), right = find_cell(*mesh, b, a, &j);
  if (left == mesh->cell_count() || right == mesh->cell_count()) return false;
  const std::uint32_t c = mesh->cell(left)[i], d = mesh->cell(right)[j];
  const std::uint32_t cells[2][3] = {{a, d, c}, {d, b, c}};
  std::copy(cells[0], cells[0] + 3, mesh->cells.begin() + static_cast<std::ptrdiff_t>(3 * left));
  std::copy(cells[1], cells[1] + 3, mesh->cells.begin() + static_cast<std::ptrdiff_t>(3 * right));
  return true;
}
inline bool is_subsegment(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const MeshEdge& e) {
    return (e.a == a && e.b == b) || (e.a == b && e.b == a);
  });
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_QUALITY_VERIFY_TEST_UTIL_H_
