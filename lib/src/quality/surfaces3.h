#ifndef CIRCUMBALL_QUALITY_SURFACES3_H_
#define CIRCUMBALL_QUALITY_SURFACES3_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "quality/context3.h"

namespace circumball {

/// The tube about an input segment: distances along it, and radii, of its first rings.
struct TubeProfile {
  Point3 origin, axis;
  std::vector<double> along, radius;

  /// Distance of p from the axis less the radius of the tube there; infinite beyond its ends.
  double outside(const Point3& p, double slack) const;
};

/// Spheres and tubes of intestines (thesis, 6.3.1), read off a mesh. About an input vertex there is
/// a sphere if all of its neighbors are equally far from it. About an input segment there is a tube
/// if at least two neighbors of the first vertex on it are on the ring that it would have there.
class Surfaces3 {
 public:
  explicit Surfaces3(const VerifyContext3& context);

  std::size_t spheres() const { return spheres_; }
  std::size_t tubes() const { return tubes_.size(); }
  /// Whether a cell belongs to the inside of spheres and tubes: a corner of it is the center of a
  /// sphere or on a segment with a tube, or all four are on one sphere, or all four on one tube
  /// with their centroid not outside of it.
  bool holds(const VerifyContext3::Cell& c) const;
  /// The same of tubes alone: no corner is the center of a sphere.
  bool holds_in_tube(const VerifyContext3::Cell& c) const {
    return std::none_of(c.begin(), c.end(), [&](std::uint32_t v) { return center_[v]; }) &&
           !on_one(sphere_, c) && holds(c);
  }
  template <class Corners>
  bool on_one_surface(const Corners& corners) const {
    return on_one(sphere_, corners) || on_one(tube_, corners);
  }

 private:
  template <class Corners>
  static bool on_one(const std::vector<std::uint32_t>& surface, const Corners& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      return surface[v] != kNoIndex && surface[v] == surface[corners[0]];
    });
  }
  double tolerance(double radius) const;
  double distance(std::uint32_t a, std::uint32_t b) const;
  void find_spheres();
  void find_tube(const std::vector<std::uint32_t>& v);
  void find_vertices_on_tubes();

  const VerifyContext3& context_;
  std::size_t spheres_ = 0;
  std::vector<TubeProfile> tubes_;
  std::vector<std::uint32_t> sphere_, tube_;  // by vertex
  std::vector<std::uint8_t> center_,
      inner_;  // by vertex: of a sphere; that, or on a segment with a tube
};

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_SURFACES3_H_
