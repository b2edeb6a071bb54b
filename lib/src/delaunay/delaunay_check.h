#ifndef CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_
#define CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_

#include <string>

#include "delaunay/delaunay2.h"

namespace circumball {

/// Whether a triangulation keeps all that Delaunay2 promises between insertions; if not, `why`
/// (unless null) gets one sentence with the place. Shares nothing with the insertion but orient2d
/// and incircle. Checked, in this order:
///  1. there are 2n - 2 triangles for n inserted vertices, and none below two vertices;
///  2. twins point at each other, join the same vertices, and bear the same tag;
///  3. corners are inserted vertices, at most one of them kGhost; triangle_of gives a triangle that
///  has the vertex;
///  4. the triangles at a vertex form one cycle (so the triangles are a sphere, by Euler's formula
///  and 1);
///  5. triangles are counter-clockwise; in dimension 1 there are none, and all vertices are on one
///  line, in its order;
///  6. every edge is locally Delaunay, ties settled by vertex numbers: hence all of it is (Delaunay
///  1934);
///  7. the hull turns to one side, and where it goes straight it does not turn back.
/// O(n).
bool is_valid(const Delaunay2& triangulation, std::string* why);

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_
