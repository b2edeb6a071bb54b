#ifndef CIRCUMBALL_COMPLEX_PLANAR_ARRANGEMENT_H_
#define CIRCUMBALL_COMPLEX_PLANAR_ARRANGEMENT_H_

#include <cstdint>
#include <vector>

#include "complex/planar_sweep.h"

namespace circumball {

/// The segments at each point of a view, counter-clockwise, in exact angular order. A half-edge 2 s
/// goes from the lower to the higher end of segment s, 2 s + 1 back.
struct PlanarStars {
  std::vector<std::uint32_t> first;  ///< points + 1: where the star of a point begins in `outgoing`
  std::vector<std::uint32_t> outgoing;  ///< half-edges, from just after straight down
  explicit PlanarStars(const PlanarView& view);
};

/// The faces into which the segments of a complex divide the plane, with areas and nesting levels.
/// For valid complexes (a sweep without suspects) only. O(n log n).
class PlanarArrangement {
 public:
  PlanarArrangement(const PlanarView& view, const SweepResult& swept);

  static constexpr std::uint32_t kUnbounded = 0;  ///< the number of the unbounded face
  std::size_t face_count() const { return level_.size(); }
  /// Least number of segments to cross from the unbounded face.
  std::uint32_t level(std::uint32_t face) const { return level_[face]; }
  /// Area of a bounded face, its holes taken off.
  double area(std::uint32_t face) const { return area_[face]; }
  /// The face to the left of a half-edge.
  std::uint32_t left_face(std::uint32_t half_edge) const { return face_of_loop_[loop_[half_edge]]; }
  /// The face that a point lies in; kNoIndex for a point on a segment (its ends included).
  std::uint32_t face_of_point(std::uint32_t point) const;

  /// Which faces belong to a `closed` domain. kAuto is settled by `complex`; hole seeds are the
  /// first seeds of the view.
  std::vector<bool> inside(const Complex& complex, const PlanarView& view) const;

 private:
  void trace_loops(const PlanarView& view);
  void nest_components(const PlanarView& view, const SweepResult& swept);
  void find_levels(const PlanarView& view);

  PlanarStars stars_;
  std::vector<std::uint32_t> below_, through_;
  std::vector<std::uint32_t> loop_;  // of each half-edge
  std::vector<std::uint32_t> face_of_loop_;
  std::vector<double> loop_area_;  // signed
  std::vector<std::uint32_t> level_;
  std::vector<double> area_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_PLANAR_ARRANGEMENT_H_
