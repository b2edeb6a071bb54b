// Delaunay triangulation in the plane, side by side with CGAL in one process: batches of uniform
// points, the two in turn, medians of several repeats. Seconds depend on the machine: read the
// ratios.
//   delaunay_bench [--repeats N] [--large]     --large: 10^7 points as well, without CGAL
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "delaunay/constructions.h"
#include "delaunay/delaunay2.h"

namespace {

using circumball::Delaunay2;
using circumball::Point2;
using circumball::VertexId;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Peer = CGAL::Delaunay_triangulation_2<Kernel>;

std::uint64_t random_bits(std::uint64_t* state) {
  std::uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

std::vector<Point2> uniform_points(std::size_t n) {
  std::uint64_t state = n;
  std::vector<Point2> points(n);
  for (Point2& p : points) {
    p.x = static_cast<double>(random_bits(&state) >> 11) * 0x1p-53;
    p.y = static_cast<double>(random_bits(&state) >> 11) * 0x1p-53;
  }
  return points;
}

template <class F>
double seconds(F f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Built {
  double seconds;
  std::size_t triangles, bytes;
};

Built build_ours(const std::vector<Point2>& points) {
  Built built{};
  Delaunay2 d;
  built.seconds = seconds([&] {
    d.reserve(points.size());
    for (const Point2& p : points) d.add_vertex(p);
    d.insert_batch(0, d.vertex_count(), nullptr);
  });
  d.for_each_triangle([&](circumball::TriangleId) { ++built.triangles; });
  built.bytes = d.bytes();
  return built;
}

Built build_peer(const std::vector<Kernel::Point_2>& points) {
  Built built{};
  Peer* d = nullptr;
  built.seconds = seconds([&] { d = new Peer(points.begin(), points.end()); });
  built.triangles = d->number_of_faces();
  delete d;
  return built;
}

// Point location aside, as in refinement: the circumcenter of a triangle at hand, probed from it
// and inserted.
double seconds_per_refinement_step(std::size_t n) {
  Delaunay2 d;
  for (const Point2& p : uniform_points(n)) d.add_vertex(p);
  d.insert_batch(0, d.vertex_count(), nullptr);
  std::uint64_t state = 7;
  const std::size_t steps = n / 2;
  d.reserve(n + steps);
  std::size_t done = 0;
  circumball::TriangleId t = 0;
  const double total = seconds([&] {
    while (done < steps) {
      // A walk through the mesh, as a queue of nearby triangles would make.
      t = d.twin(4 * t + random_bits(&state) % 3) >> 2;
      if (d.is_ghost(t)) continue;
      const auto& at = d.triangle(t);
      const Point2 c =
          circumball::circumcenter(d.point(at.v[0]), d.point(at.v[1]), d.point(at.v[2]));
      if (!(c.x > 0 && c.x < 1 && c.y > 0 && c.y < 1)) continue;
      if (d.probe(c, t) != Delaunay2::Probe::kOk) continue;
      d.commit(d.add_vertex(c));
      t = d.born()[0];
      ++done;
    }
  });
  return total / static_cast<double>(steps);
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 5;
  bool large = false;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--repeats") && i + 1 < argc)
      repeats = std::max(1, std::atoi(argv[++i]));
    if (!std::strcmp(argv[i], "--large")) large = true;
  }
  std::printf("%10s %12s %12s %8s %14s\n", "points", "ours us/pt", "CGAL us/pt", "ratio",
              "bytes a point");
  for (const std::size_t n : {std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}}) {
    const std::vector<Point2> points = uniform_points(n);
    std::vector<Kernel::Point_2> peer_points;
    for (const Point2& p : points) peer_points.emplace_back(p.x, p.y);
    std::vector<double> ours, peer;
    std::size_t bytes = 0;
    const int rounds = n < 100000 ? 10 * repeats : repeats;
    for (int r = 0; r < rounds; ++r) {
      const Built a = build_ours(points), b = build_peer(peer_points);
      if (a.triangles != b.triangles) {
        std::printf("different triangulations: %zu and %zu triangles\n", a.triangles, b.triangles);
        return 1;
      }
      ours.push_back(a.seconds);
      peer.push_back(b.seconds);
      bytes = a.bytes;
    }
    const double scale = 1e6 / static_cast<double>(n);
    std::printf("%10zu %12.3f %12.3f %8.2f %14.1f\n", n, median(ours) * scale, median(peer) * scale,
                median(peer) / median(ours), static_cast<double>(bytes) / static_cast<double>(n));
    std::fflush(stdout);
  }
  if (large) {
    const std::size_t n = 10000000;
    const Built a = build_ours(uniform_points(n));
    std::printf("%10zu %12.3f %12s %8s %14.1f\n", n, a.seconds * 1e6 / static_cast<double>(n), "-",
                "-", static_cast<double>(a.bytes) / static_cast<double>(n));
  }
  std::printf("one step of refinement (probe at a circumcenter + commit): %.3f us\n",
              seconds_per_refinement_step(200000) * 1e6);
  return 0;
}
