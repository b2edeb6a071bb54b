#ifndef CIRCUMBALL_COMPLEX_VALIDATE_SPACE_H_
#define CIRCUMBALL_COMPLEX_VALIDATE_SPACE_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "complex/box_tree.h"
#include "complex/space_view.h"
#include "complex/validate_defects.h"

namespace circumball {

/// A polygon is planar if its vertices are this close to a plane, relative to its size
/// (architecture.md, "Numbers"). The only tolerance in what makes a complex invalid.
constexpr double kPlanarity = 1e-9;
/// Far from the origin the roundings of coordinates are larger than that: 8 units in the last place
/// of the largest are granted (Live3::rounding), unless that is more than this part of the size.
constexpr double kPlanarityOfRounded = 1e-6;

/// How far from a plane the vertices of a face may be that lie in this box.
inline double planarity_of(const Box3& box) {
  const double dx = box.extent(0), dy = box.extent(1), dz = box.extent(2);
  const double size = std::sqrt(dx * dx + dy * dy + dz * dz);
  const double largest = std::max({std::fabs(box.lo_x), std::fabs(box.hi_x), std::fabs(box.lo_y),
                                   std::fabs(box.hi_y), std::fabs(box.lo_z), std::fabs(box.hi_z)});
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * largest;
  return std::max(kPlanarity * size, std::min(rounding, kPlanarityOfRounded * size));
}

// The parts of check() in space, by what they look at.

/// Each face by itself: "degenerate-face", "loop-touches-itself", "non-planar-face",
/// "side-without-segment", "segment-not-in-face", "vertex-not-in-face", "face-hole-outside"; what
/// meets in a face's plane goes to `meetings`. Returns one surface a face.
std::vector<FaceSurface> check_faces(const Complex& complex, const SpaceView& view, std::size_t max,
                                     SpaceMeetings* meetings, std::vector<Defect>* defects);
/// What meets in space, along with `meetings`: "vertex-on-segment", "segments-cross",
/// "segments-overlap", "vertex-in-face", "segment-in-face", "segment-crosses-face", "faces-cross",
/// "faces-overlap", "duplicate-faces".
void check_contacts(const Complex& complex, const SpaceView& view,
                    const std::vector<FaceSurface>& surfaces, std::size_t max,
                    SpaceMeetings* meetings, std::vector<Defect>* defects);
/// Warnings of what nearly meets, closer than 1e-9 of the diameter, and is not in `meetings`:
/// "vertex-near-segment", "vertex-near-face", "segments-near".
void check_near_contacts(const Complex& complex, const SpaceView& view,
                         const std::vector<FaceSurface>& surfaces, const SpaceMeetings& meetings,
                         std::size_t max, std::vector<Defect>* defects);
/// "hole-outside", "region-outside". Needs faces that meet in shared features only.
void check_seeds_in_space(const Complex& complex, const SpaceView& view,
                          const std::vector<FaceSurface>& surfaces, std::size_t max,
                          std::vector<Defect>* defects);

/// smallest_angle_degrees of a 3D complex.
double smallest_angle_in_space(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_VALIDATE_SPACE_H_
