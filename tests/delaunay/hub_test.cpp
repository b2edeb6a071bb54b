// Vertices of thousands of neighbors: edges and degrees are found from the end that has few.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "circumball/refine.h"
#include "delaunay/delaunay2.h"
#include "point_sets.h"

namespace circumball::testing {
namespace {

std::size_t degree(const Delaunay2& d, VertexId v) {
  std::size_t n = 0;
  d.for_each_outgoing(v, [&](HalfEdge) { return ++n > 0; });
  return n;
}

/// A fan of n segments all around the origin; `spread` makes the longest 1 + spread.
Complex hub(std::uint32_t n, double spread) {
  Complex complex;
  complex.vertices.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double turn = 2 * 3.14159265358979323846 * i / n;
    const double length = 1 + spread * (i * 7 % 11) / 11;
    complex.vertices.push_back({length * std::cos(turn), length * std::sin(turn), 0});
    complex.segments.push_back({0, i + 1});
  }
  return complex;
}

TEST(Hub, EdgesAndLesserDegreesAreThoseOfAllHalfEdges) {
  const Complex complex = hub(60, 1);
  Delaunay2 d;
  for (const Point3& p : complex.vertices) d.add_vertex(xy(p));
  d.insert_batch(0, d.vertex_count(), nullptr);
  for (std::uint32_t i = 0; i < d.vertex_count(); ++i) {
    for (std::uint32_t j = 0; j < d.vertex_count(); ++j) {
      const VertexId a(i), b(j);
      HalfEdge expected = kNone;
      d.for_each_outgoing(a, [&](HalfEdge h) {
        if (d.target(h) == b) expected = h;
        return true;
      });
      EXPECT_EQ(d.find_edge(a, b), expected) << i << ", " << j;
      const std::size_t least = std::min(degree(d, a), degree(d, b));
      EXPECT_EQ(degree(d, d.of_lesser_degree(a, b)), least) << i << ", " << j;
    }
  }
}

TEST(Hub, OfTwentyThousandEqualSegmentsNeedsNoSplit) {
  // Quadratic work would take minutes.
  Options options;
  options.algorithm = "feature-size";
  std::vector<Defect> defects;
  std::string error;
  const auto run = Run::create(hub(20000, 0), options, nullptr, &defects, &error);
  ASSERT_TRUE(run) << error;
  EXPECT_EQ(run->advance(), Status::kComplete);
  EXPECT_EQ(run->mesh().vertices.size(), 20001u);
}

}  // namespace
}  // namespace circumball::testing
