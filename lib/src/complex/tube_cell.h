#ifndef CIRCUMBALL_COMPLEX_TUBE_CELL_H_
#define CIRCUMBALL_COMPLEX_TUBE_CELL_H_

#include <memory>
#include <vector>

#include "circumball/types.h"
#include "complex/ring.h"
#include "delaunay/delaunay2.h"

namespace circumball {

/// The part of a tube between two rings and two base directions, and its developed triangulation:
/// what Algorithm 6.3 refines. A frustum is developed into a sector about the apex of its cone, a
/// cylinder into a rectangle: without distortion, so that its Delaunay triangulation in the plane
/// is the one on the surface. (That of the corners in space would not do: the hull of points that
/// are elongated along the axis has other edges.)
///
/// Places on it: the part of the angle between the base directions, and of the way from ring to
/// ring.
class TubeCell {
 public:
  TubeCell(const Tube& tube, std::uint32_t gap, const Ring& low, const Ring& high);

  Point3 place(double part, double t) const;
  Point2 developed(double part, double t) const;
  /// The way back: (part, t). O(1).
  Point2 undeveloped(const Point2& p) const;

  /// Appends a vertex; not inserted yet.
  void add(VertexId v, double part, double t) {
    vertices_.push_back(v);
    triangulation_->add_vertex(developed(part, t));
  }
  void insert_all() { triangulation_->insert_batch(0, triangulation_->vertex_count(), nullptr); }
  /// Appends a vertex and inserts it; false where rounding puts it onto another one.
  bool insert(VertexId v, double part, double t);
  const Delaunay2& triangulation() const { return *triangulation_; }
  VertexId global(VertexId local) const { return vertices_[local.value]; }

 private:
  Point3 center_low_, center_high_, first_, second_;  // at the first base direction, and across
  double radius_low_, radius_high_, angle_, slant_, sine_;
  std::unique_ptr<Delaunay2> triangulation_;
  std::vector<VertexId> vertices_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_TUBE_CELL_H_
