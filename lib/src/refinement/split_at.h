#ifndef CIRCUMBALL_REFINEMENT_SPLIT_AT_H_
#define CIRCUMBALL_REFINEMENT_SPLIT_AT_H_

#include <array>
#include <optional>

#include "refinement/stage.h"

/// What the single sweeps do: insertions that no rule decides on.
namespace circumball {

/// Splits s, a piece of an input segment, at p, a rounded point of it (View::outward is applied),
/// and records it. The halves are in the order of the ends of s. Nothing, recorded as refused,
/// where p coincides with a vertex, or is nearer to one than Limits::min_edge.
std::optional<std::array<SubsegmentId, 2>> split_at(Workspace& w, SubsegmentId s, const Point2& p,
                                                    Reason why);

/// Inserts p, near the input vertex `near`, as a free vertex, and records it. Invalid where p
/// coincides with a vertex, or is nearer to one than Limits::min_edge.
VertexId insert_free(Workspace& w, const Point2& p, VertexId near, Reason why);

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SPLIT_AT_H_
