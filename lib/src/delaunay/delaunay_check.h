#ifndef CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_
#define CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_

#include <string>

#include "delaunay/delaunay2.h"
#include "delaunay/delaunay3.h"

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

/// The same for a triangulation in space. Checked, in this order:
///  1. the dimension fits the number of vertices, and below 2 there are no cells, and the vertices
///  are on one line, their neighbors along it;
///  2. corners are inserted vertices, only the last may be kGhost; cell_of gives a cell that has
///  the vertex;
///  3. twins point at each other, and have the same corners the other way round;
///  4. the cells at a vertex hang together, and its link is a sphere, by Euler's formula;
///  5. cells are positively oriented; in dimension 2 there are ghosts alone, and all vertices are
///  in one plane;
///  6. every facet is locally Delaunay, ties settled by vertex numbers: hence all of it is
///  (Delaunay 1934);
///  7. the hull is convex at every edge, and where it is flat, it is locally Delaunay.
/// O(n) in dimension 3; in dimension 2, O(n) for each edge of the hull.
bool is_valid(const Delaunay3& triangulation, std::string* why);

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_DELAUNAY_CHECK_H_
