#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

Complex boxes() {
  std::ifstream file(std::string(CIRCUMBALL_SOURCE_DIR) + "/examples/boxes.json", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return read(bytes, "boxes.json").complex;
}

double volume_of(const Mesh& mesh, std::size_t cell) {
  const std::uint32_t* v = mesh.cell(cell);
  const Point3 &o = mesh.vertices[v[0]], &a = mesh.vertices[v[1]], &b = mesh.vertices[v[2]],
               &c = mesh.vertices[v[3]];
  const double ax = a.x - o.x, ay = a.y - o.y, az = a.z - o.z;
  const double bx = b.x - o.x, by = b.y - o.y, bz = b.z - o.z;
  const double cx = c.x - o.x, cy = c.y - o.y, cz = c.z - o.z;
  return std::fabs(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) /
         6;
}

/// Twelve boxes that share faces, in three materials, by JSON and by TetGen's format: each has its
/// volume, obeys its bound, and its label is written.
TEST(RegionsInSpace, HaveTheirCellsBoundsAndLabelsInEveryFormat) {
  const Complex original = boxes();
  std::string error;
  const auto poly = write_complex(original, ".poly", &error);
  ASSERT_EQ(poly.size(), 1u) << error;
  const Complex again = read(poly[0].bytes, "boxes.poly").complex;
  ASSERT_EQ(again.regions.size(), original.regions.size());
  const std::map<double, double> bounds = {{1, 0.02}, {2, 0.005}, {3, 0.05}};
  for (const Complex* complex : {&original, &again}) {
    for (const char* algorithm : {"ruppert", "collar"}) {
      const auto run = testing::finish(*complex, testing::options_of(algorithm));
      ASSERT_TRUE(run);
      for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
        EXPECT_TRUE(c.ok) << algorithm << ", " << c.name << ": " << c.detail;
      }
      const Mesh mesh = run->mesh();
      ASSERT_EQ(mesh.cell_regions.size(), mesh.cell_count());
      std::map<double, double> volume, largest;
      std::map<double, std::size_t> count;
      for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        const double label = mesh.cell_regions[i], v = volume_of(mesh, i);
        ++count[label];
        volume[label] += v;
        largest[label] = std::max(largest[label], v);
      }
      ASSERT_EQ(count.size(), 3u);
      for (const auto& [label, bound] : bounds) {
        EXPECT_NEAR(volume[label], 4, 1e-9) << label;
        EXPECT_LE(largest[label], bound) << label;
        EXPECT_GE(static_cast<double>(count[label]), 4 / bound) << label;
      }
      // Each cell's label is the last number of its line in .ele; the others are told by name.
      const auto written = [&](const char* extension) {
        for (const OutputFile& f : write_mesh(mesh, run->complex(), extension, {}, &error)) {
          if (f.extension == extension) return f.bytes;
        }
        return std::string();
      };
      std::istringstream lines(written(".ele"));
      std::map<double, std::size_t> labels;
      std::size_t cells = 0, corners = 0, attributes = 0;
      lines >> cells >> corners >> attributes;
      ASSERT_EQ(cells, mesh.cell_count());
      ASSERT_EQ(attributes, 1u);
      double number = 0;
      for (std::size_t k = 1; lines >> number; ++k) {
        if (k % 6 == 0) ++labels[number];
      }
      EXPECT_EQ(labels, count);
      EXPECT_NE(written(".vtu").find("Name=\"region\""), std::string::npos);
      EXPECT_NE(written(".msh").find("\"region 3\""), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace circumball
