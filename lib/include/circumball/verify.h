#ifndef CIRCUMBALL_VERIFY_H_
#define CIRCUMBALL_VERIFY_H_

#include <optional>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"

/// Verification of a mesh against its complex, whoever made it. Shares no code with the mesher but
/// the predicates.
namespace circumball {

struct VerifyOptions {
  std::optional<double> tau;   ///< radius-edge bound to check; none: "radius-edge" is left out
  std::optional<double> size;  ///< circumradius bound to check
  std::string sizing;  ///< the same as a function of the place: text as Options::size has it
  /// "sizing-lower": how many of the first Steiner vertices were on segments before the refinement
  /// began, so that the theorem counts them as input.
  std::uint32_t divisions = 0;
  std::string domain = "closed";  ///< "hull", "box" or "closed": what the mesh should cover
  bool protect_all =
      false;  ///< collars, intestines: at every input vertex, not at acute angles only
  std::optional<double> size_factor;  ///< in space: the c of (H2), for "protection"; none: 1
  std::vector<std::string> checks;    ///< which; empty: all that apply
  /// Cells (sorted vertex numbers) that the run reported as rightly refused: not counted by the
  /// quality checks.
  std::vector<std::vector<std::uint32_t>> excused;
  /// Those of them whose circumcenter lies outside of a hull, whose facets need not be faces: the
  /// only exception that "collar" and "intestine" in space know.
  std::vector<std::vector<std::uint32_t>> beyond_hull;
};

struct Check {
  std::string name;  ///< "delaunay", "topology", …
  bool ok = false;
  std::string detail;  ///< one sentence: what was checked, and the worst offender with its vertices
  std::optional<double> bound, observed;
  std::vector<std::uint32_t> worst;  ///< vertices of the worst offender; may be empty
};

/// Runs the checks, in this order. Names:
/// "topology" (cells positively oriented, at most two at an edge, vertices manifold or on the
/// boundary, indices in range), "delaunay" (every edge between two cells locally Delaunay, and with
/// it all of it; for hull and box the cells also tile the convex hull), "input-vertices" (every
/// input vertex is the mesh vertex of its number, bit for bit; on other meshes: found by
/// coordinates), "input-segments" (every input segment is a union of edges of the mesh, in order,
/// without gap or overlap), "area" (areas of the cells add up to the domain's area, from exact
/// signed areas of loops, relative 1e-9 and what rounding of vertices can move), "radius-edge"
/// (every cell has circumradius / shortest edge <= tau, with the rounding error of the measurement
/// as slack), "collar" (Theorem 5.7, in space 6.11: the circumcenter of every cell above tau lies
/// in the diametral disk, or the ball, of a collar simplex), "intestine" and "max-angle"
/// (Theorem 5.11: cells above tau lie in the disks that protect acute input angles; no angle above
/// 180 degrees - 2 kappa), "min-angle" (chew:
/// >= 30 degrees), "size" (circumradius <= size), "sizing" (circumradius <= infimum of the sizing
/// function over the cell, by certain bounds), "sizing-lower" (fem-size: Theorem 7.13, the other
/// side), "nearest-neighbor" (Theorem 2.3: N(q0) <= sqrt 2 lfs(q0) for each input vertex; lfs by
/// brute force), "nearest-neighbor-lower" (Theorem 3.2: 1/2 lfs(q0) <= N(q0)), "grading" (the
/// constant C of lfs(q) <= C r_q over the Steiner vertices, as observed: Theorems 2.2, 5.6 and 5.10
/// give no number to check; vertices are taken to be numbered by birth).
///
/// In space: "topology" (at most two cells at a facet, links of inner vertices are spheres),
/// "delaunay" (every facet locally Delaunay, and with it all of it; for hull and box the cells also
/// tile the convex hull), "input-vertices", "input-segments", "input-faces" (every input face is a
/// union of facets of the mesh on each of its sides, counted combinatorially), "volume" (volumes of
/// the cells add up to what their boundary encloses, and for box to the box), "radius-edge",
/// "protection" (collars and intestines: (H2) and (H3) for all protected subsegments, feature sizes
/// by definition; and Lemma 6.9 I: no vertex in their balls, nor in those of the facets of faces at
/// them, but for Algorithm 6.3, whose tubes are not Delaunay),
/// "segment-lower" (Theorem 4.1: min(fs_1(s)/16, lfs(s)/4) <= |s| for every subsegment s) and
/// "segment-upper" (Theorem 4.2: |s| <= min(sqrt 2 fs_1(s), 5/3 lfs(s))), feature sizes by
/// definition.
std::vector<Check> verify(const Mesh& mesh, const Complex& complex, const VerifyOptions& options);

/// Measures of a mesh, for the report.
struct Quality {
  double min_angle_degrees = 0, max_angle_degrees = 0;        ///< in the plane
  double min_dihedral_degrees = 0, max_dihedral_degrees = 0;  ///< in space
  double max_radius_edge = 0, shortest_edge = 0;
  double area = 0, volume = 0;  ///< of all cells, in the plane and in space
};
Quality measure(const Mesh& mesh);

}  // namespace circumball

#endif  // CIRCUMBALL_VERIFY_H_
