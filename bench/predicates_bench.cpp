// What exactness costs on random input: every predicate with its filter against the naive
// determinant, inline in the same loop. The target is at most 1.5 times. Run with
// --benchmark_repetitions=5 and compare medians.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "circumball/predicates.h"
#include "predicates/fast.h"

namespace {

using circumball::Point3;

/// Points of the unit cube, few enough for the second-level cache, visited in an order that no
/// prefetcher or vectorizer can turn into something that a mesher would not see.
constexpr std::uint32_t kPoints = 4096;
constexpr std::uint32_t kCalls = 1 << 14;
constexpr std::uint32_t kStride =
    5;  // a call's own five indices: nothing carries over to the next call

std::uint64_t next(std::uint64_t& state) {  // splitmix64 (Steele, Lea, Flood 2014)
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

struct Input {
  std::vector<Point3> points;
  std::vector<std::uint32_t> order;
  Input() {
    std::uint64_t state = 1;
    const auto coordinate = [&] { return static_cast<double>(next(state) >> 11) * 0x1p-53; };
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      points.push_back({x, y, z});
    }
    for (std::uint32_t i = 0; i < kStride * kCalls; ++i) {
      order.push_back(static_cast<std::uint32_t>(next(state) % kPoints));
    }
  }
};

const Input& input() {
  static const Input instance;
  return instance;
}

/// Calls f with five points of the input and counts the positive signs.
template <class F>
void measure(benchmark::State& state, F f) {
  const Point3* p = input().points.data();
  for (auto _ : state) {
    int positive = 0;
    const std::uint32_t* o = input().order.data();
    for (std::uint32_t i = 0; i < kCalls; ++i, o += kStride) {
      positive += f(p[o[0]], p[o[1]], p[o[2]], p[o[3]], p[o[4]]) > 0;
    }
    benchmark::DoNotOptimize(positive);
  }
  state.SetItemsProcessed(state.iterations() * kCalls);
}

double naive_orient2d(const Point3& a, const Point3& b, const Point3& c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

double naive_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double adx = a.x - d.x, ady = a.y - d.y, adz = a.z - d.z;
  const double bdx = b.x - d.x, bdy = b.y - d.y, bdz = b.z - d.z;
  const double cdx = c.x - d.x, cdy = c.y - d.y, cdz = c.z - d.z;
  return adz * (bdx * cdy - cdx * bdy) + bdz * (cdx * ady - adx * cdy) +
         cdz * (adx * bdy - bdx * ady);
}

double naive_incircle(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  return (adx * adx + ady * ady) * (bdx * cdy - cdx * bdy) +
         (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy) +
         (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady);
}

double naive_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  const double aex = a.x - e.x, aey = a.y - e.y, aez = a.z - e.z;
  const double bex = b.x - e.x, bey = b.y - e.y, bez = b.z - e.z;
  const double cex = c.x - e.x, cey = c.y - e.y, cez = c.z - e.z;
  const double dex = d.x - e.x, dey = d.y - e.y, dez = d.z - e.z;
  const double ab = aex * bey - bex * aey, bc = bex * cey - cex * bey;
  const double cd = cex * dey - dex * cey, da = dex * aey - aex * dey;
  const double ac = aex * cey - cex * aey, bd = bex * dey - dex * bey;
  const double abc = aez * bc - bez * ac + cez * ab, bcd = bez * cd - cez * bd + dez * bc;
  const double cda = cez * da + dez * ac + aez * cd, dab = dez * ab + aez * bd + bez * da;
  return ((dex * dex + dey * dey + dez * dez) * abc - (cex * cex + cey * cey + cez * cez) * dab) +
         ((bex * bex + bey * bey + bez * bez) * cda - (aex * aex + aey * aey + aez * aez) * bcd);
}

double naive_segment_ball2(const Point3& a, const Point3& b, const Point3& p) {
  return (a.x - p.x) * (p.x - b.x) + (a.y - p.y) * (p.y - b.y);
}

double naive_segment_ball3(const Point3& a, const Point3& b, const Point3& p) {
  return (a.x - p.x) * (p.x - b.x) + (a.y - p.y) * (p.y - b.y) + (a.z - p.z) * (p.z - b.z);
}

double naive_triangle_ball(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  const double ux = a.x - c.x, uy = a.y - c.y, uz = a.z - c.z;
  const double vx = b.x - c.x, vy = b.y - c.y, vz = b.z - c.z;
  const double qx = p.x - c.x, qy = p.y - c.y, qz = p.z - c.z;
  const double uu = ux * ux + uy * uy + uz * uz, vv = vx * vx + vy * vy + vz * vz;
  const double qq = qx * qx + qy * qy + qz * qz, uv = ux * vx + uy * vy + uz * vz;
  const double qu = qx * ux + qy * uy + qz * uz, qv = qx * vx + qy * vy + qz * vz;
  return uu * vv * (qu + qv - qq) - uv * (uu * qv + vv * qu - uv * qq);
}

double naive_compare_distance(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double abx = a.x - b.x, aby = a.y - b.y, cdx = c.x - d.x, cdy = c.y - d.y;
  return (abx * abx + aby * aby) - (cdx * cdx + cdy * cdy);
}

using P = const Point3&;

// clang-format off
void orient2d_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return naive_orient2d(a, b, c); }); }
void orient2d_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return circumball::orient2d_filtered(a.x, a.y, b.x, b.y, c.x, c.y); }); }
void orient3d_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return naive_orient3d(a, b, c, d); }); }
void orient3d_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return circumball::orient3d_filtered(a, b, c, d); }); }
void incircle_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return naive_incircle(a, b, c, d); }); }
void incircle_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return circumball::incircle_filtered(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y); }); }
void insphere_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P e) { return naive_insphere(a, b, c, d, e); }); }
void insphere_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P e) { return circumball::insphere_filtered(a, b, c, d, e); }); }
void segment_ball2_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return naive_segment_ball2(a, b, c); }); }
void segment_ball2_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return circumball::in_segment_ball_filtered(a.x, a.y, b.x, b.y, c.x, c.y); }); }
void segment_ball3_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return naive_segment_ball3(a, b, c); }); }
void segment_ball3_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P, P) { return circumball::in_segment_ball_filtered(a, b, c); }); }
void triangle_ball_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return naive_triangle_ball(a, b, c, d); }); }
void triangle_ball_filtered(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return circumball::in_triangle_ball_filtered(a, b, c, d); }); }
void compare_distance_naive(benchmark::State& s) { measure(s, [](P a, P b, P c, P d, P) { return naive_compare_distance(a, b, c, d); }); }
void compare_distance_filtered(benchmark::State& s) {
  measure(s, [](P a, P b, P c, P d, P) { return circumball::compare_distance_filtered({a.x, a.y}, {b.x, b.y}, {c.x, c.y}, {d.x, d.y}); });
}
// clang-format on

BENCHMARK(orient2d_naive);
BENCHMARK(orient2d_filtered);
BENCHMARK(orient3d_naive);
BENCHMARK(orient3d_filtered);
BENCHMARK(incircle_naive);
BENCHMARK(incircle_filtered);
BENCHMARK(insphere_naive);
BENCHMARK(insphere_filtered);
BENCHMARK(segment_ball2_naive);
BENCHMARK(segment_ball2_filtered);
BENCHMARK(segment_ball3_naive);
BENCHMARK(segment_ball3_filtered);
BENCHMARK(triangle_ball_naive);
BENCHMARK(triangle_ball_filtered);
BENCHMARK(compare_distance_naive);
BENCHMARK(compare_distance_filtered);

}  // namespace
BENCHMARK_MAIN();
