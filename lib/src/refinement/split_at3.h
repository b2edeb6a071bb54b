#ifndef CIRCUMBALL_REFINEMENT_SPLIT_AT3_H_
#define CIRCUMBALL_REFINEMENT_SPLIT_AT3_H_

#include <array>
#include <optional>

#include "refinement/stage3.h"

/// Insertions in space: what the loop and the single sweeps share.
namespace circumball {

/// Inserts the point just looked at, as a vertex on `feature`, into the tetrahedralization and into
/// the faces that it belongs to, and records it; `event` comes from Recorder3::insertion_of.
VertexId insert_vertex(Workspace3& w, const View3& view, const Event& event, const Point3& p,
                       const Feature& feature, SubsegmentId splitting = SubsegmentId());

/// Splits s at p, a rounded point of it, and records it. The halves are in the order of the ends of
/// s. Nothing, recorded as refused, where p coincides with a vertex, or is nearer to one than
/// Limits::min_edge.
std::optional<std::array<SubsegmentId, 2>> split_at(Workspace3& w, SubsegmentId s, const Point3& p,
                                                    Reason why);

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SPLIT_AT3_H_
