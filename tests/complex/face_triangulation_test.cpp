#include "complex/face_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "circumball/complex.h"
#include "circumball/predicates.h"
#include "complex/face_plane.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::Random;
using Triangle = std::array<std::uint32_t, 3>;

/// A point of a sloping plane, rounded: polygons there are planar only nearly.
Point3 tilt(double u, double v) {
  return {0.3 + 0.36 * u + 0.8 * v, -1.7 + 0.48 * u - 0.6 * v, 5.1 + 0.8 * u};
}
Complex one_face(const std::vector<Point2>& points,
                 const std::vector<std::vector<std::uint32_t>>& loops, bool tilted) {
  Complex c;
  c.dimension = 3;
  for (const Point2& p : points)
    c.vertices.push_back(tilted ? tilt(p.x, p.y) : Point3{p.x, p.y, 2});
  c.faces.push_back({loops, {}, {}, {}});
  return c;
}
double area(const Complex& c, const Triangle& t) {
  const Point3 &p = c.vertices[t[0]], &q = c.vertices[t[1]], &r = c.vertices[t[2]];
  const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return 0.5 * std::sqrt(x * x + y * y + z * z);
}
double total_area(const Complex& c, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += area(c, t);
  return sum;
}

/// Whether the triangles are counter-clockwise in projection, fit together along their edges, and
/// have every side and segment of the face for an edge.
void expect_triangulation(const Complex& c, const std::vector<Triangle>& triangles) {
  const FaceProjection project = FaceProjection::along(FacePlane(c, 0).normal());
  const Face& face = c.faces[0];
  std::map<std::array<std::uint32_t, 2>, int> edges;
  std::set<std::uint32_t> used;
  for (const Triangle& t : triangles) {
    EXPECT_EQ(
        orient2d(project(c.vertices[t[0]]), project(c.vertices[t[1]]), project(c.vertices[t[2]])),
        Sign::kPositive);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ((++edges[{t[i], t[(i + 1) % 3]}]), 1) << "an edge has one triangle on a side";
      used.insert(t[i]);
    }
  }
  std::set<std::array<std::uint32_t, 2>> constraints;
  for (const auto& loop : face.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      constraints.insert({loop[i], loop[(i + 1) % loop.size()]});
  for (const std::uint32_t s : face.segments) constraints.insert(c.segments[s]);
  const auto has = [&](std::uint32_t a, std::uint32_t b) { return edges.count({a, b}) != 0; };
  const auto is_constraint = [&](std::uint32_t a, std::uint32_t b) {
    return constraints.count({a, b}) != 0 || constraints.count({b, a}) != 0;
  };
  for (const auto& e : constraints) EXPECT_TRUE(has(e[0], e[1]) || has(e[1], e[0]));
  for (const auto& [e, count] : edges)
    EXPECT_TRUE(is_constraint(e[0], e[1]) || has(e[1], e[0])) << "an inner edge has two";
  for (const std::uint32_t v : face.vertices) EXPECT_TRUE(used.count(v)) << v;
}

TEST(TriangulateFace, IsCounterClockwiseAboutTheNormalWhateverTheLoopsDirection) {
  for (const bool reversed : {false, true}) {
    std::vector<std::uint32_t> loop = {0, 1, 2, 3};
    if (reversed) std::reverse(loop.begin(), loop.end());
    const Complex c = one_face({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {loop}, true);
    const auto triangles = triangulate_face(c, 0);
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_NEAR(total_area(c, triangles), 4, 1e-12);
    const FacePlane plane(c, 0);
    for (const Triangle& t : triangles) {
      const Point2 p = plane.to_plane(c.vertices[t[0]]), q = plane.to_plane(c.vertices[t[1]]),
                   r = plane.to_plane(c.vertices[t[2]]);
      EXPECT_EQ(orient2d(p, q, r), Sign::kPositive);
    }
    expect_triangulation(c, triangles);
  }
}

TEST(TriangulateFace, CutsOutWhatAHolePointLiesInAndNothingElse) {
  for (const bool tilted : {false, true}) {
    Complex c = one_face({{0, 0},
                          {9, 0},
                          {9, 9},
                          {0, 9},
                          {1, 1},
                          {4, 1},
                          {4, 4},
                          {1, 4},
                          {2, 2},
                          {3, 2},
                          {3, 3},
                          {2, 3},
                          {6, 6},
                          {8, 6},
                          {8, 8},
                          {6, 8},
                          {1, 7}},
                         {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}}, tilted);
    c.faces[0].vertices = {16};
    c.segments = {{16, 3}, {16, 15}};
    c.faces[0].segments = {0, 1};
    auto triangles = triangulate_face(c, 0);
    EXPECT_NEAR(total_area(c, triangles), 81, 1e-11) << "inner loops alone cut nothing";
    expect_triangulation(c, triangles);
    const auto hole = [&](double u, double v) { return tilted ? tilt(u, v) : Point3{u, v, 2}; };
    c.faces[0].holes = {hole(1.5, 1.5)};
    triangles = triangulate_face(c, 0);
    EXPECT_NEAR(total_area(c, triangles), 81 - 8, 1e-11) << "the ring only";
    expect_triangulation(c, triangles);
    c.faces[0].holes = {hole(1.5, 1.5), hole(7, 7), hole(7.1, 7.1), hole(-1, 0)};
    triangles = triangulate_face(c, 0);
    EXPECT_NEAR(total_area(c, triangles), 81 - 8 - 4, 1e-11);
    expect_triangulation(c, triangles);
  }
}

TEST(TriangulateFace, CoversCombsAndSpiralsOfTenThousandVertices) {
  const std::uint32_t teeth = 2500;
  std::vector<Point2> comb;  // thin teeth: nearly every side is missing in the Delaunay
  std::vector<std::uint32_t> loop;
  for (std::uint32_t i = 0; i < teeth; ++i) {
    comb.push_back({i * 1.0, 0});
    comb.push_back({i + 0.5, 300.0 + i % 7});
  }
  comb.push_back({teeth - 0.5, 1000});
  comb.push_back({-0.5, 1000});
  double twice = 0;
  for (std::uint32_t i = 0; i < comb.size(); ++i) {
    const Point2 &p = comb[i], &q = comb[(i + 1) % comb.size()];
    twice += p.x * q.y - p.y * q.x;
    loop.push_back(i);
  }
  const Complex c = one_face(comb, {loop}, true);
  const auto triangles = triangulate_face(c, 0);
  EXPECT_EQ(triangles.size(), comb.size() - 2);
  EXPECT_NEAR(total_area(c, triangles) / (0.5 * twice), 1, 1e-11);

  std::vector<Point2> spiral;
  const std::uint32_t arm = 5000;
  for (std::uint32_t i = 0; i < arm; ++i)
    spiral.push_back(testing::polar(0, 0, 1 + i * 0.002, i * 3.7));
  for (std::uint32_t i = arm; i-- > 0;)
    spiral.push_back(testing::polar(0, 0, 1 + i * 0.002 + 0.08, i * 3.7 + 1));
  loop.clear();
  for (std::uint32_t i = 0; i < spiral.size(); ++i) loop.push_back(i);
  EXPECT_EQ(triangulate_face(one_face(spiral, {loop}, true), 0).size(), spiral.size() - 2);
}

TEST(TriangulateFace, HoldsForRandomFacesWithLoopsSegmentsAndVertices) {
  Random random(7);
  int found = 0;
  for (int run = 0; run < 300; ++run) {
    // A star-shaped outline on a circle of cells, cells of a grid in it as loops, and random
    // segments between random points: those that would cross others are left out by trial.
    const std::uint32_t n = 3 + random.below(12);
    std::vector<Point2> points;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t i = 0; i < n; ++i) {
      points.push_back(testing::polar(0, 0, 1 + random.unit(), 360.0 * i / n));
      loop.push_back(i);
    }
    const bool tilted = run % 2 == 1;
    Complex c = one_face(points, {loop}, tilted);
    double expected = total_area(c, triangulate_face(c, 0));
    ASSERT_GT(expected, 0);
    for (int k = 0; k < 20; ++k) {
      Complex next = c;
      const auto add = [&](double x, double y) {
        next.vertices.push_back(tilted ? tilt(x, y) : Point3{x, y, 2});
        return static_cast<std::uint32_t>(next.vertices.size() - 1);
      };
      const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
      const std::uint32_t v = add(x, y);
      if (k % 3 == 0) {
        next.faces[0].vertices.push_back(v);
      } else if (k % 3 == 1) {
        next.faces[0].segments.push_back(static_cast<std::uint32_t>(next.segments.size()));
        next.segments.push_back({v, random.below(v)});
      } else {
        next.faces[0].loops.push_back({v, add(x + 0.1, y), add(x, y + 0.1)});
      }
      const FaceLayout layout(next, 0, FaceProjection::along(FacePlane(next, 0).normal()), {});
      if (!is_planar(layout)) continue;
      const FaceTriangles parts = triangulate(layout);
      if (!parts.members_outside.empty() || !parts.edges_outside.empty()) continue;
      if (std::fabs(total_area(next, parts.triangles) - expected) > 1e-9) continue;  // outside loop
      c = next;
      ++found;
    }
    const auto triangles = triangulate_face(c, 0);
    expect_triangulation(c, triangles);
    EXPECT_NEAR(total_area(c, triangles), expected, 1e-9);
  }
  EXPECT_GT(found, 2000);
}

TEST(TriangulateFace, IsEmptyForFacesThatHaveNoTriangles) {
  const std::vector<Point2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}};
  EXPECT_TRUE(triangulate_face(one_face(square, {}, false), 0).empty());
  EXPECT_TRUE(triangulate_face(one_face(square, {{}}, false), 0).empty());
  EXPECT_TRUE(triangulate_face(one_face(square, {{0, 1}}, false), 0).empty());
  EXPECT_TRUE(triangulate_face(one_face(square, {{0, 1, 4}}, false), 0).empty()) << "collinear";
  EXPECT_TRUE(triangulate_face(one_face(square, {{0, 2, 1, 3}}, false), 0).empty()) << "crosses";
  EXPECT_TRUE(triangulate_face(one_face(square, {{0, 1, 9}}, false), 0).empty()) << "no vertex 9";
  EXPECT_TRUE(triangulate_face(one_face(square, {{0, 1, 2}}, false), 1).empty()) << "no face 1";
  Complex c = one_face(square, {{0, 1, 2}}, false);
  c.faces[0].segments = {3};
  EXPECT_TRUE(triangulate_face(c, 0).empty()) << "no segment 3";
  c.faces[0].segments = {};
  c.vertices[1].x = std::nan("");
  EXPECT_TRUE(triangulate_face(c, 0).empty());
}

}  // namespace
}  // namespace circumball
