#ifndef CIRCUMBALL_QUALITY_CONTEXT_H_
#define CIRCUMBALL_QUALITY_CONTEXT_H_

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "circumball/verify.h"
#include "complex/planar_arrangement.h"
#include "complex/planar_sweep.h"
#include "quality/chains.h"
#include "quality/words.h"

namespace circumball {

/// What several checks need to know of the mesh and the complex, worked out once. Nothing in it
/// trusts the mesh: cells that cannot be used are left out, and counted.
class VerifyContext {
 public:
  VerifyContext(const Mesh& mesh, const Complex& complex, const VerifyOptions& options);

  const Mesh& mesh;
  const Complex& complex;
  const VerifyOptions& options;

  using Cell = std::array<std::uint32_t, 3>;
  Point2 point(std::uint32_t v) const { return xy(mesh.vertices[v]); }

  /// Cells with indices in range, three different vertices and coordinates that the predicates can
  /// take.
  std::vector<Cell> cells;
  std::vector<std::uint32_t> cell_number;  ///< their numbers in the mesh
  std::vector<std::uint8_t> positive;      ///< 1 where the cell is exactly counter-clockwise
  std::vector<std::uint8_t> used;          ///< for each mesh vertex: 1 if one of `cells` has it

  /// Half-edge 3 c + i is the edge of cell c opposite its vertex i, from vertex i + 1 to i + 2.
  std::uint32_t origin(std::uint32_t h) const { return cells[h / 3][(h % 3 + 1) % 3]; }
  std::uint32_t target(std::uint32_t h) const { return cells[h / 3][(h % 3 + 2) % 3]; }
  std::uint32_t apex(std::uint32_t h) const { return cells[h / 3][h % 3]; }
  /// The same edge in the only other cell that has it, the other way round; kNoIndex on the
  /// boundary and at bad edges.
  std::vector<std::uint32_t> twin;
  /// Edges with more than two cells, or with two that run along it the same way.
  std::vector<std::array<std::uint32_t, 2>> bad_edges;
  std::size_t edge_count = 0;
  /// Half-edges sorted by their lower, then their higher vertex; `edge_first` has vertices + 1
  /// entries.
  std::vector<std::uint32_t> edge_first, edge_half;
  /// The half-edges (at most one of each pair of twins) between two vertices, or kNoIndex.
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const;
  bool has_edge(std::uint32_t a, std::uint32_t b) const { return find_edge(a, b) != kNoIndex; }
  /// Neighbors of a vertex along edges of cells, sorted.
  std::vector<std::uint32_t> neighbor_first, neighbor;

  /// For each vertex of the complex its mesh vertex, or kNoIndex: by number where the mesh knows
  /// its input (and has it where the input does), else by coordinates.
  std::vector<std::uint32_t> mesh_vertex;
  bool by_number = false;
  /// Diameter of the box around the vertices of the complex.
  double diameter = 0;
  /// How far rounding can move a vertex off the segment that it lies on: 8 units in the last place
  /// of the largest coordinate (each midpoint adds at most one to the mean of its subsegment's
  /// ends, and one more on the hull).
  double rounding = 0;
  /// The tolerances, with what rounding can do where coordinates are large and features small.
  double on_segment() const { return kOnSegment * diameter + rounding; }
  double area_tolerance(double area) const {
    return kAreaTolerance * area + rounding * boundary_length;
  }
  double boundary_length = 0;  ///< at most: of all segments and the hull

  bool closed() const { return options.domain == "closed"; }

  // The complex as an arrangement. Null where its segments cross: then nothing can be said of a
  // domain.
  PlanarView view;
  SweepResult swept;
  std::unique_ptr<PlanarArrangement> arrangement;
  std::vector<bool> inside;  ///< of each face of the arrangement: part of the closed domain
  /// Whether the mesh must have the feature: always for hull and box; for closed where the domain
  /// touches it.
  std::vector<std::uint8_t> vertex_wanted, segment_wanted;
  /// Whether a feature counts in feature sizes. The triangulation is of all vertices, and segments
  /// outside of a closed domain are split as those inside are (levels are counted only when all are
  /// edges): what lies outside may encroach upon the border. So in a mesh that knows its input all
  /// count. Other meshers leave what is outside alone.
  bool counts(const Feature& f) const {
    return by_number || (f.kind == FeatureKind::kVertex ? vertex_wanted : segment_wanted)[f.index];
  }

  bool excused(const Cell& cell) const;

 private:
  void read_cells();
  void pair_edges();
  void match_vertices();
  void measure();
  void arrange();
  std::vector<Cell> excused_;
};

// The checks, one a file.
Check check_topology(const VerifyContext& context);
Check check_delaunay(const VerifyContext& context);
template <class Context>
Check check_input_vertices(const Context& context);  // in the plane and in space
template <class Context>
Check check_input_segments(const Context& context);
template <class Context>
Check check_radius_edge(const Context& context);
Check check_area(const VerifyContext& context);
Check check_min_angle(const VerifyContext& context);
Check check_size(const VerifyContext& context);
Check check_nearest_neighbor(const VerifyContext& context);
Check check_nearest_neighbor_lower(const VerifyContext& context);
Check check_seditious(const VerifyContext& context);
Check check_collar(const VerifyContext& context);
Check check_intestine(const VerifyContext& context);
Check check_max_angle(const VerifyContext& context);
Check check_grading(const VerifyContext& context);
Check check_sizing(const VerifyContext& context);
Check check_sizing_lower(const VerifyContext& context);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_CONTEXT_H_
