#ifndef CIRCUMBALL_DELAUNAY_SPATIAL_ORDER_H_
#define CIRCUMBALL_DELAUNAY_SPATIAL_ORDER_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "circumball/types.h"

/// The order in which a batch of points is inserted: near each other in a row, and yet random
/// enough for the bound on the expected work to hold.
namespace circumball {

/// Place of a cell of a 65536 x 65536 grid along the Hilbert curve.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y);
/// Place of a cell of a 1024 x 1024 x 1024 grid along the Hilbert curve of space.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// Sorts numbers by the upper half of their bits, a key; ties end in an order that depends on the
/// input alone. `scratch` has the same size.
void sort_keyed(std::uint64_t* first, std::uint64_t* last, std::uint64_t* scratch);

/// Deals an order into rounds, each about four times as large as all before it, that keep the order
/// within (Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003). Which round an index
/// gets depends on the index alone.
void deal_rounds(std::vector<std::uint32_t>* order);

namespace internal {

/// The cell of a coordinate on a grid of `side` cells, whatever the numbers.
inline std::uint32_t grid_cell(double offset, double width, double side) {
  const double cell = offset * (side / width);
  return cell >= side - 1 ? static_cast<std::uint32_t>(side) - 1
         : cell > 0       ? static_cast<std::uint32_t>(cell)
                          : 0u;
}

inline std::uint32_t curve_key(const Point2& p, const Point2& low, double width) {
  return hilbert_key(grid_cell(p.x - low.x, width, 65536), grid_cell(p.y - low.y, width, 65536));
}
inline std::uint32_t curve_key(const Point3& p, const Point3& low, double width) {
  return hilbert_key(grid_cell(p.x - low.x, width, 1024), grid_cell(p.y - low.y, width, 1024),
                     grid_cell(p.z - low.z, width, 1024));
}

inline Point2 minimum(const Point2& a, const Point2& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y)};
}
inline Point3 minimum(const Point3& a, const Point3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Point2 maximum(const Point2& a, const Point2& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y)};
}
inline Point3 maximum(const Point3& a, const Point3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
inline double greatest_side(const Point2& low, const Point2& high) {
  return std::max(high.x - low.x, high.y - low.y);
}
inline double greatest_side(const Point3& low, const Point3& high) {
  return std::max(std::max(high.x - low.x, high.y - low.y), high.z - low.z);
}

inline bool lexicographically_less(const Point2& p, const Point2& q) {
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}
inline bool lexicographically_less(const Point3& p, const Point3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

template <class At>
void sort_run(const At& at, std::uint64_t* first, std::uint64_t* last, std::uint64_t* scratch) {
  const auto index = [](std::uint64_t item) { return static_cast<std::uint32_t>(item); };
  const auto lexicographic = [&](std::uint64_t a, std::uint64_t b) {
    const auto &p = at(index(a)), &q = at(index(b));
    return p == q ? index(a) < index(b) : lexicographically_less(p, q);
  };
  constexpr std::ptrdiff_t kSmallRun = 8;  // below it, one order is as good as another
  if (last - first <= kSmallRun) return std::sort(first, last, lexicographic);

  auto low = at(index(*first)), high = low;
  for (const std::uint64_t* i = first; i != last; ++i) {
    low = minimum(low, at(index(*i)));
    high = maximum(high, at(index(*i)));
  }
  const double width = greatest_side(low, high);
  for (std::uint64_t* i = first; i != last; ++i)
    *i = std::uint64_t{curve_key(at(index(*i)), low, width)} << 32 | index(*i);
  sort_keyed(first, last, scratch);
  if (first[0] >> 32 == last[-1] >> 32) return std::sort(first, last, lexicographic);  // all equal
  for (std::uint64_t *run = first, *end; run != last; run = end) {
    end = run + 1;
    while (end != last && *end >> 32 == *run >> 32) ++end;
    if (end - run > 1) sort_run(at, run, end, scratch + (run - first));
  }
}

}  // namespace internal

/// Sorts indices of points, at(index) -> const Point2& or const Point3&, along the Hilbert curve of
/// their bounding square or cube; points that share a cell of its grid, along a finer curve, so
/// that clusters of any size are in order. Of points with equal coordinates only the lowest index
/// stays; returns pairs (an index that went, the one that stayed). O(n log n).
template <class At>
std::vector<std::pair<std::uint32_t, std::uint32_t>> sort_along_hilbert_curve(
    const At& at, std::vector<std::uint32_t>* order) {
  std::vector<std::uint64_t> items(order->begin(), order->end()), scratch(items.size());
  if (!items.empty())
    internal::sort_run(at, items.data(), items.data() + items.size(), scratch.data());
  // Points with equal coordinates have shared every cell, so their keys are equal, and they end
  // side by side in the order of their indices.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;
  std::size_t kept = 0;
  std::uint64_t last_key = ~std::uint64_t{0};
  for (const std::uint64_t item : items) {
    const std::uint32_t i = static_cast<std::uint32_t>(item);
    if (item >> 32 == last_key && at((*order)[kept - 1]) == at(i)) {
      duplicates.emplace_back(i, (*order)[kept - 1]);
      continue;
    }
    last_key = item >> 32;
    (*order)[kept++] = i;
  }
  order->resize(kept);
  return duplicates;
}

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_SPATIAL_ORDER_H_
