// CGAL's triangulation of space as an oracle: the same cells in general position; where points are
// cospherical, as much space filled by as many vertices, of which neither has a ball around
// another.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include "../point_sets3.h"
#include "delaunay/delaunay3.h"
#include "delaunay/delaunay_check.h"

namespace circumball::testing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Peer = CGAL::Delaunay_triangulation_3<
    Kernel,
    CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

std::multiset<Corners4> finite_cells(const Delaunay3& d) {
  std::multiset<Corners4> all;
  d.for_each_cell([&](CellSlot c) { all.insert(corners(d.cell(c))); });
  return all;
}

Peer peer(const std::vector<Point3>& points) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> input;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    input.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), i);
  return Peer(input.begin(), input.end());
}

std::multiset<Corners4> finite_cells(const Peer& d) {
  std::multiset<Corners4> all;
  for (auto c = d.finite_cells_begin(); c != d.finite_cells_end(); ++c) {
    Delaunay3::Cell cell{};
    for (int i = 0; i < 4; ++i) cell.v[i] = VertexId(c->vertex(i)->info());
    // CGAL's cells are oriented the other way.
    std::swap(cell.v[0], cell.v[1]);
    all.insert(corners(cell));
  }
  return all;
}

/// Six times the volume of all cells, for integer coordinates: exact.
double volume(const std::vector<Point3>& points, const std::multiset<Corners4>& cells) {
  double sum = 0;
  for (const Corners4& c : cells) {
    const Point3 &a = points[c[0]], &b = points[c[1]], &d = points[c[2]], &e = points[c[3]];
    const double ux = a.x - e.x, uy = a.y - e.y, uz = a.z - e.z;
    const double vx = b.x - e.x, vy = b.y - e.y, vz = b.z - e.z;
    const double wx = d.x - e.x, wy = d.y - e.y, wz = d.z - e.z;
    sum += ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
  }
  return sum;
}

TEST(Cgal3, AgreesInGeneralPosition) {
  for (const Kind3 kind : {Kind3::kRandom, Kind3::kOffset, Kind3::kNearlyCoplanar})
    for (const std::size_t n : {std::size_t{4}, std::size_t{100}, std::size_t{10000}}) {
      if (kind == Kind3::kNearlyCoplanar && n > 100) continue;
      const std::vector<Point3> points = random_points(kind, n, 21);
      const auto expected = finite_cells(peer(points));
      EXPECT_EQ(finite_cells(in_a_batch(points)), expected) << name(kind);
      EXPECT_EQ(finite_cells(in_number_order(points)), expected) << name(kind);
    }
}

TEST(Cgal3, FillsTheSameVolumeWithTheSameVerticesWherePointsAreCospherical) {
  for (const Kind3 kind : {Kind3::kLattice, Kind3::kSheared, Kind3::kCospherical, Kind3::kTwoPlanes,
                           Kind3::kTwoLines, Kind3::kCocircular, Kind3::kDuplicates}) {
    const std::vector<Point3> points = without_duplicates(random_points(kind, 300, 22));
    const Delaunay3 d = in_a_batch(points);
    const Peer other = peer(points);
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
    EXPECT_EQ(other.number_of_vertices(), points.size());
    EXPECT_EQ(d.dimension(), other.dimension()) << name(kind);
    EXPECT_EQ(volume(points, finite_cells(d)), volume(points, finite_cells(other))) << name(kind);
  }
}

}  // namespace
}  // namespace circumball::testing
