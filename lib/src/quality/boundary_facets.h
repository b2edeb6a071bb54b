#ifndef CIRCUMBALL_QUALITY_BOUNDARY_FACETS_H_
#define CIRCUMBALL_QUALITY_BOUNDARY_FACETS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quality/context3.h"

namespace circumball {

/// How many facets on the boundary of a mesh lie in no input face, by VerifyContext3::on_segment():
/// in a closed domain there should be none. Labels are not asked. `worst`: the corners of the first
/// one. A facet counts as in faces if its corners, the midpoints of its sides and its centroid are
/// in one or another: what rounding put across a common segment of two faces is in both.
std::size_t boundary_facets_off_faces(const VerifyContext3& context,
                                      std::vector<std::uint32_t>* worst);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_BOUNDARY_FACETS_H_
