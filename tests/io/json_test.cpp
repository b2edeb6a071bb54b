#include <gtest/gtest.h>

#include <cmath>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

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
      {head + R"(, "segments": [[0, 3]]})", "index-out-of-range", "segments[0][1]: "},
      {head + R"(, "segments": [[0, -1]]})", "index-out-of-range", "segments[0][1]: "},
      {head + R"(, "segments": [[0, 18446744073709551615]]})", "too-large", "segments[0][1]: "},
      {head + R"(, "segments": [[0, 4294967296]]})", "index-out-of-range", "segments[0][1]: "},
      {head + R"(, "holes": [[0]]})", "type", "holes[0]: "},
      {head + R"(, "regions": [{}]})", "type", "regions[0]: "},
      {head + R"(, "regions": [{"at": [0, 0], "label": []}]})", "type", "regions[0].label: "},
      {head + R"(, "regions": [{"at": [0, true]}]})", "type", "regions[0].at[1]: "},
      {head + R"(, "markers": []})", "type", "markers: "},
      {head + R"(, "markers": {"vertices": [1]}})", "wrong-length", "markers.vertices: "},
      {head + R"(, "markers": {"vertices": [1, 2, 3000000000]}})", "too-large",
       "markers.vertices[2]: "},
      {head + R"(, "faces": [[]]})", "type", "faces[0]: "},
      {head + R"(, "faces": [{"loops": [[9]]}]})", "index-out-of-range", "faces[0].loops[0][0]: "},
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
      {"{\"circumball\": 1, \"dimension\": 2, \"vertices\": [[1e999, 0]]}", "not-finite", "line 1"},
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

TEST(OwnJson, AllDefectsOfTheSegmentsAreListed) {
  EXPECT_EQ(names(read(R"({"circumball": 1, "dimension": 2, "vertices": [[0,0]],
                           "segments": [[0,5],[0,0],[7],["a","b"]]})",
                       "x")),
            "index-out-of-range type type type");
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
