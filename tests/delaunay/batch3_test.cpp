// Batches in space: the order in which they are inserted, and what is left out.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <numeric>

#include "delaunay/delaunay3.h"
#include "delaunay/delaunay_check.h"
#include "delaunay/spatial_order.h"
#include "point_sets3.h"

namespace circumball::testing {
namespace {

TEST(HilbertCurve3, VisitsEveryCellOnceAndStepsToANeighbor) {
  std::map<std::uint32_t, std::array<int, 3>> cells;
  constexpr std::uint32_t kSide = 16;
  for (std::uint32_t x = 0; x < kSide; ++x)
    for (std::uint32_t y = 0; y < kSide; ++y)
      for (std::uint32_t z = 0; z < kSide; ++z)
        // In the corner where the curve of the whole grid begins.
        cells[hilbert_key(x, y, z)] = {int(x), int(y), int(z)};
  ASSERT_EQ(cells.size(), kSide * kSide * kSide);
  EXPECT_EQ(cells.begin()->first, 0u);
  EXPECT_EQ(cells.rbegin()->first, kSide * kSide * kSide - 1);
  const std::array<int, 3>* last = nullptr;
  for (const auto& [key, cell] : cells) {
    int steps = 0;
    for (int i = 0; last && i < 3; ++i) steps += std::abs(cell[i] - (*last)[i]);
    EXPECT_EQ(steps, last ? 1 : 0);
    last = &cell;
  }
}

TEST(HilbertCurve3, EndsOfTheWholeGridAreAtTwoCornersOfOneSide) {
  EXPECT_EQ(hilbert_key(0, 0, 0), 0u);
  const std::uint32_t last = (1u << 30) - 1;
  EXPECT_TRUE(hilbert_key(1023, 0, 0) == last || hilbert_key(0, 1023, 0) == last ||
              hilbert_key(0, 0, 1023) == last);
}

TEST(HilbertCurve3, OrderIsAPermutationThatKeepsTheLowestOfEqualPoints) {
  for (const Kind3 kind : kAllKinds3)
    for (const std::size_t n : {0, 1, 500, 4000}) {
      const std::vector<Point3> points = random_points(kind, n, 1);
      std::vector<std::uint32_t> order(n);
      std::iota(order.begin(), order.end(), 0u);
      const auto at = [&](std::uint32_t i) -> const Point3& { return points[i]; };
      const auto duplicates = sort_along_hilbert_curve(at, &order);
      std::map<std::array<double, 3>, std::uint32_t> lowest;
      for (std::uint32_t i = 0; i < n; ++i)
        lowest.emplace(std::array<double, 3>{points[i].x, points[i].y, points[i].z}, i);
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

TEST(Batch3, ReportsDuplicatesAndKeepsTheLowestNumber) {
  for (const Kind3 kind : kAllKinds3)
    for (const bool observed : {false, true}) {
      const std::vector<Point3> points = random_points(kind, 150, 2);
      Delaunay3 d;
      for (const Point3& p : points) d.add_vertex(p);
      std::set<std::uint32_t> seen;
      const auto duplicates =
          observed ? d.insert_batch(0, 150,
                                    [&](VertexId v) { EXPECT_TRUE(seen.insert(v.value).second); })
                   : d.insert_batch(0, 150, nullptr);
      std::uint32_t expected = 0;
      for (std::uint32_t v = 0; v < 150; ++v) {
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
        EXPECT_EQ(seen.size() + duplicates.size(), 150u);
      }
      EXPECT_EQ(cells(d), cells(in_number_order(points))) << name(kind);
    }
}

TEST(Batch3, GoesIntoATriangulationThatIsThere) {
  for (const Kind3 kind : kAllKinds3) {
    const std::vector<Point3> points = random_points(kind, 120, 6);
    Delaunay3 d;
    for (const Point3& p : points) d.add_vertex(p);
    std::size_t left_out = 0;
    for (std::uint32_t first = 0; first < 120; first += 30) {
      const auto duplicates = d.insert_batch(first, first + 30, nullptr);
      for (const auto& [vertex, of] : duplicates) {
        EXPECT_TRUE(d.inserted(of)) << name(kind);
        EXPECT_EQ(d.point(vertex), d.point(of));
      }
      left_out += duplicates.size();
    }
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
    EXPECT_EQ(cells(d), cells(in_number_order(points))) << name(kind);
    std::size_t not_inserted = 0;
    for (std::uint32_t v = 0; v < 120; ++v) not_inserted += !d.inserted(VertexId(v));
    EXPECT_EQ(left_out, not_inserted);
  }
}

TEST(Batch3, ObserverSeesTheChangeRecordOfEachInsertion) {
  for (const Kind3 kind : {Kind3::kLattice, Kind3::kTiltedLattice, Kind3::kTwoLines}) {
    const std::vector<Point3> points = random_points(kind, 60, 6);
    Delaunay3 d;
    for (const Point3& p : points) d.add_vertex(p);
    std::multiset<Corners4> replayed;
    d.insert_batch(0, 60, [&](VertexId v) {
      for (const auto& c : d.died()) replayed.erase(replayed.find(corners(c)));
      for (const CellSlot c : d.born()) {
        replayed.insert(corners(d.cell(c)));
        EXPECT_EQ(d.cell(c).v[0], v);
      }
      EXPECT_EQ(replayed, cells(d));
    });
  }
}

TEST(Batch3, InsertionGoesOnAfterIt) {
  // Slots, marks and births of the batch serve the insertions after it.
  for (const Kind3 kind : kAllKinds3) {
    const std::vector<Point3> points = without_duplicates(random_points(kind, 100, 8));
    Delaunay3 d;
    const std::size_t half = points.size() / 2;
    for (std::size_t i = 0; i < half; ++i) d.add_vertex(points[i]);
    d.insert_batch(0, d.vertex_count(), nullptr);
    std::set<std::uint32_t> births;
    for (CellSlot c = 0; c < d.slot_count(); ++c)
      if (d.alive(c)) {
        EXPECT_TRUE(births.insert(d.cell(c).birth).second);
      }
    for (std::size_t i = half; i < points.size(); ++i) {
      const VertexId v = d.add_vertex(points[i]);
      ASSERT_EQ(d.probe(v, 0), Delaunay3::Probe::kOk);
      d.commit(v);
      for (const CellSlot c : d.born()) EXPECT_TRUE(births.insert(d.cell(c).birth).second);
    }
    EXPECT_EQ(cells(d), cells(in_number_order(points))) << name(kind);
  }
}

TEST(Batch3, LargeOneIsValidAndSmall) {
  const std::vector<Point3> points = random_points(Kind3::kRandom, 20000, 1);
  Delaunay3 d;
  d.reserve(points.size());
  for (const Point3& p : points) d.add_vertex(p);
  EXPECT_TRUE(d.insert_batch(0, d.vertex_count(), nullptr).empty());
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  EXPECT_LT(d.bytes(), 400 * points.size());
}

TEST(Batch3, EmptyOrPastTheEndDoesNothing) {
  Delaunay3 d;
  EXPECT_TRUE(d.insert_batch(0, 0, nullptr).empty());
  EXPECT_TRUE(d.insert_batch(5, 3, nullptr).empty());
  d.add_vertex({1, 2, 3});
  EXPECT_TRUE(d.insert_batch(0, 9, nullptr).empty());
  EXPECT_EQ(d.dimension(), 0);
  EXPECT_TRUE(d.insert_batch(0, 1, nullptr).empty());
}

}  // namespace
}  // namespace circumball::testing
