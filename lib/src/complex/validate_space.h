#ifndef CIRCUMBALL_COMPLEX_VALIDATE_SPACE_H_
#define CIRCUMBALL_COMPLEX_VALIDATE_SPACE_H_

#include <vector>

#include "complex/box_tree.h"
#include "complex/space_view.h"
#include "complex/validate_defects.h"

namespace circumball {

/// A polygon is planar if its vertices are this close to a plane, relative to its size
/// (architecture.md, "Numbers"). The only tolerance in what makes a complex invalid.
constexpr double kPlanarity = 1e-9;

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
