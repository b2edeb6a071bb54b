#include "complex/shells.h"

#include <utility>

#include "delaunay/constructions.h"
#include "predicates/double_bits.h"

namespace circumball {

void Shells::track(const Complex& complex, std::vector<bool> centers) {
  complex_ = &complex;
  centers_ = std::move(centers);
}

Shells::Position Shells::position(VertexId v, SegmentId segment) const {
  const auto& ends = complex_->segments[segment.value];
  if (v.value != ends[0] && v.value != ends[1]) return positions_[v.value];
  const double length = distance(xy(complex_->vertices[ends[0]]), xy(complex_->vertices[ends[1]]));
  return v.value == ends[0] ? Position{0, length} : Position{length, 0};
}

std::optional<Shells::Shell> Shells::shell_of(VertexId a, VertexId b, SegmentId segment) const {
  const auto& ends = complex_->segments[segment.value];
  if (a.value == ends[0] && centers_[a.value]) {
    const double length = position(b, segment).from_first;
    return Shell{a, shell_radius(length), length};
  }
  if (b.value == ends[1] && centers_[b.value]) {
    const double length = position(a, segment).from_second;
    return Shell{b, shell_radius(length), length};
  }
  return std::nullopt;
}

void Shells::split(VertexId a, VertexId b, SegmentId segment, VertexId m) {
  const Position p = position(a, segment), q = position(b, segment);
  Position at{0.5 * (p.from_first + q.from_first), 0.5 * (p.from_second + q.from_second)};
  if (const auto shell = shell_of(a, b, segment)) {
    const double rest = shell->length - shell->radius;
    at = shell->center == a ? Position{shell->radius, q.from_second + rest}
                            : Position{p.from_first + rest, shell->radius};
  }
  if (positions_.size() <= m.value) positions_.resize(m.value + 1);
  positions_[m.value] = at;
}

double shell_radius(double length) {
  const double half = 0.5 * length;
  // Lengths are far from the ends of the exponents: without its mantissa, half is a power of two.
  const double below = internal::from_bits(internal::to_bits(half) & 0x7ff0000000000000u);
  return half - below <= 2 * below - half ? below : 2 * below;
}

}  // namespace circumball
