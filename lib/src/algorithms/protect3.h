#ifndef CIRCUMBALL_ALGORITHMS_PROTECT3_H_
#define CIRCUMBALL_ALGORITHMS_PROTECT3_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "refinement/stage3.h"

/// What comes before step 3 of the refinement with collar in space (thesis 6.2.1).
namespace circumball {

/// What is protected, and how short its pieces are to be.
struct SegmentSizes {
  bool all = true;        ///< every vertex and segment, or only those of acute angles
  bool box = true;        ///< those of the box as well
  bool estimate = false;  ///< by Algorithm 4.1, or by distances to features
  /// The c of (H2). The thesis has c < 1, and 0.9 would do elsewhere; but rule 2 puts a vertex at
  /// height eta |s'| on the circle about q0, for both of two segments at q0, and eta c < 1/2 keeps
  /// their arcs apart at any angle.
  double clearance = 0.8;
  /// For intestines: no piece is more than twice as long as one beside it.
  bool graded = false;
};

/// Splits protected segments until (H1) to (H3) hold, each into three pieces at least; of other
/// segments only the tips at protected vertices are made. Two spheres about ends of a segment, of
/// the radii of Live3::protection_radius, are at least (1 - c) / (1 + c) of it apart.
std::unique_ptr<Stage3> prepare_segments(SegmentSizes sizes = SegmentSizes());

/// Step 2c: collar vertices, `height` times as high as subsegments are long, collar segments and
/// collar arcs. The thesis has the height 1/2, at which midpoints of split collar segments fall on
/// the diametral spheres of subsegments.
std::unique_ptr<Stage3> draw_collars(double height);

/// After all collar elements are edges: which triangles of faces belong to the collars.
std::unique_ptr<Stage3> label_collars();

/// The vertices on an input segment, from its first end to its second.
std::vector<VertexId> vertices_on_segment(const Live3& live, std::uint32_t segment);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PROTECT3_H_
