#ifndef CIRCUMBALL_PREDICATES_WIDE_INTEGER_H_
#define CIRCUMBALL_PREDICATES_WIDE_INTEGER_H_

#include <cassert>
#include <cstdint>

#include "predicates/double_bits.h"

/// Integers wide enough for a polynomial of degree six in the coordinates, on the stack, for the
/// one predicate whose range no expansion of doubles has room for: coordinates of 1e-45 to 1e55
/// reach over 386 bits, six of them multiplied over more than 2,316, and the exponents of doubles
/// over 2,098.
namespace circumball::internal {

/// Sign and magnitude, in limbs of 32 bits, the lowest first. Schoolbook multiplication (Knuth, The
/// Art of Computer Programming 2, 4.3.1, algorithm M); the length is that of the value, so ordinary
/// coordinates stay short.
class WideInteger {
 public:
  /// Room for degree six over all doubles: 6 * (2,100 + 1) bits and a few for the sums.
  static constexpr int kCapacity = 396;

  WideInteger() = default;
  WideInteger(const WideInteger& other) { *this = other; }
  WideInteger& operator=(const WideInteger& other) {
    size_ = other.size_;
    negative_ = other.negative_;
    for (int i = 0; i < size_; ++i) limb_[i] = other.limb_[i];
    return *this;
  }

  /// value / 2^unit, for a `unit` of at most the exponent of value.
  WideInteger(const Decoded& value, int unit) : negative_(value.negative) {
    if (value.mantissa == 0) return;
    const int shift = value.exponent - unit;
    assert(shift >= 0);
    const int skip = shift / 32, bits = shift % 32;
    for (int i = 0; i < skip; ++i) limb_[i] = 0;
    const std::uint64_t low = (value.mantissa & 0xffffffffu) << bits;
    const std::uint64_t high = ((value.mantissa >> 32) << bits) + (low >> 32);
    limb_[skip] = static_cast<std::uint32_t>(low);
    limb_[skip + 1] = static_cast<std::uint32_t>(high);
    limb_[skip + 2] = static_cast<std::uint32_t>(high >> 32);
    size_ = skip + 3;
    trim();
  }

  int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  friend WideInteger operator-(const WideInteger& a) {
    WideInteger r = a;
    r.negative_ = !a.negative_;
    return r;
  }

  friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    WideInteger r;
    if (a.negative_ == b.negative_) {
      r.set_sum(a, b);
      r.negative_ = a.negative_;
    } else if (compare_magnitudes(a, b) >= 0) {
      r.set_difference(a, b);
      r.negative_ = a.negative_;
    } else {
      r.set_difference(b, a);
      r.negative_ = b.negative_;
    }
    return r;
  }

  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) { return a + (-b); }

  friend WideInteger operator*(const WideInteger& a, const WideInteger& b) {
    WideInteger r;
    r.size_ = a.size_ + b.size_;
    assert(r.size_ <= kCapacity);
    for (int i = 0; i < r.size_; ++i) r.limb_[i] = 0;
    for (int i = 0; i < a.size_; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; j < b.size_; ++j) {
        carry += std::uint64_t{a.limb_[i]} * b.limb_[j] + r.limb_[i + j];
        r.limb_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      r.limb_[i + b.size_] = static_cast<std::uint32_t>(carry);
    }
    r.negative_ = a.negative_ != b.negative_;
    r.trim();
    return r;
  }

 private:
  static int compare_magnitudes(const WideInteger& a, const WideInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
    for (int i = a.size_; i-- > 0;) {
      if (a.limb_[i] != b.limb_[i]) return a.limb_[i] < b.limb_[i] ? -1 : 1;
    }
    return 0;
  }

  void set_sum(const WideInteger& a, const WideInteger& b) {
    const int n = a.size_ > b.size_ ? a.size_ : b.size_;
    assert(n < kCapacity);
    std::uint64_t carry = 0;
    for (int i = 0; i < n; ++i) {
      carry += std::uint64_t{a.limb(i)} + b.limb(i);
      limb_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    limb_[n] = static_cast<std::uint32_t>(carry);
    size_ = n + 1;
    trim();
  }

  /// |a| - |b|, for |a| >= |b|.
  void set_difference(const WideInteger& a, const WideInteger& b) {
    std::uint64_t borrow = 0;
    for (int i = 0; i < a.size_; ++i) {
      const std::uint64_t t = std::uint64_t{a.limb_[i]} - b.limb(i) - borrow;
      limb_[i] = static_cast<std::uint32_t>(t);
      borrow = t >> 63;
    }
    size_ = a.size_;
    trim();
  }

  std::uint32_t limb(int i) const { return i < size_ ? limb_[i] : 0; }
  void trim() {
    while (size_ > 0 && limb_[size_ - 1] == 0) --size_;
  }

  int size_ = 0;
  bool negative_ = false;
  std::uint32_t limb_[kCapacity];
};

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_WIDE_INTEGER_H_
