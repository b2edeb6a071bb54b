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
    std::uint64_t carry = 0;
    for (int j = 0; j < M; ++j) {
      const DoubleLimb t = DoubleLimb{a.limb[i]} * b.limb[j] + r.limb[i + j] + carry;
      r.limb[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    r.limb[i + M] = carry;
  }
  const auto subtract_high = [&r](const auto& factor, int size, std::uint64_t mask) {
    std::uint64_t borrow = 0;
    for (int i = 0; i < size; ++i) {
      std::uint64_t& limb = r.limb[N + M - size + i];
      const DoubleLimb t = DoubleLimb{limb} - (factor.limb[i] & mask) - borrow;
      limb = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
  };
  subtract_high(b, M, a.negative() ? ~std::uint64_t{0} : 0);
  subtract_high(a, N, b.negative() ? ~std::uint64_t{0} : 0);
  return r;
}

inline FixedInteger<2> operator*(const FixedInteger<1>& a, const FixedInteger<1>& b) {
  __extension__ typedef __int128 Signed;
  const DoubleLimb t = static_cast<DoubleLimb>(Signed{static_cast<std::int64_t>(a.limb[0])} *
                                               static_cast<std::int64_t>(b.limb[0]));
  return {{static_cast<std::uint64_t>(t), static_cast<std::uint64_t>(t >> 64)}};
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_FIXED_INTEGER_H_
