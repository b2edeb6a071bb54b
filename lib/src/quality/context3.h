#ifndef CIRCUMBALL_QUALITY_CONTEXT3_H_
#define CIRCUMBALL_QUALITY_CONTEXT3_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/verify.h"
#include "quality/chains.h"
#include "quality/words.h"

namespace circumball {

/// What several checks need to know of a mesh and a complex of space, worked out once. The
/// counterpart of VerifyContext, whose names it keeps. Nothing in it trusts the mesh: cells that
/// cannot be used are left out, and counted.
class VerifyContext3 {
 public:
  VerifyContext3(const Mesh& mesh, const Complex& complex, const VerifyOptions& options);

  const Mesh& mesh;
  const Complex& complex;
  const VerifyOptions& options;

  using Cell = std::array<std::uint32_t, 4>;
  using Facet = std::array<std::uint32_t, 3>;
  const Point3& point(std::uint32_t v) const { return mesh.vertices[v]; }

  /// Cells with indices in range, four different vertices and coordinates that the predicates can
  /// take.
  std::vector<Cell> cells;
  std::vector<std::uint32_t> cell_number;  ///< their numbers in the mesh
  std::vector<std::uint8_t> positive;      ///< 1 where orient3d is positive
  std::vector<std::uint8_t> used;          ///< for each mesh vertex: 1 if one of `cells` has it

  /// Facet 4 c + i is that of cell c opposite its vertex i. Its corners in the order in which they
  /// are counter-clockwise seen from outside of a positive cell.
  Facet corners(std::uint32_t f) const {
    constexpr int kOrder[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
    const Cell& c = cells[f / 4];
    const int* o = kOrder[f % 4];
    return {c[static_cast<std::size_t>(o[0])], c[static_cast<std::size_t>(o[1])],
            c[static_cast<std::size_t>(o[2])]};
  }
  std::uint32_t apex(std::uint32_t f) const { return cells[f / 4][f % 4]; }
  /// The same facet of the only other cell that has it, on its other side; kNoIndex on the boundary
  /// and at bad facets.
  std::vector<std::uint32_t> twin;
  /// Facets (corners ascending) of more than two cells, or of two on one side.
  std::vector<Facet> bad_facets;
  /// Some cell's facet with these corners in any order, or kNoIndex.
  std::uint32_t find_facet(Facet corners) const;
  /// Calls f(facet) for the facets of which v is the lowest corner.
  template <class F>
  void for_each_facet_from(std::uint32_t v, F f) const {
    for (std::uint32_t k = facet_first_[v]; k < facet_first_[v + 1]; ++k) f(facet_[k]);
  }

  /// Neighbors of a vertex along edges of cells, ascending.
  std::vector<std::uint32_t> neighbor_first, neighbor;
  bool has_edge(std::uint32_t a, std::uint32_t b) const;

  /// For each vertex of the complex its mesh vertex, or kNoIndex: by number where the mesh knows
  /// its input (and has it where the input does), else by coordinates.
  std::vector<std::uint32_t> mesh_vertex;
  bool by_number = false;
  /// Diameter of the box around the vertices of the complex.
  double diameter = 0;
  /// How far rounding can move a vertex off the segment or face that it lies on: 8 units in the
  /// last place of the largest coordinate.
  double rounding = 0;
  double on_segment() const { return kOnSegment * diameter + rounding; }
  bool closed() const { return options.domain == "closed"; }

  /// Whether the mesh must have the feature: all that are usable, duplicates aside.
  /// In a closed domain not those outside: a vertex of no cell that lies in none, and what has one.
  std::vector<std::uint8_t> vertex_wanted, segment_wanted, face_wanted;

  /// Whether Safety refused it; or a convex hull has it as a layer of a face, which no point
  /// splits.
  bool excused(const Cell& cell) const {
    return is_in(excused_, cell) || (options.domain == "hull" && is_layer(cell));
  }
  bool beyond_hull(const Cell& cell) const { return is_in(beyond_hull_, cell); }
  /// Whether a vertex belongs to a face, by its label.
  bool lies_in_face(std::uint32_t v, std::uint32_t face) const;
  /// Whether all four vertices belong to one face: what rounding makes of it.
  bool is_layer(const Cell& cell) const;
  /// Whether what is on both sides of a facet in a face is a layer of the face, or nothing.
  bool is_between_layers(const MeshFacet& facet) const;

 private:
  void read_cells();
  void pair_facets();
  void list_neighbors();
  void match_vertices();
  void leave_out_vertices_outside();
  void measure();
  void leave_out_what_is_outside();
  std::vector<std::uint32_t> facet_first_, facet_;  // by their lowest corner, then the others
  static bool is_in(const std::vector<Cell>& list, const Cell& cell);
  std::vector<Cell> excused_, beyond_hull_;
};

// The checks, one a file; the templates are those of the plane.
Check check_topology(const VerifyContext3& context);
Check check_delaunay(const VerifyContext3& context);
Check check_input_faces(const VerifyContext3& context);
Check check_volume(const VerifyContext3& context);
Check check_collar(const VerifyContext3& context);
Check check_protection(const VerifyContext3& context);
Check check_intestine(const VerifyContext3& context);
Check check_delaunay_outside(const VerifyContext3& context);
Check check_segment_lower(const VerifyContext3& context);
Check check_segment_upper(const VerifyContext3& context);
template <class Context>
Check check_input_vertices(const Context& context);
template <class Context>
Check check_input_segments(const Context& context);
template <class Context>
Check check_radius_edge(const Context& context);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_CONTEXT3_H_
