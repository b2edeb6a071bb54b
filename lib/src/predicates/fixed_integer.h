#ifndef CIRCUMBALL_PREDICATES_FIXED_INTEGER_H_
#define CIRCUMBALL_PREDICATES_FIXED_INTEGER_H_

#include <cstdint>

/// Integers of a few machine words, whose width the type says: sums and products of them cannot
/// overflow where the caller has counted the bits, and there are no branches.
namespace circumball::internal {

/// 128 bits are an extension that GCC and Clang share, on every target that they are used for.
__extension__ typedef unsigned __int128 DoubleLimb;

/// Two's complement in N limbs of 64 bits, the lowest first.
template <int N>
struct FixedInteger {
  std::uint64_t limb[N];

  bool negative() const { return limb[N - 1] >> 63; }
  int sign() const {
    std::uint64_t any = 0;
    for (int i = 0; i < N; ++i) any |= limb[i];
    return negative() ? -1 : any != 0;
  }
};

inline FixedInteger<1> fixed_integer(std::int64_t value) {
  return {{static_cast<std::uint64_t>(value)}};
}

template <int N>
inline FixedInteger<N> operator+(const FixedInteger<N>& a, const FixedInteger<N>& b) {
  FixedInteger<N> r;
  DoubleLimb carry = 0;
  for (int i = 0; i < N; ++i) {
    carry += DoubleLimb{a.limb[i]} + b.limb[i];
    r.limb[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return r;
}

template <int N>
inline FixedInteger<N> operator-(const FixedInteger<N>& a, const FixedInteger<N>& b) {
  FixedInteger<N> r;
  DoubleLimb carry = 1;
  for (int i = 0; i < N; ++i) {
    carry += DoubleLimb{a.limb[i]} + ~b.limb[i];
    r.limb[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return r;
}

/// Schoolbook multiplication of the residues modulo 2^64N and 2^64M; then a negative factor's
/// 2^64N, which its residue is too large by, is taken from the product.
template <int N, int M>
inline FixedInteger<N + M> operator*(const FixedInteger<N>& a, const FixedInteger<M>& b) {
  FixedInteger<N + M> r{};
  for (int i = 0; i < N; ++i) {
    DoubleLimb carry = 0;
    for (int j = 0; j < M; ++j) {
      carry += DoubleLimb{a.limb[i]} * b.limb[j] + r.limb[i + j];
      r.limb[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    r.limb[i + M] = static_cast<std::uint64_t>(carry);
  }
  const auto correct = [&r](const auto& factor, int size, std::uint64_t mask) {
    DoubleLimb carry = mask & 1;
    for (int i = 0; i < size; ++i) {
      carry += DoubleLimb{r.limb[N + M - size + i]} + (~factor.limb[i] & mask);
      r.limb[N + M - size + i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  };
  correct(b, M, a.negative() ? ~std::uint64_t{0} : 0);
  correct(a, N, b.negative() ? ~std::uint64_t{0} : 0);
  return r;
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_FIXED_INTEGER_H_
