#ifndef CIRCUMBALL_IO_COPLANAR_FACES_H_
#define CIRCUMBALL_IO_COPLANAR_FACES_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"

namespace circumball::io {

/// Makes faces of a triangulated surface: neighbors over a side that no third triangle has are one
/// face if they are *exactly* coplanar (orient3d is zero) and lie on different sides of it. The
/// outer loop of a face turns as its first triangle does; inner loops are holes, with a point in
/// each. Sides that a face has on both sides of it although a third triangle stands on it are
/// segments in the face; vertices that neither a loop nor a segment of it has are vertices in the
/// face. Adds the faces to `complex`, which has the vertices, in the order of their first
/// triangles, and their sides to its segments. All indices must be in range. O(n log n).
void add_merged_faces(const std::vector<std::array<std::uint32_t, 3>>& triangles, Complex* complex);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_COPLANAR_FACES_H_
