// What the triangulation of space is: Delaunay by brute force, unique, and the same from
// everywhere.
#include "delaunay/delaunay3.h"

#include <gtest/gtest.h>

#include <numeric>

#include "circumball/predicates.h"
#include "delaunay/delaunay_check.h"
#include "point_sets3.h"

namespace circumball::testing {
namespace {

TEST(Delaunay3, IsValidAfterEveryInsertion) {
  for (const Kind3 kind : kAllKinds3) {
    Delaunay3 d;
    Random random(5);
    for (const Point3& p : random_points(kind, 60, 1)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(200)) == Delaunay3::Probe::kOk) d.commit(v);
      std::string why;
      ASSERT_TRUE(is_valid(d, &why)) << name(kind) << ", vertex " << v.value << ": " << why;
    }
  }
}

TEST(Delaunay3, IsUniqueForNumberedPointsWhateverTheOrderOfInsertion) {
  for (const Kind3 kind : kAllKinds3)
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      // Distinct points: which of two equal ones stays does depend on the order, one by one.
      const std::vector<Point3> points = without_duplicates(random_points(kind, 50, seed));
      const std::multiset<Corners4> expected = cells(in_number_order(points));
      EXPECT_EQ(cells(in_a_batch(points)), expected) << name(kind);
      Random random(seed);
      for (int trial = 0; trial < 4; ++trial) {
        Delaunay3 d;
        std::vector<std::uint32_t> order;
        for (const Point3& p : points) order.push_back(d.add_vertex(p).value);
        for (std::size_t i = order.size(); i > 1; --i)
          std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
        insert_all(&d, order, &random);
        EXPECT_EQ(cells(d), expected) << name(kind);
      }
    }
}

}  // namespace
}  // namespace circumball::testing
