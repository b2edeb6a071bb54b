#ifndef CIRCUMBALL_TESTS_FEM_FEM_TEST_UTIL_H_
#define CIRCUMBALL_TESTS_FEM_FEM_TEST_UTIL_H_

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "circumball/fem_laboratory.h"
#include "support/complexes.h"

namespace circumball::testing {

inline PlaneFunction function(const std::string& text) {
  PlaneFunction u;
  std::string error;
  EXPECT_TRUE(PlaneFunction::parse(text, &u, &error)) << error;
  return u;
}
inline PlaneFunction named(const std::string& id) {
  for (const NamedFunction& f : fem_functions()) {
    if (f.id == id) return function(f.expression);
  }
  ADD_FAILURE() << id;
  return {};
}

/// The mesh of a complex by an algorithm, with circumradii of at most `size`.
inline Mesh mesh_of(const Complex& complex, const std::string& algorithm, double size) {
  Options options = options_of(algorithm);
  options.size = std::to_string(size);
  const auto run = finish(complex, options);
  EXPECT_TRUE(run);
  if (!run) return {};
  EXPECT_EQ(run->status(), Status::kComplete);
  return run->mesh();
}

inline Mesh family(MeshFamily f, std::uint32_t n, std::uint32_t degeneration) {
  std::string error;
  Mesh mesh = family_mesh(f, n, degeneration, &error);
  EXPECT_EQ(error, "");
  return mesh;
}

/// The order p of an error like h^p between two meshes.
inline double order(double coarse, double fine, double coarse_h, double fine_h) {
  return std::log(coarse / fine) / std::log(coarse_h / fine_h);
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_FEM_FEM_TEST_UTIL_H_
