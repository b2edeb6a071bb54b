#ifndef CIRCUMBALL_COMPLEX_PLANAR_MEETINGS_H_
#define CIRCUMBALL_COMPLEX_PLANAR_MEETINGS_H_

#include <cstdint>
#include <functional>

#include "complex/planar_sweep.h"

namespace circumball {

enum class PlanarMeeting : std::uint8_t { kNone, kCross, kOverlap };

/// Calls on(point, segment) for every vertex of a view in the interior of a segment of it, and
/// meet(segment, segment, how) once for every two segments that cross or overlap, by looking at the
/// suspects of a sweep in a box tree. Exact. False if the search was ended, as there are too many.
bool find_meetings(const PlanarView& view, const SweepResult& swept,
                   const std::function<void(std::uint32_t, std::uint32_t)>& on,
                   const std::function<void(std::uint32_t, std::uint32_t, PlanarMeeting)>& meet);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_PLANAR_MEETINGS_H_
