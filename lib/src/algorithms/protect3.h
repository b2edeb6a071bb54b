#ifndef CIRCUMBALL_ALGORITHMS_PROTECT3_H_
#define CIRCUMBALL_ALGORITHMS_PROTECT3_H_

#include <memory>

#include "refinement/stage3.h"

/// What comes before step 3 of the refinement with collar in space (thesis 6.2.1).
namespace circumball {

/// How short subsegments are to be, beyond what Algorithm 4.1 makes of them.
struct SegmentSizes {
  /// (H2): a subsegment that is no end segment is shorter than this part of its distance from what
  /// it does not belong to. The thesis has c < 1, and 0.9 would do elsewhere; but rule 2 puts a
  /// vertex at height eta |s'| on the circle about q0, for both of two segments at q0, and eta c <
  /// 1/2 keeps their arcs apart at any angle.
  double clearance = 0.8;
  /// For intestines: end segments are shorter than the same part of the distance of their input
  /// vertex, so that spheres keep apart; no subsegment is more than twice as long as one beside it;
  /// and each input segment has at least three.
  bool graded = false;
};

/// Splits segments until (H1) to (H3) hold: by the vertices on segments of a run of Algorithm 4.1,
/// once more each, and then where adjacent end segments differ or others are near.
std::unique_ptr<Stage3> prepare_segments(SegmentSizes sizes = SegmentSizes());

/// Step 2c: collar vertices, collar segments and collar arcs.
std::unique_ptr<Stage3> draw_collars();

/// After all collar elements are edges: which triangles of faces belong to the collars.
std::unique_ptr<Stage3> label_collars();

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PROTECT3_H_
