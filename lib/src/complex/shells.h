#ifndef CIRCUMBALL_COMPLEX_SHELLS_H_
#define CIRCUMBALL_COMPLEX_SHELLS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "circumball/complex.h"

namespace circumball {

/// Concentric shells (Ruppert 1995, section 5): circles about the input vertices of acute angles,
/// their radii all powers of two. Segments that are split where they cross them end at equal
/// lengths, and adjacent ones of equal length do not encroach upon each other.
///
/// Knows how far each vertex on a segment is from both ends of it, as the split was meant: rounded
/// coordinates far from the origin do not tell that two vertices are on one shell, these numbers
/// do.
class Shells {
 public:
  /// `centers`: by vertex of the complex, which have shells about them.
  void track(const Complex& complex, std::vector<bool> centers);
  bool on() const { return complex_ != nullptr; }

  /// Distances of a vertex on a segment to the first and the second end of the segment. Powers of
  /// two, and halves of sums of them, are exact.
  struct Position {
    double from_first = 0, from_second = 0;
  };
  /// Of v, which lies on input segment `segment` (or is an end of it).
  Position position(VertexId v, SegmentId segment) const;

  /// Where an end segment at a center is split.
  struct Shell {
    VertexId center;
    double radius = 0;  ///< a power of two
    double length = 0;  ///< of the end segment: the radius is between 1/3 and 2/3 of it
  };
  /// The shell nearest to the middle of the piece ab (in the order of its input segment), where it
  /// is an end segment at a center; about a, where it is at both ends. Nothing elsewhere: pieces
  /// between shells are split at their midpoints.
  std::optional<Shell> shell_of(VertexId a, VertexId b, SegmentId segment) const;

  /// The piece ab was split at m, on `shell_of` it or at its midpoint.
  void split(VertexId a, VertexId b, SegmentId segment, VertexId m);

 private:
  const Complex* complex_ = nullptr;
  std::vector<bool> centers_;
  std::vector<Position> positions_;  // by vertex; of Steiner vertices on segments
};

/// The power of two nearest to half the length: between 1/3 and 2/3 of it. Exact.
double shell_radius(double length);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_SHELLS_H_
