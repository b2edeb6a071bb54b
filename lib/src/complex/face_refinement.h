#ifndef CIRCUMBALL_COMPLEX_FACE_REFINEMENT_H_
#define CIRCUMBALL_COMPLEX_FACE_REFINEMENT_H_

#include <cstdint>
#include <vector>

#include "complex/face_plane.h"
#include "delaunay/delaunay2.h"

namespace circumball {

/// The refinement of one face: the exact 2D Delaunay triangulation of the vertices that belong to
/// it, in the coordinates of its plane. Its vertices have numbers of their own, in the order of
/// their numbers in the complex, so that ties are settled alike in a face and in its neighbors.
class FaceRefinement {
 public:
  FaceRefinement(const Complex& complex, std::uint32_t face) : plane_(complex, face) {}

  const FacePlane& plane() const { return plane_; }
  const Delaunay2& triangulation() const { return triangulation_; }
  Delaunay2& triangulation() { return triangulation_; }
  /// The number in the complex of a vertex of the triangulation.
  VertexId global(VertexId local) const { return vertices_[local.value]; }
  Point2 point(VertexId local) const { return triangulation_.point(local); }

  /// Appends a vertex that lies in the face: not inserted yet. Vertices come by ascending numbers.
  VertexId add_vertex(VertexId v, const Point3& p) {
    vertices_.push_back(v);
    return triangulation_.add_vertex(plane_.to_plane(p));
  }
  /// Inserts all that were added. Those that rounding put onto another are left out.
  void insert_all() { triangulation_.insert_batch(0, triangulation_.vertex_count(), nullptr); }
  /// Finds the cavity of p, near the triangle `start`; false where rounding puts it onto a vertex.
  bool probe(const Point3& p, TriangleId start) {
    return triangulation_.probe(plane_.to_plane(p), start) == Delaunay2::Probe::kOk;
  }
  bool probe(const Point2& p, TriangleId start) {
    return triangulation_.probe(p, start) == Delaunay2::Probe::kOk;
  }
  /// Whether the cavity last found holds t.
  bool cavity_holds(TriangleId t) const;
  /// Inserts a vertex just added into the cavity last found, which is its.
  void commit(VertexId local, std::uint32_t splitting_tag = kNone) {
    triangulation_.commit(local, splitting_tag);
  }

  /// Whether t lies inside of the polygon: its centroid does.
  bool inside(const Delaunay2::Triangle& t) const;

  std::size_t bytes() const {
    return triangulation_.bytes() + vertices_.capacity() * sizeof(VertexId);
  }

 private:
  FacePlane plane_;
  Delaunay2 triangulation_;
  std::vector<VertexId> vertices_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_FACE_REFINEMENT_H_
