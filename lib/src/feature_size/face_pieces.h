#ifndef CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_
#define CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"

namespace circumball {

/// Triangles that cover a face of a valid complex, without overlap but for rounding; between its
/// vertices if it is convex, else between points of its sides on lines through its corners
/// (trapezoids, halved). Empty if the face has no area. O(n) if convex, else O(n^2 log n) for n
/// corners.
std::vector<std::array<Point3, 3>> face_pieces(const Complex& complex, std::uint32_t face);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_FACE_PIECES_H_
