#ifndef CIRCUMBALL_REFINEMENT_PICKING_REGION_H_
#define CIRCUMBALL_REFINEMENT_PICKING_REGION_H_

#include <cstdint>

#include "circumball/types.h"

namespace circumball {

/// Points of concentric balls, uniform and independent as far as anybody can tell; the same for the
/// same key, everywhere. The generator counts: number k of a key is a mix of both (SplitMix64:
/// Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class PickingRegion {
 public:
  PickingRegion(const Point3& center, double radius, std::uint64_t key)
      : center_(center), radius_(radius), state_(mix(key)) {}

  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  }

  /// The next point, of the ball of `part` of the radius; its coordinates are rounded.
  Point3 next(double part) {
    const double r = part * radius_;
    for (;;) {  // of a cube about the ball: every second point is in the ball
      const double x = coordinate(), y = coordinate(), z = coordinate();
      if (x * x + y * y + z * z <= 1) {
        return {center_.x + r * x, center_.y + r * y, center_.z + r * z};
      }
    }
  }

 private:
  /// In [-1, 1), a multiple of 2^-52.
  double coordinate() {
    state_ += 0x9e3779b97f4a7c15u;
    return static_cast<double>(mix(state_) >> 11) * 0x1p-52 - 1;
  }

  Point3 center_;
  double radius_;
  std::uint64_t state_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_PICKING_REGION_H_
