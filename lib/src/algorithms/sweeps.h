#ifndef CIRCUMBALL_ALGORITHMS_SWEEPS_H_
#define CIRCUMBALL_ALGORITHMS_SWEEPS_H_

#include <memory>

#include "refinement/stage.h"

/// The steps that are single sweeps over the triangulation, not runs of the loop.
namespace circumball {

/// Step 0: the Delaunay triangulation of the input vertices (and the corners of the box), then its
/// subsegments.
std::unique_ptr<Stage> insert_vertices();

/// Labels the triangles of the domain; the triangulation conforms by now.
std::unique_ptr<Stage> classify_triangles();

/// Divides every input segment into as many equal parts as leaves each at least h long: between h
/// and 2 h, and between h and sqrt(3) h but for segments of length between sqrt(3) h and 2 h, which
/// stay whole (Algorithm 7.2; Chew 1989).
std::unique_ptr<Stage> divide_segments(double h);

/// The h of `divide_segments` where none is given: half the shortest of all input segments and all
/// distances between neighbouring vertices, so that every segment can be divided as asked.
double default_division_length(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_SWEEPS_H_
