#ifndef CIRCUMBALL_COMPLEX_H_
#define CIRCUMBALL_COMPLEX_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circumball/types.h"

namespace circumball {

/// A planar polygonal face of a 3D complex: loops of vertices, hole points, segments and isolated
/// vertices inside.
struct Face {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<Point3> holes;
  std::vector<std::uint32_t> segments;
  std::vector<std::uint32_t> vertices;
};

/// A seed point that labels the part of the domain it lies in, and may bound the size of its cells.
struct Region {
  Point3 at;
  double label = 0;
  double max = 0;  ///< bound on area (2D) or volume (3D) of a cell; <= 0 means none
};

/// Which part of the plane is meshed.
enum class Domain : std::uint8_t {
  kDefault,  ///< the algorithm's own default (see AlgorithmInfo)
  kHull,     ///< the convex hull of the vertices as given
  kBox,  ///< a bounding box, 3 times the size of the input, is added and everything in it is meshed
  kClosed,  ///< what closed boundaries enclose, minus holes
};

/// How a `closed` domain treats loops inside loops.
enum class HoleRule : std::uint8_t {
  kAuto,    ///< kSeeds if the complex lists holes or regions, else kParity
  kSeeds,   ///< everything enclosed is inside, but for the parts that a hole seed lies in
  kParity,  ///< nesting level: one loop deep is inside, two loops deep is a hole, three inside, …
};

/// The input: a piecewise linear complex (thesis, Definitions 2.1.3 and 2.1.4). Plain data; `check`
/// says whether it is valid. Indices are 0-based.
struct Complex {
  int dimension = 2;
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<Face> faces;  ///< 3D only
  std::vector<Point3> holes;
  HoleRule hole_rule = HoleRule::kAuto;
  std::vector<Region> regions;

  /// Boundary markers: empty, or one for each vertex / segment / face.
  std::vector<std::int32_t> vertex_markers, segment_markers, face_markers;
  /// Attributes carried through: `attributes_per_vertex` numbers for each vertex.
  int attributes_per_vertex = 0;
  std::vector<double> vertex_attributes;
};

/// Everything that is wrong with a complex, and warnings; all of it, not the first. Empty for a
/// valid complex.
///
/// In both dimensions: "not-finite", "magnitude" (outside 0 or 1e-45 … 1e55),
/// "index-out-of-range", "too-few-vertices", "duplicate-vertices" (equal bits),
/// "near-duplicate-vertices" (warning: closer than 1e-9 of the diameter), "zero-length-segment",
/// "duplicate-segments" (warning; the second is ignored), "vertex-on-segment", "segments-cross",
/// "segments-overlap", "hole-outside" and "region-outside" (warnings).
///
/// In space, faces by themselves: "degenerate-face" (fewer than three distinct vertices in a loop,
/// collinear, no area, nothing left of it), "loop-touches-itself", "non-planar-face" (a vertex
/// farther from the face's plane than 1e-9 of its size; the only tolerance), "side-without-segment"
/// (every side of a loop is to be listed as a segment of the complex), "segment-not-in-face" and
/// "vertex-not-in-face" (listed, but outside), "face-hole-outside" (warning). And what meets
/// outside of shared features: "vertex-in-face", "segment-in-face" (not listed there),
/// "segment-crosses-face", "faces-cross", "faces-overlap", "duplicate-faces"; warnings where it is
/// rounding that keeps features apart (1e-9 of the diameter): "vertex-near-segment",
/// "vertex-near-face", "segments-near".
///
/// Exact: a complex has none of these exactly if the relative interiors of its features (vertices,
/// segments, faces less what they list) are disjoint. Members of a face, its vertices by number,
/// lie in its plane as far as planarity asks, and what is between them is decided in the face's
/// projection onto a coordinate plane, as if it were planar; to everything else a face is the
/// surface of its own triangles (see triangulate_face). O((n + k) log n) on ordinary input;
/// docs/validity.md has the argument. At most `max_defects` of each name are listed; a last one
/// then counts the rest.
std::vector<Defect> check(const Complex& complex, std::size_t max_defects = 1000);

/// Of those defects the ones that readers leave in a complex although nothing can be made of it:
/// "not-finite" and "index-out-of-range" (of segments and faces; a number that no index can hold is
/// read as kNoIndex). Whoever uses the indices of a complex that was read looks here first. O(n).
std::vector<Defect> check_numbers(const Complex& complex, std::size_t max_defects = 1000);

/// Smallest angle in degrees, 180 if there is none: between two input segments that share a vertex;
/// in space also between two faces that share a segment, and between a segment and a face that
/// share a vertex, where the segment is not in the face. (Two faces that share a vertex only are no
/// closer than a segment of one is to the other.)
double smallest_angle_degrees(const Complex& complex);

/// A face of a 3D complex in triangles on its own vertices, counter-clockwise about its normal
/// (Newell's, of the loop of the largest area): what its loops enclose, but for the parts between
/// loops that a hole point lies in; segments and vertices listed in the face are edges and corners.
/// The constrained Delaunay triangulation in the coordinate plane to which the face is nearest to
/// parallel, where coordinates are exact; so it is valid whatever the rounding of a sloping face.
/// Empty for a face that has none: indices out of range, no area, sides that cross or touch (see
/// `check`), dimension 2. O(n log n) on ordinary input.
std::vector<std::array<std::uint32_t, 3>> triangulate_face(const Complex& complex,
                                                           std::uint32_t face);

/// The plane that a face of a 3D complex is triangulated in: an orthonormal frame. A point p of the
/// face has the coordinates ((p - origin) . first, (p - origin) . second); seen from the tip of the
/// normal, which is Newell's of the loop of the largest area, the first axis turns to the second
/// counter-clockwise. Axes of a face parallel to a coordinate plane are coordinate axes.
struct FaceFrame {
  Point3 origin, first, second, normal;
};

/// The frame of a face; none where it has no area, indices are out of range, or dimension is 2.
/// O(vertices of the face).
std::optional<FaceFrame> face_frame(const Complex& complex, std::uint32_t face);

/// The complex with a box around it, `scale` times the larger extent of the input and centered on
/// it: a square of four segments in the plane; a cube of 8 vertices, 12 segments and 6 faces in
/// space. Its vertices, segments and faces come last. The domain `box` is this, with scale 3.
Complex with_box(const Complex& complex, double scale);

/// The complex with a segment for every side of a loop of a face that has none; these come last, in
/// the order of faces and loops; sides with indices out of range are left to `check`. Readers see
/// to it. O(n log n).
Complex with_sides(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_H_
