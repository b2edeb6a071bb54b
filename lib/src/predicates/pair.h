#ifndef CIRCUMBALL_PREDICATES_PAIR_H_
#define CIRCUMBALL_PREDICATES_PAIR_H_

#include <cstdint>

/// Two doubles computed side by side, by the vector extension that GCC and Clang share. On
/// processors with such registers (SSE2, NEON) a filter written in pairs leaves room for its error
/// bound; elsewhere, and in WebAssembly without SIMD, the compiler takes the pairs apart. Either
/// way each lane is rounded as a double is.
namespace circumball::internal {

typedef double Pair __attribute__((vector_size(16)));
typedef std::int64_t PairBits __attribute__((vector_size(16)));

inline Pair both(double x) { return Pair{x, x}; }
inline Pair swapped(Pair p) { return Pair{p[1], p[0]}; }
inline Pair absolute(Pair p) {
  constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(p) & PairBits{kAllButSign, kAllButSign});
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_PAIR_H_
