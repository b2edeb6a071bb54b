// What the triangulation is: Delaunay by brute force, unique, and the same from everywhere.
#include "delaunay/delaunay2.h"

#include <gtest/gtest.h>

#include <numeric>

#include "circumball/predicates.h"
#include "delaunay/delaunay_check.h"
#include "point_sets.h"

namespace circumball::testing {
namespace {

/// Whether p is in the disk of ccw (a, b, c) after vertex i has been lifted by epsilon_i, epsilon_0
/// << epsilon_1 << ... The determinant is linear in the lifts: without them, or else the first
/// coefficient that does not vanish decides.
bool in_perturbed_disk(const Delaunay2& d, const Corners& t, std::uint32_t p) {
  const auto at = [&](std::uint32_t v) -> const Point2& { return d.point(VertexId(v)); };
  const Sign in = incircle(at(t[0]), at(t[1]), at(t[2]), at(p));
  if (in != Sign::kZero) return in == Sign::kPositive;
  std::vector<std::pair<std::uint32_t, int>> coefficients = {
      {t[0], static_cast<int>(orient2d(at(t[1]), at(t[2]), at(p)))},
      {t[1], static_cast<int>(orient2d(at(t[2]), at(t[0]), at(p)))},
      {t[2], static_cast<int>(orient2d(at(t[0]), at(t[1]), at(p)))},
      {p, -static_cast<int>(orient2d(at(t[0]), at(t[1]), at(t[2])))},
  };
  std::sort(coefficients.rbegin(), coefficients.rend());
  for (const auto& [vertex, sign] : coefficients)
    if (sign != 0) return sign > 0;
  ADD_FAILURE() << "a tie that the perturbation leaves open";
  return false;
}

/// Number of points on the boundary of the convex hull, by Andrew's monotone chain (1979),
/// collinear ones kept.
std::size_t hull_size(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), [](const Point2& a, const Point2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  std::size_t size = 0;
  for (int side = 0; side < 2; ++side) {
    std::vector<Point2> chain;
    for (const Point2& p : points) {
      while (chain.size() > 1 &&
             orient2d(chain[chain.size() - 2], chain.back(), p) == Sign::kNegative)
        chain.pop_back();
      chain.push_back(p);
    }
    size += chain.size() - 1;
    std::reverse(points.begin(), points.end());
  }
  return size;
}

void expect_delaunay(const Delaunay2& d, const std::string& what) {
  std::string why;
  ASSERT_TRUE(is_valid(d, &why)) << what << ": " << why;
  std::vector<Point2> points;
  for (std::uint32_t v = 0; v < d.vertex_count(); ++v)
    if (d.inserted(VertexId(v))) points.push_back(d.point(VertexId(v)));
  std::size_t count = 0;
  d.for_each_triangle([&](TriangleId t) {
    ++count;
    const Corners c = corners(d.triangle(t));
    for (std::uint32_t p = 0; p < d.vertex_count(); ++p) {
      if (!d.inserted(VertexId(p)) || std::count(c.begin(), c.end(), p)) continue;
      EXPECT_FALSE(in_perturbed_disk(d, c, p)) << what;
    }
  });
  if (d.dimension() == 2) {
    EXPECT_EQ(count, 2 * points.size() - 2 - hull_size(points)) << what;
  }
}

TEST(Delaunay2, EveryDiskIsEmptyForEveryKindOfPointSet) {
  for (const Kind kind : kAllKinds)
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const std::size_t n = 1 + seed * 3 / 2;
      const std::vector<Point2> points = random_points(kind, n, seed);
      const std::string what = name(kind) + ", n = " + std::to_string(n);
      expect_delaunay(in_number_order(points), what + ", one by one");
      expect_delaunay(in_a_batch(points), what + ", batch");
      if (HasFailure()) return;
    }
}

TEST(Delaunay2, IsValidAfterEveryInsertion) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d;
    Random random(5);
    for (const Point2& p : random_points(kind, 80, 1)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(100)) == Delaunay2::Probe::kOk) d.commit(v);
      std::string why;
      ASSERT_TRUE(is_valid(d, &why)) << name(kind) << ", vertex " << v.value << ": " << why;
    }
  }
}

TEST(Delaunay2, IsUniqueForNumberedPointsWhateverTheOrderOfInsertion) {
  for (const Kind kind : kAllKinds)
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      // Distinct points: which of two equal ones stays does depend on the order, one by one.
      std::vector<Point2> points;
      for (const Point2& p : random_points(kind, 70, seed))
        if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
      const std::multiset<Corners> expected = triangles(in_number_order(points));
      EXPECT_EQ(triangles(in_a_batch(points)), expected) << name(kind);
      Random random(seed);
      for (int trial = 0; trial < 5; ++trial) {
        Delaunay2 d;
        std::vector<std::uint32_t> order;
        for (const Point2& p : points) order.push_back(d.add_vertex(p).value);
        for (std::size_t i = order.size(); i > 1; --i)
          std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
        insert_all(&d, order, &random);
        EXPECT_EQ(triangles(d), expected) << name(kind);
      }
    }
}

TEST(Delaunay2, LargeLatticeIsTheSameInABatchAsInNumberOrder) {
  std::vector<Point2> points;
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y) points.push_back({double((x * 29) % 64), double((y * 37) % 64)});
  const Delaunay2 d = in_a_batch(points);
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  EXPECT_EQ(triangles(d), triangles(in_number_order(points)));
}

TEST(Delaunay2, DimensionGrowsWithThePoints) {
  Delaunay2 d;
  const auto insert = [&](double x, double y) {
    const VertexId v = d.add_vertex({x, y});
    EXPECT_EQ(d.probe(v, kNone), Delaunay2::Probe::kOk);
    d.commit(v);
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << why;
    return d.dimension();
  };
  EXPECT_EQ(d.dimension(), -1);
  EXPECT_EQ(d.locate({0, 0}, 0), kNone);
  EXPECT_EQ(insert(0, 0), 0);
  EXPECT_EQ(d.triangle_of(VertexId(0)), kNone);
  EXPECT_TRUE(d.inserted(VertexId(0)));
  EXPECT_EQ(insert(4, 4), 1);
  EXPECT_EQ(insert(2, 2), 1);
  EXPECT_EQ(insert(-1, -1), 1);
  EXPECT_EQ(insert(9, 9), 1);
  EXPECT_EQ(d.slot_count(), 8u);
  EXPECT_EQ(insert(3, 2), 2);
  EXPECT_EQ(d.slot_count(), 10u);
}

TEST(Delaunay2, QueriesWorkOnAChainOfCollinearVertices) {
  Delaunay2 d;
  for (const double x : {2.0, 0.0, 3.0, 1.0}) d.add_vertex({x, 2 * x});
  d.insert_batch(0, 4, nullptr);
  ASSERT_EQ(d.dimension(), 1);
  EXPECT_NE(d.find_edge(VertexId(0), VertexId(3)), kNone);
  EXPECT_NE(d.find_edge(VertexId(3), VertexId(1)), kNone);
  EXPECT_EQ(d.find_edge(VertexId(0), VertexId(1)), kNone);
  std::set<std::uint32_t> neighbors;
  d.for_each_neighbor(VertexId(0), [&](VertexId u) { return neighbors.insert(u.value).second; });
  EXPECT_EQ(neighbors, (std::set<std::uint32_t>{2, 3}));
  const TriangleId above = d.locate({0, 9}, 0), below = d.locate({9, 0}, 0);
  const HalfEdge h = d.find_edge(VertexId(3), VertexId(0));
  EXPECT_NE(above, below);
  EXPECT_TRUE(d.is_ghost(above) && d.is_ghost(below) && d.is_ghost(h >> 2));
}

TEST(Delaunay2, ProbeSaysTheSameFromEveryHint) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d = in_a_batch(random_points(kind, 40, 3));
    Random random(9);
    for (int trial = 0; trial < 20; ++trial) {
      const Point2 p = random_point(kind, &random);
      std::vector<Corners> expected;
      for (TriangleId hint = 0; hint < d.slot_count() + 3; ++hint) {
        const Delaunay2::Probe result = d.probe(p, hint);
        std::vector<Corners> cavity;
        for (const TriangleId t : d.cavity()) cavity.push_back(corners(d.triangle(t)));
        std::sort(cavity.begin(), cavity.end());
        if (hint == 0) expected = cavity;
        ASSERT_EQ(cavity, expected) << name(kind);
        ASSERT_EQ(result == Delaunay2::Probe::kDuplicate, d.duplicate_of().valid());
        if (d.duplicate_of().valid()) {
          ASSERT_EQ(d.point(d.duplicate_of()), p);
        }
      }
    }
  }
}

TEST(Delaunay2, LocateFindsATriangleThatContainsThePoint) {
  const Delaunay2 d = in_a_batch(random_points(Kind::kLattice, 60, 4));
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const Point2 p{random.below(80) / 8.0 - 4, random.below(80) / 8.0 - 4};
    const TriangleId t = d.locate(p, random.below(100));
    for (HalfEdge h = 4 * t; h < 4 * t + 3; ++h) {
      if (d.origin(h) == Delaunay2::kGhost || d.target(h) == Delaunay2::kGhost) continue;
      const Sign side = orient2d(d.point(d.origin(h)), d.point(d.target(h)), p);
      EXPECT_TRUE(side == Sign::kPositive || (side == Sign::kZero && !d.is_ghost(t)));
    }
  }
}

TEST(Delaunay2, NeighborsAreGivenOnceEachAndCounterClockwise) {
  const Delaunay2 d = in_a_batch(random_points(Kind::kRandom, 200, 6));
  std::vector<std::set<std::uint32_t>> expected(d.vertex_count());
  d.for_each_triangle([&](TriangleId t) {
    for (HalfEdge h = 4 * t; h < 4 * t + 3; ++h) {
      expected[d.origin(h).value].insert(d.target(h).value);
      expected[d.target(h).value].insert(d.origin(h).value);
      EXPECT_EQ(d.find_edge(d.origin(h), d.target(h)), h);
    }
  });
  for (std::uint32_t v = 0; v < d.vertex_count(); ++v) {
    std::vector<VertexId> around;
    bool inner = true;
    d.for_each_outgoing(VertexId(v), [&](HalfEdge h) {
      if (d.target(h) == Delaunay2::kGhost) inner = false;
      return true;
    });
    d.for_each_neighbor(VertexId(v), [&](VertexId u) {
      around.push_back(u);
      return true;
    });
    EXPECT_EQ(around.size(), expected[v].size());
    for (const VertexId u : around) EXPECT_EQ(expected[v].count(u.value), 1u);
    for (std::size_t i = 0; inner && i < around.size(); ++i)
      EXPECT_EQ(orient2d(d.point(VertexId(v)), d.point(around[i]),
                         d.point(around[(i + 1) % around.size()])),
                Sign::kPositive);
    int calls = 0;
    d.for_each_neighbor(VertexId(v), [&](VertexId) { return ++calls < 2; });
    EXPECT_EQ(calls, 2);
  }
}

TEST(Delaunay2, CheckNamesWhatIsWrong) {
  Delaunay2 d = in_a_batch(random_points(Kind::kRandom, 10, 1));
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  d.pop_vertex();  // against its precondition: vertex 9 is inserted
  EXPECT_FALSE(is_valid(d, &why));
  EXPECT_NE(why, "");
  EXPECT_FALSE(is_valid(d, nullptr));
}

}  // namespace
}  // namespace circumball::testing
