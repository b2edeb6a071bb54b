#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "circumball/io.h"
#include "io/svg_geometry.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::check_text;
using io_test::names;

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>";
}
Complex drawn(const std::string& content) {
  const ReadResult r = read(svg(content), "a.svg");
  EXPECT_TRUE(r.ok()) << content << ": " << names(r);
  return r.complex;
}
using Points = std::vector<Point3>;

TEST(SvgPath, LinesOfEveryKindAreDrawnWithYPointingUp) {
  const Points square = {{1, -2, 0}, {5, -2, 0}, {5, -6, 0}, {1, -6, 0}};
  for (const char* d : {"M1 2H5V6H1Z", "m1,2h4v4h-4z", "M1 2L5 2 5 6 1 6z", "M 1 2 5 2 5 6 1 6 Z",
                        "m1 2 4 0 0 4-4 0z", "M1 2h4v4h-4v-4", "M1,2 L5,2L5,6L1,6L1,2Z"}) {
    const Complex c = drawn(std::string("<path d='") + d + "'/>");
    EXPECT_EQ(c.vertices, square) << d;
    EXPECT_EQ(c.segments.size(), 4u) << d;
    EXPECT_EQ(c.hole_rule, HoleRule::kParity);
  }
}

TEST(SvgPath, NumbersMayTouch) {
  const Complex c = drawn("<path d='M.5.5-1-1e0L1e1-.5'/>");
  EXPECT_EQ(c.vertices, (Points{{0.5, -0.5, 0}, {-1, 1, 0}, {10, 0.5, 0}}));
}

TEST(SvgPath, SubpathsBeginWhereTheLastOneClosed) {
  const Complex c = drawn("<path d='M0 0h2v2z l-1 0'/>");
  EXPECT_EQ(c.vertices.size(), 4u);
  EXPECT_EQ(c.segments.back(), (std::array<std::uint32_t, 2>{0, 3}));
}

TEST(SvgPath, ASubpathWithoutLengthIsAnIsolatedVertexAndABareMoveIsNothing) {
  const Complex c = drawn("<path d='M0 0h4M9 9M2 2h0M3 3z'/>");
  EXPECT_EQ(c.vertices, (Points{{0, 0, 0}, {4, 0, 0}, {2, -2, 0}, {3, -3, 0}}));
  EXPECT_EQ(c.segments.size(), 1u);
}

TEST(SvgPath, RelativeCoordinatesThatNearlyComeBackClose) {
  const Complex c = drawn("<path d='M0.1 0.1l0.7 0.1 0.1 0.7-0.8-0.8z'/>");
  EXPECT_EQ(c.vertices.size(), 3u);
  EXPECT_EQ(c.segments.size(), 3u);
}

TEST(SvgPath, ChordsOfACircleLieOnItWithinTheStatedTolerance) {
  for (const char* text :
       {"<circle cx='3' cy='4' r='10'/>", "<ellipse cx='3' cy='4' rx='10' ry='10'/>",
        "<path d='M13 4A10 10 0 0 1 -7 4 10 10 0 1 1 13 4z'/>",
        "<path d='M13 4a10 10 0 1 0-20 0 10 10 0 0 0 20 0'/>",
        "<g transform='translate(3 4) scale(10)'><circle r='1'/></g>",
        "<rect x='-7' y='-6' width='20' height='20' rx='10'/>"}) {
    const Complex c = drawn(text);
    ASSERT_GE(c.segments.size(), 16u) << text;
    EXPECT_LE(c.segments.size(), 128u);
    EXPECT_EQ(c.segments.size(), c.vertices.size()) << text;
    for (const auto& s : c.segments) {
      const Point3 &p = c.vertices[s[0]], &q = c.vertices[s[1]];
      EXPECT_NEAR(std::hypot(p.x - 3, p.y + 4), 10, 1e-12) << text;
      EXPECT_GT(std::hypot((p.x + q.x) / 2 - 3, (p.y + q.y) / 2 + 4),
                10 - 20 * io::kChordTolerance);
    }
  }
}

TEST(SvgPath, ArcsTakeTheSideThatTheirFlagsSay) {
  // From (0, 0) to (1, 1) on circles of radius 1: the four arcs of the SVG specification.
  const struct {
    const char* flags;
    double x, y;  // center, y down
    bool large;
  } cases[] = {
      {"0 0", 1, 0, false}, {"0 1", 0, 1, false}, {"1 0", 0, 1, true}, {"1 1", 1, 0, true}};
  for (const auto& arc : cases) {
    const Complex c = drawn("<path d='M0 0A1 1 0 " + std::string(arc.flags) + " 1 1'/>");
    double length = 0;
    for (const auto& s : c.segments) {
      const Point3 &p = c.vertices[s[0]], &q = c.vertices[s[1]];
      EXPECT_NEAR(std::hypot(p.x - arc.x, -p.y - arc.y), 1, 1e-12) << arc.flags;
      length += std::hypot(p.x - q.x, p.y - q.y);
    }
    EXPECT_NEAR(length, arc.large ? 4.712 : 1.571, 0.02) << arc.flags;
    EXPECT_EQ(c.vertices.back(), (Point3{1, -1, 0}));
  }
}

TEST(SvgPath, ArcsThatCannotReachGrowAndFlatOnesAreLines) {
  const Complex grown = drawn("<path d='M0 0A1 1 0 0 1 10 0'/>");
  for (const Point3& p : grown.vertices) EXPECT_NEAR(std::hypot(p.x - 5, p.y), 5, 1e-12);
  EXPECT_EQ(drawn("<path d='M0 0A0 1 0 0 1 10 0'/>").segments.size(), 1u);
}

TEST(SvgPath, ChordsOfBezierCurvesStayWithinTheStatedTolerance) {
  const auto at = [](double t) {  // (0,0) (0,10) (10,10) (10,0), y up
    const double u = 1 - t;
    return Point2{3 * u * t * t * 10 + t * t * t * 10, -(3 * u * u * t * 10 + 3 * u * t * t * 10)};
  };
  const Complex c = drawn("<path d='M0 0C0 10 10 10 10 0'/>");
  const auto n = static_cast<double>(c.segments.size());
  for (std::size_t i = 0; i < c.segments.size(); ++i) {
    const Point2 middle = at((static_cast<double>(i) + 0.5) / n);
    const Point3 &p = c.vertices[i], &q = c.vertices[i + 1];
    EXPECT_LT(std::hypot((p.x + q.x) / 2 - middle.x, (p.y + q.y) / 2 - middle.y),
              10 * io::kChordTolerance);
  }
}

TEST(SvgPath, CurvesThatAskForMoreChordsThanTheFileHasBytesAreRefused) {
  std::string data = "M0 0c";
  for (int i = 0; i < 5000; ++i) data += "9 9-9 9 .001 0 ";
  EXPECT_EQ(names(read(svg("<path d='" + data + "'/>"), "a.svg")), "too-large");
}

TEST(SvgPath, SmoothCommandsReflectTheLastControlPoint) {
  EXPECT_EQ(drawn("<path d='M0 0C0 4 4 4 4 0S8-4 8 0'/>").vertices,
            drawn("<path d='M0 0C0 4 4 4 4 0C4-4 8-4 8 0'/>").vertices);
  EXPECT_EQ(drawn("<path d='M0 0Q2 4 4 0T8 0'/>").vertices,
            drawn("<path d='M0 0Q2 4 4 0Q6-4 8 0'/>").vertices);
  EXPECT_EQ(drawn("<path d='M0 0L4 0S8-4 8 0'/>").vertices,
            drawn("<path d='M0 0L4 0C4 0 8-4 8 0'/>").vertices);
  EXPECT_EQ(drawn("<path d='m0 0c0 4 4 4 4 0s4-4 4 0'/>").vertices,
            drawn("<path d='M0 0C0 4 4 4 4 0S8-4 8 0'/>").vertices);
}

TEST(SvgShapes, AreDrawnAsThePathsTheyStandFor) {
  EXPECT_EQ(drawn("<rect x='1' y='2' width='3px' height='4'/>").vertices,
            drawn("<path d='M1 2h3v4h-3z'/>").vertices);
  EXPECT_EQ(drawn("<polygon points='1,2 3,4 5,0'/>").segments.size(), 3u);
  EXPECT_EQ(drawn("<polyline points='1,2 3,4 5,0'/>").segments.size(), 2u);
  EXPECT_EQ(drawn("<line x1='1' y2='3'/>").vertices, (Points{{1, 0, 0}, {0, -3, 0}}));
}

TEST(SvgTransform, NestsAndComposesFromTheOutside) {
  const Points expected = {{10, -20, 0}, {10, -30, 0}};
  for (const char* text :
       {"<g transform='translate(10,20)'><g transform='rotate(90)'><path d='M0 0H10'/></g></g>",
        "<path transform='translate(10 20) rotate(90)' d='M0 0H10'/>",
        "<path transform='matrix(0 1 -1 0 10 20)' d='M0 0H10'/>",
        "<path transform='rotate(90,10,20)' d='M10 20H20'/>",
        "<path transform='rotate(450) translate(20-10)' d='M0 0H10'/>",
        "<path transform='translate(10)translate(0,20)scale(-1 2)rotate(-270)' d='M0 0H5'/>"})
    EXPECT_EQ(drawn(text).vertices, expected) << text;
  const Complex turned = drawn("<path transform='rotate(30)' d='M0 0H2'/>");
  EXPECT_NEAR(turned.vertices[1].x, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(turned.vertices[1].y, -1, 1e-15);
}

TEST(SvgTransform, CosineAndSineAgreeWithTheLibraryToAFewUlp) {
  for (int i = -2000; i <= 2000; ++i) {
    const double degrees = i * 0.7;
    const Point2 r = io::cos_sin_degrees(degrees);
    EXPECT_NEAR(r.x, std::cos(degrees * 3.141592653589793 / 180), 1e-14) << degrees;
    EXPECT_NEAR(r.y, std::sin(degrees * 3.141592653589793 / 180), 1e-14) << degrees;
    EXPECT_NEAR(r.x * r.x + r.y * r.y, 1, 1e-15);
  }
  EXPECT_EQ(io::cos_sin_degrees(-90), (Point2{0, -1}));
  EXPECT_TRUE(std::isnan(io::cos_sin_degrees(std::numeric_limits<double>::infinity()).x));
}

TEST(SvgDocument, WhatIsNotDrawnIsNotRead) {
  const Complex c = drawn(
      "<!-- <path d='M9 9H8'/> --><defs><g><path d='garbage'/></g></defs><style><![CDATA[ a > b "
      "]]></style><clipPath id='x'><rect width='5' height='5'/></clipPath><g display='none'><path "
      "d='M7 7H8'/></g><svg:path xmlns:svg='x' d='M0 0H1'/><title>a</title>");
  EXPECT_EQ(c.vertices.size(), 2u);
  const ReadResult r = read(svg("<text x='1'>A</text><path d='M0 0H1'/><use href='#a'/>"), "a");
  EXPECT_EQ(names(r), "(ignored) (ignored)");
}

TEST(SvgDocument, PreambleAndQuotesAreUnderstood) {
  const ReadResult r = read(
      "\xef\xbb\xbf  <?xml version='1.0'?>\n<!DOCTYPE svg PUBLIC \"-//W3C\" "
      "\"x\" [ <!ENTITY a \"b\"> ]>\n<svg a='>'><path\n id=\"p>\" d = \"M0 0H1\" /></svg>",
      "a.txt");
  EXPECT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.segments.size(), 1u);
}

TEST(SvgDocument, MalformedFilesAreNamed) {
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "<g>";
  const std::pair<std::string, const char*> cases[] = {
      {"<html><body/></html>", "unknown-format"},
      {"<", "truncated"},
      {"<svg><path d='M0 0H1'/>", "truncated"},
      {"<svg><path d='M0 0H1", "truncated"},
      {"<svg><!-- ", "truncated"},
      {"<!-- a -->", "unknown-format"},
      {svg(""), "empty"},
      {svg("<path d='L0 0'/>"), "syntax"},
      {svg("<path d='M0 0X'/>"), "syntax"},
      {svg("<path d='M0 0L1'/>"), "syntax"},
      {svg("<path d='5 5'/>"), "syntax"},
      {svg("<path d='M0 0z1 1'/>"), "syntax"},
      {svg("<path d='M0 0A1 1 0 2 0 1 1'/>"), "syntax"},
      {svg("<polygon points='0,0 1'/>"), "syntax"},
      {svg("<polygon points='0,0 a,b'/>"), "syntax"},
      {svg("<rect width='5cm' height='5'/>"), "syntax"},
      {svg("<circle r='x'/>"), "syntax"},
      {svg("<g transform='spin(3)'/>"), "syntax"},
      {svg("<g transform='matrix(1 2 3)'/>"), "syntax"},
      {svg("<g transform='rotate(1'/>"), "syntax"},
      {"<svg>" + deep, "too-large"},
  };
  for (const auto& [text, defect] : cases) EXPECT_EQ(names(read(text, "a.svg")), defect) << text;
}

TEST(Obj, LinesPolylinesAndNegativeIndicesAreRead) {
  const ReadResult r =
      read("# c\no thing\nv 0 0\nv 1 0 0\nv 1 1 0 1\nl 1 2 3\nv 0 1\nl -1 -4\nl 3/1 4/2\nl 2 1\n",
           "a.obj");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.format, "obj");
  EXPECT_EQ(r.complex.hole_rule, HoleRule::kParity);
  EXPECT_EQ(r.complex.segments,
            (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}, {3, 0}, {2, 3}}));
  EXPECT_FALSE(r.mesh.has_value());
}

TEST(Obj, TrianglesInThePlaneAreAMeshWhoseBoundaryIsTheComplex) {
  const ReadResult r =
      read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//2 3/3\nf 1 3 4\n", "a.obj");
  ASSERT_TRUE(r.ok()) << names(r);
  ASSERT_TRUE(r.mesh.has_value());
  EXPECT_EQ(r.mesh->cells, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(r.complex.segments.size(), 4u);
}

TEST(Obj, OtherPolygonsInThePlaneGiveTheirSides) {
  const ReadResult r =
      read("v 0 0\nv 1 0\nv 1 1\nv 0 1\nv 2 0\nv 2 1\nf 1 2 3 4\nf 2 5 6 3\n", "a.obj");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_FALSE(r.mesh.has_value());
  EXPECT_EQ(r.complex.segments.size(), 7u);
}

TEST(Obj, PolygonsInSpaceAreFaces) {
  const ReadResult r = read("v 0 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n", "a.obj");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.dimension, 3);
  EXPECT_EQ(r.complex.faces.size(), 1u);
}

TEST(Obj, MalformedFilesAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"v 1\n", "syntax"},
      {"v 1 x\n", "syntax"},
      {"l 1 2\n", "empty"},
      {"v 0 0\nv 1 1\nl 1 3\n", "(index-out-of-range)"},
      {"v 0 0\nv 1 1\nl 0 1\n", "(index-out-of-range)"},
      {"v 0 0\nl 1 -2\nv 1 1\n", "(index-out-of-range)"},
      {"v 0 0\nv 1 1\nl 1 3 7 0\n", "(index-out-of-range)"},
      {"v 0 0\nv 1 1\nv 0 1\nf 1 2 9\nf 1 2 0\n", "index-out-of-range index-out-of-range"},
      {"v 0 0\nv 1 1\nv 0 1\nf 1 2 3 9\n", "(index-out-of-range)"},
      {"v 0 0 1\nv 1 1 0\nv 0 1 0\nf 1 2 9\n", "(index-out-of-range)"},
      {"v 0 0\nv 1 1\nl 1\n", "syntax"},
      {"v 0 0\nv 1 1\nf 1 2\n", "syntax"},
      {"v 0 0\nv 1 1\nl 1 a\n", "syntax"},
      {"v 0 0\nl 1 99999999999999999999\n", "(index-out-of-range)"},
      {"o nothing\n", "empty"},
  };
  for (const auto& [text, defect] : cases) EXPECT_EQ(names(read(text, "a.obj")), defect) << text;
}

TEST(Obj, IndicesOutOfRangeAreAllKept) {
  // Neither lines that lead nowhere twice nor ones whose both ends are lost are taken for one.
  const ReadResult lines = read("v 0 0\nv 1 1\nl 1 2\nl 2 1\nl 0 0\nl 1 9\nl 1 9\n", "a.obj");
  const std::vector<std::array<std::uint32_t, 2>> wanted = {
      {0, 1}, {kNoIndex, kNoIndex}, {0, 8}, {0, 8}};
  EXPECT_EQ(lines.complex.segments, wanted);
  const ReadResult sides = read("v 0 0\nv 1 0\nv 1 1\nf 1 2 3 9\n", "a.obj");
  EXPECT_EQ(sides.complex.segments.size(), 4u);
  EXPECT_FALSE(sides.mesh.has_value());
  const ReadResult faces = read("v 0 0 1\nv 1 0 0\nv 1 1 0\nf 1 2 9\n", "a.obj");
  EXPECT_EQ(check_text(faces.complex).find("index-out-of-range: face 0 refers to vertex 8,"), 0u);
  // The cells of a mesh are whole: lines beside them that lead nowhere are no edges of it.
  const ReadResult mesh = read("v 0 0\nv 1 0\nv 1 1\nf 1 2 3\nl 1 2\nl 2 9\n", "a.obj");
  ASSERT_TRUE(mesh.mesh.has_value());
  EXPECT_EQ(mesh.mesh->edges.size(), 1u);
  EXPECT_EQ(mesh.complex.segments.size(), 2u);
}

TEST(Obj, AHeightThatIsNoNumberIsTold) {
  const ReadResult r = read("v 0 0 nan\nv 1 1 0\nl 1 2\n", "a.obj");
  EXPECT_EQ(r.complex.dimension, 2);
  EXPECT_EQ(check_text(r.complex).find("not-finite: vertex 0 "), 0u);
}

TEST(Off, PlanarTrianglesAreAMeshAndLiesAboutCountsAreFound) {
  const ReadResult r = read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.mesh->cells, (std::vector<std::uint32_t>{0, 1, 2}));
  const std::pair<const char*, const char*> cases[] = {
      {"OFF\n", "truncated"},
      {"OFF 1000000000 1 0\n0 0 0\n", "truncated"},
      {"OFF 9223372036854775807 9223372036854775807 0\n0 0 0\n", "truncated"},
      {"OFF -1 0 0\n", "syntax"},
      {"OFF a b c\n", "syntax"},
      {"OFF 1 1 0\n0 0 0\n9 0 0 0 0\n", "syntax"},
      {"OFF 1 1 0\n0 0 0\n3 0 0 1\n", "index-out-of-range"},
      {"OFF 1 1 0\n0 0 0\n2 0 1\n", "(index-out-of-range)"},
      {"OFF 2 0 0\n0 0 0        \n", "truncated"},
      {"OFF 1 0 0\n0 0   \n", "syntax"},
  };
  for (const auto& [text, defect] : cases) EXPECT_EQ(names(read(text, "a.off")), defect) << text;
}

TEST(UnknownFormat, IsSaidWhateverTheBytes) {
  for (const std::string& text :
       {std::string("hello"), std::string("\x89PNG\r\n\x1a\n\0\0", 10), std::string("plywood\n"),
        std::string("solidus x\n"), std::string("[1, 2]"), std::string(200, '\xff')})
    EXPECT_EQ(names(read(text, "a.poly")), "unknown-format");
  for (const char* text : {"", " \n\t ", "# nothing\n", "\xef\xbb\xbf"})
    EXPECT_EQ(names(read(text, "a.poly")), "empty");
}

}  // namespace
}  // namespace circumball
