#ifndef CIRCUMBALL_IO_SEGMENT_TABLE_H_
#define CIRCUMBALL_IO_SEGMENT_TABLE_H_

#include <cstdint>
#include <unordered_map>

#include "circumball/complex.h"

namespace circumball::io {

/// Finds the segments of a complex by their ends, whichever way they run, and adds those that are
/// new. A side that several loops share is one segment.
class SegmentTable {
 public:
  explicit SegmentTable(Complex* complex) : complex_(*complex) {
    for (std::uint32_t i = 0; i < complex_.segments.size(); ++i)
      numbers_.try_emplace(key(complex_.segments[i][0], complex_.segments[i][1]), i);
  }

  /// The number of segment ab. A new one has marker 0 where the complex has markers.
  std::uint32_t number(std::uint32_t a, std::uint32_t b) {
    const auto [it, fresh] =
        numbers_.try_emplace(key(a, b), static_cast<std::uint32_t>(complex_.segments.size()));
    if (fresh) {
      if (!complex_.segment_markers.empty()) complex_.segment_markers.push_back(0);
      complex_.segments.push_back({a, b});
    }
    return it->second;
  }

  /// Every side of the loops of `face`, as `with_sides` has it: the smaller number first. Sides
  /// that lead nowhere or to their own beginning are left to `check`, which tells of the loop.
  void add_sides(const Face& face) {
    const std::size_t n = complex_.vertices.size();
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i], b = loop[i + 1 < loop.size() ? i + 1 : 0];
        if (a != b && a < n && b < n) number(a < b ? a : b, a < b ? b : a);
      }
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
  }
  struct Hash {  // used for look-up only: nothing ever depends on its order
    std::size_t operator()(std::uint64_t k) const {
      k = (k ^ (k >> 32)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(k ^ (k >> 29));
    }
  };

  Complex& complex_;
  std::unordered_map<std::uint64_t, std::uint32_t, Hash> numbers_;
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_SEGMENT_TABLE_H_
