// Feature sizes of complexes of 10^3 to 10^5 segments: the algorithm `feature-size` and the oracle.
// Where a time grows like n log n, the time for each of n grows like log n: by a quarter to a third
// from one size to ten times as many. The ratio is of the time a vertex, to the size before.
//
//   feature_size_bench [repeats]        prints medians
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "circumball/feature_size.h"
#include "circumball/refine.h"
#include "support/complexes.h"

namespace {

using namespace circumball;
using testing::Random;

template <class F>
double seconds_of(F f) {
  const std::clock_t start = std::clock();  // of the processor: nothing here waits
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A fan of four segments in each cell of a grid, 3 to 20 degrees apart.
Complex fans(std::uint32_t segments) {
  Random random(segments);
  Complex c;
  const auto side = static_cast<std::uint32_t>(std::sqrt(segments / 4.0) + 0.5);
  for (std::uint32_t cell = 0; cell < side * side; ++cell) {
    const double x = cell % side + 0.2 * random.unit(), y = cell / side + 0.2 * random.unit();
    const auto hub = static_cast<std::uint32_t>(c.vertices.size());
    c.vertices.push_back({x, y, 0});
    double slope = 0;
    for (std::uint32_t k = 0; k < 4; ++k) {
      slope += 0.05 + 0.3 * random.unit();
      const double length = 0.2 + 0.3 * random.unit();
      c.segments.push_back({hub, hub + 1 + k});
      c.vertices.push_back({x + length, y + length * slope, 0});
    }
  }
  return c;
}

/// All edges of a grid with shaken vertices: one connected web.
Complex web(std::uint32_t segments) {
  Random random(segments);
  Complex c;
  const auto side = static_cast<std::uint32_t>(std::sqrt(segments / 2.0) + 1.5);
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const double x = i + 0.6 * random.unit();
      c.vertices.push_back({x, j + 0.6 * random.unit(), 0});
      const std::uint32_t v = j * side + i;
      if (i > 0) c.segments.push_back({v - 1, v});
      if (j > 0) c.segments.push_back({v - side, v});
    }
  }
  return c;
}

/// Two parallel segments in each cell of a grid, from their lengths to a hundredth of them apart.
Complex parallels(std::uint32_t segments) {
  Random random(segments);
  Complex c;
  const auto side = static_cast<std::uint32_t>(std::sqrt(segments / 2.0) + 0.5);
  for (std::uint32_t cell = 0; cell < side * side; ++cell) {
    const double x = cell % side, y = cell / side;
    const double gap = random.below(2) ? 0.4 : 0.004 * (1 + random.below(10));
    for (std::uint32_t k = 0; k < 2; ++k) {
      const auto a = static_cast<std::uint32_t>(c.vertices.size());
      const double from = 0.2 * random.unit(), length = 0.3 + 0.2 * random.unit();
      c.vertices.push_back({x + from, y + 0.2 * from + k * gap, 0});
      c.vertices.push_back({x + from + length, y + 0.2 * (from + length) + k * gap, 0});
      c.segments.push_back({a, a + 1});
    }
  }
  return c;
}

void measure(const char* family, Complex (*make)(std::uint32_t), int repeats) {
  double last = 0;
  for (const std::uint32_t n : {1'000u, 3'000u, 10'000u, 30'000u, 100'000u}) {
    const Complex complex = make(n);
    const double segments = static_cast<double>(complex.segments.size());
    std::vector<double> runs, builds, queries, pieces;
    std::size_t vertices = 0;
    for (int i = 0; i < repeats; ++i) {
      runs.push_back(seconds_of([&] {
        const auto run = testing::finish(complex, testing::options_of("feature-size"));
        vertices = run ? run->progress().vertices : 0;
      }));
      std::unique_ptr<FeatureSizes> sizes;
      builds.push_back(seconds_of([&] { sizes = std::make_unique<FeatureSizes>(complex); }));
      Random random(7);
      double sum = 0;
      const double side = std::sqrt(segments);
      constexpr int kQueries = 20000;
      queries.push_back(seconds_of([&] {
                          for (int k = 0; k < kQueries; ++k) {
                            const double x = side * random.unit();
                            sum += sizes->local({x, side * random.unit()}).radius;
                          }
                        }) /
                        kQueries);
      const std::size_t step = std::max<std::size_t>(1, complex.segments.size() / 1000);
      std::size_t asked = 0;
      const double time = seconds_of([&] {
        for (std::size_t s = 0; s < complex.segments.size(); s += step, ++asked) {
          const Point2 a = xy(complex.vertices[complex.segments[s][0]]),
                       b = xy(complex.vertices[complex.segments[s][1]]);
          sum += sizes->of_subsegment(a, b).radius;
        }
      });
      pieces.push_back(time / static_cast<double>(asked));
      if (!(sum > 0)) std::printf("no sum\n");  // so that nothing is optimized away
    }
    const double each = median(runs) / segments;
    const double each_vertex = median(runs) / static_cast<double>(vertices);
    std::printf("%10s %9.0f %9zu %10.1f %12.2f %8.2f %8.2f %10.2f %10.2f %10.2f\n", family,
                segments, vertices, 1e3 * median(runs), 1e6 * each, 1e6 * each_vertex,
                last > 0 ? each_vertex / last : 1.0, 1e6 * median(builds) / segments,
                1e6 * median(queries), 1e6 * median(pieces));
    last = each_vertex;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
  std::printf("%10s %9s %9s %10s %12s %8s %8s %10s %10s %10s\n", "complex", "segments", "vertices",
              "ms", "us a segment", "a vertex", "ratio", "build, us", "lfs(x), us", "fs(s), us");
  measure("parallels", parallels, repeats);
  measure("fans", fans, repeats);
  measure("web", web, repeats);
  return 0;
}
