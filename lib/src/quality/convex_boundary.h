#ifndef CIRCUMBALL_QUALITY_CONVEX_BOUNDARY_H_
#define CIRCUMBALL_QUALITY_CONVEX_BOUNDARY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "quality/context3.h"

namespace circumball {

/// Empty if the cells tile the convex hull of their vertices, for positively oriented cells of
/// which at most two share a facet; else why not, and `worst` the vertices of the place.
///
/// Shown by: the boundary is one closed surface, convex at each edge (exact orient3d) and at each
/// vertex (whose link is a convex polygon of the sphere, run through once). A closed connected
/// surface that is convex everywhere bounds a convex body (van Heijenoort, On locally convex
/// manifolds, 1952). Every place inside is then covered as often as any other: once, as is counted
/// at one. O(n log n).
std::string why_not_convex(const VerifyContext3& context, std::vector<std::uint32_t>* worst);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_CONVEX_BOUNDARY_H_
