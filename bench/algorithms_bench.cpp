// Vertices a second of the algorithms that split triangles, on the same inputs, with Ruppert's = 1.
// Where angles are acute, Ruppert's algorithm is stopped at edges of a thousandth of the bound.
//
//   algorithms_bench [repeats]        prints medians of rates, and ratios
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "circumball/refine.h"
#include "circumball/registry.h"
#include "support/acute.h"

namespace {

using circumball::Complex;
using circumball::Options;

/// Vertices a second, validation of the input included; 0 where the run cannot start.
double rate(const Complex& complex, const Options& options, std::size_t* vertices) {
  const auto start = std::chrono::steady_clock::now();
  const auto run = circumball::testing::finish(complex, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!run) return 0;
  *vertices = run->progress().vertices;
  return static_cast<double>(*vertices) / seconds;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
  struct Input {
    const char* name;
    Complex complex;
    double size;
  };
  std::vector<Input> inputs = {
      {"unit square, many triangles", circumball::testing::unit_square(), 0.00257},
      {"unit square, few triangles", circumball::testing::unit_square(), 0.0257},
      {"grid of right angles, no bound", circumball::testing::random_grid(11, 0), 0},
      {"fan of 24 segments, 2 degrees apart", circumball::testing::dense_fan(1, 24, 2), 0.01},
      {"lake with capes and islands", circumball::testing::rough_lake(11), 0.004},
      {"coast with capes", circumball::testing::rough_coast(12), 0.004},
      {"coast with capes, no bound", circumball::testing::rough_coast(12), 0},
  };
  std::printf("%-38s %-12s %10s %10s %8s\n", "input", "algorithm", "vertices", "k/s", "ratio");
  for (const Input& input : inputs) {
    std::vector<std::string> ids;
    for (const auto& info : circumball::registry()) {
      const bool has_tau =
          std::any_of(info.parameters.begin(), info.parameters.end(),
                      [](const circumball::ParameterInfo& p) { return p.name == "tau"; });
      if ((has_tau || info.id == "fem-size") && info.dimension == 2) ids.push_back(info.id);
    }
    std::vector<std::vector<double>> rates(ids.size());
    std::vector<std::size_t> vertices(ids.size());
    const bool acute = smallest_angle_degrees(input.complex) < 60;
    for (int i = 0; i < repeats; ++i) {  // interleaved, so that noise is shared
      for (std::size_t k = 0; k < ids.size(); ++k) {
        Options options = circumball::testing::options_of(ids[k]);
        if (input.size > 0) options.size = std::to_string(input.size);
        if (acute && ids[k] == "ruppert") options.limits.min_edge = 1e-3 * (input.size + 1e-3);
        rates[k].push_back(rate(input.complex, options, &vertices[k]));
      }
    }
    for (std::size_t k = 0; k < ids.size(); ++k) {
      std::printf("%-38s %-12s %10zu %10.0f %8.2f\n", k == 0 ? input.name : "", ids[k].c_str(),
                  vertices[k], median(rates[k]) / 1000, median(rates[k]) / median(rates[0]));
    }
  }
}
