#include "delaunay/spatial_order.h"

#include <array>

namespace circumball {
namespace {

/// Four levels of the curve at once. A state says how the curve lies in its cell: bit 0, axes
/// swapped; bit 1, both reversed. The entry of (state, 4 bits of x, 4 bits of y) holds 8 bits of
/// the key, and the next state above them.
struct HilbertTable {
  std::array<std::uint16_t, 1024> entry{};
  constexpr HilbertTable() {
    for (std::uint32_t start = 0; start < 4; ++start)
      for (std::uint32_t x = 0; x < 16; ++x)
        for (std::uint32_t y = 0; y < 16; ++y) {
          std::uint32_t state = start, key = 0;
          for (int bit = 3; bit >= 0; --bit) {
            std::uint32_t u = x >> bit & 1, v = y >> bit & 1;
            if (state & 2) u ^= 1, v ^= 1;
            if (state & 1) {
              const std::uint32_t w = u;
              u = v;
              v = w;
            }
            key = key << 2 | ((3 * u) ^ v);
            if (v == 0) state ^= u ? 3 : 1;
          }
          entry[start << 8 | x << 4 | y] = static_cast<std::uint16_t>(state << 8 | key);
        }
  }
};
constexpr HilbertTable kHilbert;

/// One level of the curve in space, after Hamilton ("Compact Hilbert indices", 2006): a cell is
/// entered at corner `entry`, and left along axis `direction` from it; state is 3 * entry +
/// direction. The entry of (state, octant) holds 3 bits of the key, and the next state above them.
struct HilbertTable3 {
  std::array<std::uint8_t, 24 * 8> entry{};
  static constexpr std::uint32_t rotated(std::uint32_t bits, std::uint32_t left) {
    return (bits << left | bits >> (3 - left)) & 7;
  }
  static constexpr std::uint32_t gray(std::uint32_t i) { return i ^ i >> 1; }
  constexpr HilbertTable3() {
    for (std::uint32_t state = 0; state < 24; ++state) {
      const std::uint32_t corner = state / 3, direction = state % 3;
      for (std::uint32_t octant = 0; octant < 8; ++octant) {
        // The octant's place on the curve: the inverse Gray code in the cell's own frame.
        std::uint32_t place = rotated(octant ^ corner, 2 - direction);
        place ^= place >> 1 ^ place >> 2;
        // Where the curve enters that octant, and along which axis it leaves it, in that frame.
        const std::uint32_t enters = place == 0 ? 0 : gray((place - 1) & ~1u);
        std::uint32_t along = 0;
        if (place != 0)
          for (std::uint32_t i = place % 2 == 0 ? place - 1 : place; i & 1; i >>= 1) ++along;
        const std::uint32_t next =
            3 * (corner ^ rotated(enters, (direction + 1) % 3)) + (direction + along + 1) % 3;
        entry[8 * state + octant] = static_cast<std::uint8_t>(next << 3 | place);
      }
    }
  }
};
constexpr HilbertTable3 kHilbert3;

/// Mixes 64 bits (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
std::uint64_t splitmix64(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

}  // namespace

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t state = 0, key = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const std::uint32_t e = kHilbert.entry[state << 8 | (x >> shift & 15) << 4 | (y >> shift & 15)];
    key = key << 8 | (e & 255);
    state = e >> 8;
  }
  return key;
}

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::uint32_t state = 0, key = 0;
  for (int bit = 9; bit >= 0; --bit) {
    const std::uint32_t octant = (x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2;
    const std::uint32_t e = kHilbert3.entry[8 * state + octant];
    key = key << 3 | (e & 7);
    state = e >> 3;
  }
  return key;
}

void sort_keyed(std::uint64_t* first, std::uint64_t* last, std::uint64_t* scratch) {
  const std::size_t n = static_cast<std::size_t>(last - first);
  if (n < 2048) return std::sort(first, last);  // smaller than the counters below
  // Radix sort of the upper half, 11 bits a pass, the lowest first; each pass keeps ties in order.
  constexpr int kBits = 11, kPasses = 3;
  constexpr std::uint32_t kBuckets = 1u << kBits;
  std::vector<std::uint32_t> counts(kPasses * kBuckets, 0);
  for (const std::uint64_t* i = first; i != last; ++i)
    for (int pass = 0; pass < kPasses; ++pass)
      ++counts[pass * kBuckets + (*i >> (32 + pass * kBits) & (kBuckets - 1))];
  std::uint64_t *from = first, *to = scratch;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::uint32_t* start = &counts[pass * kBuckets];
    std::uint32_t sum = 0;
    for (std::uint32_t b = 0; b < kBuckets; ++b) {
      const std::uint32_t count = start[b];
      start[b] = sum;
      sum += count;
    }
    for (std::size_t i = 0; i < n; ++i)
      to[start[from[i] >> (32 + pass * kBits) & (kBuckets - 1)]++] = from[i];
    std::swap(from, to);
  }
  if (from != first) std::copy(from, from + n, first);
}

void deal_rounds(std::vector<std::uint32_t>* order) {
  constexpr std::size_t kFirstRound = 512;  // smaller rounds do not pay
  constexpr std::uint32_t kLevels = 12;
  std::uint32_t levels = 1;
  for (std::size_t n = order->size(); n > kFirstRound && levels < kLevels; n /= 4) ++levels;
  // The last round takes three quarters, the one before three quarters of the rest, and so on.
  const auto round_of = [&](std::uint32_t index) {
    std::uint64_t bits = splitmix64(index);
    std::uint32_t round = levels - 1;
    while (round > 0 && (bits & 3) == 0) {
      --round;
      bits >>= 2;
    }
    return round;
  };
  std::array<std::size_t, kLevels + 1> start{};
  std::vector<std::uint8_t> rounds;
  rounds.reserve(order->size());
  for (const std::uint32_t v : *order) {
    rounds.push_back(static_cast<std::uint8_t>(round_of(v)));
    ++start[rounds.back() + 1];
  }
  for (std::uint32_t r = 0; r < kLevels; ++r) start[r + 1] += start[r];
  std::vector<std::uint32_t> dealt(order->size());
  for (std::size_t i = 0; i < rounds.size(); ++i) dealt[start[rounds[i]]++] = (*order)[i];
  order->swap(dealt);
}

}  // namespace circumball
