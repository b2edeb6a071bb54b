#ifndef CIRCUMBALL_PREDICATES_TWOFOLD_H_
#define CIRCUMBALL_PREDICATES_TWOFOLD_H_

#include "predicates/expansion.h"

namespace circumball::internal {

/// A double-double number: the unevaluated sum high + low, |low| at most half an ulp of high
/// (Dekker 1971). With u = 2^-53, relative errors are at most 3 u^2 + 13 u^3 of a sum and 7 u^2 of
/// a product (Joldes, Muller and Popescu, Tight and rigorous error bounds for basic building blocks
/// of double-word arithmetic, ACM TOMS 44, 2017, algorithms 6 and 10), where nothing under- or
/// overflows.
struct Twofold {
  double high = 0, low = 0;
};
inline Twofold twofold(const TwoDoubles& d) { return {d.high, d.low}; }

inline Twofold operator+(const Twofold& a, const Twofold& b) {
  const TwoDoubles s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
  const TwoDoubles v = fast_two_sum(s.high, s.low + t.high);
  return twofold(fast_two_sum(v.high, t.low + v.low));
}

inline Twofold operator-(const Twofold& a, const Twofold& b) {
  return a + Twofold{-b.high, -b.low};
}

inline Twofold operator*(const Twofold& a, const Twofold& b) {
  const TwoDoubles p = two_product(a.high, b.high);
  return twofold(fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high)));
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_TWOFOLD_H_
