#ifndef CIRCUMBALL_COMPLEX_CONSTRAINED_TRIANGULATION_H_
#define CIRCUMBALL_COMPLEX_CONSTRAINED_TRIANGULATION_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/types.h"
#include "delaunay/delaunay2.h"

namespace circumball {

/// The constrained Delaunay triangulation (Lee and Lin 1986) of points and edges in the plane: the
/// Delaunay triangulation in which missing edges are recovered by flips (Sloan 1993), and then
/// edges that are not locally Delaunay and not constrained are flipped (Lawson 1977). Exact.
///
/// Points must be distinct, and edges must meet in common ends only and hold no point in their
/// interior: otherwise `valid` is false, and there is nothing to use. Recovering an edge costs at
/// most the square of the number of edges that it crosses, which is small on ordinary input.
class ConstrainedTriangulation {
 public:
  struct Triangle {
    std::uint32_t v[3];     ///< points, counter-clockwise; a ghost has kGhost at some place
    HalfEdge n[3];          ///< n[i]: the same edge in the neighbor (delaunay2.h)
    std::uint32_t edge[3];  ///< opposite v[i]: the constraint (the first of equal ones), or kNone
  };
  static constexpr std::uint32_t kGhost = Delaunay2::kGhost.value;

  ConstrainedTriangulation(const std::vector<Point2>& points,
                           const std::vector<std::array<std::uint32_t, 2>>& edges);

  bool valid() const { return valid_; }
  /// Empty where all points are collinear.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  static bool is_ghost(const Triangle& t) {
    return t.v[0] == kGhost || t.v[1] == kGhost || t.v[2] == kGhost;
  }
  /// Some triangle at a point, kNone without any.
  std::uint32_t triangle_at(std::uint32_t point) const { return triangle_at_[point]; }

 private:
  std::uint32_t origin(HalfEdge h) const { return triangles_[h >> 2].v[((h & 3) + 1) % 3]; }
  std::uint32_t target(HalfEdge h) const { return triangles_[h >> 2].v[((h & 3) + 2) % 3]; }
  std::uint32_t apex(HalfEdge h) const { return triangles_[h >> 2].v[h & 3]; }
  HalfEdge twin(HalfEdge h) const { return triangles_[h >> 2].n[h & 3]; }
  static HalfEdge next(HalfEdge h) { return (h & ~3u) + ((h & 3) + 1) % 3; }
  static HalfEdge prev(HalfEdge h) { return (h & ~3u) + ((h & 3) + 2) % 3; }
  HalfEdge some_outgoing(std::uint32_t point) const;
  HalfEdge find_edge(std::uint32_t a, std::uint32_t b) const;
  void link(HalfEdge h, HalfEdge g);
  void constrain(HalfEdge h, std::uint32_t edge);
  bool convex(HalfEdge h) const;
  void flip(HalfEdge h);
  bool recover(std::uint32_t a, std::uint32_t b);
  void make_delaunay();

  const std::vector<Point2>& points_;  // of the caller; used while constructing
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> triangle_at_;
  bool valid_ = true;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_CONSTRAINED_TRIANGULATION_H_
