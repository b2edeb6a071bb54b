#ifndef CIRCUMBALL_TESTS_SUPPORT_ACUTE_COMPLEXES_H_
#define CIRCUMBALL_TESTS_SUPPORT_ACUTE_COMPLEXES_H_

#include <algorithm>
#include <cstdint>

#include "circumball/complex.h"
#include "circumball/predicates.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

/// A generator of small valid complexes with everything that makes refinement hard: angles down to
/// a given one, gaps down to 1e-6, needles, hubs.
namespace circumball::testing {

class AcuteComplexes {
 public:
  /// `least`: the smallest angle between adjacent segments, in degrees; many are not much larger.
  AcuteComplexes(std::uint64_t seed, double least) : random_(seed), least_(least) {}

  Complex make() {
    do {
      complex_ = Complex();
      add_all();
    } while (smallest_angle_degrees(complex_) < 0.9 * least_);  // by chance
    return complex_;
  }

 private:
  void add_all() {
    const std::uint32_t side = random_.below(5) == 0 ? 2 : 1;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      center_ = {2.5 * (i % side), 2.5 * (i / side)};
      switch (random_.below(4)) {
        case 0:
          fan();
          break;
        case 1:
          star();
          break;
        case 2:
          soup();
          break;
        default:
          parallel_pairs();
      }
    }
    if (random_.below(3) == 0) add_square(&complex_, -1.5, -1.5, 2.5 * side + 0.5);
  }

  std::uint32_t vertex(const Point2& p) {
    complex_.vertices.push_back(xyz(p));
    return static_cast<std::uint32_t>(complex_.vertices.size() - 1);
  }
  static Point2 polar(const Point2& from, double radius, double degrees) {
    return testing::polar(from.x, from.y, radius, degrees);
  }
  double between(double a, double b) { return a + (b - a) * random_.unit(); }
  /// 10^-k with k between the two, evenly.
  double small(double k_low, double k_high) {
    return elementary::exp(-between(k_low, k_high) * 2.302585092994046);
  }

  /// Segments from a common vertex; some only the least angle apart.
  void fan() {
    const std::uint32_t hub = vertex(center_), count = 2 + random_.below(8);
    double angle = between(0, 360), turned = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      complex_.segments.push_back({hub, vertex(polar(center_, between(0.1, 0.95), angle))});
      const double step = i == 0             ? least_
                          : random_.below(2) ? least_ * between(1, 3)
                                             : between(least_, 60);
      angle += step;
      turned += step;
      if (turned + least_ + 60 > 360) break;
    }
  }

  /// A closed polygon with needle tips: corners at large and small radii in turn.
  void star() {
    const std::uint32_t tips = 3 + random_.below(4);
    const double turn = 360.0 / tips, start = between(0, 360);
    const auto first = static_cast<std::uint32_t>(complex_.vertices.size());
    for (std::uint32_t i = 0; i < tips; ++i) {
      const double at = start + turn * i, r = between(0.05, 0.3), far = between(0.7, 1);
      const double needle = least_ * between(1, 3) * (far - r) / (2 * r);  // as seen from its foot
      const double half = random_.below(2) ? 0.4 * turn : std::min(0.4 * turn, needle);
      vertex(polar(center_, r, at - half));
      vertex(polar(center_, far, at));
      vertex(polar(center_, r, at + half));
    }
    const auto n = static_cast<std::uint32_t>(complex_.vertices.size()) - first;
    for (std::uint32_t i = 0; i < n; ++i)
      complex_.segments.push_back({first + i, first + (i + 1) % n});
  }

  bool crosses(const Point2& a, const Point2& b, std::uint32_t shared_a, std::uint32_t shared_b,
               std::size_t from) const {
    for (std::size_t k = from; k < complex_.segments.size(); ++k) {
      const auto& s = complex_.segments[k];
      const Point2 p = xy(complex_.vertices[s[0]]), q = xy(complex_.vertices[s[1]]);
      const auto side = [](const Point2& u, const Point2& v, const Point2& w) {
        return static_cast<int>(orient2d(u, v, w));
      };
      const int pa = side(a, b, p), qa = side(a, b, q), ap = side(p, q, a), bp = side(p, q, b);
      const bool meets =
          s[0] == shared_a || s[1] == shared_a || s[0] == shared_b || s[1] == shared_b;
      if (meets ? pa == 0 && qa == 0 : pa * qa <= 0 && ap * bp <= 0) return true;
    }
    return false;
  }

  /// Segments that do not cross: anywhere, from an end of another one, or close beside it.
  void soup() {
    const std::size_t from = complex_.segments.size();
    const auto first = static_cast<std::uint32_t>(complex_.vertices.size());
    const std::uint32_t wanted = 2 + random_.below(10);
    for (std::uint32_t tries = 0; tries < 3 * wanted; ++tries) {
      if (complex_.segments.size() >= from + wanted) break;
      std::uint32_t shared = kNoIndex;
      Point2 a{center_.x + between(-0.8, 0.8), center_.y + between(-0.8, 0.8)};
      Point2 b{center_.x + between(-0.8, 0.8), center_.y + between(-0.8, 0.8)};
      if (complex_.segments.size() > from && random_.below(2)) {
        const auto old = complex_.segments[from + random_.below(static_cast<std::uint32_t>(
                                                      complex_.segments.size() - from))];
        shared = old[0];
        a = xy(complex_.vertices[shared]);
        if (random_.below(3) == 0) {  // turned by the least angle, or somewhat more
          const double radians = least_ * between(1, 2) * (elementary::kPi / 180);
          const Point2 q = xy(complex_.vertices[old[1]]);
          const double scale = between(0.2, 1.1), c = scale * elementary::cos(radians),
                       s = scale * elementary::sin(radians);
          b = {a.x + c * (q.x - a.x) - s * (q.y - a.y), a.y + s * (q.x - a.x) + c * (q.y - a.y)};
        }
      }
      if (a == b || crosses(a, b, shared, kNoIndex, from)) continue;
      const std::uint32_t n = shared == kNoIndex ? vertex(a) : shared;
      complex_.segments.push_back({n, vertex(b)});
    }
    if (complex_.vertices.size() == first) vertex(center_);
  }

  /// Two or three bundles of parallel segments; overlaps of at most some hundred gaps, since two
  /// parallels end in pieces of the size of their gap. Isolated vertices beside them.
  void parallel_pairs() {
    const std::uint32_t bundles = 1 + random_.below(3);
    for (std::uint32_t i = 0; i < bundles; ++i) {
      const double gap = small(1, 6), overlap = std::min(0.3, gap * between(0, 100));
      const double turned = between(-20, 20);
      const Point2 m{center_.x + between(-0.2, 0.2), center_.y - 0.8 + 0.7 * i};
      const auto place = [&](double along, double across) {
        return polar(polar(m, along, turned), across, turned + 90);
      };
      const auto line = [&](double from, double to, double across) {
        const std::uint32_t a = vertex(place(from, across));
        complex_.segments.push_back({a, vertex(place(to, across))});
      };
      line(-between(0.1, 0.6), overlap, 0);
      line(0, between(0.35, 0.6), gap);
      if (random_.below(3) == 0) vertex(place(-0.05, gap * between(1, 3)));
    }
  }

  Random random_;
  const double least_;
  Complex complex_;
  Point2 center_;
};

inline Complex random_acute_complex(std::uint64_t seed, double least) {
  return AcuteComplexes(seed, least).make();
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_ACUTE_COMPLEXES_H_
