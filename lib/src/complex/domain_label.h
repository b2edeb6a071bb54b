#ifndef CIRCUMBALL_COMPLEX_DOMAIN_LABEL_H_
#define CIRCUMBALL_COMPLEX_DOMAIN_LABEL_H_

#include <cstdint>

namespace circumball {

/// What the label of a triangle (in the plane) or of a tetrahedron (in space) says. Regions get
/// kFirstRegion + their index.
enum DomainLabel : std::uint32_t {
  kUnknown = 0,  ///< not known yet, or lost when a cavity swallowed a subsegment
  kInside = 1,
  kOutside = 2,
  kFirstRegion = 3,
  kVisited = 0xfffffff0,  ///< during a local flood only
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_DOMAIN_LABEL_H_
