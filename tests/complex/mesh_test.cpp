#include "circumball/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace circumball {
namespace {

Mesh square() {
  Mesh m;
  m.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  m.cells = {0, 1, 2, 0, 2, 3};
  return m;
}

TEST(Fingerprint, IsFnv1aOverCountsCoordinatesAndSortedCells) {
  // The offset basis of FNV-1a 64, after eight zero bytes: no vertices, no cells.
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (int i = 0; i < 8; ++i) hash *= 0x100000001b3u;
  char expected[17];
  std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(hash));
  EXPECT_EQ(fingerprint(Mesh()), expected);
  // The bytes of cli.md, laid out by an independent script.
  EXPECT_EQ(fingerprint(square()), "956fab5830f8cfe1");
}

TEST(Fingerprint, DoesNotDependOnTheOrderOfCellsAndCorners) {
  Mesh m = square();
  m.cells = {2, 3, 0, 1, 2, 0};
  EXPECT_EQ(fingerprint(m), fingerprint(square()));
}

TEST(Fingerprint, DependsOnNumberingBitsAndCells) {
  Mesh renumbered = square();
  std::swap(renumbered.vertices[0], renumbered.vertices[1]);
  Mesh negative_zero = square();
  negative_zero.vertices[0].x = -0.0;
  Mesh fewer = square();
  fewer.cells.resize(3);
  Mesh other_diagonal = square();
  other_diagonal.cells = {0, 1, 3, 1, 2, 3};
  for (const Mesh& m : {renumbered, negative_zero, fewer, other_diagonal})
    EXPECT_NE(fingerprint(m), fingerprint(square()));
}

TEST(Fingerprint, OfThePlaneIgnoresZ) {
  Mesh m = square();
  m.vertices[2].z = 5;
  EXPECT_EQ(fingerprint(m), fingerprint(square()));
}

TEST(Compact, DropsVerticesOfNoCellAndKeepsTheOrderOfTheRest) {
  Mesh m;
  m.vertices = {{9, 9, 0}, {0, 0, 0}, {1, 0, 0}, {8, 8, 0}, {0, 1, 0}};
  m.input_vertices = 2;
  m.box_vertices = 2;
  m.cells = {1, 2, 4};
  m.vertex_features = {{FeatureKind::kVertex, 0},
                       {FeatureKind::kVertex, 1},
                       {FeatureKind::kVertex, 2},
                       {FeatureKind::kVertex, 3},
                       {FeatureKind::kFree, kNoIndex}};
  m.vertex_markers = {1, 2, 3, 4, 5};
  m.attributes_per_vertex = 2;
  m.vertex_attributes = {0, 1, 10, 11, 20, 21, 30, 31, 40, 41};
  m.edges = {{0, 1, 7}, {1, 2, 8}, {2, 4, kNoIndex}};
  m.edge_markers = {1, 2, 3};
  const Mesh c = compact(m);
  EXPECT_EQ(c.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(c.cells, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(c.input_vertices, 1u);
  EXPECT_EQ(c.box_vertices, 1u);
  EXPECT_EQ(c.vertex_features[0], (Feature{FeatureKind::kVertex, 1}));
  EXPECT_EQ(c.vertex_markers, (std::vector<std::int32_t>{2, 3, 5}));
  EXPECT_EQ(c.vertex_attributes, (std::vector<double>{10, 11, 20, 21, 40, 41}));
  ASSERT_EQ(c.edges.size(), 2u);
  EXPECT_EQ(c.edges[0].a, 0u);
  EXPECT_EQ(c.edges[0].segment, 8u);
  EXPECT_EQ(c.edges[1].b, 2u);
  EXPECT_EQ(c.edge_markers, (std::vector<std::int32_t>{2, 3}));
}

TEST(Compact, LeavesAMeshThatUsesEveryVertexAsItIs) {
  EXPECT_EQ(fingerprint(compact(square())), fingerprint(square()));
}

}  // namespace
}  // namespace circumball
