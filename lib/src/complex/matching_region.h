#ifndef CIRCUMBALL_COMPLEX_MATCHING_REGION_H_
#define CIRCUMBALL_COMPLEX_MATCHING_REGION_H_

#include <array>
#include <vector>

#include "complex/live3.h"

namespace circumball {

/// The tetrahedralization of tubes of thesis Theorem 6.15: it takes the place of the Delaunay cells
/// there, which after Algorithm 6.3 need not conform to the faces, and matches what is around. For
/// each piece of a tube between two rings, about the subsegment p1 p2, it has p1 with every
/// triangle of the surface, and p1, p2 with every chord of the second ring. Triangles of the
/// surface are the facets between what is kept and what is not, so that ties among cocircular
/// vertices are settled as outside.
struct MatchingRegion {
  struct Cell {
    std::array<VertexId, 4> v;  ///< orient3d is positive
    std::uint32_t label;        ///< of the domain: that of the cell beyond the surface
  };
  struct Facet {
    std::array<VertexId, 3> v;
    std::uint32_t face;
  };

  /// Of a run of 6.3 that ended. `matches` is false where a facet of the surface is not where it
  /// should be, or a cell would not be positive: then nothing is replaced. O(cells).
  explicit MatchingRegion(const Live3& live);

  bool matches = true;
  std::vector<bool> replaced;  ///< by slot
  std::vector<Cell> cells;
  std::vector<Facet> facets;                          ///< those in faces, of cells of the domain
  std::vector<std::array<VertexId, 2>> inside_edges;  ///< subsegments of cells of the domain

 private:
  void add(const Live3& live, const std::array<VertexId, 4>& v, std::uint32_t label);
  void leave_out_facets_outside();
};

/// Whether a mesh of it has one: of a run of 6.3 that knows inside from outside.
inline bool needs_matching_region(const Live3& live) {
  return live.classified() && live.has_intestine() && !live.intestine().structured();
}

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_MATCHING_REGION_H_
