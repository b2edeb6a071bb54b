#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::check_text;
using io_test::names;

// The object of the contract (cli.md, "The project's own JSON"), with values filled in.
constexpr const char* kContract = R"({"circumball": 1, "dimension": 2,
  "vertices": [[0, 0], [1, 0], [1, 1.5]], "segments": [[0, 1], [1, 0]], "faces": [],
  "holes": [[0.5, 0.25]], "regions": [{"at": [0.1, 0.2], "label": 1, "max": 0.1}],
  "markers": {"vertices": [1, 2, -3], "segments": [4, 5], "faces": []},
  "mesh": {"cells": [[0, 1, 2]], "cellRegions": [1], "vertexFeatures": [[0, 0], [0, 1], [3, -1]],
           "edges": [[0, 1, 0], [1, 2, -1]], "facets": []}})";

TEST(OwnJson, EveryFieldOfTheContractIsRead) {
  const ReadResult r = read(kContract, "a.json");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.format, "json");
  const Complex& c = r.complex;
  EXPECT_EQ(c.segments.size(), 2u);
  EXPECT_EQ(c.holes[0], (Point3{0.5, 0.25, 0}));
  EXPECT_EQ(c.regions[0].at, (Point3{0.1, 0.2, 0}));
  EXPECT_EQ(c.regions[0].label, 1);
  EXPECT_EQ(c.regions[0].max, 0.1);
  EXPECT_EQ(c.segment_markers, (std::vector<std::int32_t>{4, 5}));
  ASSERT_TRUE(r.mesh.has_value());
  const Mesh& m = *r.mesh;
  EXPECT_EQ(m.vertices.size(), 3u);
  EXPECT_EQ(m.vertices[2], (Point3{1, 1.5, 0}));
  EXPECT_EQ(m.cells, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(m.cell_regions, (std::vector<double>{1}));
  EXPECT_EQ(m.vertex_markers, (std::vector<std::int32_t>{1, 2, -3}));
  ASSERT_EQ(m.vertex_features.size(), 3u);
  EXPECT_EQ(m.vertex_features[1], (Feature{FeatureKind::kVertex, 1}));
  EXPECT_EQ(m.vertex_features[2], (Feature{FeatureKind::kFree, kNoIndex}));
  ASSERT_EQ(m.edges.size(), 2u);
  EXPECT_EQ(m.edges[0].segment, 0u);
  EXPECT_EQ(m.edges[1].segment, kNoIndex);
  EXPECT_EQ(m.edge_markers, (std::vector<std::int32_t>{4, 0}));
  EXPECT_EQ(m.input_vertices, 2u);
}

TEST(OwnJson, EverythingButVersionDimensionAndVerticesMayBeMissing) {
  const ReadResult r = read(R"({"circumball": 1, "dimension": 2, "vertices": []})", "x");
  EXPECT_TRUE(r.ok()) << names(r);
  EXPECT_FALSE(r.mesh.has_value());
}

TEST(OwnJson, UnknownFieldsAreLeftToWhoeverWroteThem) {
  EXPECT_TRUE(
      read(R"({"circumball": 1, "dimension": 2, "vertices": [[0, 0]], "name": {"a": []}})", "x")
          .ok());
}

TEST(OwnJson, HolesAreToldBySeedsWhereHolesOrRegionsAreListedElseByParity) {
  const auto rule = [](const std::string& rest) {
    return read(R"({"circumball": 1, "dimension": 2, "vertices": [[0, 0]])" + rest + "}", "x")
        .complex.hole_rule;
  };
  EXPECT_EQ(rule(""), HoleRule::kParity);
  EXPECT_EQ(rule(R"(, "segments": [])"), HoleRule::kParity);
  EXPECT_EQ(rule(R"(, "holes": [[1, 2]])"), HoleRule::kSeeds);
  EXPECT_EQ(rule(R"(, "holes": [])"), HoleRule::kSeeds);
  EXPECT_EQ(rule(R"(, "regions": [])"), HoleRule::kSeeds);
  EXPECT_EQ(rule(R"(, "holes": null)"), HoleRule::kParity);
}

TEST(OwnJson, ComplexesOfSpaceKeepTheirFaces) {
  const ReadResult r = read(R"({"circumball": 1, "dimension": 3,
    "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "segments": [[0,3]],
    "faces": [{"loops": [[0,1,2]], "holes": [[0.1,0.2,0]], "segments": [0], "vertices": [3]}],
    "markers": {"faces": [6]}, "mesh": {"cells": [[0,1,2,3]], "facets": [[0,1,2,0]]}})",
                            "x");
  ASSERT_TRUE(r.ok()) << names(r);
  std::string error;
  const auto files = write_mesh(*r.mesh, r.complex, ".json", {}, &error);
  ASSERT_EQ(files.size(), 1u) << error;
  const ReadResult again = read(files[0].bytes, "x");
  ASSERT_TRUE(again.ok()) << names(again);
  ASSERT_EQ(again.complex.faces.size(), 1u);
  EXPECT_EQ(again.complex.faces[0].loops, r.complex.faces[0].loops);
  EXPECT_EQ(again.complex.faces[0].holes, r.complex.faces[0].holes);
  EXPECT_EQ(again.complex.faces[0].segments, r.complex.faces[0].segments);
  EXPECT_EQ(again.complex.faces[0].vertices, r.complex.faces[0].vertices);
  EXPECT_EQ(again.complex.face_markers, r.complex.face_markers);
  EXPECT_EQ(again.mesh->facets[0].face, 0u);
  EXPECT_EQ(fingerprint(*again.mesh), fingerprint(*r.mesh));
}

TEST(OwnJson, NullStandsForACoordinateThatIsNotFinite) {
  const ReadResult r = read(R"({"circumball": 1, "dimension": 2, "vertices": [[0, null]]})", "x");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_TRUE(std::isnan(r.complex.vertices[0].y));
}

TEST(OwnJson, EverySurpriseIsADefectThatNamesThePath) {
  const std::string head = R"({"circumball": 1, "dimension": 2, "vertices": [[0,0],[1,0],[0,1]])";
  const struct {
    std::string text;
    const char* defect;
    const char* path;
  } cases[] = {
      {R"({"circumball": "1"})", "type", "circumball: "},
      {R"({"circumball": 2, "dimension": 2, "vertices": []})", "unsupported", "circumball: "},
      {R"({"circumball": 0})", "unsupported", "circumball: "},
      {R"({"circumball": 1})", "type", "\"dimension\" is missing"},
      {R"({"circumball": 1, "dimension": 4, "vertices": []})", "unsupported", "dimension: "},
      {R"({"circumball": 1, "dimension": 2.5, "vertices": []})", "type", "dimension: "},
      {R"({"circumball": 1, "dimension": 2})", "type", "\"vertices\" is missing"},
      {R"({"circumball": 1, "dimension": 2, "vertices": {}})", "type", "vertices: "},
      {R"({"circumball": 1, "dimension": 2, "vertices": [[1,2],[1]]})", "type", "vertices[1]: "},
      {R"({"circumball": 1, "dimension": 2, "vertices": [[1,2,3]]})", "type", "vertices[0]: "},
      {R"({"circumball": 1, "dimension": 2, "vertices": [[1,"2"]]})", "type", "vertices[0][1]: "},
      {head + R"(, "segments": 5})", "type", "segments: "},
      {head + R"(, "segments": [[0]]})", "type", "segments[0]: "},
      {head + R"(, "segments": [[0, 1.5]]})", "type", "segments[0][1]: "},
      {head + R"(, "holes": [[0]]})", "type", "holes[0]: "},
      {head + R"(, "regions": [{}]})", "type", "regions[0]: "},
      {head + R"(, "regions": [{"at": [0, 0], "label": []}]})", "type", "regions[0].label: "},
      {head + R"(, "regions": [{"at": [0, true]}]})", "type", "regions[0].at[1]: "},
      {head + R"(, "markers": []})", "type", "markers: "},
      {head + R"(, "markers": {"vertices": [1]}})", "wrong-length", "markers.vertices: "},
      {head + R"(, "markers": {"vertices": [1, 2, 3000000000]}})", "too-large",
       "markers.vertices[2]: "},
      {head + R"(, "faces": [[]]})", "type", "faces[0]: "},
      {head + R"(, "mesh": 1})", "type", "mesh: "},
      {head + R"(, "mesh": {"cells": [[0, 1]]}})", "type", "mesh.cells[0]: "},
      {head + R"(, "mesh": {"cells": [[0, 1, 7]]}})", "index-out-of-range", "mesh.cells[0][2]: "},
      {head + R"(, "mesh": {"cells": [], "cellRegions": [1]}})", "wrong-length",
       "mesh.cellRegions: "},
      {head + R"(, "mesh": {"cells": [], "vertexFeatures": [[0, 0]]}})", "wrong-length",
       "mesh.vertexFeatures: "},
      {head + R"(, "mesh": {"cells": [], "vertexFeatures": [[4, 0], [0, 0], [0, 0]]}})",
       "index-out-of-range", "mesh.vertexFeatures[0][0]: "},
      {head + R"(, "mesh": {"cells": [], "edges": [[0, 1]]}})", "type", "mesh.edges[0]: "},
      {head + R"(, "mesh": {"cells": [], "edges": [[0, 1, -2]]}})", "index-out-of-range",
       "mesh.edges[0][2]: "},
      {R"({"a": 1})", "unknown-format", "circumball"},
      {"{", "truncated", "line 1"},
      {"{\n\"circumball\": 1,\n\"vertices\": [[0, 0}", "syntax", "line 3"},
      {"{\"a\": nan}", "syntax", "line 1"},
      {"{\"a\": \"\xff\"}", "syntax", "line 1"},
      {head + "} trailing", "syntax", "line 1"},
  };
  for (const auto& c : cases) {
    const ReadResult r = read(c.text, "x");
    EXPECT_EQ(names(r), c.defect) << c.text;
    ASSERT_FALSE(r.defects.empty());
    EXPECT_NE(r.defects[0].message.find(c.path), std::string::npos) << c.text << "\n"
                                                                    << r.defects[0].message;
  }
}

TEST(OwnJson, IndicesOutOfRangeStaySoForCheckToTell) {
  const std::string head = R"({"circumball": 1, "dimension": 2, "vertices": [[0,0],[1,0],[0,1]])";
  const std::pair<const char*, std::uint32_t> cases[] = {{"3", 3},
                                                         {"-1", kNoIndex},
                                                         {"4294967295", kNoIndex},
                                                         {"4294967296", kNoIndex},
                                                         {"9223372036854775808", kNoIndex},
                                                         {"18446744073709551615", kNoIndex}};
  for (const auto& [text, index] : cases) {
    const ReadResult r = read(head + ", \"segments\": [[0, 1], [0, " + text + "]]}", "x");
    ASSERT_EQ(names(r), "") << text;
    EXPECT_EQ(r.complex.segments[1][1], index) << text;
    EXPECT_EQ(check_text(r.complex).find("index-out-of-range: segment 1 joins vertices 0 and "),
              0u);
  }
}

TEST(OwnJson, FacesThatReferToNothingAreTold) {
  const ReadResult r = read(R"({"circumball": 1, "dimension": 3,
    "vertices": [[0,0,0],[1,0,0],[0,1,0]], "segments": [[0, 1]],
    "faces": [{"loops": [[0, 1, 2]]},
              {"loops": [[0, 1, 9]], "segments": [1], "vertices": [-1], "holes": [[0, null, 0]]}]})",
                            "x");
  ASSERT_EQ(names(r), "");
  const std::string text = check_text(r.complex);
  for (const char* part : {"not-finite: hole seed 0 of face 1 ", "face 1 refers to vertex 9,",
                           "face 1 refers to vertex none,", "face 1 refers to segment 1,"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(text.find("face 0 refers"), std::string::npos) << text;
}

TEST(OwnJson, ANumberThatNoDoubleCanHoldIsInfiniteAndItsLineIsTold) {
  const ReadResult r = read(
      "{\"circumball\": 1, \"dimension\": 2, \"1e999 \\\" -1e999\": \"1e999\",\n"
      "\"vertices\": [[1e308, 0],\n[1e999, -1.5E+400], [2, 3]]}",
      "x");
  ASSERT_EQ(names(r), "(not-finite)");
  EXPECT_NE(r.defects[0].message.find("line 3: "), std::string::npos) << r.defects[0].message;
  ASSERT_EQ(r.complex.vertices.size(), 3u);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(r.complex.vertices[1], (Point3{kInfinity, -kInfinity, 0}));
  EXPECT_NE(check_text(r.complex).find("not-finite: vertex 1 has coordinates (inf, -inf)"),
            std::string::npos);
  // What else is wrong is found too, where it is.
  const ReadResult cut = read("{\"a\": [1e999,\n2,, 3]}", "x");
  ASSERT_EQ(names(cut), "(not-finite) syntax");
  EXPECT_NE(cut.defects[1].message.find("line 2: "), std::string::npos) << cut.defects[1].message;
}

TEST(OwnJson, OfAMeshWithAComplexThatRefersToNothingTheInputsVerticesAreKnown) {
  const ReadResult r = read(R"({"circumball": 1, "dimension": 2,
    "vertices": [[0,0],[1,0],[0,1],[0.5,0]], "segments": [[0, 1], [1, 4294967295], [2, 77]],
    "mesh": {"cells": [[0,3,2],[3,1,2]], "vertexFeatures": [[0,0],[0,1],[0,2],[1,0]]}})",
                            "x");
  ASSERT_EQ(names(r), "");
  EXPECT_EQ(r.complex.vertices.size(), 3u);
  EXPECT_EQ(r.mesh->vertices.size(), 4u);
}

TEST(OwnJson, AllDefectsOfTheSegmentsAreListed) {
  EXPECT_EQ(names(read(R"({"circumball": 1, "dimension": 2, "vertices": [[0,0]],
                           "segments": [[0,5],[0,0],[7],["a","b"]]})",
                       "x")),
            "type type type");
}

TEST(OwnJson, DeepNestingIsRefusedBeforeItIsBuilt) {
  for (const std::string open : {"[", "{\"a\":"}) {
    std::string text = "{\"circumball\": ";
    for (int i = 0; i < 100000; ++i) text += open;
    EXPECT_EQ(names(read(text, "x")), "too-large");
  }
}

TEST(OwnJson, WritingGivesTheContractsObject) {
  const ReadResult r = read(kContract, "a.json");
  std::string error;
  const std::string text = write_complex(r.complex, ".json", &error)[0].bytes;
  EXPECT_EQ(text, R"({
  "circumball": 1,
  "dimension": 2,
  "vertices": [
    [0, 0], [1, 0]
  ],
  "segments": [
    [0, 1], [1, 0]
  ],
  "holes": [
    [0.5, 0.25]
  ],
  "regions": [
    {"at": [0.1, 0.2], "label": 1, "max": 0.1}
  ],
  "markers": {
    "vertices": [
      1, 2
    ],
    "segments": [
      4, 5
    ]
  }
}
)");
}

TEST(GeoJson, EveryGeometryIsLineWorkInThePlane) {
  const ReadResult r = read(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"a": 1}, "geometry": {"type": "Polygon", "coordinates":
      [[[0,0],[10,0],[10,10],[0,10],[0,0]], [[2,2],[4,2],[4,4],[2,2]]]}},
    {"type": "Feature", "geometry": null},
    {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
      {"type": "Point", "coordinates": [5, 5, 100]},
      {"type": "MultiPoint", "coordinates": [[6, 6], [7, 7]]},
      {"type": "LineString", "coordinates": [[0,0],[-1,-1],[-2,0]]},
      {"type": "MultiLineString", "coordinates": [[[20,0],[21,0]],[[21,0],[22,0]]]}]}},
    {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates":
      [[[[10,0],[20,0],[10,10],[10,0]]]]}}]})",
                            "map.geojson");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.format, "geojson");
  EXPECT_EQ(r.complex.hole_rule, HoleRule::kParity);
  // 4 + 3 corners, 3 points, 2 more on the line, 3 on the lines of which 20,0 is shared with the
  // last polygon.
  EXPECT_EQ(r.complex.vertices.size(), 15u);
  // 4 + 3, 2, 2, and of the last polygon's 3 the shared side 10,0 - 10,10 is there already.
  EXPECT_EQ(r.complex.segments.size(), 13u);
}

TEST(GeoJson, MalformedDocumentsAreNamed) {
  const struct {
    const char* text;
    const char* defect;
  } cases[] = {
      {R"({"type": 5})", "type"},
      {R"({"type": "Circle", "coordinates": []})", "unknown-format"},
      {R"({"type": "Polygon"})", "type"},
      {R"({"type": "Polygon", "coordinates": [[0, 0]]})", "type"},
      {R"({"type": "Point", "coordinates": [0]})", "type"},
      {R"({"type": "Point", "coordinates": ["0", 0]})", "type"},
      {R"({"type": "FeatureCollection"})", "type"},
      {R"({"type": "FeatureCollection", "features": []})", "empty"},
  };
  for (const auto& c : cases) EXPECT_EQ(names(read(c.text, "x")), c.defect) << c.text;
}

}  // namespace
}  // namespace circumball
