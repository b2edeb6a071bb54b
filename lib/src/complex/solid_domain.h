#ifndef CIRCUMBALL_COMPLEX_SOLID_DOMAIN_H_
#define CIRCUMBALL_COMPLEX_SOLID_DOMAIN_H_

#include <cstdint>
#include <vector>

#include "complex/live3.h"

/// Which facets of the tetrahedralization make up the faces, and which cells belong to the domain.
///
/// Both are matters of numbers, not of coordinates: vertices in a sloping face are rounded, and lie
/// in its plane only nearly. A facet lies in a face where its three vertices belong to the face and
/// its projection is inside of the polygon. Where more than three vertices of a face are nearly
/// cocircular, or near the convex hull, rounding also makes flat cells, whose four vertices belong
/// to the face: they are part of the face, which has more than one layer there. Seen from either
/// side, the facets that have something else than such a cell on that side tile the face. The same
/// happens across a segment between faces in one plane; so what keeps parts of space apart are
/// facets of groups of such faces.
namespace circumball {

class FaceFacets {
 public:
  /// O(cells).
  explicit FaceFacets(const Live3& live);

  /// The face that a facet lies in; kNone if there is none.
  std::uint32_t face(CellFacet f) const { return faces_[f]; }
  /// Whether a facet lies in faces of one group.
  bool is_barrier(CellFacet f) const { return barrier_[f]; }
  /// Whether the cell is a layer of faces of one group.
  bool is_flat(CellSlot c) const { return flat_[c]; }

 private:
  std::vector<std::uint32_t> faces_;
  std::vector<bool> barrier_, flat_;
};

/// Whether the vertices of a cell all belong to faces of one group.
bool has_one_group(const Live3& live, CellSlot c);

/// A cell that has another label than before.
struct RelabeledCell {
  CellSlot cell;
  std::uint32_t before;
};

/// Labels every cell, by flooding from outside across facets that lie in no face. Domain `closed`:
/// levels count the faces between a cell and the outside (see HoleRule), seeds of holes take out
/// what they reach; `box` and `hull`: all cells are inside. Then seeds of regions label what they
/// reach. A flat cell goes with the side that is farther out, so that none is left on the boundary
/// of the domain. Returns the cells whose label changed, by slot. O(cells).
///
/// Not to be called where faces have gaps (SolidView::conforms), through which floods would leak:
/// labels are left as they are then, which is as insertions inherited them; or where there are none
/// yet, everything is in the domain and of no region (Live3::classified).
///
/// Labels stay right while refinement goes on, as long as the faces are there: what an insertion
/// makes inherits them (see Delaunay3::commit).
std::vector<RelabeledCell> classify(Live3* live);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_SOLID_DOMAIN_H_
