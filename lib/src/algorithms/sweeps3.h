#ifndef CIRCUMBALL_ALGORITHMS_SWEEPS3_H_
#define CIRCUMBALL_ALGORITHMS_SWEEPS3_H_

#include <memory>
#include <string>

#include "refinement/stage3.h"

/// The single sweeps of thesis Algorithm 4.1.
namespace circumball {

/// Step 0: the Delaunay tetrahedralization of the input vertices (and of the corners of the box).
/// The subsegments and the refinements of the faces begin. Births of cells depend on the way, so
/// that what goes by birth later asks for the way with a record (`by_birth`), which is slower.
std::unique_ptr<Stage3> insert_vertices_in_space(bool by_birth = false);

/// Once the faces are there: which cells belong to the domain (see solid_domain.h).
std::unique_ptr<Stage3> classify_cells(std::string name);

/// Step 1a: every segment is split at each of its input vertices q0, at distance N(q0)/3. N(q0) is
/// measured for all of them before the first split.
std::unique_ptr<Stage3> split_at_thirds();

/// How step 2a splits segments.
enum class Step2a { kFourths, kHalves, kAdaptive };
/// Step 2a: every segment is split into four equal parts; or, as the thesis suggests for further
/// study (4.2), into two, or only those for which |s| <= lfs_1(s) / (2 sqrt 2) does not hold.
std::unique_ptr<Stage3> split_into_parts(Step2a how);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_SWEEPS3_H_
