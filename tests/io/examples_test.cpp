#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

std::string path(const std::string& file) { return CIRCUMBALL_SOURCE_DIR "/examples/" + file; }

std::optional<std::string> slurp(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

nlohmann::json gallery() {
  return nlohmann::json::parse(slurp(path("index.json")).value_or(""), nullptr, false);
}

TEST(Examples, GalleryIsAListThatBeginsWithFirstLight) {
  const nlohmann::json list = gallery();
  ASSERT_TRUE(list.is_array());
  ASSERT_GE(list.size(), 10u);
  EXPECT_EQ(list[0]["id"], "first-light");
  std::set<std::string> ids;
  for (const auto& example : list) {
    for (const char* key : {"id", "title", "file", "sentence", "algorithm"})
      EXPECT_TRUE(example[key].is_string()) << example;
    EXPECT_TRUE(example["options"].is_object()) << example;
    EXPECT_TRUE(ids.insert(example["id"]).second) << example;
  }
}

TEST(Examples, EachIsAValidComplexAndRuppertsAlgorithmHasALimitWhereAnglesAreSmall) {
  for (const auto& example : gallery()) {
    const std::string file = path(example["file"]);
    const auto bytes = slurp(file);
    ASSERT_TRUE(bytes.has_value()) << file;
    const ReadResult r = read(*bytes, file, slurp);
    ASSERT_TRUE(r.ok()) << file << ": " << io_test::names(r);
    for (const Defect& d : check(r.complex)) EXPECT_TRUE(d.warning) << file << ": " << d.message;
    const bool limited = example["options"].contains("minEdge");
    const bool proved = smallest_angle_degrees(r.complex) >= 60;
    EXPECT_TRUE(example["algorithm"] != "ruppert" || proved || limited) << example;
  }
}

TEST(Examples, EachSurvivesJsonAndPolyBitForBit) {
  for (const auto& example : gallery()) {
    const std::string file = path(example["file"]);
    const Complex complex = read(slurp(file).value_or(""), file, slurp).complex;
    std::string error;
    for (const char* extension : {".json", ".poly"}) {
      const auto output = write_complex(complex, extension, &error);
      ASSERT_EQ(output.size(), 1u) << error;
      const ReadResult back = read(output[0].bytes, std::string("a") + extension);
      EXPECT_EQ(back.complex.vertices, complex.vertices) << file;
      EXPECT_EQ(back.complex.segments, complex.segments) << file;
    }
  }
}

}  // namespace
}  // namespace circumball
