#include "complex/ring.h"

#include <algorithm>
#include <cmath>

#include "predicates/elementary.h"

namespace circumball {

VertexId Ring::at(RingKey key) const {
  const auto found =
      std::lower_bound(vertices.begin(), vertices.end(), key,
                       [](const RingVertex& v, RingKey wanted) { return v.key < wanted; });
  return found != vertices.end() && found->key == key ? found->vertex : VertexId();
}

RingKey Ring::key_of(VertexId v) const {
  const auto found = std::find_if(vertices.begin(), vertices.end(),
                                  [&](const RingVertex& r) { return r.vertex == v; });
  return found == vertices.end() ? 0 : found->key;
}

Point3 Tube::direction(RingKey key) const {
  const std::size_t base = key / kRingGap;
  RingKey low = base * kRingGap, high = low + kRingGap;
  Point3 a = bases[base].direction;
  if (key == low) return a;
  Point3 b = bases[(base + 1) % bases.size()].direction;
  for (;;) {
    const Point3 sum{a.x + b.x, a.y + b.y, a.z + b.z};
    const double scale = 1 / std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
    const Point3 mean{scale * sum.x, scale * sum.y, scale * sum.z};
    const RingKey middle = low + (high - low) / 2;
    if (middle == key || high - low <= 1) return mean;
    if (key < middle) {
      high = middle;
      b = mean;
    } else {
      low = middle;
      a = mean;
    }
  }
}

bool Tube::holds(const Point3& p) const {
  const double x = p.x - origin.x, y = p.y - origin.y, z = p.z - origin.z;
  const double along = x * axis.x + y * axis.y + z * axis.z;
  if (profile.empty() || !(along >= profile.front().x && along <= profile.back().x)) return false;
  const double radius2 = x * x + y * y + z * z - along * along;
  const auto above = std::upper_bound(profile.begin(), profile.end() - 1, along,
                                      [](double t, const Point2& q) { return t < q.x; });
  const Point2 &q = *above, &r = above == profile.begin() ? *above : *(above - 1);
  const double part = q.x > r.x ? (along - r.x) / (q.x - r.x) : 0;
  const double radius = r.y + part * (q.y - r.y);
  return radius2 < radius * radius;
}

unsigned parts_of_sixty_degrees(double angle) {
  // Not one more for what rounding makes of 60 degrees.
  const double parts = std::ceil(angle / (elementary::kPi / 3) - 1e-9);
  return parts > 1 ? static_cast<unsigned>(parts) : 1;
}

void fill_gaps(std::vector<BaseDirection>* bases, const Point3& first, const Point3& second) {
  std::vector<BaseDirection> all;
  const double turn = 2 * elementary::kPi;
  for (std::size_t i = 0; i < bases->size(); ++i) {
    const BaseDirection& from = (*bases)[i];
    const double to = i + 1 < bases->size() ? (*bases)[i + 1].angle : (*bases)[0].angle + turn;
    const unsigned parts = parts_of_sixty_degrees(to - from.angle);
    all.push_back(from);
    for (unsigned k = 1; k < parts; ++k) {
      const double angle = from.angle + (to - from.angle) * k / parts;
      const double c = elementary::cos(angle), s = elementary::sin(angle);
      all.push_back(
          {{c * first.x + s * second.x, c * first.y + s * second.y, c * first.z + s * second.z},
           kNoIndex,
           angle});
    }
  }
  *bases = std::move(all);
}

}  // namespace circumball
