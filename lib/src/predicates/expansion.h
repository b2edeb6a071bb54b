#ifndef CIRCUMBALL_PREDICATES_EXPANSION_H_
#define CIRCUMBALL_PREDICATES_EXPANSION_H_

/// Exact arithmetic with expansions: a number is an unevaluated sum of doubles, its components.
///
/// Sources: T. J. Dekker, A floating-point technique for extending the available precision, 1971
/// (product, fast sum); D. E. Knuth, The Art of Computer Programming 2, 4.2.2 (sum without a
/// comparison); J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust
/// geometric predicates, 1997 (expansions; theorem numbers below).
///
/// Components stand in order of increasing magnitude, none is zero, and they are strongly
/// nonoverlapping, which sum (theorem 13) and scaling (theorem 19, with ties rounded to even)
/// preserve. So the last component carries the sign of the whole, and an expansion without
/// components is zero. Everything lives on the stack: the template parameter is the capacity, and
/// the capacity of a result is the worst case.
///
/// Requires round-to-nearest-even doubles, no contraction, and no over- or underflow: see
/// predicates/fast.h for why polynomials of degree five in the coordinates have none.
namespace circumball::internal {

/// x + y = high + low exactly; low is the rounding error of high.
struct TwoDoubles {
  double high, low;
};

/// Knuth's sum: six operations, no condition.
inline TwoDoubles two_sum(double a, double b) {
  const double s = a + b;
  const double b_virtual = s - a;
  const double a_virtual = s - b_virtual;
  return {s, (a - a_virtual) + (b - b_virtual)};
}

/// Dekker's sum: three operations, needs |a| >= |b| or a = 0.
inline TwoDoubles fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

inline TwoDoubles two_difference(double a, double b) { return two_sum(a, -b); }

/// Veltkamp's split into halves of at most 26 bits each, as Dekker gives it.
inline TwoDoubles split(double a) {
  const double c = 0x8000001p0 * a;  // 2^27 + 1
  const double high = c - (c - a);
  return {high, a - high};
}

/// Dekker's product of a and b, the halves of b being known.
inline TwoDoubles two_product(double a, double b, TwoDoubles b_halves) {
  const double p = a * b;
  const TwoDoubles h = split(a);
  const double e1 = p - h.high * b_halves.high;
  const double e2 = e1 - h.low * b_halves.high;
  const double e3 = e2 - h.high * b_halves.low;
  return {p, h.low * b_halves.low - e3};
}

inline TwoDoubles two_product(double a, double b) { return two_product(a, b, split(b)); }

/// Writes e + f to h (which has room for ne + nf components) and returns the number of components.
/// Shewchuk's Fast-Expansion-Sum, theorem 13, dropping zeros.
int add_components(const double* e, int ne, const double* f, int nf, double* h);

/// Writes b e to h (room for 2 ne) and returns the number of components.
/// Shewchuk's Scale-Expansion, theorem 19, dropping zeros.
int scale_components(const double* e, int ne, double b, double* h);

/// Writes e f to h and returns the number of components. h and scratch have room for 2 ne nf each,
/// which must not be zero; line for 2 max(ne, nf).
int multiply_components(const double* e, int ne, const double* f, int nf, double* h,
                        double* scratch, double* line);

template <int Capacity>
struct Expansion {
  int size = 0;
  double component[Capacity];

  Expansion() = default;
  Expansion(const Expansion& other) : size(other.size) {
    for (int i = 0; i < size; ++i) component[i] = other.component[i];
  }
  Expansion& operator=(const Expansion& other) {
    size = other.size;
    for (int i = 0; i < size; ++i) component[i] = other.component[i];
    return *this;
  }
  /// Takes another capacity; `other` must fit.
  template <int Other>
  explicit Expansion(const Expansion<Other>& other) : size(other.size) {
    static_assert(Other <= Capacity);
    for (int i = 0; i < size; ++i) component[i] = other.component[i];
  }

  /// A double of the sign of the sum, within one unit in the last place of it.
  double sign() const { return size == 0 ? 0.0 : component[size - 1]; }
};

inline Expansion<1> expansion(double a) {
  Expansion<1> h;
  h.component[0] = a;
  h.size = a != 0;
  return h;
}

inline Expansion<2> expansion(TwoDoubles t) {
  Expansion<2> h;
  if (t.low != 0) h.component[h.size++] = t.low;
  if (t.high != 0) h.component[h.size++] = t.high;
  return h;
}

inline Expansion<2> difference(double a, double b) { return expansion(two_difference(a, b)); }

template <int N>
Expansion<N> operator-(const Expansion<N>& e) {
  Expansion<N> h;
  h.size = e.size;
  for (int i = 0; i < e.size; ++i) h.component[i] = -e.component[i];
  return h;
}

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> h;
  h.size = add_components(e.component, e.size, f.component, f.size, h.component);
  return h;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + (-f);
}

template <int N>
Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> h;
  h.size = b == 0 ? 0 : scale_components(e.component, e.size, b, h.component);
  return h;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<2 * N * M> h;
  double scratch[2 * N * M];
  double line[2 * (N > M ? N : M)];
  h.size =
      multiply_components(e.component, e.size, f.component, f.size, h.component, scratch, line);
  return h;
}

template <int N>
Expansion<2 * N * N> square(const Expansion<N>& e) {
  return e * e;
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_EXPANSION_H_
