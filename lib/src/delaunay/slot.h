#ifndef CIRCUMBALL_DELAUNAY_SLOT_H_
#define CIRCUMBALL_DELAUNAY_SLOT_H_

#include <cstdint>

namespace circumball {

/// No slot, no half-edge, no facet of a cell.
constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_SLOT_H_
