#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "circumball/feature_size.h"
#include "circumball/verify.h"
#include "predicates/elementary.h"
#include "support/complexes3.h"

namespace circumball {
namespace {

using testing::Builder3;
using testing::Random;

/// A complex and a mesh of it, to be verified.
struct Subject3 {
  Complex complex;
  Mesh mesh;
  VerifyOptions options;

  Check check(const std::string& name) const {
    VerifyOptions only = options;
    only.checks = {name};
    const std::vector<Check> all = verify(mesh, complex, only);
    return all.empty() ? Check{} : all[0];
  }
  std::set<std::string> failing() const {
    std::set<std::string> names;
    for (const Check& c : verify(mesh, complex, options))
      if (!c.ok) names.insert(c.name);
    return names;
  }
  std::string said() const {
    std::string text;
    for (const Check& c : verify(mesh, complex, options)) text += c.name + ": " + c.detail + "\n";
    return text;
  }
  /// The same mesh as somebody else would hand it in: without labels, not knowing its input.
  Subject3 foreign() const {
    Subject3 s = *this;
    s.mesh.input_vertices = s.mesh.box_vertices = 0;
    s.mesh.vertex_features.clear();
    s.mesh.edges.clear();
    s.mesh.facets.clear();
    return s;
  }
};

/// A cube of n x n x n unit cubes, each in six tetrahedra about a diagonal (Kuhn), which are
/// Delaunay, all cospherical. The complex is the cube with its faces and, where n is even, the
/// square in the middle, with a side of the cube's faces as its own; everything labeled.
Subject3 kuhn(std::uint32_t n, const testing::Rotation* turn = nullptr) {
  Subject3 s;
  Builder3 b;
  b.place({0, 0, 0}, turn);
  const double h = n;
  std::uint32_t c[8], m[4];
  for (std::uint32_t k = 0; k < 8; ++k)
    c[k] = b.vertex({k & 1 ? h : 0, k & 2 ? h : 0, k & 4 ? h : 0});
  for (std::uint32_t k = 0; k < 4; ++k) m[k] = b.vertex({k & 1 ? h : 0, k & 2 ? h : 0, h / 2});
  // The sides of the cube upright are cut by the middle square.
  const auto upright = [&](std::uint32_t p, std::uint32_t q) {
    b.face({c[p], c[q], m[q], c[q + 4], c[p + 4], m[p]}).segments.push_back(b.segment(m[p], m[q]));
  };
  b.face({c[0], c[1], c[3], c[2]});
  b.face({c[4], c[5], c[7], c[6]});
  upright(0, 1);
  upright(1, 3);
  upright(3, 2);
  upright(2, 0);
  b.face({m[0], m[1], m[3], m[2]});
  s.complex = b.complex();

  Mesh& mesh = s.mesh;
  mesh.dimension = 3;
  mesh.vertices = s.complex.vertices;
  mesh.input_vertices = 12;
  const auto features = [&](std::uint32_t index) { return Feature{FeatureKind::kVertex, index}; };
  for (std::uint32_t k = 0; k < 12; ++k) mesh.vertex_features.push_back(features(k));
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  for (std::uint32_t k = 0; k < 8; ++k)
    number[{k & 1 ? n : 0, k & 2 ? n : 0, k & 4 ? n : 0}] = c[k];
  for (std::uint32_t k = 0; k < 4; ++k) number[{k & 1 ? n : 0, k & 2 ? n : 0, n / 2}] = m[k];
  std::vector<std::array<std::uint32_t, 3>> at(12);
  for (const auto& entry : number) at[entry.second] = entry.first;
  const auto vertex = [&](const std::array<std::uint32_t, 3>& p) {
    const auto [it, is_new] = number.try_emplace(p, static_cast<std::uint32_t>(at.size()));
    if (is_new) {
      at.push_back(p);
      mesh.vertices.push_back(b.placed({double(p[0]), double(p[1]), double(p[2])}));
      mesh.vertex_features.push_back({FeatureKind::kFree, kNoIndex});
    }
    return it->second;
  };
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (std::uint32_t x = 0; x < n; ++x)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t z = 0; z < n; ++z)
        for (int k = 0; k < 6; ++k) {
          std::array<std::uint32_t, 3> p = {x, y, z};
          std::uint32_t v[4] = {vertex(p), 0, 0, 0};
          for (int i = 0; i < 3; ++i) {
            ++p[static_cast<std::size_t>(kOrders[k][i])];
            v[i + 1] = vertex(p);
          }
          const bool even = k == 0 || k == 3 || k == 4;
          if (even) std::swap(v[2], v[3]);
          mesh.cells.insert(mesh.cells.end(), v, v + 4);
        }
  // Labels: what lies in a plane of a face, or on two of them.
  const auto inside = [&](std::uint32_t f, const std::array<std::uint32_t, 3>& p) {
    const std::uint32_t plane[7][2] = {{2, 0}, {2, n}, {1, 0}, {0, n}, {1, n}, {0, 0}, {2, n / 2}};
    return p[plane[f][0]] == plane[f][1];
  };
  const auto on_segment = [&](std::uint32_t k, std::uint32_t v) {
    const auto &p = at[s.complex.segments[k][0]], &q = at[s.complex.segments[k][1]];
    for (std::size_t i = 0; i < 3; ++i)
      if (at[v][i] < std::min(p[i], q[i]) || at[v][i] > std::max(p[i], q[i])) return false;
    return true;
  };
  for (std::uint32_t v = 12; v < mesh.vertices.size(); ++v) {
    for (std::uint32_t f = 0; f < 7; ++f)
      if (inside(f, at[v])) mesh.vertex_features[v] = {FeatureKind::kFace, f};
    for (std::uint32_t k = 0; k < s.complex.segments.size(); ++k)
      if (on_segment(k, v)) mesh.vertex_features[v] = {FeatureKind::kSegment, k};
  }
  std::set<std::array<std::uint32_t, 2>> edges;
  std::set<std::array<std::uint32_t, 3>> facets;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    std::array<std::uint32_t, 4> v;
    std::copy(mesh.cell(i), mesh.cell(i) + 4, v.begin());
    std::sort(v.begin(), v.end());
    for (std::size_t skip = 0; skip < 4; ++skip)
      facets.insert({v[skip == 0], v[skip <= 1 ? 2 : 1], v[skip <= 2 ? 3 : 2]});
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t q = 0; q < p; ++q) edges.insert({v[q], v[p]});
  }
  for (const auto& e : edges)
    for (std::uint32_t k = 0; k < s.complex.segments.size(); ++k)
      if (on_segment(k, e[0]) && on_segment(k, e[1])) mesh.edges.push_back({e[0], e[1], k});
  for (const auto& t : facets)
    for (std::uint32_t f = 0; f < 7; ++f)
      if (inside(f, at[t[0]]) && inside(f, at[t[1]]) && inside(f, at[t[2]]))
        mesh.facets.push_back({t[0], t[1], t[2], f});
  s.options.domain = "box";
  s.options.tau = 1;
  return s;
}

TEST(VerifyInSpace, AcceptsALatticeInTetrahedraWithLabelsAndWithout) {
  for (const std::uint32_t n : {2u, 4u}) {
    const Subject3 s = kuhn(n);
    EXPECT_TRUE(s.failing().empty()) << s.said();
    EXPECT_EQ(verify(s.mesh, s.complex, s.options).size(), 7u);
    EXPECT_EQ(*s.check("volume").bound, double(n) * n * n);
    EXPECT_NEAR(*s.check("radius-edge").observed, std::sqrt(3.0) / 2, 1e-15);
    EXPECT_TRUE(s.foreign().failing().empty()) << s.foreign().said();
    for (const char* domain : {"hull", "closed"}) {
      Subject3 other = s;
      other.options.domain = domain;
      EXPECT_TRUE(other.failing().empty()) << other.said();
    }
  }
}

TEST(VerifyInSpace, AcceptsFacesWhoseVerticesAreRoundedOffTheirPlanes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const testing::Rotation turn(&random);
    Subject3 s = kuhn(2, &turn);
    // The cospherical lattice is no longer exactly Delaunay, nor its hull exactly convex.
    s.options.checks = {"topology", "input-vertices", "input-segments", "input-faces",
                        "radius-edge"};
    EXPECT_TRUE(s.failing().empty()) << s.said();
    EXPECT_TRUE(s.foreign().failing().empty()) << s.foreign().said();
  }
}

TEST(VerifyInSpace, SeesWhatIsBroken) {
  const Subject3 whole = kuhn(2);
  const auto fails = [](const Subject3& s) { return s.failing(); };
  using Names = std::set<std::string>;
  {
    Subject3 s = whole;  // a cell is missing, on the boundary
    s.mesh.cells.erase(s.mesh.cells.begin(), s.mesh.cells.begin() + 4);
    const Names names = fails(s);
    EXPECT_TRUE(names.count("delaunay")) << s.said();
    EXPECT_TRUE(names.count("volume")) << s.said();
  }
  {
    Subject3 s = whole;  // a cell is inverted
    std::swap(s.mesh.cells[0], s.mesh.cells[1]);
    EXPECT_TRUE(fails(s).count("topology")) << s.said();
    EXPECT_TRUE(fails(s).count("delaunay")) << s.said();
  }
  {
    Subject3 s = whole;  // a cell twice
    for (int k = 0; k < 4; ++k) s.mesh.cells.push_back(s.mesh.cells[static_cast<std::size_t>(k)]);
    EXPECT_TRUE(fails(s).count("topology")) << s.said();
  }
  {
    Subject3 s = whole;  // no vertex of that number; a number twice
    s.mesh.cells[0] = 999;
    s.mesh.cells[5] = s.mesh.cells[6];
    EXPECT_TRUE(fails(s).count("topology")) << s.said();
  }
  {
    Subject3 s = whole;  // an inner vertex moves: no longer Delaunay, the tiling stays
    for (std::uint32_t v = 12; v < s.mesh.vertices.size(); ++v)
      if (s.mesh.vertices[v] == Point3{1, 1, 1}) s.mesh.vertices[v] = {1.0625, 1.03125, 1};
    EXPECT_EQ(fails(s), (Names{"delaunay"})) << s.said();
    s.options.domain = "closed";
    EXPECT_TRUE(fails(s).count("delaunay")) << s.said();
  }
  {
    Subject3 s = whole;  // an input vertex moves out
    s.mesh.vertices[0].x -= 0x1p-20;
    const Names names = fails(s);
    EXPECT_TRUE(names.count("input-vertices")) << s.said();
  }
  {
    Subject3 s = whole;  // quality
    s.options.tau = 0.5;
    EXPECT_EQ(fails(s), (Names{"radius-edge"})) << s.said();
    EXPECT_EQ(s.check("radius-edge").worst.size(), 4u);
  }
  {
    Subject3 s = whole;  // a subsegment, a facet not listed
    s.mesh.edges.pop_back();
    EXPECT_TRUE(fails(s).count("input-segments")) << s.said();
    EXPECT_TRUE(fails(s).count("input-faces")) << s.said();
    s = whole;
    s.mesh.facets.pop_back();
    EXPECT_EQ(fails(s), (Names{"input-faces"})) << s.said();
    s.mesh.facets.push_back(s.mesh.facets.front());
    s.mesh.facets.back().face = 6;
    EXPECT_EQ(fails(s), (Names{"input-faces"})) << s.said();
  }
  {
    Subject3 s = whole;  // a facet that no cell has, of a face that need not be there
    s.mesh.facets.push_back({0, 3, 5, 99});
    EXPECT_EQ(fails(s), (Names{"input-faces"})) << s.said();
  }
  {
    Subject3 s = whole.foreign();  // a face that the mesh does not respect
    s.complex.faces.push_back({{{0, 1, 7, 6}}, {}, {}, {}});
    EXPECT_TRUE(fails(s).empty()) << s.said();  // the lattice has the diagonal plane
    s.complex.faces.back().loops = {{1, 2, 4}};
    EXPECT_EQ(fails(s), (Names{"input-faces"})) << s.said();
  }
  {
    Subject3 s = whole;  // nothing at all
    s.mesh.cells.clear();
    EXPECT_TRUE(fails(s).count("delaunay")) << s.said();
    s.mesh = Mesh();
    s.mesh.dimension = 3;
    EXPECT_TRUE(fails(s).count("input-vertices")) << s.said();
    s.mesh.dimension = 2;
    EXPECT_TRUE(fails(s).count("topology")) << s.said();
  }
}

TEST(VerifyInSpace, AClosedMeshWithHolesFillsNotWhatItsFacesEnclose) {
  Random random(3);
  const testing::Rotation turn(&random);
  Subject3 whole = kuhn(4, &turn);
  whole.options.domain = "closed";
  whole.options.checks = {"topology", "input-segments", "input-faces", "volume"};
  std::set<std::array<std::uint32_t, 3>> in_faces;
  for (const MeshFacet& f : whole.mesh.facets) {
    std::array<std::uint32_t, 3> v{f.a, f.b, f.c};
    std::sort(v.begin(), v.end());
    in_faces.insert(v);
  }
  std::size_t torn = 0;
  for (std::size_t c = 0; c < whole.mesh.cell_count() && torn < 3; c += 7) {
    std::array<std::uint32_t, 4> v;
    std::copy(whole.mesh.cell(c), whole.mesh.cell(c) + 4, v.begin());
    std::sort(v.begin(), v.end());
    bool inner = true;
    for (std::size_t skip = 0; skip < 4; ++skip)
      inner = inner && !in_faces.count({v[skip == 0], v[skip <= 1 ? 2 : 1], v[skip <= 2 ? 3 : 2]});
    if (!inner) continue;
    ++torn;
    for (const bool labeled : {true, false}) {
      Subject3 s = labeled ? whole : whole.foreign();
      EXPECT_TRUE(s.failing().empty()) << s.said();
      const auto at = s.mesh.cells.begin() + static_cast<std::ptrdiff_t>(4 * c);
      s.mesh.cells.erase(at, at + 4);
      const std::set<std::string> names = s.failing();
      EXPECT_TRUE(names.count("volume")) << s.said();
      EXPECT_TRUE(names.count("input-faces")) << s.said();  // its boundary leaves the faces
    }
  }
  EXPECT_EQ(torn, 3u);
}

TEST(VerifyInSpace, AMeshThatCoversAPlaceTwiceIsNoTiling) {
  // Two tetrahedra, one within the other, without a common facet: two parts of the boundary.
  Subject3 s;
  s.complex.dimension = s.mesh.dimension = 3;
  for (const double h : {1.0, 0.25})
    for (const Point3& p : {Point3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -4}})
      s.mesh.vertices.push_back({h * p.x + (1 - h), h * p.y + (1 - h), h * p.z - (1 - h)});
  s.complex.vertices = s.mesh.vertices;
  s.mesh.cells = {0, 1, 2, 3, 4, 5, 6, 7};
  s.options.domain = "hull";
  EXPECT_TRUE(s.check("topology").ok) << s.said();
  EXPECT_FALSE(s.check("delaunay").ok) << s.said();
}

TEST(Theorems4_1And4_2, TheChecksCompareEverySubsegmentWithItsBounds) {
  Subject3 s = kuhn(8);
  s.options.checks = {"segment-lower", "segment-upper"};
  EXPECT_TRUE(s.failing().empty()) << s.said();
  double lower = 1e300, upper = 0;
  const FeatureSizes3 sizes(s.complex);
  for (const MeshEdge& e : s.mesh.edges) {
    const Point3 &a = s.mesh.vertices[e.a], &b = s.mesh.vertices[e.b];
    const double fs = sizes.of_subsegment(a, b).radius;
    const double lfs = sizes.local_by_brute_force(a, b).radius;
    lower = std::min(lower, 1 / std::min(fs / 16, lfs / 4));
    upper = std::max(upper, 1 / std::min(std::sqrt(2.0) * fs, 5.0 / 3 * lfs));
  }
  EXPECT_NEAR(*s.check("segment-lower").observed, lower, 1e-12);
  EXPECT_NEAR(*s.check("segment-upper").observed, upper, 1e-12);
  EXPECT_NEAR(*s.foreign().check("segment-upper").observed, upper, 1e-12);
  // Too long: the box alone is a mesh of itself with subsegments of 1 and 2, of sizes 1.
  const Subject3 coarse = [&] {
    Subject3 c = kuhn(2);
    for (Point3& p : c.mesh.vertices) p.z *= 0.25;  // plates near each other
    for (Point3& p : c.complex.vertices) p.z *= 0.25;
    c.options.checks = {"segment-upper"};
    return c;
  }();
  EXPECT_EQ(coarse.failing().size(), 1u) << coarse.said();
  EXPECT_EQ(coarse.check("segment-upper").worst.size(), 2u);
}

TEST(MeasureInSpace, OfTheRegularTetrahedronAndOfALattice) {
  Mesh regular;
  regular.dimension = 3;
  regular.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  regular.cells = {0, 2, 1, 3};
  Quality q = measure(regular);
  const double dihedral = elementary::acos(1.0 / 3) * (180 / elementary::kPi);
  EXPECT_NEAR(std::fabs(q.volume), 8.0 / 3, 1e-15);
  EXPECT_NEAR(q.min_dihedral_degrees, dihedral, 1e-13);
  EXPECT_NEAR(q.max_dihedral_degrees, dihedral, 1e-13);
  EXPECT_NEAR(q.max_radius_edge, std::sqrt(3.0) / std::sqrt(8.0), 1e-15);
  EXPECT_NEAR(q.shortest_edge, std::sqrt(8.0), 1e-15);
  q = measure(kuhn(2).mesh);
  EXPECT_EQ(q.volume, 8);
  EXPECT_NEAR(q.min_dihedral_degrees, 45, 1e-13);
  EXPECT_NEAR(q.max_dihedral_degrees, 90, 1e-13);
}

TEST(MeasureInSpace, ASliverFarFromTheOriginHasItsCircumradius) {
  // Four points near the equator of a sphere of radius 5: integers, shifted by 2^20.
  Mesh sliver;
  sliver.dimension = 3;
  for (const Point3& p : {Point3{3, 4, 0}, {-4, 3, 0}, {-3, -4, 0}, {4, -3, 0x1p-20}})
    sliver.vertices.push_back({p.x + 0x1p20, p.y - 0x1p20, p.z + 0x1p20});
  sliver.cells = {0, 1, 2, 3};
  const Quality q = measure(sliver);
  EXPECT_NEAR(q.max_radius_edge, 5 / std::sqrt(50.0), 1e-12);
  EXPECT_LT(q.min_dihedral_degrees, 1e-4);
  EXPECT_GT(q.max_dihedral_degrees, 179.999);
}

}  // namespace
}  // namespace circumball
