// Complexes of space: the check of a surface of many triangles, the oracle of feature sizes, and
// `feature-size` step by step.
//
//   space_bench [repeats]        prints medians
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "circumball/complex.h"
#include "circumball/feature_size.h"
#include "circumball/refine.h"
#include "predicates/elementary.h"
#include "support/complexes.h"
#include "support/complexes3.h"

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

/// A torus of 2 * around * across triangles.
Complex torus(std::uint32_t around, std::uint32_t across) {
  Complex c;
  c.dimension = 3;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = 2 * elementary::kPi * i / around, v = 2 * elementary::kPi * k / across;
      const double r = 2 + 0.7 * elementary::cos(v);
      c.vertices.push_back(
          {r * elementary::cos(u), r * elementary::sin(u), 0.7 * elementary::sin(v)});
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const auto at = [&](std::uint32_t p, std::uint32_t q) {
        return (i + p) % around * across + (k + q) % across;
      };
      const std::uint32_t a = at(0, 0), b = at(1, 0), d = at(1, 1), e = at(0, 1);
      for (const auto& loop : {std::vector<std::uint32_t>{a, b, d}, {a, d, e}}) {
        c.faces.emplace_back();
        c.faces.back().loops = {loop};
      }
      c.segments.push_back({a, b});
      c.segments.push_back({a, d});
      c.segments.push_back({a, e});
    }
  }
  return c;
}

/// Parts of every kind with small angles between segments and faces, in a row.
Complex sharp(std::uint32_t parts) {
  Random random(parts);
  testing::Builder3 b;
  for (std::uint32_t k = 0; k < parts; ++k) {
    const testing::Rotation turn(&random);
    b.place({2.05 * k, 0, 0}, &turn);
    testing::add_part(&b, &random, 5, k);
  }
  return b.complex();
}

void measure_surface(std::uint32_t around, std::uint32_t across, int repeats) {
  const Complex c = torus(around, across);
  std::vector<double> checks, builds, points, pieces;
  for (int i = 0; i < repeats; ++i) {
    std::size_t defects = 0;
    checks.push_back(seconds_of([&] { defects = check(c).size(); }));
    if (defects > 0) std::printf("%zu defects\n", defects);
    std::unique_ptr<FeatureSizes3> sizes;
    builds.push_back(seconds_of([&] { sizes = std::make_unique<FeatureSizes3>(c); }));
    constexpr int kQueries = 20000;
    Random random(7);
    double sum = 0;
    points.push_back(seconds_of([&] {
                       for (int k = 0; k < kQueries; ++k) {
                         const Point3& p = c.vertices[random.below(around * across)];
                         const double near = 0.05 * random.unit();
                         sum += sizes->local({p.x + near, p.y - near, p.z + near}).radius;
                       }
                     }) /
                     kQueries);
    const std::size_t step = c.segments.size() / 5000 + 1;
    std::size_t asked = 0;
    const double time = seconds_of([&] {
      for (std::size_t s = 0; s < c.segments.size(); s += step, ++asked) {
        const Point3 &a = c.vertices[c.segments[s][0]], &b = c.vertices[c.segments[s][1]];
        sum += sizes->of_subsegment(a, b).radius + sizes->local(a, b).radius;
      }
    });
    pieces.push_back(time / static_cast<double>(asked));
    if (!(sum > 0)) std::printf("no sum\n");  // so that nothing is optimized away
  }
  std::printf("%9zu %9zu %10.2f %10.2f %10.2f %14.1f\n", c.faces.size(), c.segments.size(),
              median(checks), median(builds), 1e6 * median(points), 1e6 * median(pieces));
}

void measure_steps(const char* name, const Complex& c, int repeats) {
  std::vector<std::vector<double>> seconds;
  std::vector<StepReport> steps;
  for (int i = 0; i < repeats; ++i) {
    const auto run = testing::finish(c, testing::options_of("feature-size"));
    if (!run) return;
    steps = run->steps();
    seconds.resize(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) seconds[k].push_back(steps[k].seconds);
  }
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double time = median(seconds[k]);
    const auto inserted = static_cast<double>(steps[k].inserted);
    std::printf("%15s %5s %10.0f %10.3f %10.1f\n", k == 0 ? name : "", steps[k].name.c_str(),
                inserted, time, time > 0 ? 1e-3 * inserted / time : 0.0);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  std::printf("%9s %9s %10s %10s %10s %14s\n", "triangles", "segments", "check, s", "oracle, s",
              "lfs(x), us", "fs, lfs(s), us");
  measure_surface(50, 20, repeats);
  measure_surface(100, 100, repeats);
  measure_surface(200, 170, repeats);
  measure_surface(250, 200, repeats);
  std::printf("\n%15s %5s %10s %10s %10s\n", "feature-size", "step", "inserted", "s", "1000 / s");
  measure_steps("torus, 2000", torus(50, 20), repeats);
  measure_steps("140 sharp parts", sharp(140), repeats);
  return 0;
}
