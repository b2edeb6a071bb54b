#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>

#include "circumball/io.h"
#include "circumball/predicates.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::files;
using io_test::folder;
using io_test::names;
using io_test::sample_complex_of_space_mesh;
using io_test::sample_space_complex;
using io_test::sample_space_mesh;

ReadOptions each_triangle() {
  ReadOptions options;
  options.merge_coplanar = false;
  return options;
}

Complex through(const Complex& complex, const std::string& extension) {
  std::string error;
  const auto output = write_complex(complex, extension, &error);
  EXPECT_EQ(error, "");
  if (output.empty()) return {};
  const ReadResult r = read(output[0].bytes, "a" + extension, nullptr, each_triangle());
  EXPECT_TRUE(r.ok()) << extension << ": " << names(r);
  return r.complex;
}

void expect_same_faces(const std::vector<Face>& a, const std::vector<Face>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].loops, b[i].loops);
    EXPECT_EQ(a[i].holes, b[i].holes);
    EXPECT_EQ(a[i].segments, b[i].segments);
    EXPECT_EQ(a[i].vertices, b[i].vertices);
  }
}

void expect_same_bits(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Point3)), 0);
}

TEST(SpaceComplexRoundTrip, PolyAndJsonKeepEverythingBitForBit) {
  const Complex c = sample_space_complex();
  for (const char* extension : {".poly", ".json"}) {
    const Complex back = through(c, extension);
    EXPECT_EQ(back.dimension, 3);
    expect_same_bits(back.vertices, c.vertices);
    EXPECT_EQ(back.segments, c.segments) << extension;
    expect_same_faces(back.faces, c.faces);
    EXPECT_EQ(back.holes, c.holes);
    EXPECT_EQ(back.hole_rule, c.hole_rule);
    ASSERT_EQ(back.regions.size(), c.regions.size());
    for (std::size_t i = 0; i < c.regions.size(); ++i) {
      EXPECT_EQ(back.regions[i].at, c.regions[i].at);
      EXPECT_EQ(back.regions[i].label, c.regions[i].label);
      EXPECT_EQ(back.regions[i].max, c.regions[i].max);
    }
    EXPECT_EQ(back.vertex_markers, c.vertex_markers);
    EXPECT_EQ(back.segment_markers, c.segment_markers);
    EXPECT_EQ(back.face_markers, c.face_markers);
  }
}

TEST(SpaceComplexRoundTrip, PolyKeepsAttributesAndSegmentsInAnyOrder) {
  Complex c = sample_space_complex();
  c.attributes_per_vertex = 1;
  for (std::size_t i = 0; i < c.vertices.size(); ++i)
    c.vertex_attributes.push_back(1.0 / (3 + static_cast<double>(i)));
  c.segment_markers.clear();
  c.face_markers.clear();
  Complex back = through(c, ".poly");
  EXPECT_EQ(back.vertex_attributes, c.vertex_attributes);
  EXPECT_EQ(back.segments, c.segments);
  EXPECT_TRUE(back.segment_markers.empty());
  // Where the faces alone give the segments, there are no facets but the faces.
  const Complex natural = through(back, ".json");
  c = Complex();
  c.dimension = 3;
  c.vertices = natural.vertices;
  c.faces = {natural.faces[1]};
  c.segments = {{2, 3}, {2, 12}, {3, 12}};
  std::string error;
  const std::string text = write_complex(c, ".poly", &error).at(0).bytes;
  EXPECT_NE(text.find("\n1 0\n1 0\n3 4 3 13\n0\n"), std::string::npos) << text;
  EXPECT_EQ(through(c, ".poly").segments, c.segments);
}

TEST(SpaceComplexRoundTrip, PolygonsAndLinesSurviveTheFormatsOfSurfaces) {
  Complex c = sample_space_complex();
  c.faces[0] = Face();
  c.faces[0].loops = {{0, 1, 2, 3}};
  for (const char* extension : {".smesh", ".off", ".obj", ".ply"}) {
    const Complex back = through(c, extension);
    expect_same_bits(back.vertices, c.vertices);
    expect_same_faces(back.faces, c.faces);
    const auto sorted = [](const Complex& complex) {
      auto out = complex.segments;
      for (auto& s : out)
        if (s[0] > s[1]) std::swap(s[0], s[1]);
      std::sort(out.begin(), out.end());
      return out;
    };
    EXPECT_EQ(sorted(back), sorted(c)) << extension;
  }
  EXPECT_EQ(through(c, ".smesh").face_markers, c.face_markers);
  EXPECT_EQ(through(c, ".smesh").segment_markers, c.segment_markers);
}

TEST(SpaceComplexRoundTrip, WhatAFormatCannotHoldIsSaid) {
  std::string error;
  for (const char* extension : {".smesh", ".off", ".obj", ".ply", ".svg", ".stl"}) {
    EXPECT_TRUE(write_complex(sample_space_complex(), extension, &error).empty()) << extension;
    EXPECT_NE(error.find(".poly"), std::string::npos) << error;
  }
  Complex broken = sample_space_complex();
  broken.faces[0].vertices = {99};
  EXPECT_TRUE(write_complex(broken, ".poly", &error).empty());
}

TEST(SpaceComplexRoundTrip, SidesThatNobodyListsAreSegments) {
  const ReadResult r = read(
      R"({"circumball": 1, "dimension": 3, "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
          "segments": [[1, 0], [2, 3]], "faces": [{"loops": [[0, 1, 2]]}, {"loops": [[0, 1, 3]]}],
          "markers": {"segments": [5, 6]}})",
      "a");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.segments, (std::vector<std::array<std::uint32_t, 2>>{
                                    {1, 0}, {2, 3}, {1, 2}, {0, 2}, {1, 3}, {0, 3}}));
  EXPECT_EQ(r.complex.segment_markers, (std::vector<std::int32_t>{5, 6, 0, 0, 0, 0}));
  EXPECT_EQ(through(r.complex, ".json").segments, r.complex.segments);
}

TEST(SpaceMeshRoundTrip, EleFamilyKeepsEverything) {
  const Mesh m = sample_space_mesh();
  const Complex c = sample_complex_of_space_mesh();
  std::string error;
  auto family = files(write_mesh(m, c, ".ele", {}, &error), "m");
  ASSERT_EQ(family.size(), 4u);
  ReadResult r = read(family.at("m.ele"), "m.ele", folder(family));
  ASSERT_TRUE(r.ok()) << names(r);
  ASSERT_TRUE(r.mesh.has_value());
  expect_same_bits(r.mesh->vertices, m.vertices);
  EXPECT_EQ(r.mesh->cells, m.cells);
  EXPECT_EQ(fingerprint(*r.mesh), fingerprint(m));
  EXPECT_EQ(r.mesh->cell_regions, m.cell_regions);
  EXPECT_EQ(r.mesh->vertex_features, m.vertex_features);
  EXPECT_EQ(r.mesh->input_vertices, m.input_vertices);
  EXPECT_EQ(r.mesh->box_vertices, m.box_vertices);
  EXPECT_EQ(r.mesh->vertex_markers, m.vertex_markers);
  EXPECT_EQ(r.mesh->vertex_attributes, m.vertex_attributes);
  EXPECT_EQ(r.mesh->edge_markers, m.edge_markers);
  ASSERT_EQ(r.mesh->edges.size(), m.edges.size());
  for (std::size_t i = 0; i < m.edges.size(); ++i) {
    EXPECT_EQ(r.mesh->edges[i].a, m.edges[i].a);
    EXPECT_EQ(r.mesh->edges[i].b, m.edges[i].b);
    EXPECT_EQ(r.mesh->edges[i].segment, m.edges[i].segment);
  }
  ASSERT_EQ(r.mesh->facets.size(), m.facets.size());
  for (std::size_t i = 0; i < m.facets.size(); ++i) {
    EXPECT_EQ(r.mesh->facets[i].a, m.facets[i].a);
    EXPECT_EQ(r.mesh->facets[i].b, m.facets[i].b);
    EXPECT_EQ(r.mesh->facets[i].c, m.facets[i].c);
    EXPECT_EQ(r.mesh->facets[i].face, m.facets[i].face);
  }
  EXPECT_EQ(r.complex.face_markers, (std::vector<std::int32_t>{17, 17, 0}));
  // With the complex beside it, that is the complex.
  family["m.poly"] = write_complex(c, ".poly", &error).at(0).bytes;
  r = read(family.at("m.ele"), "m.ele", folder(family));
  ASSERT_TRUE(r.ok()) << names(r);
  expect_same_bits(r.complex.vertices, c.vertices);
  EXPECT_EQ(r.complex.segments, c.segments);
  EXPECT_EQ(r.complex.segment_markers, c.segment_markers);
  EXPECT_EQ(r.complex.face_markers, c.face_markers);
  expect_same_faces(r.complex.faces, c.faces);
}

TEST(SpaceMeshRoundTrip, JsonKeepsEverythingButAttributes) {
  const Mesh m = sample_space_mesh();
  const Complex c = sample_complex_of_space_mesh();
  std::string error;
  const ReadResult r = read(write_mesh(m, c, ".json", {}, &error).at(0).bytes, "m.json");
  ASSERT_TRUE(r.ok()) << names(r);
  expect_same_bits(r.mesh->vertices, m.vertices);
  EXPECT_EQ(r.mesh->cells, m.cells);
  EXPECT_EQ(r.mesh->cell_regions, m.cell_regions);
  EXPECT_EQ(r.mesh->vertex_features, m.vertex_features);
  EXPECT_EQ(r.mesh->input_vertices, m.input_vertices);
  EXPECT_EQ(r.mesh->box_vertices, m.box_vertices);
  EXPECT_EQ(r.mesh->vertex_markers, m.vertex_markers);
  ASSERT_EQ(r.mesh->facets.size(), m.facets.size());
  for (std::size_t i = 0; i < m.facets.size(); ++i)
    EXPECT_EQ(r.mesh->facets[i].face, m.facets[i].face);
  for (std::size_t i = 0; i < m.edges.size(); ++i)
    EXPECT_EQ(r.mesh->edges.at(i).segment, m.edges[i].segment);
  expect_same_bits(r.complex.vertices, c.vertices);
  EXPECT_EQ(r.complex.segments, c.segments);
  expect_same_faces(r.complex.faces, c.faces);
  EXPECT_EQ(r.complex.face_markers, c.face_markers);
}

/// The lines between the one that begins with `begin` and the one that is `end`, parted by blanks.
std::string section(const std::string& text, const std::string& begin, const std::string& end) {
  std::istringstream lines(text);
  std::string line, out;
  bool inside = false;
  while (std::getline(lines, line)) {
    if (inside && line == end) return out;
    if (inside) out += (out.empty() ? "" : ", ") + line;
    inside = inside || line.rfind(begin, 0) == 0;
  }
  return inside ? out : "missing";
}

TEST(SpaceVtk, BothFormatsHaveTetrahedraFacetsAndLinesWithTheirFeatures) {
  std::string error;
  const Mesh m = sample_space_mesh();
  const Complex c = sample_complex_of_space_mesh();
  const std::string xml = write_mesh(m, c, ".vtu", {}, &error).at(0).bytes;
  const auto array = [&](const std::string& name) {
    const std::size_t from = xml.find("<CellData>");
    return section(name == "connectivity" || name == "types" || name == "feature_kind"
                       ? xml
                       : xml.substr(from),
                   name == "types"          ? "<DataArray type=\"UInt8\""
                   : name == "connectivity" ? "<DataArray type=\"Int64\" Name=\"connectivity\""
                   : name == "feature_kind" ? "<DataArray type=\"Int8\""
                   : name == "feature"      ? "<DataArray type=\"Int64\" Name=\"feature\""
                   : name == "marker"       ? "<DataArray type=\"Int32\""
                                            : "<DataArray type=\"Float64\" Name=\"region\"",
                   "</DataArray>");
  };
  EXPECT_EQ(array("connectivity"), "0 4 5 1, 0 2 5 4, 0 1 4, 0 4 2, 0 2 5, 0 1, 1 4, 4 2, 2 0");
  EXPECT_EQ(array("types"), "10, 10, 5, 5, 5, 3, 3, 3, 3");
  EXPECT_EQ(array("feature"), "-1, -1, 0, 0, -1, 0, 1, 1, -1");
  EXPECT_EQ(array("marker"), "0, 0, 17, 17, 0, 8, 0, -9, 1");
  EXPECT_EQ(array("region"), "1.5, 2, 0, 0, 0, 0, 0, 0, 0");
  EXPECT_EQ(array("feature_kind"), "0, 0, 0, 0, 1, 3");
  const std::string legacy = write_mesh(m, c, ".vtk", {}, &error).at(0).bytes;
  EXPECT_EQ(section(legacy, "CELLS 9 34", "CELL_TYPES 9"),
            "4 0 4 5 1, 4 0 2 5 4, 3 0 1 4, 3 0 4 2, 3 0 2 5, 2 0 1, 2 1 4, 2 4 2, 2 2 0");
  EXPECT_EQ(section(legacy.substr(legacy.find("CELL_DATA 9")), "SCALARS feature int 1",
                    "SCALARS marker int 1"),
            "LOOKUP_TABLE default, -1, -1, 0, 0, -1, 0, 1, 1, -1");
  EXPECT_NE(legacy.find("POINT_DATA 6\nSCALARS feature_kind int 1\nLOOKUP_TABLE default\n0\n"),
            std::string::npos);
}

TEST(SpaceMsh, BothVersionsHaveAGroupForEachRegionFaceAndSegment) {
  std::string error;
  Mesh m = sample_space_mesh();
  m.edge_markers.clear();
  m.cell_regions = {1, 2};
  WriteOptions old;
  old.msh_version = "2.2";
  const std::string text = write_mesh(m, {}, ".msh", old, &error).at(0).bytes;
  // Where a tag would be 0, groups are numbered from 1; names say which feature it is.
  EXPECT_EQ(section(text, "$PhysicalNames", "$EndPhysicalNames"),
            "7, 1 1 \"segment 0\", 1 2 \"segment 1\", 1 3 \"segment 2\", 2 1 \"face 0\", "
            "2 2 \"face 1\", 3 1 \"region 1\", 3 2 \"region 2\"");
  EXPECT_EQ(section(text, "$Elements", "$EndElements"),
            "9, 1 1 2 1 1 3 1, 2 1 2 2 2 1 2, 3 1 2 3 3 2 5, 4 1 2 3 3 5 3, 5 2 2 1 1 1 3 6, "
            "6 2 2 2 2 1 2 5, 7 2 2 2 2 1 5 3, 8 4 2 1 1 1 5 6 2, 9 4 2 2 2 1 3 6 5");
  const std::string marked =
      write_mesh(m, sample_complex_of_space_mesh(), ".msh", {}, &error).at(0).bytes;
  EXPECT_NE(marked.find("2 2 \"marker 17\""), std::string::npos) << marked;
  EXPECT_EQ(section(marked, "$Entities", "$EndEntities").substr(0, 7), "0 3 2 2");
  EXPECT_EQ(section(marked, "$Nodes", "$EndNodes").substr(0, 18), "1 6 1 6, 3 1 0 6, ");
  EXPECT_NE(section(marked, "$Elements", "$EndElements").find("3 1 4 1, 8 1 5 6 2, 3 2 4 1, 9 1"),
            std::string::npos);
}

TEST(SpaceMedit, HasReferencesCornersAndRidges) {
  std::string error;
  const std::string text =
      write_mesh(sample_space_mesh(), sample_complex_of_space_mesh(), ".mesh", {}, &error)
          .at(0)
          .bytes;
  EXPECT_EQ(section(text, "Dimension 3", "Vertices"), "");
  EXPECT_EQ(section(text, "Vertices", ""),
            "6, 0 0 0 3, 1 0 0 0, 0 1 0 -2, 9 9 9 0, 0.5 0.5 0 5, 0.1 0.2 1 6");
  EXPECT_EQ(section(text, "Edges", ""), "4, 1 2 8, 2 5 0, 5 3 -9, 3 1 1");
  EXPECT_EQ(section(text, "Triangles", ""), "3, 1 2 5 17, 1 5 3 17, 1 3 6 0");
  EXPECT_EQ(section(text, "Tetrahedra", ""), "2, 1 5 6 2 0, 1 3 6 5 2");
  EXPECT_EQ(section(text, "Corners", ""), "4, 1, 2, 3, 4");
  EXPECT_EQ(section(text, "Ridges", ""), "4, 1, 2, 3, 4");
  Mesh plain = sample_space_mesh();
  plain.edge_markers.clear();
  const std::string by_feature = write_mesh(plain, {}, ".mesh", {}, &error).at(0).bytes;
  EXPECT_EQ(section(by_feature, "Edges", ""), "4, 1 2 1, 2 5 2, 5 3 2, 3 1 0");
  EXPECT_EQ(section(by_feature, "Triangles", ""), "3, 1 2 5 1, 1 5 3 1, 1 3 6 0");
}

/// Every side of a closed surface is run through once in each direction.
bool closed(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  return std::all_of(sides.begin(), sides.end(), [&](const auto& s) {
    return s.second == 1 && sides.count({s.first[1], s.first[0]}) == 1;
  });
}

TEST(SpaceSurface, WithoutInputFacesItIsTheHullSeenFromOutside) {
  Mesh m = sample_space_mesh();
  m.facets.clear();
  m.edges.clear();
  for (std::size_t i = 0; i < m.cells.size(); i += 4)  // the sample's cells are positive
    ASSERT_EQ(orient3d(m.vertices[m.cells[i]], m.vertices[m.cells[i + 1]],
                       m.vertices[m.cells[i + 2]], m.vertices[m.cells[i + 3]]),
              Sign::kPositive);
  std::string error;
  for (const char* extension : {".off", ".obj", ".ply", ".stl"}) {
    const ReadResult r = read(write_mesh(m, {}, extension, {}, &error).at(0).bytes,
                              std::string("a") + extension, nullptr, each_triangle());
    ASSERT_TRUE(r.ok()) << extension << names(r);
    EXPECT_EQ(r.complex.vertices.size(), 5u);  // without the corner of the box
    std::vector<std::array<std::uint32_t, 3>> triangles;
    double volume = 0;
    for (const Face& face : r.complex.faces) {
      const auto& l = face.loops.at(0);
      triangles.push_back({l[0], l[1], l[2]});
      const Point3 &a = r.complex.vertices[l[0]], &b = r.complex.vertices[l[1]],
                   &c = r.complex.vertices[l[2]];
      volume += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                a.z * (b.x * c.y - b.y * c.x);
    }
    EXPECT_EQ(triangles.size(), 6u);
    EXPECT_TRUE(closed(triangles)) << extension;
    EXPECT_NEAR(volume, 1, 1e-12) << extension;  // six times the volume, counter-clockwise outside
  }
}

TEST(SpaceSurface, FacetsOnInputFacesAreTheSurfaceAndMergeAgain) {
  std::string error;
  for (const char* extension : {".off", ".obj", ".ply", ".stl"}) {
    Mesh m = sample_space_mesh();
    m.facets.pop_back();
    m.edges.clear();
    const std::string text = write_mesh(m, {}, extension, {}, &error).at(0).bytes;
    // In the plane z = 0: a complex of the plane, as files of polygons have always been read.
    EXPECT_EQ(read(text, "a").complex.dimension, 2) << extension;
    for (Point3& p : m.vertices) p = {p.x, p.z + 2, p.y};
    const ReadResult r = read(write_mesh(m, {}, extension, {}, &error).at(0).bytes, "a");
    ASSERT_TRUE(r.ok()) << names(r);
    ASSERT_EQ(r.complex.faces.size(), 1u);
    EXPECT_EQ(r.complex.faces[0].loops[0].size(), 4u);
  }
  const std::string ply = write_mesh(sample_space_mesh(), {}, ".ply", {}, &error).at(0).bytes;
  EXPECT_NE(ply.find("\n3 0 1 3 0\n3 0 3 2 0\n3 0 2 4 -1\n0 1 0\n1 3 1\n3 2 1\n2 0 -1\n"),
            std::string::npos)
      << ply;
}

TEST(SpaceWriters, EveryExtensionIsWrittenAlsoOfAnEmptyMesh) {
  std::string error;
  Mesh empty;
  empty.dimension = 3;
  for (const std::string& extension : mesh_extensions(3)) {
    for (const Mesh& m : {sample_space_mesh(), empty}) {
      const auto output = write_mesh(m, sample_complex_of_space_mesh(), extension, {}, &error);
      EXPECT_EQ(error, "");
      EXPECT_TRUE(std::any_of(output.begin(), output.end(),
                              [&](const OutputFile& f) { return f.extension == extension; }));
    }
  }
  Mesh broken = sample_space_mesh();
  broken.facets[0].c = 99;
  EXPECT_TRUE(write_mesh(broken, {}, ".vtu", {}, &error).empty());
}

}  // namespace
}  // namespace circumball
