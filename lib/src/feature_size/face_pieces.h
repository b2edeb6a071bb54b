#ifndef CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_
#define CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"

namespace circumball {

/// The part of its plane that a face is.
struct FacePieces {
  /// Triangles that cover it, without overlap but for rounding. Corners are vertices of the face,
  /// or rounded onto its sides.
  std::vector<std::array<Point3, 3>> triangles;
  /// The loops (indices) that bound it: one side of them is in the face, the other is not.
  std::vector<std::uint32_t> bounds;
};

/// The pieces of a face of a valid complex: a fan if it is one convex loop, else the halves of its
/// trapezoids (the parts between two of its sides that are next to each other, between lines
/// through its corners). A face that lists hole points is without the parts that they lie in, else
/// all that its loops enclose (circumball/complex.h). Empty if an index is out of range or the face
/// has no area.
///
/// This is deliberately not the triangulation that refinement starts with: what is measured with it
/// shares nothing with what is to be measured. O(n^2 log n) for n corners.
FacePieces face_pieces(const Complex& complex, std::uint32_t face);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_
