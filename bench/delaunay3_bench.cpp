// Delaunay triangulation in space, side by side with CGAL in one process: batches of uniform
// points, of points on a sphere's surface, and of a lattice, the two in turn, medians of several
// repeats. Seconds depend on the machine: read the ratios.
//   delaunay3_bench [--repeats N] [--only uniform|sphere|lattice] [--most POINTS]
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "delaunay/delaunay3.h"

namespace {

using circumball::CellSlot;
using circumball::Delaunay3;
using circumball::Point3;
using circumball::VertexId;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Peer = CGAL::Delaunay_triangulation_3<Kernel>;

double random_unit(std::uint64_t* state) {
  std::uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
}

std::vector<Point3> uniform(std::size_t n) {
  std::uint64_t state = n;
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    p.x = random_unit(&state);
    p.y = random_unit(&state);
    p.z = random_unit(&state);
  }
  return points;
}

/// Uniform on the unit sphere, up to rounding (Marsaglia, "Choosing a point from the surface of a
/// sphere", 1972).
std::vector<Point3> sphere(std::size_t n) {
  std::uint64_t state = n;
  std::vector<Point3> points;
  while (points.size() < n) {
    const double u = 2 * random_unit(&state) - 1, v = 2 * random_unit(&state) - 1;
    const double s = u * u + v * v;
    if (s >= 1) continue;
    const double r = 2 * std::sqrt(1 - s);
    points.push_back({u * r, v * r, 1 - 2 * s});
  }
  return points;
}

/// The corners of a cubic lattice, about n of them.
std::vector<Point3> lattice(std::size_t n) {
  const int side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(n))));
  std::vector<Point3> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) points.push_back({double(x), double(y), double(z)});
  return points;
}

/// Of the processor: others may use the machine at the same time.
template <class F>
double seconds(F f) {
  const std::clock_t start = std::clock();
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Built {
  double seconds;
  std::size_t cells, vertices, bytes;
};

Built build_ours(const std::vector<Point3>& points) {
  Built built{};
  Delaunay3 d;
  built.seconds = seconds([&] {
    d.reserve(points.size());
    for (const Point3& p : points) d.add_vertex(p);
    built.vertices = points.size() - d.insert_batch(0, d.vertex_count(), nullptr).size();
  });
  d.for_each_cell([&](CellSlot) { ++built.cells; });
  built.bytes = d.bytes();
  return built;
}

Built build_peer(const std::vector<Kernel::Point_3>& points) {
  Built built{};
  Peer* d = nullptr;
  built.seconds = seconds([&] { d = new Peer(points.begin(), points.end()); });
  built.cells = d->number_of_finite_cells();
  built.vertices = d->number_of_vertices();
  delete d;
  return built;
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 3;
  std::string only;
  std::size_t most = 1000000;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--repeats")) repeats = std::max(1, std::atoi(argv[i + 1]));
    if (!std::strcmp(argv[i], "--only")) only = argv[i + 1];
    if (!std::strcmp(argv[i], "--most")) most = std::strtoull(argv[i + 1], nullptr, 10);
  }
  std::printf("%8s %9s %12s %12s %8s %10s %14s\n", "points", "number", "ours us/pt", "CGAL us/pt",
              "ratio", "cells/pt", "bytes a point");
  const struct {
    const char* name;
    std::vector<Point3> (*make)(std::size_t);
    bool unique;  // in general position, so that both have the same cells
  } kinds[] = {{"uniform", uniform, true}, {"sphere", sphere, true}, {"lattice", lattice, false}};
  for (const auto& kind : kinds) {
    if (!only.empty() && only != kind.name) continue;
    for (const std::size_t size : {std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}}) {
      if (size > most) continue;
      const std::vector<Point3> points = kind.make(size);
      std::vector<Kernel::Point_3> peer_points;
      for (const Point3& p : points) peer_points.emplace_back(p.x, p.y, p.z);
      std::vector<double> ours, peer;
      Built a{}, b{};
      const int rounds = size < 100000 ? 5 * repeats : repeats;
      for (int r = 0; r < rounds; ++r) {
        a = build_ours(points);
        b = build_peer(peer_points);
        if (a.vertices != b.vertices || (kind.unique && a.cells != b.cells)) {
          std::printf("different triangulations: %zu and %zu cells\n", a.cells, b.cells);
          return 1;
        }
        ours.push_back(a.seconds);
        peer.push_back(b.seconds);
      }
      const double n = static_cast<double>(points.size()), scale = 1e6 / n;
      std::printf("%8s %9zu %12.3f %12.3f %8.2f %10.3f %14.1f\n", kind.name, points.size(),
                  median(ours) * scale, median(peer) * scale, median(peer) / median(ours),
                  static_cast<double>(a.cells) / n, static_cast<double>(a.bytes) / n);
      std::fflush(stdout);
    }
  }
  return 0;
}
