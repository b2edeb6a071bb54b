#ifndef CIRCUMBALL_COMPLEX_PLANAR_SWEEP_H_
#define CIRCUMBALL_COMPLEX_PLANAR_SWEEP_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"
#include "circumball/types.h"

namespace circumball {

/// True if coordinates are finite, and zero or of a magnitude for which the predicates are exact
/// (1e-45 to 1e55).
bool usable(double coordinate);

/// What of a 2D complex can be reasoned about: its usable vertices without duplicates, as points in
/// lexicographic order (so that "to the left of" is "<" of indices), and its usable segments
/// without duplicates.
struct PlanarView {
  struct Segment {
    std::uint32_t lo, hi;   ///< points; lo < hi
    std::uint32_t segment;  ///< of the complex (the first of duplicates)
  };
  std::vector<Point2> points;
  std::vector<std::uint32_t>
      vertex;  ///< of each point: its lowest vertex number; kNoIndex for a seed only
  std::vector<std::uint32_t> point_of_vertex;  ///< kNoIndex where the vertex is not usable
  std::vector<std::uint32_t> point_of_seed;    ///< kNoIndex where the seed is not usable
  std::vector<Segment> segments;               ///< in the order of the complex
  /// Pairs (duplicate, first segment with the same ends), in order.
  std::vector<std::array<std::uint32_t, 2>> duplicate_segments;

  /// `seeds` are points to be located along with the vertices. O(n log n).
  PlanarView(const Complex& complex, const std::vector<Point2>& seeds);
};

/// What one sweep over a PlanarView finds.
struct SweepResult {
  /// For each segment of the view: 1 if it may cross or overlap another, or hold a vertex in its
  /// interior. Every pair of segments that cross or overlap has a suspect in it, and every segment
  /// with a vertex in its interior is one; in a valid complex there is none.
  std::vector<std::uint8_t> suspect;
  /// For each point: the segment of the view directly below it (not through it), or kNoIndex. Of
  /// use without suspects.
  std::vector<std::uint32_t> below;
  /// For each point: a segment of the view that has it in its interior, or kNoIndex.
  std::vector<std::uint32_t> through;
};

/// Plane sweep after Shamos and Hoey (Geometric intersection problems, 1976), exact: points in
/// lexicographic order, the segments that span the present one ordered by orient2d. Where two
/// neighbours cross, the shorter leaves the sweep as a suspect, so that the order stays right for
/// the others. O(n log n) time, linear memory, whatever the input.
SweepResult sweep(const PlanarView& view);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_PLANAR_SWEEP_H_
