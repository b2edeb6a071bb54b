#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::files;
using io_test::folder;
using io_test::names;
using io_test::sample_complex;
using io_test::sample_mesh;

/// Writes a complex and reads it back.
Complex through(const Complex& complex, const std::string& extension) {
  std::string error;
  const auto output = write_complex(complex, extension, &error);
  EXPECT_EQ(error, "");
  EXPECT_EQ(output.size(), 1u);
  const ReadResult r = read(output.at(0).bytes, "a" + extension);
  EXPECT_TRUE(r.ok()) << extension << ": " << names(r);
  return r.complex;
}

/// Writes a mesh and reads it back, with its siblings.
ReadResult through(const Mesh& mesh, const Complex& complex, const std::string& extension) {
  std::string error;
  const auto output = write_mesh(mesh, complex, extension, {}, &error);
  EXPECT_EQ(error, "");
  const auto family = files(output, "m");
  return read(family.at("m" + extension), "m" + extension, folder(family));
}

void expect_same_bits(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(std::memcmp(&a[i], &b[i], 2 * sizeof(double)), 0) << i;
}

void expect_same_regions(const std::vector<Region>& a, const std::vector<Region>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].at, b[i].at);
    EXPECT_EQ(a[i].label, b[i].label);
    EXPECT_EQ(a[i].max, b[i].max);
  }
}

TEST(ComplexRoundTrip, PolyAndJsonKeepEverythingBitForBit) {
  const Complex c = sample_complex();
  for (const char* extension : {".poly", ".json"}) {
    const Complex back = through(c, extension);
    expect_same_bits(back.vertices, c.vertices);
    EXPECT_EQ(back.segments, c.segments);
    EXPECT_EQ(back.holes, c.holes);
    EXPECT_EQ(back.hole_rule, c.hole_rule);
    expect_same_regions(back.regions, c.regions);
    EXPECT_EQ(back.vertex_markers, c.vertex_markers);
    EXPECT_EQ(back.segment_markers, c.segment_markers);
  }
}

TEST(ComplexRoundTrip, PolyKeepsAttributes) {
  Complex c = sample_complex();
  c.attributes_per_vertex = 2;
  for (std::size_t i = 0; i < 2 * c.vertices.size(); ++i)
    c.vertex_attributes.push_back(1.0 / (3 + static_cast<double>(i)));
  const Complex back = through(c, ".poly");
  EXPECT_EQ(back.attributes_per_vertex, 2);
  EXPECT_EQ(back.vertex_attributes, c.vertex_attributes);
}

TEST(ComplexRoundTrip, ObjKeepsVerticesAndSegmentsBitForBit) {
  const Complex c = sample_complex();
  const Complex back = through(c, ".obj");
  expect_same_bits(back.vertices, c.vertices);
  EXPECT_EQ(back.segments, c.segments);
}

TEST(ComplexRoundTrip, NodeKeepsVertices) {
  const Complex c = sample_complex();
  expect_same_bits(through(c, ".node").vertices, c.vertices);
}

TEST(ComplexRoundTrip, SvgKeepsPlacesAndLinesUpToNumbering) {
  const Complex c = sample_complex();
  const auto lines = [](const Complex& complex) {
    std::multiset<std::vector<double>> out;
    for (const auto& s : complex.segments) {
      std::vector<double> a{complex.vertices[s[0]].x, complex.vertices[s[0]].y};
      std::vector<double> b{complex.vertices[s[1]].x, complex.vertices[s[1]].y};
      if (b < a) std::swap(a, b);
      a.insert(a.end(), b.begin(), b.end());
      out.insert(a);
    }
    return out;
  };
  const auto places = [](const Complex& complex) {
    std::multiset<std::pair<double, double>> out;
    for (const Point3& p : complex.vertices) out.insert({p.x, p.y});
    return out;
  };
  const Complex back = through(c, ".svg");
  EXPECT_EQ(lines(back), lines(c));
  EXPECT_EQ(places(back), places(c));
}

TEST(ComplexRoundTrip, TheRuleOfHolesSurvivesJson) {
  Complex c = sample_complex();
  c.holes.clear();
  c.regions.clear();
  for (const HoleRule rule : {HoleRule::kSeeds, HoleRule::kParity}) {
    c.hole_rule = rule;
    EXPECT_EQ(through(c, ".json").hole_rule, rule);
  }
}

TEST(MeshRoundTrip, FingerprintSurvivesEveryFormatThatIsReadBack) {
  const Mesh m = sample_mesh();
  for (const char* extension : {".ele", ".json", ".obj", ".off"}) {
    const ReadResult r = through(m, Complex(), extension);
    ASSERT_TRUE(r.ok()) << extension << ": " << names(r);
    ASSERT_TRUE(r.mesh.has_value()) << extension;
    EXPECT_EQ(fingerprint(*r.mesh), fingerprint(m)) << extension;
  }
}

TEST(MeshRoundTrip, EleFamilyKeepsRegionsMarkersAttributesAndSubsegments) {
  Mesh m = sample_mesh();
  m.vertex_markers = {1, 2, -3, 0, 5};
  m.edge_markers = {7, -1, 3, 0};
  m.attributes_per_vertex = 1;
  m.vertex_attributes = {0.1, 0.2, 0.3, 0.4, 0};
  const ReadResult r = through(m, sample_complex(), ".ele");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.mesh->cells, m.cells);
  EXPECT_EQ(r.mesh->cell_regions, m.cell_regions);
  EXPECT_EQ(r.mesh->vertex_markers, m.vertex_markers);
  EXPECT_EQ(r.mesh->vertex_attributes, m.vertex_attributes);
  // The .edge file lists edges by their vertices.
  ASSERT_EQ(r.mesh->edges.size(), 4u);
  const std::uint32_t expected[4][4] = {
      {0, 1, 0, 7}, {3, 0, kNoIndex, 0}, {1, 2, 1, ~0u}, {2, 3, 2, 3}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(r.mesh->edges[i].a, expected[i][0]);
    EXPECT_EQ(r.mesh->edges[i].b, expected[i][1]);
    EXPECT_EQ(r.mesh->edges[i].segment, expected[i][2]);
    EXPECT_EQ(static_cast<std::uint32_t>(r.mesh->edge_markers[i]), expected[i][3]);
  }
  EXPECT_EQ(r.complex.holes, sample_complex().holes);
  EXPECT_EQ(r.complex.segments.size(), 4u);
}

TEST(MeshRoundTrip, JsonKeepsFeaturesAndSaysWhichVerticesAreTheInputs) {
  Mesh m = sample_mesh();
  m.input_vertices = 3;
  m.box_vertices = 1;  // vertex 3
  Complex c;
  c.vertices.assign(m.vertices.begin(), m.vertices.begin() + 3);
  c.segments = {{0, 1}, {1, 2}, {2, 0}};
  c.segment_markers = {4, 5, 6};
  const ReadResult r = through(m, c, ".json");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.mesh->input_vertices, 3u);
  EXPECT_EQ(r.mesh->box_vertices, 1u);
  EXPECT_EQ(r.mesh->vertex_features, m.vertex_features);
  EXPECT_EQ(r.mesh->cell_regions, m.cell_regions);
  ASSERT_EQ(r.mesh->edges.size(), 4u);
  EXPECT_EQ(r.mesh->edges[3].segment, kNoIndex);
  EXPECT_EQ(r.mesh->edge_markers, (std::vector<std::int32_t>{4, 5, 6, 0}));
  expect_same_bits(r.complex.vertices, c.vertices);
  EXPECT_EQ(r.complex.segments, c.segments);
}

TEST(MeshRoundTrip, AComplexThatNeedsTheBoxKeepsItsCorners) {
  Mesh m = sample_mesh();
  m.input_vertices = 3;
  m.box_vertices = 1;
  Complex c;
  c.vertices.assign(m.vertices.begin(), m.vertices.begin() + 4);
  c.segments = {{0, 3}};
  const ReadResult r = through(m, c, ".json");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.vertices.size(), 4u);
}

TEST(EdgeFile, ListsEveryEdgeWithMarkerAndInputSegment) {
  const Mesh m = sample_mesh();
  std::string error;
  const auto family = files(write_mesh(m, {}, ".node", {}, &error), "m");
  EXPECT_EQ(family.at("m.edge"),
            "7 1\n1 1 2 1 1\n2 1 3 0 0\n3 4 1 1 -1\n4 2 3 1 2\n5 2 5 0 0\n6 3 4 1 3\n7 3 5 0 0\n");
  EXPECT_EQ(family.at("m.poly"), "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  EXPECT_EQ(family.at("m.ele"), "3 3 1\n1 1 2 3 1\n2 1 3 4 2\n3 2 5 3 1\n");
}

/// The text between two lines.
std::string section(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin + "\n");
  const std::size_t to = text.find(end + "\n");
  if (from == std::string::npos || to == std::string::npos) return "missing";
  return text.substr(from + begin.size() + 1, to - from - begin.size() - 1);
}

TEST(Msh, BothVersionsHaveAGroupForEachRegionAndSegment) {
  const Mesh m = sample_mesh();
  std::string error;
  const std::string names =
      "6\n1 1 \"segment 0\"\n1 2 \"segment 1\"\n1 3 \"segment 2\"\n"
      "1 4 \"segment 3\"\n2 1 \"region 1\"\n2 2 \"region 2\"\n";
  const std::string new_text = write_mesh(m, {}, ".msh", {}, &error).at(0).bytes;
  EXPECT_EQ(section(new_text, "$MeshFormat", "$EndMeshFormat"), "4.1 0 8\n");
  EXPECT_EQ(section(new_text, "$PhysicalNames", "$EndPhysicalNames"), names);
  EXPECT_EQ(section(new_text, "$Entities", "$EndEntities"),
            "0 4 2 0\n1 0 0 0 0 1 0 1 1 0\n2 0 0 0 1 0 0 1 2 0\n3 1 0 0 1 1 0 1 3 0\n"
            "4 0 1 0 1 1 0 1 4 0\n1 0 0 0 1.3333333333333333 1 0 1 1 0\n2 0 0 0 1 1 0 1 2 0\n");
  EXPECT_EQ(
      section(new_text, "$Nodes", "$EndNodes"),
      "1 5 1 5\n2 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1.3333333333333333 0.1 0\n");
  EXPECT_EQ(section(new_text, "$Elements", "$EndElements"),
            "6 7 1 7\n1 1 1 1\n1 4 1\n1 2 1 1\n2 1 2\n1 3 1 1\n3 2 3\n1 4 1 1\n4 3 4\n"
            "2 1 2 2\n5 1 2 3\n6 2 5 3\n2 2 2 1\n7 1 3 4\n");
  WriteOptions old;
  old.msh_version = "2.2";
  const std::string old_text = write_mesh(m, {}, ".msh", old, &error).at(0).bytes;
  EXPECT_EQ(section(old_text, "$MeshFormat", "$EndMeshFormat"), "2.2 0 8\n");
  EXPECT_EQ(section(old_text, "$PhysicalNames", "$EndPhysicalNames"), names);
  EXPECT_EQ(section(old_text, "$Elements", "$EndElements"),
            "7\n1 1 2 1 1 4 1\n2 1 2 2 2 1 2\n3 1 2 3 3 2 3\n4 1 2 4 4 3 4\n5 2 2 1 1 1 2 3\n"
            "6 2 2 1 1 2 5 3\n7 2 2 2 2 1 3 4\n");
}

TEST(Vtu, HasPointsCellsAndLinesWithTheirFeatures) {
  std::string error;
  const std::string text = write_mesh(sample_mesh(), {}, ".vtu", {}, &error).at(0).bytes;
  const auto array = [&](const std::string& head) {
    const std::size_t from = text.find(head);
    if (from == std::string::npos) return std::string("missing");
    const std::size_t begin = text.find(">\n", from) + 2;
    std::string out = text.substr(begin, text.find("</DataArray>", begin) - begin);
    std::replace(out.begin(), out.end(), '\n', ',');
    return out;
  };
  EXPECT_NE(text.find("NumberOfPoints=\"5\" NumberOfCells=\"7\""), std::string::npos);
  EXPECT_EQ(array("Name=\"points\""), "0 0 0,1 0 0,1 1 0,0 1 0,1.3333333333333333 0.1 0,");
  EXPECT_EQ(array("Name=\"connectivity\""), "0 1 2,0 2 3,1 4 2,0 1,1 2,2 3,3 0,");
  EXPECT_EQ(array("Name=\"offsets\""), "3,6,9,11,13,15,17,");
  EXPECT_EQ(array("Name=\"types\""), "5,5,5,3,3,3,3,");
  EXPECT_EQ(array("Name=\"region\""), "1,2,1,0,0,0,0,");
  EXPECT_EQ(array("Name=\"feature_kind\""), "0,0,0,0,3,");
  EXPECT_EQ(text.substr(text.size() - 11), "</VTKFile>\n");
}

TEST(SvgFigure, HasTrianglesUnderHeavierSegmentsInAFrame) {
  std::string error;
  const std::string text = write_mesh(sample_mesh(), {}, ".svg", {}, &error).at(0).bytes;
  EXPECT_NE(text.find("viewBox=\""), std::string::npos);
  EXPECT_NE(text.find("M0 0L1 0L1 -1Z"), std::string::npos);
  EXPECT_LT(text.find("M0 0L1 0L1 -1Z"), text.find("fill=\"none\""));
  EXPECT_TRUE(read(text, "a.svg").ok());
}

TEST(Writers, SayWhatTheyCannotDo) {
  std::string error;
  EXPECT_TRUE(write_mesh(sample_mesh(), {}, ".xyz", {}, &error).empty());
  EXPECT_NE(error.find(".vtu"), std::string::npos);
  EXPECT_TRUE(write_complex(sample_complex(), ".vtu", &error).empty());
  EXPECT_NE(error.find(".poly"), std::string::npos);
  WriteOptions options;
  options.msh_version = "3";
  EXPECT_TRUE(write_mesh(sample_mesh(), {}, ".msh", options, &error).empty());
  EXPECT_NE(error.find("4.1"), std::string::npos);
  Mesh broken = sample_mesh();
  broken.cells[0] = 99;
  EXPECT_TRUE(write_mesh(broken, {}, ".json", {}, &error).empty());
  EXPECT_NE(error, "");
  Mesh space;
  space.dimension = 3;
  EXPECT_TRUE(write_mesh(space, {}, ".svg", {}, &error).empty());
}

TEST(Writers, EveryExtensionThatIsListedIsWritten) {
  std::string error;
  for (const std::string& extension : mesh_extensions(2)) {
    const auto output = write_mesh(sample_mesh(), sample_complex(), extension, {}, &error);
    EXPECT_EQ(error, "");
    EXPECT_TRUE(std::any_of(output.begin(), output.end(),
                            [&](const OutputFile& f) { return f.extension == extension; }));
  }
}

TEST(Writers, AnEmptyMeshIsWrittenToo) {
  std::string error;
  for (const std::string& extension : mesh_extensions(2)) {
    EXPECT_FALSE(write_mesh({}, {}, extension, {}, &error).empty());
    EXPECT_EQ(error, "");
  }
}

}  // namespace
}  // namespace circumball
