#include "complex/enclosure.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

namespace circumball {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Those that stand an odd number of times in a list, ascending.
std::vector<Edge> odd_ones(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> odd;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && edges[j] == edges[i];) ++j;
    if ((j - i) % 2 == 1) odd.push_back(edges[i]);
  }
  return odd;
}

}  // namespace

bool faces_enclose_something(const Complex& complex) {
  std::map<Edge, std::vector<Edge>> columns;  // by their last edge
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    std::vector<Edge> sides;
    for (const auto& t : triangulate_face(complex, f)) {
      for (unsigned i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
        sides.push_back({low, high});
      }
    }
    if (sides.empty()) continue;
    std::vector<Edge> column = odd_ones(std::move(sides));
    bool reduced = false;
    while (!column.empty() && !reduced) {
      const auto [at, is_new] = columns.try_emplace(column.back());
      if (is_new) {
        at->second = std::move(column);
        reduced = true;
        continue;
      }
      std::vector<Edge> sum;
      std::set_symmetric_difference(column.begin(), column.end(), at->second.begin(),
                                    at->second.end(), std::back_inserter(sum));
      column = std::move(sum);
    }
    if (!reduced) return true;
  }
  return false;
}

}  // namespace circumball
