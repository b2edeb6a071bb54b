#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "support/complexes.h"
#include "support/interiors.h"

namespace circumball {
namespace {

using testing::Random;
using testing::Simplex;
using Pair = std::array<std::uint32_t, 2>;

/// Adds a segment for every side of a face that has none.
void list_sides(Complex* c) {
  std::set<Pair> have;
  for (const auto& s : c->segments) have.insert({std::min(s[0], s[1]), std::max(s[0], s[1])});
  for (const Face& face : c->faces)
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
        if (a != b && have.insert({std::min(a, b), std::max(a, b)}).second)
          c->segments.push_back({a, b});
      }
}
Complex make(const std::vector<Point3>& points,
             const std::vector<std::vector<std::uint32_t>>& loops,
             const std::vector<Pair>& segments = {}) {
  Complex c;
  c.dimension = 3;
  c.vertices = points;
  c.segments = segments;
  for (const auto& loop : loops) c.faces.push_back({{loop}, {}, {}, {}});
  list_sides(&c);
  return c;
}
const std::vector<Point3> kSquare = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
Complex square_and(const std::vector<Point3>& more, const std::vector<Pair>& segments = {}) {
  std::vector<Point3> points = kSquare;
  points.insert(points.end(), more.begin(), more.end());
  return make(points, {{0, 1, 2, 3}}, segments);
}
/// A similarity with irrational rotation: what was planar is so no more, exactly.
Complex tilted(Complex c) {
  const auto turn = [](Point3* p) {
    const double x = 0.36 * p->x + 0.48 * p->y - 0.8 * p->z, y = -0.8 * p->x + 0.6 * p->y,
                 z = 0.48 * p->x + 0.64 * p->y + 0.6 * p->z;
    *p = {1.7 * x + 12.3, 1.7 * (0.28 * y - 0.96 * z) - 4.1, 1.7 * (0.96 * y + 0.28 * z) + 0.7};
  };
  for (Point3& p : c.vertices) turn(&p);
  for (Point3& p : c.holes) turn(&p);
  for (Region& r : c.regions) turn(&r.at);
  for (Face& face : c.faces)
    for (Point3& p : face.holes) turn(&p);
  return c;
}

std::string list(const std::vector<Defect>& all) {
  std::string text;
  for (const Defect& d : all) text += d.name + ": " + d.message + "\n";
  return text;
}
/// Names of all defects with the indices of their features.
using Found = std::multiset<std::pair<std::string, std::vector<std::uint32_t>>>;
Found found(const Complex& c) {
  Found all;
  for (const Defect& d : check(c)) {
    std::vector<std::uint32_t> indices;
    for (const Feature& f : d.features) indices.push_back(f.index);
    all.insert({d.name, indices});
    EXPECT_FALSE(d.message.empty());
    for (const Point3& p : d.at)
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << d.message;
  }
  return all;
}
void expect_found(const Complex& c, const Found& expected, const std::string& what) {
  EXPECT_EQ(found(c), expected) << what << "\n" << list(check(c));
}
/// In place and in a sloping plane, where exact coplanarity is lost.
void expect_both(const Complex& c, const Found& expected, const std::string& what) {
  expect_found(c, expected, what);
  expect_found(tilted(c), expected, what + ", tilted");
}

TEST(CheckInSpace, AcceptsWhateverIsALegalComplex) {
  expect_both(square_and({}), {}, "a square");
  Complex c = make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                   {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
  expect_both(c, {}, "a tetrahedron");
  // Coplanar neighbors, a dangling segment on each side, a free vertex, faces on both sides.
  c = make({{0, 0, 0},
            {4, 0, 0},
            {4, 4, 0},
            {0, 4, 0},
            {8, 0, 0},
            {8, 4, 0},
            {2, 2, 3},
            {4, 0, 3},
            {4, 4, -2},
            {1, 1, 1}},
           {{0, 1, 2, 3}, {1, 4, 5, 2}, {1, 2, 7}, {1, 2, 8}}, {{0, 6}, {5, 6}});
  expect_both(c, {}, "neighbors");
  // A face with a hole, filled by another face, a segment and a vertex inside.
  c = square_and({{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {3, 3, 0}, {2, 3, 0}, {3, 1, 0}},
                 {{8, 9}});
  c.faces[0].loops.push_back({4, 5, 6, 7});
  c.faces[0].holes = {{1.5, 1.5, 0}};
  c.faces[0].segments = {0};
  c.faces[0].vertices = {10};
  c.faces.push_back({{{4, 5, 6, 7}}, {}, {}, {}});
  list_sides(&c);
  expect_both(c, {}, "a filled hole");
  // A non-convex face and a segment across its mouth, in its plane but outside of it.
  c = make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 4}}, {{2, 4}});
  expect_both(c, {}, "a mouth");
  // Two faces that share two vertices, no side: a bow around a corner.
  c = make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}, {2, 9, 3}},
           {{0, 1, 2, 3, 4}, {2, 4, 5}});
  expect_both(c, {}, "two vertices in common");
  // Loops that share a vertex or a side.
  c = square_and({{1, 1, 0}, {1, 3, 0}, {0, 2, 0}});
  c.faces[0].loops[0] = {0, 1, 2, 3, 6};
  c.faces[0].loops.push_back({6, 4, 5});
  c.faces[0].holes = {{0.8, 2, 0}};
  c.segments.clear();
  list_sides(&c);
  expect_both(c, {}, "a hole that touches the outline");
  c = make({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}}, {{0, 1, 4, 5}});
  c.faces[0].loops.push_back({1, 2, 3, 4});
  list_sides(&c);
  expect_both(c, {}, "two loops side by side");
}

TEST(CheckInSpace, NamesFacesThatAreNoPolygons) {
  Complex c = square_and({});
  c.faces[0].loops = {};
  expect_both(c, {{"degenerate-face", {0}}}, "no loop");
  c.faces[0].loops = {{}};
  expect_both(c, {{"degenerate-face", {0}}}, "an empty loop");
  c.faces[0].loops = {{0, 1, 0, 1}};
  expect_both(c, {{"degenerate-face", {0}}}, "two vertices");
  expect_found(make({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}}),
               {{"degenerate-face", {0}},
                {"segments-overlap", {0, 2}},
                {"segments-overlap", {1, 2}},
                {"vertex-on-segment", {1, 2}}},
               "collinear");
  expect_both(make({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 4, 2}}),
              {{"loop-touches-itself", {0, 2}}}, "a loop that touches itself");
  expect_both(make(kSquare, {{0, 1, 3, 2}}), {{"segments-cross", {1, 3}}}, "an hourglass");
  c = make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 1e-6}}, {{0, 1, 2, 3}});
  const auto defects = check(c);
  ASSERT_EQ(defects.size(), 1u) << list(defects);
  EXPECT_EQ(defects[0].name, "non-planar-face");
  c.vertices[3].z = 1e-9;
  expect_found(c, {}, "planar enough");
  c = square_and({});
  c.segments.pop_back();
  expect_both(c, {{"side-without-segment", {0, 0, 3}}}, "a side that is no segment");
}

TEST(CheckInSpace, NamesWhatIsListedInAFaceAndNotInIt) {
  Complex c = square_and({{5, 1, 0}, {6, 1, 0}, {7, 2, 0}, {1, 1, 0}}, {{4, 5}});
  c.faces[0].segments = {0};
  c.faces[0].vertices = {6, 7};
  expect_both(c,
              {{"segment-not-in-face", {0, 0}},
               {"vertex-not-in-face", {0, 4}},
               {"vertex-not-in-face", {0, 5}},
               {"vertex-not-in-face", {0, 6}}},
              "outside");
  c = square_and({});
  c.faces[0].holes = {{9, 9, 0}};
  expect_both(c, {{"face-hole-outside", {0}}}, "a hole point outside");
  c.faces[0].holes = {{2, 2, 0}};
  expect_both(c, {{"degenerate-face", {0}}}, "a hole point that removes everything");
  c = square_and({{1, 1, 0}, {3, 1, 0}, {2, 3, 0}});
  c.faces[0].loops.push_back({4, 5, 6});
  list_sides(&c);
  c.faces[0].holes = {{2, 1, 0}, {2, 2, 0}};
  expect_found(c, {{"face-hole-outside", {0}}}, "a hole point on a side");
}

TEST(CheckInSpace, NamesSegmentsThatMeet) {
  const std::vector<Point3> cross = {{0, 0, 0}, {2, 2, 2}, {0, 2, 0}, {2, 0, 2}, {1, 1, 1}};
  Complex c = make({cross.begin(), cross.begin() + 4}, {}, {{0, 1}, {2, 3}});
  expect_found(c, {{"segments-cross", {0, 1}}}, "crossing");
  EXPECT_EQ(check(c)[0].at, (std::vector<Point3>{{1, 1, 1}}));
  expect_found(tilted(c), {{"segments-near", {0, 1}}}, "crossing, tilted: apart by rounding");
  c = make(cross, {}, {{0, 1}});
  expect_found(c, {{"vertex-on-segment", {4, 0}}}, "a vertex on a segment");
  expect_found(tilted(c), {{"vertex-near-segment", {4, 0}}}, "a vertex near a segment");
  expect_found(make(cross, {}, {{0, 1}, {4, 3}}), {{"vertex-on-segment", {4, 0}}}, "a T");
  expect_found(
      make({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {}, {{0, 2}, {1, 3}}),
      {{"segments-overlap", {0, 1}}, {"vertex-on-segment", {1, 0}}, {"vertex-on-segment", {2, 1}}},
      "overlap");
  expect_both(make({{0, 0, 0}, {1, 1, 1}}, {}, {{0, 1}, {1, 0}, {0, 0}}),
              {{"duplicate-segments", {0, 1}}, {"zero-length-segment", {2}}}, "duplicates");
  // In a face's plane, by number: exactly, whatever the plane.
  c = square_and({{1, 1, 0}, {3, 3, 0}, {3, 1, 0}, {1, 3, 0}, {2, 1, 0}}, {{4, 5}, {6, 7}, {4, 6}});
  c.faces[0].segments = {0, 1, 2};
  c.faces[0].vertices = {8};
  const auto in_plane = found(tilted(c));
  EXPECT_EQ(in_plane.count({"segments-cross", {0, 1}}), 1u) << list(check(tilted(c)));
}

TEST(CheckInSpace, NamesSegmentsAndVerticesThatMeetFaces) {
  expect_both(square_and({{1, 1, -1}, {1, 2, 3}}, {{4, 5}}), {{"segment-crosses-face", {0, 0}}},
              "a segment through a face");
  EXPECT_EQ(check(square_and({{1, 1, -1}, {1, 2, 1}}, {{4, 5}}))[0].at,
            (std::vector<Point3>{{1, 1.5, 0}}));
  expect_both(square_and({{5, 2, -1}, {5, 2, 1}}, {{4, 5}}), {}, "a segment beside a face");
  Complex c = square_and({{1, 2, 0}});
  expect_found(c, {{"vertex-in-face", {4, 0}}}, "a vertex in a face");
  expect_found(tilted(c), {{"vertex-near-face", {4, 0}}}, "a vertex in a face but for rounding");
  expect_found(square_and({{1, 1, 0}, {2, 2, 5}}, {{4, 5}}), {{"vertex-in-face", {4, 0}}},
               "a segment that touches a face");
  c = square_and({{2, 3, 0}, {1, 0.5, 0}, {3, 1.5, 0}}, {{0, 2}, {5, 6}});
  c.faces[0].vertices = {5, 6};
  expect_found(
      c, {{"segment-in-face", {0, 0}}, {"segment-in-face", {1, 0}}, {"vertex-in-face", {4, 0}}},
      "segments in a face that does not list them");
  c.vertices[4] = {9, 9, 9};
  expect_both(c, {{"segment-in-face", {0, 0}}, {"segment-in-face", {1, 0}}},
              "segments between members");
  c = square_and({{9, 2, 0}}, {{0, 4}});
  expect_found(c, {{"segment-in-face", {0, 0}}, {"segments-cross", {0, 2}}},
               "a segment from a corner through a face and out of it");
  // Through a side and through a corner: told of the segment and of the vertex.
  expect_found(square_and({{2, 0, -1}, {2, 0, 1}, {4, 4, -1}, {4, 4, 1}}, {{4, 5}, {6, 7}}),
               {{"segments-cross", {0, 2}}, {"vertex-on-segment", {2, 1}}}, "through the boundary");
}

TEST(CheckInSpace, NamesFacesThatMeet) {
  Complex c = make(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 2, -1}, {3, 2, -1}, {3, 2, 1}, {1, 2, 1}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_both(
      c,
      {{"faces-cross", {0, 1}}, {"segment-crosses-face", {5, 0}}, {"segment-crosses-face", {7, 0}}},
      "a face through a face");
  // Two squares that cross along their common diagonal, which neither lists: no segment tells.
  c = make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, -2}, {2, 2, 2}},
           {{0, 1, 2, 3}, {0, 4, 2, 5}});
  expect_both(c, {{"faces-cross", {0, 1}}}, "a common diagonal");
  c.faces[0].segments = c.faces[1].segments = {static_cast<std::uint32_t>(c.segments.size())};
  c.segments.push_back({0, 2});
  expect_both(c, {}, "a common segment");
  c.faces[1].segments = {};
  expect_both(c, {{"segment-in-face", {c.faces[0].segments[0], 1}}}, "listed in one of them");
  expect_both(make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3}, {2, 1, 0, 3}}),
              {{"duplicate-faces", {0, 1}}}, "the same face twice");
  // An inner loop without a hole point, filled by another face.
  c = square_and({{1, 1, 0}, {2, 1, 0}, {2.5, 2.5, 0}, {1, 2, 0}});
  c.faces[0].loops.push_back({4, 5, 6, 7});
  c.faces.push_back({{{4, 5, 6, 7}}, {}, {}, {}});
  list_sides(&c);
  expect_both(c, {{"faces-overlap", {0, 1}}}, "a hole that is not cut out");
  // Coplanar, sharing no vertex: exact where they are, nearly where rounding moved them.
  c = make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {9, 1, 0}, {1, 9, 0}},
           {{0, 1, 2}, {3, 4, 5}});
  const auto all = found(c);
  EXPECT_EQ(all.count({"faces-overlap", {0, 1}}), 1u) << list(check(c));
  EXPECT_FALSE(check(tilted(c)).empty());
}

/// Triangles and segments on points of a small lattice: every degenerate case comes up. The
/// expected names follow from the definition by looking at all pairs, in rationals.
TEST(CheckInSpace, FindsExactlyWhatTheDefinitionSays) {
  Random random(11);
  std::map<std::string, int> seen;
  for (int run = 0; run < 600; ++run) {
    std::vector<Point3> points;
    const std::uint32_t side = 3 + run % 2;
    while (points.size() < 8) {
      const auto x = [&] { return static_cast<double>(random.below(side)); };
      const Point3 p{x(), x(), x()};
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    const auto pick = [&](std::size_t n) {
      Simplex s;
      while (s.size() < n) {
        const std::uint32_t v = random.below(8);
        if (std::find(s.begin(), s.end(), v) == s.end()) s.push_back(v);
      }
      return s;
    };
    std::vector<std::vector<std::uint32_t>> loops;
    std::set<std::set<std::uint32_t>> distinct;
    for (int k = 0; k < 3; ++k) {
      const Simplex t = pick(3);
      const Point3 &a = points[t[0]], &b = points[t[1]], &d = points[t[2]];
      const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
      const double vx = d.x - a.x, vy = d.y - a.y, vz = d.z - a.z;
      if (uy * vz == uz * vy && uz * vx == ux * vz && ux * vy == uy * vx) continue;
      if (distinct.insert({t[0], t[1], t[2]}).second) loops.push_back(t);
    }
    const Simplex s = pick(2);
    const Complex c = make(points, loops, {{s[0], s[1]}});
    Found expected;
    const auto apart = [&](const Simplex& x, const Simplex& y, double Point3::*z) {
      double low = -1, high = 9, least = 9, most = -1;  // saves most of the work
      for (const std::uint32_t v : x)
        least = std::min(least, points[v].*z), most = std::max(most, points[v].*z);
      low = least, high = most, least = 9, most = -1;
      for (const std::uint32_t v : y)
        least = std::min(least, points[v].*z), most = std::max(most, points[v].*z);
      return most < low || high < least;
    };
    const auto meet = [&](const Simplex& x, const Simplex& y) {
      if (apart(x, y, &Point3::x) || apart(x, y, &Point3::y) || apart(x, y, &Point3::z))
        return false;
      return testing::interiors_meet(points, x, y);
    };
    const auto segment = [&](std::uint32_t i) {
      return Simplex(c.segments[i].begin(), c.segments[i].end());
    };
    const auto expect = [&](const char* name, std::uint32_t i, std::uint32_t j) {
      expected.insert({name, {i, j}});
      ++seen[name];
    };
    for (std::uint32_t v = 0; v < 8; ++v) {
      for (std::uint32_t i = 0; i < c.segments.size(); ++i)
        if (meet({v}, segment(i))) expect("vertex-on-segment", v, i);
      for (std::uint32_t f = 0; f < c.faces.size(); ++f)
        if (meet({v}, c.faces[f].loops[0])) expect("vertex-in-face", v, f);
    }
    for (std::uint32_t i = 0; i < c.segments.size(); ++i) {
      for (std::uint32_t j = i + 1; j < c.segments.size(); ++j)
        if (meet(segment(i), segment(j))) expect("segments-meet", i, j);
      for (std::uint32_t f = 0; f < c.faces.size(); ++f)
        if (meet(segment(i), c.faces[f].loops[0])) expect("segment-meets-face", i, f);
    }
    for (std::uint32_t f = 0; f < c.faces.size(); ++f)
      for (std::uint32_t g = f + 1; g < c.faces.size(); ++g)
        if (meet(c.faces[f].loops[0], c.faces[g].loops[0])) expect("faces-meet", f, g);
    Found actual;
    for (const auto& item : found(c)) {
      std::string name = item.first;
      if (name == "segments-cross" || name == "segments-overlap") name = "segments-meet";
      if (name == "segment-crosses-face" || name == "segment-in-face") name = "segment-meets-face";
      if (name == "faces-cross" || name == "faces-overlap") name = "faces-meet";
      actual.insert({name, item.second});
    }
    ASSERT_EQ(actual, expected) << "run " << run << "\n" << list(check(c));
  }
  EXPECT_EQ(seen.size(), 5u);
  for (const auto& item : seen) EXPECT_GT(item.second, 20) << item.first;
}

/// Walls of a lattice of boxes with cells of uneven sizes, some left out; with floors that are
/// divided, merged into larger non-convex faces, or hold segments and vertices.
Complex random_walls(Random* random) {
  const std::uint32_t n = 3;
  Complex c;
  c.dimension = 3;
  double at[3][4];
  for (auto& row : at) {
    row[0] = 0;
    for (std::uint32_t i = 1; i <= n; ++i) row[i] = row[i - 1] + 0.3 + random->unit();
  }
  const auto id = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return (i * (n + 1) + j) * (n + 1) + k;
  };
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t k = 0; k <= n; ++k) c.vertices.push_back({at[0][i], at[1][j], at[2][k]});
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t k = 0; k < n; ++k) {
          const auto corner = [&](std::uint32_t x, std::uint32_t y) {
            return axis == 0   ? id(i, j + x, k + y)
                   : axis == 1 ? id(j + x, i, k + y)
                               : id(j + x, k + y, i);
          };
          const std::uint32_t what = random->below(8);
          if (what < 3) continue;
          Face face;
          face.loops = {{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}};
          if (what >
              4) {  // a vertex inside, or a segment from a corner to it, or a triangle cut out
            const Point3 p = c.vertices[corner(0, 0)], q = c.vertices[corner(1, 1)];
            const auto inside = [&](double u, double v) {
              const auto mix = [](double a, double b, double f) { return a + f * (b - a); };
              const auto w = static_cast<std::uint32_t>(c.vertices.size());
              Point3 m = {mix(p.x, q.x, u), mix(p.y, q.y, axis == 0 ? u : v), mix(p.z, q.z, v)};
              c.vertices.push_back(m);
              return w;
            };
            const std::uint32_t a = inside(0.3, 0.2);
            if (what == 5) face.vertices = {a};
            if (what == 6) {
              face.segments = {static_cast<std::uint32_t>(c.segments.size())};
              c.segments.push_back({corner(0, 0), a});
            }
            if (what == 7) {
              const std::uint32_t b = inside(0.7, 0.3), d = inside(0.4, 0.6);
              face.loops.push_back({a, b, d});
              const Point3 &x = c.vertices[a], &y = c.vertices[b], &z = c.vertices[d];
              face.holes = {{(x.x + y.x + z.x) / 3, (x.y + y.y + z.y) / 3, (x.z + y.z + z.z) / 3}};
            }
          }
          c.faces.push_back(face);
        }
  list_sides(&c);
  return c;
}

TEST(CheckInSpace, FindsNothingInRandomValidComplexesUprightOrTilted) {
  Random random(5);
  for (int run = 0; run < 40; ++run) {
    const Complex c = random_walls(&random);
    expect_both(c, {}, "walls");
  }
}

TEST(CheckInSpace, FindsOneFaceThatIsAddedToAValidComplexWrongly) {
  Random random(6);
  for (int run = 0; run < 40; ++run) {
    Complex c = random_walls(&random);
    const auto v = static_cast<std::uint32_t>(c.vertices.size());
    for (int k = 0; k < 3; ++k)
      c.vertices.push_back({-1 + 5 * random.unit(), -1 + 5 * random.unit(), 5.0 * k - 3});
    c.faces.push_back({{{v, v + 1, v + 2}}, {}, {}, {}});
    list_sides(&c);
    const auto f = static_cast<std::uint32_t>(c.faces.size() - 1);
    const auto upright = found(c);
    EXPECT_EQ(upright, found(tilted(c))) << list(check(c)) << list(check(tilted(c)));
    for (const auto& item : upright)
      EXPECT_TRUE(item.second[1] == f || c.segments[item.second[0]][0] >= v ||
                  c.segments[item.second[0]][1] >= v);
  }
}

/// Adds the six faces of a box; `but` is left out.
void add_box(Complex* c, const Point3& lo, const Point3& hi, int but = -1) {
  const auto n = static_cast<std::uint32_t>(c->vertices.size());
  for (int i = 0; i < 8; ++i)
    c->vertices.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
  const std::uint32_t corners[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int f = 0; f < 6; ++f) {
    if (f == but) continue;
    Face face;
    face.loops.emplace_back();
    for (const std::uint32_t v : corners[f]) face.loops[0].push_back(n + v);
    c->faces.push_back(face);
  }
  list_sides(c);
}

TEST(CheckInSpace, WarnsOfSeedsThatAreEnclosedByNothing) {
  Complex c;
  c.dimension = 3;
  add_box(&c, {0, 0, 0}, {9, 9, 9});
  add_box(&c, {1, 1, 1}, {4, 4, 4});
  add_box(&c, {5, 5, 5}, {8, 8, 8}, 1);          // open, in the box
  add_box(&c, {10, 0, 0}, {12, 9, 9}, 3);        // open, outside
  c.faces.push_back({{{0, 8, 9}}, {}, {}, {}});  // a dangling wall between the boxes
  list_sides(&c);
  const auto seeds = [&](const std::vector<Point3>& at) {
    c.holes = at;
    return c;
  };
  expect_both(seeds({{0.5, 0.4, 0.7}, {2, 2, 2}, {6, 6, 6}, {8.5, 8.5, 8.5}, {1, 1, 8}}), {},
              "enclosed");
  expect_both(seeds({{11, 1, 1}}), {{"hole-outside", {}}}, "in an open box");
  expect_both(seeds({{-5, 1, 1}}), {{"hole-outside", {}}}, "far out");
  expect_both(seeds({{9.5, 1, 1}}), {{"hole-outside", {}}}, "between");
  expect_found(seeds({{9, 1, 1}}), {{"hole-outside", {5}}}, "on a face");
  expect_found(seeds({{9, 9, 1}}), {{"hole-outside", {11}}}, "on a segment");
  expect_both(seeds({c.vertices[3]}), {{"hole-outside", {3}}}, "on a vertex");
  c.holes.clear();
  c.regions = {{{11, 1, 1}, 1, 0}, {{3, 3, 3}, 2, 0}};
  expect_both(c, {{"region-outside", {}}}, "regions");
}

TEST(SmallestAngle, InSpaceIsOfSegmentsAndFacesAndBoth) {
  const auto angle = [](const Complex& c) {
    EXPECT_NEAR(smallest_angle_degrees(c), smallest_angle_degrees(tilted(c)), 1e-9);
    return smallest_angle_degrees(c);
  };
  const double degrees = 3.1415926535897931 / 180;
  EXPECT_EQ(angle(make({{0, 0, 0}, {1, 1, 1}}, {}, {{0, 1}})), 180);
  EXPECT_NEAR(angle(square_and({})), 90, 1e-12);
  EXPECT_NEAR(angle(make({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3) / 2, 0}}, {{0, 1, 2}})), 60,
              1e-9);
  // A wedge of ten degrees between squares: their sides at the ends of the axis make the same.
  const double x = 4 * std::cos(10 * degrees), z = 4 * std::sin(10 * degrees);
  EXPECT_NEAR(angle(make({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {x, 0, z}, {x, 4, z}},
                         {{0, 1, 2, 3}, {0, 4, 5, 3}})),
              10, 1e-9);
  // A side of one face leans over the other: closer than the faces' ten degrees.
  const Complex lean = make({{0, 0, 0}, {0, 9, 0}, {4, 0, 0}, {x, 9, z}}, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_NEAR(angle(lean), std::asin(z / std::sqrt(4 * 4 + 9 * 9)) / degrees, 1e-9);
  // A segment from inside a face, at twenty degrees.
  Complex c =
      square_and({{2, 2, 0}, {2 + std::cos(20 * degrees), 2, std::sin(20 * degrees)}}, {{4, 5}});
  c.faces[0].vertices = {4};
  EXPECT_NEAR(angle(c), 20, 1e-9);
  c.faces[0].vertices = {};
  EXPECT_NEAR(angle(c), 90, 1e-9) << "not of the face: no angle";
  // From a corner of a face, over its inside (thirty degrees); away from it (to the sides: 125).
  c = square_and({{1, 1, std::sqrt(2) * std::tan(30 * degrees)}}, {{0, 4}});
  EXPECT_NEAR(angle(c), 30, 1e-9);
  c.vertices[4] = {-1, -1, 1};
  EXPECT_NEAR(angle(c), 90, 1e-9);
  // What is perpendicular has a shadow of rounding only, whose direction means nothing.
  for (int i = 1; i < 50; ++i) {
    const double t = 0.1 * i;
    c = make({{0, 0, 0}, {t, 0, 0}, {t, 0, 1}, {2 * t, 0, 1}, {2 * t, 0, 3}, {0, 0, 3}, {t, 2, 1}},
             {{0, 1, 2, 3, 4, 5}}, {{2, 6}});
    const double sharpest = std::atan(t / 3) / degrees;
    EXPECT_GE(angle(c), std::min(89.0, sharpest)) << i;
  }
}

TEST(SmallestAngle, InSpaceIsThatOfAllPairsOfSegmentsWithoutFaces) {
  Random random(13);
  for (int run = 0; run < 30; ++run) {
    Complex c;
    c.dimension = 3;
    const std::uint32_t n = 3 + random.below(200);
    double expected = 180;
    for (std::uint32_t i = 0; i <= n; ++i)
      c.vertices.push_back({random.unit(), random.unit(), random.unit()});
    for (std::uint32_t i = 1; i <= n; ++i) c.segments.push_back({0, i});
    for (std::uint32_t i = 1; i <= n; ++i)
      for (std::uint32_t j = 1; j < i; ++j)
        expected = std::min(
            expected, smallest_angle_degrees(make({c.vertices[0], c.vertices[i], c.vertices[j]}, {},
                                                  {{0, 1}, {0, 2}})));
    EXPECT_EQ(smallest_angle_degrees(c), expected);
  }
}

TEST(CheckInSpace, SurvivesWhateverIsRead) {
  Random random(9);
  const double values[] = {0,
                           1,
                           -1,
                           0.5,
                           1e-300,
                           1e300,
                           1e55,
                           -1e-45,
                           1e-9,
                           std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()};
  for (int run = 0; run < 3000; ++run) {
    Complex c;
    c.dimension = 3;
    const bool wild = run % 3 == 0;
    const std::uint32_t n = random.below(9);
    const auto number = [&] {
      return wild ? values[random.below(11)] : static_cast<double>(random.below(3));
    };
    const auto index = [&](std::uint32_t count) {
      return random.below(20) == 0 ? kNoIndex - random.below(3) : random.below(count + 1);
    };
    for (std::uint32_t i = 0; i < n; ++i) c.vertices.push_back({number(), number(), number()});
    for (std::uint32_t i = random.below(9); i > 0; --i) c.segments.push_back({index(n), index(n)});
    for (std::uint32_t i = random.below(5); i > 0; --i) {
      Face face;
      for (std::uint32_t k = random.below(4); k > 0; --k) {
        face.loops.emplace_back();
        for (std::uint32_t l = random.below(6); l > 0; --l) face.loops.back().push_back(index(n));
      }
      for (std::uint32_t k = random.below(3); k > 0; --k) face.segments.push_back(index(8));
      for (std::uint32_t k = random.below(3); k > 0; --k) face.vertices.push_back(index(n));
      for (std::uint32_t k = random.below(3); k > 0; --k)
        face.holes.push_back({number(), number(), number()});
      c.faces.push_back(face);
    }
    for (std::uint32_t k = random.below(3); k > 0; --k)
      c.holes.push_back({number(), number(), number()});
    for (std::uint32_t k = random.below(3); k > 0; --k)
      c.regions.push_back({{number(), number(), number()}, 1, number()});
    for (const Defect& d : check(c)) {
      EXPECT_FALSE(d.message.empty());
      for (const Feature& f : d.features)
        EXPECT_LT(f.index, f.kind == FeatureKind::kVertex    ? c.vertices.size()
                           : f.kind == FeatureKind::kSegment ? c.segments.size()
                                                             : c.faces.size());
    }
    smallest_angle_degrees(c);
    for (std::uint32_t f = 0; f <= c.faces.size(); ++f) triangulate_face(c, f);
  }
}

TEST(CheckInSpace, ListsNoMoreOfANameThanAskedFor) {
  Complex c = square_and({});
  for (int i = 0; i < 9; ++i) c.vertices.push_back({1, 1 + 0.1 * i, 0});
  std::size_t listed = 0;
  for (const Defect& d : check(c, 4)) listed += d.name == "vertex-in-face";
  EXPECT_EQ(listed, 5u) << "four, and one that counts the rest";
}

}  // namespace
}  // namespace circumball
