// Batches: the order in which they are inserted, and what is left out.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "delaunay/delaunay2.h"
#include "delaunay/delaunay_check.h"
#include "delaunay/spatial_order.h"
#include "point_sets.h"

namespace circumball::testing {
namespace {

TEST(HilbertCurve, VisitsEveryCellOnceAndStepsToANeighbor) {
  std::map<std::uint32_t, std::pair<int, int>> cells;
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y)
      cells[hilbert_key(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))] = {x, y};
  ASSERT_EQ(cells.size(), 64u * 64u);
  EXPECT_EQ(cells.begin()->first, 0u);
  EXPECT_EQ(cells.rbegin()->first, 64u * 64u - 1);
  std::pair<int, int> last = cells.begin()->second;
  for (auto it = std::next(cells.begin()); it != cells.end(); ++it) {
    EXPECT_EQ(std::abs(it->second.first - last.first) + std::abs(it->second.second - last.second),
              1);
    last = it->second;
  }
}

TEST(HilbertCurve, OrderIsAPermutationThatKeepsTheLowestOfEqualPoints) {
  for (const Kind kind : kAllKinds)
    for (const std::size_t n :
         {std::size_t{0}, std::size_t{1}, std::size_t{500}, std::size_t{5000}}) {
      const std::vector<Point2> points = random_points(kind, n, 1);
      std::vector<std::uint32_t> order(n);
      std::iota(order.begin(), order.end(), 0u);
      const auto at = [&](std::uint32_t i) -> const Point2& { return points[i]; };
      const auto duplicates = sort_along_hilbert_curve(at, &order);
      std::map<std::pair<double, double>, std::uint32_t> lowest;
      for (std::uint32_t i = 0; i < n; ++i) lowest.emplace(std::pair(points[i].x, points[i].y), i);
      std::set<std::uint32_t> all(order.begin(), order.end());
      EXPECT_EQ(all.size(), lowest.size()) << name(kind);
      EXPECT_EQ(all.size(), order.size());
      for (const auto& [point, i] : lowest) EXPECT_EQ(all.count(i), 1u) << name(kind);
      for (const auto& [gone, kept] : duplicates) {
        EXPECT_EQ(points[gone], points[kept]);
        EXPECT_LT(kept, gone);
        EXPECT_TRUE(all.insert(gone).second);
      }
      EXPECT_EQ(all.size(), n);
    }
}

TEST(HilbertCurve, StepsAreShortInClustersOfEverySize) {
  // Clusters of 1000 points, each a millionth of the one before: the tour stays within a few
  // diameters of each.
  Random random(4);
  std::vector<Point2> points;
  double scale = 1;
  for (int cluster = 0; cluster < 6; ++cluster, scale *= 1e-6)
    for (int i = 0; i < 1000; ++i) {
      const double u = random.unit();
      const double v = random.unit();
      points.push_back({scale * (1 + u), scale * (1 + v)});
    }
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  sort_along_hilbert_curve([&](std::uint32_t i) -> const Point2& { return points[i]; }, &order);
  std::vector<double> length(6, 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::uint32_t a = order[i - 1], b = order[i];
    if (a / 1000 != b / 1000) continue;
    const double dx = points[a].x - points[b].x, dy = points[a].y - points[b].y;
    length[a / 1000] += dx < 0 ? -dx : dx;
    length[a / 1000] += dy < 0 ? -dy : dy;
  }
  // 1000 steps of about 1 / sqrt(1000) each, against 1000 * 2/3 in random order.
  scale = 1;
  for (int cluster = 0; cluster < 6; ++cluster, scale *= 1e-6)
    EXPECT_LT(length[cluster], 60 * scale);
}

TEST(Rounds, KeepTheOrderAndGrowGeometrically) {
  std::vector<std::uint32_t> order(100000);
  std::iota(order.begin(), order.end(), 0u);
  deal_rounds(&order);
  std::vector<std::size_t> rounds(1, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && order[i] < order[i - 1]) rounds.push_back(0);
    ++rounds.back();
  }
  ASSERT_GT(rounds.size(), 2u);
  for (std::size_t r = 1; r < rounds.size(); ++r) EXPECT_GT(rounds[r], 2 * rounds[r - 1]);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
}

TEST(Batch, ReportsDuplicatesAndKeepsTheLowestNumber) {
  for (const Kind kind : kAllKinds)
    for (const bool observed : {false, true}) {
      const std::vector<Point2> points = random_points(kind, 300, 2);
      Delaunay2 d;
      for (const Point2& p : points) d.add_vertex(p);
      std::set<std::uint32_t> seen;
      const auto duplicates =
          observed ? d.insert_batch(0, 300,
                                    [&](VertexId v) { EXPECT_TRUE(seen.insert(v.value).second); })
                   : d.insert_batch(0, 300, nullptr);
      std::uint32_t expected = 0;
      for (std::uint32_t v = 0; v < 300; ++v) {
        const auto first = static_cast<std::uint32_t>(
            std::find(points.begin(), points.end(), points[v]) - points.begin());
        EXPECT_EQ(d.inserted(VertexId(v)), first == v) << name(kind);
        if (first == v) continue;
        ASSERT_LT(expected, duplicates.size()) << name(kind);
        EXPECT_EQ(duplicates[expected].vertex.value, v) << name(kind);
        EXPECT_EQ(duplicates[expected].of.value, first) << name(kind);
        ++expected;
      }
      EXPECT_EQ(duplicates.size(), expected) << name(kind);
      if (observed) {
        EXPECT_EQ(seen.size() + duplicates.size(), 300u);
      }
      EXPECT_EQ(triangles(d), triangles(in_number_order(points))) << name(kind);
    }
}

TEST(Batch, GoesIntoATriangulationThatIsThere) {
  for (const Kind kind : kAllKinds) {
    const std::vector<Point2> points = random_points(kind, 200, 6);
    Delaunay2 d;
    for (const Point2& p : points) d.add_vertex(p);
    std::size_t left_out = 0;
    for (std::uint32_t first = 0; first < 200; first += 40) {
      const auto duplicates = d.insert_batch(first, first + 40, nullptr);
      for (const auto& [vertex, of] : duplicates) {
        EXPECT_TRUE(d.inserted(of)) << name(kind);
        EXPECT_EQ(d.point(vertex), d.point(of));
      }
      left_out += duplicates.size();
    }
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
    EXPECT_EQ(triangles(d), triangles(in_number_order(points))) << name(kind);
    std::size_t not_inserted = 0;
    for (std::uint32_t v = 0; v < 200; ++v) not_inserted += !d.inserted(VertexId(v));
    EXPECT_EQ(left_out, not_inserted);
  }
}

TEST(Batch, ObserverSeesTheChangeRecordOfEachInsertion) {
  const std::vector<Point2> points = random_points(Kind::kLattice, 100, 6);
  Delaunay2 d;
  for (const Point2& p : points) d.add_vertex(p);
  std::multiset<Corners> replayed;
  d.insert_batch(0, 100, [&](VertexId v) {
    for (const auto& t : d.died()) replayed.erase(replayed.find(corners(t)));
    for (const TriangleId t : d.born()) {
      replayed.insert(corners(d.triangle(t)));
      EXPECT_EQ(d.triangle(t).v[0], v);
    }
    EXPECT_EQ(replayed, triangles(d));
  });
}

TEST(Batch, TagsOutliveABatchWhereTheirEdgesDo) {
  Delaunay2 d;
  for (const Point2& p : {Point2{0, 0}, Point2{8, 0}, Point2{8, 8}, Point2{0, 8}}) d.add_vertex(p);
  d.insert_batch(0, 4, nullptr);
  d.set_tag(d.find_edge(VertexId(0), VertexId(1)), 3);
  for (int i = 0; i < 50; ++i) d.add_vertex({0.5 + i % 7, 1.0 + i / 7});
  d.insert_batch(4, d.vertex_count(), nullptr);
  EXPECT_EQ(d.tag(d.find_edge(VertexId(0), VertexId(1))), 3u);
  EXPECT_EQ(d.tag(d.find_edge(VertexId(1), VertexId(0))), 3u);
}

TEST(Batch, LargeOneIsValidAndSmall) {
  const std::vector<Point2> points = random_points(Kind::kRandom, 50000, 1);
  Delaunay2 d;
  d.reserve(points.size());
  for (const Point2& p : points) d.add_vertex(p);
  EXPECT_TRUE(d.insert_batch(0, d.vertex_count(), nullptr).empty());
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  EXPECT_LT(d.bytes(), 120 * points.size());
}

TEST(Batch, EmptyOrPastTheEndDoesNothing) {
  Delaunay2 d;
  EXPECT_TRUE(d.insert_batch(0, 0, nullptr).empty());
  EXPECT_TRUE(d.insert_batch(5, 3, nullptr).empty());
  d.add_vertex({1, 2});
  EXPECT_TRUE(d.insert_batch(0, 9, nullptr).empty());
  EXPECT_EQ(d.dimension(), 0);
  EXPECT_TRUE(d.insert_batch(0, 1, nullptr).empty());
}

}  // namespace
}  // namespace circumball::testing
