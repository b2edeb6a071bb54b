// Neighbors, edges and facets in space, against the list of all cells; vertices of many neighbors.
#include <gtest/gtest.h>

#include "delaunay/delaunay3.h"
#include "delaunay/delaunay_check.h"
#include "point_sets3.h"

namespace circumball::testing {
namespace {

/// By the list of cells; below dimension 2 by position along the line.
std::vector<std::set<std::uint32_t>> all_neighbors(const Delaunay3& d) {
  std::vector<std::set<std::uint32_t>> all(d.vertex_count());
  for (CellSlot c = 0; c < d.slot_count(); ++c) {
    if (!d.alive(c)) continue;
    const Delaunay3::Cell cell = d.cell(c);
    for (const VertexId a : cell.v)
      for (const VertexId b : cell.v)
        if (a != b && a != Delaunay3::kGhost && b != Delaunay3::kGhost)
          all[a.value].insert(b.value);
  }
  if (d.dimension() > 1) return all;
  std::vector<std::uint32_t> chain;
  for (std::uint32_t v = 0; v < d.vertex_count(); ++v)
    if (d.inserted(VertexId(v))) chain.push_back(v);
  std::sort(chain.begin(), chain.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Point3 &p = d.point(VertexId(a)), &q = d.point(VertexId(b));
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  });
  for (std::size_t i = 1; i < chain.size(); ++i) {
    all[chain[i - 1]].insert(chain[i]);
    all[chain[i]].insert(chain[i - 1]);
  }
  return all;
}

TEST(Neighbors3, AreThoseOfAllCells) {
  for (const Kind3 kind : kAllKinds3)
    for (const std::size_t n : {2, 3, 5, 60}) {
      const Delaunay3 d = in_a_batch(random_points(kind, n, 6));
      const auto expected = all_neighbors(d);
      std::vector<VertexId> around;
      std::vector<CellSlot> star;
      for (std::uint32_t v = 0; v < d.vertex_count(); ++v) {
        d.neighbors(VertexId(v), &around);
        std::set<std::uint32_t> found;
        for (const VertexId u : around) EXPECT_TRUE(found.insert(u.value).second) << name(kind);
        EXPECT_EQ(found, expected[v]) << name(kind);
        std::size_t calls = 0;
        d.for_each_neighbor(VertexId(v), [&](VertexId u) {
          EXPECT_EQ(u, around[calls]);
          EXPECT_TRUE(d.has_edge(u, VertexId(v)));  // allowed within
          return ++calls < 2;
        });
        EXPECT_EQ(calls, std::min<std::size_t>(2, around.size()));
        if (!d.inserted(VertexId(v))) continue;
        for (std::uint32_t u = 0; u < d.vertex_count(); ++u) {
          if (!d.inserted(VertexId(u))) continue;
          EXPECT_EQ(d.has_edge(VertexId(v), VertexId(u)), expected[v].count(u) == 1)
              << name(kind) << ": " << v << ", " << u;
        }
        d.cells_at(VertexId(v), &star);
        std::size_t count = 0;
        for (CellSlot c = 0; c < d.slot_count(); ++c)
          if (d.alive(c))
            for (int i = 0; i < 4; ++i) count += d.cell(c).v[i] == VertexId(v);
        EXPECT_EQ(star.size(), count) << name(kind);
        EXPECT_EQ(std::set<CellSlot>(star.begin(), star.end()).size(), count);
      }
    }
}

TEST(Neighbors3, FacetsAreFoundByTheirCornersInAnyOrder) {
  for (const Kind3 kind : kAllKinds3) {
    const Delaunay3 d = in_a_batch(random_points(kind, 14, 6));
    std::set<std::array<std::uint32_t, 3>> facets;
    for (CellSlot c = 0; c < d.slot_count(); ++c)
      for (CellFacet f = 4 * c; d.alive(c) && f < 4 * c + 4; ++f) {
        std::array<std::uint32_t, 3> t;
        for (std::uint32_t i = 0; i < 3; ++i) t[i] = d.facet_corner(f, i).value;
        std::sort(t.begin(), t.end());
        if (t[2] < d.vertex_count()) facets.insert(t);
      }
    std::size_t found = 0;
    for (std::uint32_t a = 0; a < d.vertex_count(); ++a)
      for (std::uint32_t b = 0; b < d.vertex_count(); ++b)
        for (std::uint32_t c = 0; c < d.vertex_count(); ++c) {
          if (!d.inserted(VertexId(a)) || !d.inserted(VertexId(b)) || !d.inserted(VertexId(c)))
            continue;
          const CellFacet f = d.find_facet(VertexId(a), VertexId(b), VertexId(c));
          std::array<std::uint32_t, 3> t{a, b, c};
          std::sort(t.begin(), t.end());
          ASSERT_EQ(f != kNone, facets.count(t) == 1) << name(kind);
          if (f == kNone) continue;
          ++found;
          std::array<std::uint32_t, 3> at;
          for (std::uint32_t i = 0; i < 3; ++i) at[i] = d.facet_corner(f, i).value;
          std::sort(at.begin(), at.end());
          ASSERT_EQ(at, t);
        }
    EXPECT_EQ(found, 6 * facets.size());
  }
}

/// Points on a sphere, exactly, and its center (number 0), whose neighbors they all are.
std::vector<Point3> hub() {
  std::vector<Point3> points{{0, 0, 0}};
  constexpr int kRadius = 33;
  for (int x = -kRadius; x <= kRadius; ++x)
    for (int y = -kRadius; y <= kRadius; ++y)
      for (int z = -kRadius; z <= kRadius; ++z)
        if (x * x + y * y + z * z == kRadius * kRadius)
          points.push_back({double(x), double(y), double(z)});
  return points;
}

TEST(Hub3, CavityOfManyVerticesIsFilled) {
  const std::vector<Point3> points = hub();
  ASSERT_GT(points.size(), 200u);
  Delaunay3 d;
  for (const Point3& p : points) d.add_vertex(p);
  d.insert_batch(1, d.vertex_count(), nullptr);
  ASSERT_EQ(d.probe(VertexId(0), 0), Delaunay3::Probe::kOk);
  std::vector<VertexId> foretold, found;
  d.cavity_neighbors(&foretold);
  EXPECT_EQ(foretold.size(), points.size() - 1);
  d.commit(VertexId(0));
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  d.neighbors(VertexId(0), &found);
  EXPECT_EQ(found.size(), points.size() - 1);
  EXPECT_EQ(cells(d), cells(in_number_order(points)));
}

TEST(Hub3, LesserDegreeIsThatOfFewerCells) {
  const Delaunay3 d = in_a_batch(hub());
  std::vector<CellSlot> star;
  const auto degree = [&](std::uint32_t v) {
    d.cells_at(VertexId(v), &star);
    return star.size();
  };
  for (std::uint32_t a = 0; a < 40; ++a)
    for (std::uint32_t b = 0; b < 40; ++b) {
      const std::uint32_t lesser = d.of_lesser_degree(VertexId(a), VertexId(b)).value;
      EXPECT_TRUE(lesser == a || lesser == b);
      EXPECT_EQ(degree(lesser), std::min(degree(a), degree(b)));
    }
}

TEST(Hub3, EdgesOfTenThousandNeighborsAreFoundQuickly) {
  // Near a sphere: every other vertex is a neighbor of the center. Work of the square of their
  // number would take minutes.
  Random random(1);
  std::vector<Point3> points{{0, 0, 0}};
  while (points.size() < 10000) {
    const double x = 2 * random.unit() - 1;
    const double y = 2 * random.unit() - 1;
    const double z = 2 * random.unit() - 1;
    const double square = x * x + y * y + z * z;
    if (square > 1 || square < 0.01) continue;
    const double s = 1 / __builtin_sqrt(square);
    points.push_back({s * x, s * y, s * z});
  }
  const Delaunay3 d = in_a_batch(points);
  for (std::uint32_t v = 1; v < points.size(); ++v) {
    ASSERT_TRUE(d.has_edge(VertexId(0), VertexId(v)));
    ASSERT_EQ(d.of_lesser_degree(VertexId(0), VertexId(v)), VertexId(v));
  }
}

}  // namespace
}  // namespace circumball::testing
