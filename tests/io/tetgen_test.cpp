#include <gtest/gtest.h>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::folder;
using io_test::names;

const std::string kCube =
    "# a cube\n8 3 1 1\n1 0 0 0 .5 7\n2 1 0 0 .5 0\n3 1 1 0 .5 0\n4 0 1 0 .5 0\n"
    "5 0 0 1 .5 0\n6 1 0 1 .5 0\n7 1 1 1 .5 0\n8 0 1 1 .5 -3\n";

TEST(TetgenPoly, HasFacetsOfSeveralPolygonsHolesWrappedLinesAndSeeds) {
  const std::string text = kCube +
                           "\n4 1  # facets\n"
                           "1 0 5\n4 1 2 # wrapped\n\n  3\n4\n"
                           "4 1 6  # a square with a square hole, a segment and a vertex in it\n"
                           "4 5 6 7 8\n4 1 2 3 4\n2 5 7\n1 8\n1 .5 .5 1\n"
                           "1 0 9\n2 1 7\n"  // a segment that stands alone
                           "1\n1 3\n"        // a vertex that stands alone
                           "1\n1 .5 .5 .25\n"
                           "2\n1 .1 .1 .1 -3 .5\n2 .2 .2 .2 4\n";
  const ReadResult r = read(text, "a.poly");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.format, "tetgen-poly");
  const Complex& c = r.complex;
  EXPECT_EQ(c.dimension, 3);
  EXPECT_EQ(c.vertices[6], (Point3{1, 1, 1}));
  EXPECT_EQ(c.vertex_markers[7], -3);
  EXPECT_EQ(c.vertex_attributes.size(), 8u);
  ASSERT_EQ(c.faces.size(), 2u);
  EXPECT_EQ(c.face_markers, (std::vector<std::int32_t>{5, 6}));
  EXPECT_EQ(c.faces[0].loops[0], (std::vector<std::uint32_t>{0, 1, 2, 3}));
  ASSERT_EQ(c.faces[1].loops.size(), 2u);
  EXPECT_EQ(c.faces[1].holes, (std::vector<Point3>{{.5, .5, 1}}));
  EXPECT_EQ(c.faces[1].vertices, (std::vector<std::uint32_t>{7}));
  ASSERT_EQ(c.faces[1].segments.size(), 1u);
  EXPECT_EQ(c.segments[c.faces[1].segments[0]], (std::array<std::uint32_t, 2>{4, 6}));
  // Sides are segments once, whatever faces share them; the lone segment has its facet's marker.
  EXPECT_EQ(c.segments.size(), 4u + 4 + 1 + 1);
  EXPECT_EQ(c.segments.back(), (std::array<std::uint32_t, 2>{0, 6}));
  EXPECT_EQ(c.segment_markers.back(), 9);
  EXPECT_EQ(c.holes, (std::vector<Point3>{{.5, .5, .25}}));
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_EQ(c.regions[0].label, -3);
  EXPECT_EQ(c.regions[0].max, .5);
  EXPECT_EQ(c.regions[1].label, 4);
  EXPECT_EQ(c.regions[1].max, 0);
}

TEST(TetgenSmesh, HasOnePolygonAFacetAndTakesVerticesFromItsNodeFile) {
  const auto files = folder({{"a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n"}});
  for (const char* header : {"0 3 0 0\n", "0\n"}) {
    const std::string text = std::string(header) + "4 1\n3 0 1 2 4\n3 0 1 3 5\n2 2 3 6\n1 3 0\n0\n";
    const ReadResult r = read(text, "a.smesh", files);
    ASSERT_TRUE(r.ok()) << names(r);
    EXPECT_EQ(r.format, "tetgen-smesh");
    EXPECT_EQ(r.complex.faces.size(), 2u);
    EXPECT_EQ(r.complex.face_markers, (std::vector<std::int32_t>{4, 5}));
    ASSERT_EQ(r.complex.segments.size(), 6u);
    EXPECT_EQ(r.complex.segment_markers, (std::vector<std::int32_t>{0, 0, 0, 0, 0, 6}));
  }
}

TEST(TetgenFormat, DimensionInTheHeaderDecides) {
  EXPECT_EQ(read("1 3 0 0\n1 0 0 0\n", "a.node").complex.dimension, 3);
  EXPECT_EQ(read("1 3 0 0\n1 0 0 0\n", "x").format, "tetgen-node");
  EXPECT_EQ(read("1 2 0 0\n1 0 0\n", "x").format, "triangle-node");
  EXPECT_EQ(read("3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n1\n3 1 2 3\n", "x").complex.faces.size(),
            1u);
  EXPECT_EQ(read("3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n3 1 2 3\n", "x").complex.faces.size(),
            1u);
  const auto files = folder({{"a.node", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"}});
  EXPECT_EQ(read("0\n1 0\n1\n3 1 2 3\n0\n", "a.poly", files).complex.faces.size(), 1u);
}

TEST(TetgenEle, IsPositiveWhateverTheFileHasAndKeepsLabels) {
  const auto files = folder({{"a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"},
                             {"a.face", "2 1\n1 1 2 3 5\n2 1 2 4 0\n"},
                             {"a.edge", "1 1 1\n1 1 2 8 3\n"}});
  for (const char* corners : {"1 2 3 4", "1 2 4 3"}) {
    const ReadResult r = read("1 4 1\n1 " + std::string(corners) + " 6.5\n", "a.ele", files);
    ASSERT_TRUE(r.ok()) << names(r);
    EXPECT_EQ(r.format, "tetgen-ele");
    EXPECT_EQ(r.mesh->cells, (std::vector<std::uint32_t>{0, 1, 3, 2}));
    EXPECT_EQ(r.mesh->cell_regions, (std::vector<double>{6.5}));
    ASSERT_EQ(r.mesh->edges.size(), 1u);
    EXPECT_EQ(r.mesh->edges[0].segment, 2u);
    EXPECT_EQ(r.mesh->edge_markers, (std::vector<std::int32_t>{8}));
    // No column for the input's face: all listed facets are features, of a face nobody knows.
    ASSERT_EQ(r.mesh->facets.size(), 2u);
    EXPECT_EQ(r.mesh->facets[0].face, kNoIndex);
    EXPECT_EQ(r.complex.face_markers, (std::vector<std::int32_t>{5, 0}));
  }
}

TEST(TetgenMalformed, EachFileHasItsNamedDefectWithLineAndAdvice) {
  const struct {
    std::string text, defect, place;
  } cases[] = {
      {kCube, "truncated", ""},
      {kCube + "2 0\n1\n3 1 2 3\n", "truncated", "line 13"},
      {kCube + "1 0\n1\n9 1 2 3\n4\n", "truncated", "line"},
      {kCube + "1 0\n1\n99999999999 1 2 3\n4\n", "truncated", "line 13"},
      {kCube + "1 0\n1\n0\n", "truncated", "line"},
      {kCube + "1 0\n1 0 0\n-3 1 2 3\n", "syntax", "line 13"},
      {kCube + "1 0\n1\n3 1 x 3\n", "syntax", "line 13"},
      {kCube + "999999 0\n1\n3 1 2 3\n", "truncated", "line 11"},
      {kCube + "1 0\n999999\n3 1 2 3\n", "truncated", "line 12"},
      {kCube + "1 0\n1 9\n3 1 2 3\n", "truncated", "line 12"},
      {kCube + "1 7\n1\n3 1 2 3\n", "syntax", "line 11"},
      {"2 3 0 0\n1 0 0 0\n2 0 0\n1 0\n1\n3 1 1 1\n", "syntax", "line 3"},
      {"9 3 0 0\n1 0 0 0\n", "truncated", "line 1"},
  };
  for (const auto& c : cases) {
    const ReadResult r = read(c.text, "a.poly");
    EXPECT_EQ(names(r), c.defect) << c.text;
    if (!r.defects.empty()) {
      EXPECT_NE(r.defects[0].message.find(c.place), std::string::npos) << r.defects[0].message;
    }
  }
  EXPECT_EQ(names(read("1 4 0\n1 1 2 3 4\n", "a.ele")), "missing-sibling");
  const auto files = folder({{"a.node", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"}});
  EXPECT_EQ(names(read("1 4 0\n1 1 2 3 4\n", "a.ele", files)), "index-out-of-range");
}

TEST(TetgenMalformed, IndicesOutOfRangeStaySoForCheckToTell) {
  const ReadResult r = read(kCube + "1 0\n1\n3 1 2 99\n0\n", "a.poly");
  EXPECT_EQ(names(r), "(index-out-of-range)");
  ASSERT_EQ(r.complex.faces.size(), 1u);
  EXPECT_NE(io_test::check_text(r.complex).find("face 0 refers to vertex 98"), std::string::npos);
}

}  // namespace
}  // namespace circumball
