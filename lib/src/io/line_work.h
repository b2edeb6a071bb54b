#ifndef CIRCUMBALL_IO_LINE_WORK_H_
#define CIRCUMBALL_IO_LINE_WORK_H_

#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <unordered_map>

#include "circumball/complex.h"

namespace circumball::io {

/// Builds a complex of the plane from drawn lines: points with equal bits are one vertex, in order
/// of appearance; lines of no length and lines drawn twice are dropped.
class LineWork {
 public:
  explicit LineWork(Complex* complex) : complex_(*complex) {}

  std::uint32_t vertex(double x, double y) {
    x += 0.0;  // -0 and 0 are one place
    y += 0.0;
    const auto [it, fresh] = numbers_.try_emplace(
        Key{bits(x), bits(y)}, static_cast<std::uint32_t>(complex_.vertices.size()));
    if (fresh) complex_.vertices.push_back({x, y, 0});
    return it->second;
  }

  void segment(std::uint32_t a, std::uint32_t b) {
    if (a == b || !seen_.insert(a < b ? Key{a, b} : Key{b, a}).second) return;
    complex_.segments.push_back({a, b});
  }

 private:
  using Key = std::array<std::uint64_t, 2>;
  struct Hash {  // used for look-up only: nothing ever depends on its order
    std::size_t operator()(const Key& k) const {
      std::uint64_t h = (k[0] ^ (k[0] >> 32)) * 0x9e3779b97f4a7c15u;
      h = (h ^ (h >> 29) ^ k[1]) * 0xbf58476d1ce4e5b9u;
      return static_cast<std::size_t>(h ^ (h >> 32));
    }
  };
  static std::uint64_t bits(double value) {
    std::uint64_t b = 0;
    std::memcpy(&b, &value, sizeof b);
    return b;
  }

  Complex& complex_;
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
  std::set<Key> seen_;
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_LINE_WORK_H_
