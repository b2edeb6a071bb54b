// CGAL's triangulation as an oracle, where the points are in general position.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <gtest/gtest.h>

#include "../point_sets.h"
#include "delaunay/delaunay2.h"

namespace circumball::testing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Peer = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

std::multiset<Corners> finite_triangles(const Delaunay2& d) {
  std::multiset<Corners> all;
  d.for_each_triangle([&](TriangleId t) { all.insert(corners(d.triangle(t))); });
  return all;
}

std::multiset<Corners> peer_triangles(const std::vector<Point2>& points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    input.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
  const Peer peer(input.begin(), input.end());
  std::multiset<Corners> all;
  for (auto f = peer.finite_faces_begin(); f != peer.finite_faces_end(); ++f) {
    Corners c{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    all.insert(c);
  }
  return all;
}

TEST(Cgal, AgreesInGeneralPosition) {
  for (const Kind kind : {Kind::kRandom, Kind::kOffset})
    for (const std::size_t n : {std::size_t{3}, std::size_t{100}, std::size_t{20000}}) {
      const std::vector<Point2> points = random_points(kind, n, 21);
      const auto expected = peer_triangles(points);
      EXPECT_EQ(finite_triangles(in_a_batch(points)), expected) << name(kind);
      EXPECT_EQ(finite_triangles(in_number_order(points)), expected) << name(kind);
    }
}

TEST(Cgal, AgreesOnTheNumberOfTrianglesOfDegenerateSets) {
  for (const Kind kind :
       {Kind::kLattice, Kind::kComb, Kind::kCocircular, Kind::kClusters, Kind::kNearlyCollinear}) {
    const std::vector<Point2> points = random_points(kind, 300, 22);
    EXPECT_EQ(finite_triangles(in_a_batch(points)).size(), peer_triangles(points).size())
        << name(kind);
  }
}

}  // namespace
}  // namespace circumball::testing
