#include "predicates/expansion.h"

#include <cmath>

namespace circumball::internal {

int add_components(const double* e, int ne, const double* f, int nf, double* h) {
  if (ne == 0 || nf == 0) {
    const double* only = ne == 0 ? f : e;
    for (int i = 0; i < ne + nf; ++i) h[i] = only[i];
    return ne + nf;
  }
  // The components of both in order of increasing magnitude.
  int i = 0, j = 0;
  const auto next = [&] {
    if (j == nf || (i < ne && std::fabs(e[i]) < std::fabs(f[j]))) return e[i++];
    return f[j++];
  };
  const int total = ne + nf;
  int n = 0;
  const double smallest = next();
  const TwoDoubles start = fast_two_sum(next(), smallest);
  if (start.low != 0) h[n++] = start.low;
  double q = start.high;
  for (int taken = 2; taken < total; ++taken) {
    const TwoDoubles s = two_sum(q, next());
    if (s.low != 0) h[n++] = s.low;
    q = s.high;
  }
  if (q != 0) h[n++] = q;
  return n;
}

int scale_components(const double* e, int ne, double b, double* h) {
  if (ne == 0) return 0;
  const TwoDoubles halves = split(b);
  int n = 0;
  const TwoDoubles p = two_product(e[0], b, halves);
  if (p.low != 0) h[n++] = p.low;
  double q = p.high;
  for (int i = 1; i < ne; ++i) {
    const TwoDoubles t = two_product(e[i], b, halves);
    const TwoDoubles s = two_sum(q, t.low);
    if (s.low != 0) h[n++] = s.low;
    const TwoDoubles r = fast_two_sum(t.high, s.high);
    if (r.low != 0) h[n++] = r.low;
    q = r.high;
  }
  if (q != 0) h[n++] = q;
  return n;
}

int multiply_components(const double* e, int ne, const double* f, int nf, double* h,
                        double* scratch, double* line) {
  // One scaled copy of the longer factor for each component of the shorter one.
  if (ne < nf) return multiply_components(f, nf, e, ne, h, scratch, line);
  if (nf == 0) return 0;
  if (nf == 1) return scale_components(e, ne, f[0], h);
  // The sums take turns in two buffers; the number of turns says which comes last.
  double* from = nf % 2 == 0 ? scratch : h;
  double* to = nf % 2 == 0 ? h : scratch;
  int n = scale_components(e, ne, f[0], from);
  for (int i = 1; i < nf; ++i) {
    const int nl = scale_components(e, ne, f[i], line);
    n = add_components(from, n, line, nl, to);
    double* t = from;
    from = to;
    to = t;
  }
  return n;
}

}  // namespace circumball::internal
