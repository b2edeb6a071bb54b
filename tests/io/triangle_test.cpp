#include <gtest/gtest.h>

#include <cmath>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::check_text;
using io_test::folder;
using io_test::names;

constexpr const char* kPoly = R"(# a square with a hole
4 2 2 1   # header

1 0 0  5 50  1
# a comment between
2 1 0  5 50  0
3 1 1  5 50  -3

4 0 1.5  5 50  7
4 1
1 1 2 10
2 2 3 0
3 3 4
4 4 1 -2
1
1 0.5 .5
2
1 .2 .2  7  .1
2 .3 .3  8
)";

TEST(TrianglePoly, CommentsAttributesMarkersHolesAndRegionsAreRead) {
  const ReadResult r = read(kPoly, "box.poly");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.format, "triangle-poly");
  const Complex& c = r.complex;
  EXPECT_EQ(c.dimension, 2);
  ASSERT_EQ(c.vertices.size(), 4u);
  EXPECT_EQ(c.vertices[3], (Point3{0, 1.5, 0}));
  EXPECT_EQ(c.attributes_per_vertex, 2);
  EXPECT_EQ(c.vertex_attributes, (std::vector<double>{5, 50, 5, 50, 5, 50, 5, 50}));
  EXPECT_EQ(c.vertex_markers, (std::vector<std::int32_t>{1, 0, -3, 7}));
  ASSERT_EQ(c.segments.size(), 4u);
  EXPECT_EQ(c.segments[3], (std::array<std::uint32_t, 2>{3, 0}));
  EXPECT_EQ(c.segment_markers, (std::vector<std::int32_t>{10, 0, 0, -2}));
  ASSERT_EQ(c.holes.size(), 1u);
  EXPECT_EQ(c.holes[0], (Point3{0.5, 0.5, 0}));
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_EQ(c.regions[0].label, 7);
  EXPECT_EQ(c.regions[0].max, 0.1);
  EXPECT_EQ(c.regions[1].label, 8);
  EXPECT_EQ(c.regions[1].max, 0);
  EXPECT_EQ(c.hole_rule, HoleRule::kSeeds);
}

TEST(TrianglePoly, NumbersFromZeroOrOneGiveTheSameComplex) {
  const ReadResult one = read("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n1 1 2\n2 2 3\n0\n", "a.poly");
  const ReadResult zero = read("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n2 0\n0 0 1\n1 1 2\n0\n", "a.poly");
  ASSERT_TRUE(one.ok() && zero.ok());
  EXPECT_EQ(one.complex.segments, zero.complex.segments);
  EXPECT_EQ(one.complex.vertices, zero.complex.vertices);
}

TEST(TrianglePoly, HoleAndRegionSectionsMayBeMissing) {
  const std::string upto_segments = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n1 0\n1 1 2\n";
  for (const char* rest : {"", "0\n", "0\n0\n", "1\n1 .2 .2\n", "# end"}) {
    const ReadResult r = read(upto_segments + rest, "a.poly");
    EXPECT_TRUE(r.ok()) << rest << ": " << names(r);
    EXPECT_EQ(r.complex.hole_rule, HoleRule::kSeeds);
  }
}

TEST(TrianglePoly, EveryLineEndAndSeparatorIsUnderstood) {
  for (const char* end : {"\n", "\r\n", "\r", " \t\n", "# x\r\n"}) {
    std::string text;
    for (const char* line : {"3, 2, 0, 0", "1,0,0", "2\t1 0", "  3 0 1", "1 0", "1 1 2", "0"})
      text += std::string(line) + end;
    const ReadResult r = read(text, "a.poly");
    ASSERT_TRUE(r.ok()) << names(r);
    EXPECT_EQ(r.complex.vertices.size(), 3u);
  }
}

TEST(TrianglePoly, WithoutVerticesTakesThemFromTheNodeFileBesideIt) {
  const auto files = folder({{"dir.x/box.1.node", "3 2 0 1\n0 0 0 4\n1 1 0 5\n2 0 1 6\n"}});
  const ReadResult r = read("0 2 0 0\n2 0\n0 0 1\n1 1 2\n0\n", "dir.x/box.1.poly", files);
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.vertices.size(), 3u);
  EXPECT_EQ(r.complex.vertex_markers, (std::vector<std::int32_t>{4, 5, 6}));
  EXPECT_EQ(r.complex.segments[1], (std::array<std::uint32_t, 2>{1, 2}));
}

TEST(TrianglePoly, NumbersThatAreNotFiniteAreReadForCheckToName) {
  const ReadResult r = read("3 2 0 0\n1 nan 0\n2 inf 1e999\n3 0 1\n", "a.node");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_TRUE(std::isnan(r.complex.vertices[0].x));
  EXPECT_TRUE(std::isinf(r.complex.vertices[1].y));
}

TEST(TriangleFormat, ContentDecidesAndTheNameOnlySettlesTies) {
  const std::string nodes = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  EXPECT_EQ(read(nodes, "a.node").format, "triangle-node");
  EXPECT_EQ(read(nodes, "a.txt").format, "triangle-node");
  EXPECT_EQ(read(nodes + "0 0\n0\n", "a.node").format, "triangle-poly");
  const auto files = folder({{"a.node", nodes}});
  EXPECT_EQ(read("1 3 0\n1 1 2 3\n", "a.txt", files).format, "triangle-ele");
  EXPECT_EQ(read("1 3 0\n1 1 2 3\n", "a.ele", files).format, "triangle-ele");
  EXPECT_EQ(read("1 3 0\n1 1 2 3\n", "a.node", files).format, "tetgen-node");
  EXPECT_EQ(read("1 3 0 0\n1 1 2 3\n", "a.txt", files).format, "tetgen-node");
}

TEST(TriangleEle, WithItsFamilyGivesMeshRegionsAndSubsegments) {
  const auto files = folder({{"a.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"},
                             {"a.poly", "0 2 0 0\n2 1\n1 1 2 9\n2 2 3 8\n1\n1 .5 .5\n"}});
  const ReadResult r = read("2 3 1\n1 1 2 3 7\n2 1 3 4 8\n", "a.ele", files);
  ASSERT_TRUE(r.ok()) << names(r);
  ASSERT_TRUE(r.mesh.has_value());
  EXPECT_EQ(r.mesh->cells, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(r.mesh->cell_regions, (std::vector<double>{7, 8}));
  ASSERT_EQ(r.mesh->edges.size(), 2u);
  EXPECT_EQ(r.mesh->edges[1].b, 2u);
  EXPECT_EQ(r.mesh->edge_markers, (std::vector<std::int32_t>{9, 8}));
  EXPECT_EQ(r.complex.segments.size(), 2u);
  EXPECT_EQ(r.complex.holes.size(), 1u);
}

TEST(TriangleEle, EdgesOfTrianglesOwnEdgeFileAreSubsegmentsWhereMarked) {
  const auto files = folder({{"a.node", "3 2 0 0\n0 0 0\n1 1 0\n2 1 1\n"},
                             {"a.edge", "3 1\n0 0 1 1\n1 1 2 0\n2 2 0 5\n"}});
  const ReadResult r = read("1 3 0\n0 0 1 2\n", "a.ele", files);
  ASSERT_TRUE(r.ok()) << names(r);
  ASSERT_EQ(r.mesh->edges.size(), 2u);
  EXPECT_EQ(r.mesh->edges[1].a, 2u);
  EXPECT_EQ(r.mesh->edges[1].segment, kNoIndex);
  EXPECT_EQ(r.mesh->edge_markers, (std::vector<std::int32_t>{1, 5}));
}

TEST(TriangleEle, SecondOrderTrianglesGiveTheirCorners) {
  const auto files = folder({{"a.node", "6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0\n"}});
  const ReadResult r = read("1 6 0\n1 1 2 3 4 5 6\n", "a.ele", files);
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.mesh->cells, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(TriangleMalformed, EachFileHasItsNamedDefectWithLineAndAdvice) {
  const struct {
    const char* text;
    const char* defect;
    const char* place;
  } cases[] = {
      {"3", "truncated", "line 1"},
      {"3 2 0 0\n1 0 0\n2 1 0\n", "truncated", "line 1"},
      {"3 2 0 0\n1 0 0\n2 1 0000000000000000000\n", "truncated", "2 of 3 vertices"},
      {"4000000000 2 0 0\n1 0 0\n", "too-large", "line 1"},
      {"99999999999999999999 2 0 0\n", "too-large", "line 1"},
      {"2000000000 2 0 0\n1 0 0\n", "truncated", "line 1"},
      {"-3 2 0 0\n", "syntax", "line 1"},
      {"1 2 1000000000 0\n1 0 0\n", "truncated", "line 1"},
      {"1 2 -1 0\n1 0 0\n", "syntax", "line 1"},
      {"1 2 0 7\n1 0 0\n", "syntax", "line 1"},
      {"1 5 0 0\n1 0 0 0\n", "unsupported", "line 1"},
      {"1.5 2 0 0\n1 0 0\n", "syntax", "line 1"},
      {"1 2 0 0\n1 0 abc\n", "syntax", "line 2"},
      {"1 2 0 0\n1 0      \n", "syntax", "line 2"},
      {"1 2 1 0\n1 0 0      \n", "syntax", "attribute 1"},
      {"1 2 0 0\n7 0 0\n", "numbering", "line 2"},
      {"2 2 0 0\n1 0 0\n3 0 0\n", "numbering", "line 3"},
      {"2 2 0 1\n1 0 0 x\n2 1 1 0\n", "syntax", "line 2"},
      {"2 2 0 1\n1 0 0 99999999999\n2 1 1 0\n", "too-large", "line 2"},
      {"2 2 0 0\n1 0 0\n2 1 1\n5 0\n1 1 2\n", "truncated", "line 4"},
      {"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1     \n", "syntax", "line 5"},
      {"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n3\n1 .5 .5\n", "truncated", "line 6"},
      {"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n1\n1 .5\n      ", "syntax", "line 7"},
      {"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n9\n", "truncated", "line 7"},
      {"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n1\n1 .2 .2 x y\n", "syntax", "line 8"},
      {"0 2 0 0\n1 0\n1 1 2\n0\n", "missing-sibling", "a.node"},
      {"2 3 0\n1 1 2 3\n2 1 2 3\n", "missing-sibling", "a.node"},
  };
  for (const auto& c : cases) {
    const ReadResult r = read(c.text, "a");
    EXPECT_EQ(names(r), c.defect) << c.text;
    ASSERT_FALSE(r.defects.empty());
    EXPECT_NE(r.defects[0].message.find(c.place), std::string::npos) << c.text << "\n"
                                                                     << r.defects[0].message;
    EXPECT_TRUE(r.complex.vertices.empty()) << "half a complex is not given away";
  }
}

TEST(TriangleMalformed, APolyFileThatEndsBeforeItsSegmentsIsTruncated) {
  EXPECT_EQ(names(read("1 2 0 0\n1 0 0\n", "a.poly")), "truncated");
}

TEST(TriangleMalformed, IndicesOutOfRangeStaySoForCheckToTellAndTheFirstLineIsTold) {
  const struct {
    const char *base, *end;
    std::uint32_t index;
  } cases[] = {
      {"1", "3", 2},
      {"1", "0", kNoIndex},
      {"1", "-9223372036854775808", kNoIndex},
      {"1", "4294967296", kNoIndex},
      {"1", "99999999999999999", kNoIndex},
      {"1", "99999999999999999999999999", kNoIndex},
      {"1", "-99999999999999999999999999", kNoIndex},
      {"0", "2", 2},
      {"0", "-1", kNoIndex},
      {"0", "4294967295", kNoIndex},
  };
  for (const auto& c : cases) {
    const std::string second = c.base[0] == '1' ? "2" : "1";
    const ReadResult r = read("2 2 0 0\n" + std::string(c.base) + " 0 0\n" + second +
                                  " 1 1\n3 0\n1 " + c.base + " " + second + "\n2 " + c.end + " " +
                                  c.base + "\n3 " + c.base + " " + c.end + "\n0\n",
                              "a.poly");
    ASSERT_EQ(names(r), "(index-out-of-range)") << c.end;
    EXPECT_EQ(r.defects[0].message.find("line 6: the first end is vertex "), 0u)
        << r.defects[0].message;
    EXPECT_EQ(r.complex.segments[1], (std::array<std::uint32_t, 2>{c.index, 0})) << c.end;
    const std::string text = check_text(r.complex);
    EXPECT_NE(text.find("index-out-of-range: segment 1 "), std::string::npos) << text;
    EXPECT_NE(text.find("index-out-of-range: segment 2 "), std::string::npos) << text;
  }
}

TEST(CheckOfAFile, NamesEveryKindOfDefectAtOnce) {
  // A vertex that is no number, two indices that lead nowhere, a crossing and a duplicate vertex.
  const std::pair<const char*, const char*> files[] = {
      {"a.poly",
       "6 2 0 0\n1 0 0\n2 4 4\n3 0 4\n4 4 0\n5 nan 1\n6 0 0\n"
       "4 0\n1 1 2\n2 3 4\n3 1 12\n4 0 4\n0\n"},
      {"a.obj", "v 0 0\nv 4 4\nv 0 4\nv 4 0\nv nan 1\nv 0 0\nl 1 2\nl 3 4\nl 1 12\nl 0 4\n"},
      {"a.off",
       "OFF 6 4 0\n0 0 0\n4 4 0\n0 4 0\n4 0 0\nnan 1 0\n0 0 0\n"
       "2 0 1\n2 2 3\n2 0 11\n2 -1 3\n"},
      {"a.json", R"({"circumball": 1, "dimension": 2,
        "vertices": [[0,0],[4,4],[0,4],[4,0],[null,1],[0,0]],
        "segments": [[0,1],[2,3],[0,11],[-1,3]]})"},
  };
  for (const auto& [name, bytes] : files) {
    const ReadResult r = read(bytes, name);
    ASSERT_TRUE(r.ok()) << name << ": " << names(r);
    EXPECT_EQ(
        check_text(r.complex),
        "not-finite: vertex 4 has coordinates (nan, 1): give it finite numbers\n"
        "index-out-of-range: segment 2 joins vertices 0 and 11, but there are only 6 vertices, "
        "numbered from 0: correct its ends\n"
        "index-out-of-range: segment 3 joins vertices none and 3, but there are only 6 vertices, "
        "numbered from 0: correct its ends\n"
        "duplicate-vertices: vertices 0 and 5 are both at (0, 0): remove one of them\n"
        "segments-cross: segments 0 and 1 cross near (2, 2): add a vertex there and split both, or "
        "move one\n")
        << name;
    EXPECT_EQ(smallest_angle_degrees(r.complex), 180) << name;  // survives
    std::string error;
    for (const char* extension : {".poly", ".json", ".obj", ".svg"}) {
      EXPECT_TRUE(write_complex(r.complex, extension, &error).empty()) << name;
      EXPECT_FALSE(error.empty());
    }
  }
}

TEST(TriangleMalformed, SiblingsAreReadWithTheSameCare) {
  EXPECT_EQ(names(read("1 3 0\n1 1 2 3\n", "a.ele", folder({{"a.node", "garbage"}}))), "syntax");
  EXPECT_EQ(names(read("1 3 0\n1 1 2 3\n", "a.ele", folder({{"a.node", ""}}))), "truncated");
  const char* node = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  EXPECT_EQ(names(read("1 3 0\n1 1 2 4\n", "a.ele", folder({{"a.node", node}}))),
            "index-out-of-range");
  EXPECT_EQ(names(read("1 3 0\n1 1 2 3\n", "a.ele",
                       folder({{"a.node", node}, {"a.edge", "99999 1\n1 1 2 1\n"}}))),
            "truncated");
  EXPECT_EQ(names(read("1 3 0\n1 1 2 3\n", "a.ele",
                       folder({{"a.node", node}, {"a.poly", "0 2 0 0\n1 0\n1 1 9\n"}}))),
            "index-out-of-range");
}

}  // namespace
}  // namespace circumball
