#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "circumball/io.h"
#include "circumball/registry.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

const std::string kFolder = std::string(CIRCUMBALL_SOURCE_DIR) + "/examples/";

std::string bytes_of(const std::string& name) {
  std::ifstream file(kFolder + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Example {
  std::string id, file, algorithm;
  nlohmann::json options;
  int dimension;
};

/// Of space those that are meshed and verified in 0.25 s at most.
std::vector<Example> gallery() {
  const std::set<std::string> long_runs = {"wheel",        "plates", "wedge",
                                           "fan-of-faces", "book",   "wheel-intestine"};
  std::vector<Example> list;
  for (const auto& entry : nlohmann::json::parse(bytes_of("index.json"))) {
    const int dimension = entry.value("dimension", 2);
    if (dimension == 3 && long_runs.count(entry["id"])) continue;
    list.push_back({entry["id"], entry["file"], entry["algorithm"],
                    entry.value("options", nlohmann::json::object()), dimension});
  }
  return list;
}

Complex complex_of(const Example& example) {
  const ReadResult result = read(bytes_of(example.file), example.file);
  EXPECT_TRUE(result.ok()) << example.file;
  return result.complex;
}

/// The options of the gallery are those of the page's RunOptions (wasm/circumball.d.mts).
Options options_of(const Example& example) {
  Options o;
  o.algorithm = example.algorithm;
  const auto& given = example.options;
  if (given.contains("tau")) o.tau = given["tau"].get<double>();
  if (given.contains("minAngle")) o.min_angle_degrees = given["minAngle"].get<double>();
  if (given.contains("size")) o.size = given["size"].get<std::string>();
  if (given.contains("maxVertices")) o.limits.max_vertices = given["maxVertices"];
  if (given.contains("minEdge")) o.limits.min_edge = given["minEdge"];
  if (given.contains("parameters")) o.parameters = given["parameters"];
  if (given.contains("domain")) {
    const std::string domain = given["domain"];
    o.domain = domain == "hull" ? Domain::kHull : domain == "box" ? Domain::kBox : Domain::kClosed;
  }
  return o;
}

TEST(Examples, AreValidAndHaveASentence) {
  const auto index = nlohmann::json::parse(bytes_of("index.json"));
  EXPECT_GE(index.size(), 8u);
  EXPECT_EQ(index.front()["id"], "first-light");
  for (const auto& entry : index) {
    EXPECT_FALSE(entry["title"].get<std::string>().empty());
    EXPECT_FALSE(entry["sentence"].get<std::string>().empty());
    const ReadResult result = read(bytes_of(entry["file"]), entry["file"].get<std::string>());
    EXPECT_TRUE(result.ok()) << entry["file"];
    for (const Defect& d : check(result.complex)) EXPECT_TRUE(d.warning) << d.message;
  }
}

TEST(Examples, KeepThePromisesOfTheirAlgorithms) {
  for (const Example& example : gallery()) {
    const Complex complex = complex_of(example);
    const auto run = testing::finish(complex, options_of(example));
    ASSERT_TRUE(run) << example.id;
    for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      const bool promised = run->status() == Status::kComplete || c.name == "topology" ||
                            c.name == "delaunay" || c.name == "input-vertices";
      EXPECT_TRUE(c.ok || !promised) << example.id << ", " << c.name << ": " << c.detail;
    }
    if (run->status() != Status::kComplete) {
      EXPECT_FALSE(run->unresolved().empty()) << example.id;
    }
  }
}

std::vector<std::vector<std::uint32_t>> sorted(const std::uint32_t* data, std::size_t size,
                                               int dimension, bool replayed) {
  const auto corners = static_cast<std::size_t>(dimension) + 1;
  std::vector<std::vector<std::uint32_t>> cells;
  for (std::size_t i = 0; i < size; i += corners + (replayed ? 1 : 0)) {
    if (replayed && data[i + corners] == 2) continue;  // outside
    cells.emplace_back(data + i, data + i + corners);
    std::sort(cells.back().begin(), cells.back().end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

TEST(Examples, ReplayEqualsTheMeshForEveryAlgorithmInBothDirections) {
  for (const Example& example : gallery()) {
    const Complex complex = complex_of(example);
    for (const AlgorithmInfo& info : registry()) {
      if (info.dimension != complex.dimension) continue;
      // In space there is no time for more than its own.
      if (complex.dimension == 3 && info.id != example.algorithm) continue;
      Options options = complex.dimension == 3 ? options_of(example) : testing::options_of(info.id);
      options.limits.max_vertices = 1500;
      Trace trace;
      trace.dimension = complex.dimension;
      const auto run = testing::finish(complex, options, &trace);
      ASSERT_TRUE(run) << example.id << " " << info.id;
      const Mesh mesh = run->mesh();
      Replay replay(trace);
      replay.seek(trace.events.size());
      const auto cells = replay.cells();
      EXPECT_EQ(sorted(cells.data(), cells.size(), complex.dimension, true),
                sorted(mesh.cells.data(), mesh.cells.size(), complex.dimension, false))
          << example.id << " " << info.id;
      replay.seek(trace.events.size() / 3);
      const auto third = replay.cells();
      replay.seek(0);
      EXPECT_TRUE(replay.cells().empty());
      replay.seek(trace.events.size() / 3);
      EXPECT_EQ(replay.cells(), third) << example.id << " " << info.id;
    }
  }
}

}  // namespace
}  // namespace circumball
