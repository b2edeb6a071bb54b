// Theorems 3.2 and 3.3 on more random complexes than the tests have time for: 1/2 lfs <= N <=
// sqrt 2 lfs at every input vertex, the left side after every insertion.
//
//   feature_size_runs [first] [count] [least angle in degrees]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "support/acute_complexes.h"
#include "support/feature_size_run.h"

int main(int argc, char** argv) {
  using namespace circumball;
  const std::uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::uint64_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 100'000;
  std::map<double, std::size_t, std::greater<>> angles{{60, 0}, {10, 0}, {1, 0}, {0.1, 0}, {0, 0}};
  std::array<double, 2> range{1, 1};
  std::size_t insertions = 0, most = 0, failed = 0;
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t number = first; number < first + count; ++number) {
    const double least = argc > 3 ? std::atof(argv[3]) : testing::least_angle_of_run(number);
    const Complex complex = testing::random_acute_complex(number, least);
    ++angles.lower_bound(smallest_angle_degrees(complex))->second;
    testing::NearestNeighborWatch watch(complex);
    const auto run = testing::finish(complex, testing::options_of("feature-size"), &watch);
    if (!run || run->status() != Status::kComplete || !run->unresolved().empty() ||
        !watch.lower_bound_held_throughout() || !watch.upper_bound_holds()) {
      std::printf("complex %llu fails: N / lfs in [%.17g, %.17g]\n",
                  static_cast<unsigned long long>(number), watch.range()[0], watch.range()[1]);
      ++failed;
    }
    range = {std::min(range[0], watch.range()[0]), std::max(range[1], watch.range()[1])};
    insertions += watch.insertions();
    most = std::max(most, watch.insertions());
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf(
      "%llu complexes, %zu failed; N / lfs in [%.6f, %.6f]; %zu insertions, at most %zu in "
      "one; %.1f s\n",
      static_cast<unsigned long long>(count), failed, range[0], range[1], insertions, most,
      seconds);
  std::printf("smallest input angle");
  for (const auto& [above, complexes] : angles) std::printf("; >= %g: %zu", above, complexes);
  std::printf("\n");
  return failed == 0 ? 0 : 1;
}
