#ifndef CIRCUMBALL_TESTS_SUPPORT_EXAMPLES_H_
#define CIRCUMBALL_TESTS_SUPPORT_EXAMPLES_H_

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "circumball/io.h"

namespace circumball::testing {

/// The bytes of a file in `examples/`.
inline std::string bytes_of_example(const std::string& name) {
  std::ifstream file(std::string(CIRCUMBALL_SOURCE_DIR) + "/examples/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The complex of a file in `examples/`.
inline Complex example(const std::string& name) {
  const ReadResult result = read(bytes_of_example(name), name);
  EXPECT_TRUE(result.ok()) << name;
  return result.complex;
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_EXAMPLES_H_
