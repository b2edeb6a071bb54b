#ifndef CIRCUMBALL_ALGORITHMS_SHORT_SEGMENTS_H_
#define CIRCUMBALL_ALGORITHMS_SHORT_SEGMENTS_H_

#include <vector>

#include "complex/live3.h"

namespace circumball {

/// Of these subsegments those for which |s| <= lfs_1(s) / (2 sqrt 2) (Lemma 4.10) is in doubt: two
/// disjoint features of dimension at most 1 come nearer to s than 2 sqrt 2 |s|, though perhaps not
/// to the same point of it. The option `adaptive` of step 2a. With an end segment all of Spind(s)
/// is taken: Lemma 4.18 needs end segments of equal lengths at a vertex, and fails without (4 times
/// its bound was seen).
///
/// Features are found by walking the Delaunay neighbors that are near: vertices in a ball are
/// connected by Delaunay edges in it. A segment that comes so near has a vertex near, as step 1b
/// ended with |s'| <= sqrt 2 fs_1(s') for all of them. O(k^2) for k features near s.
std::vector<SubsegmentId> not_known_to_be_short(const Live3& live,
                                                const std::vector<SubsegmentId>& subsegments);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_SHORT_SEGMENTS_H_
