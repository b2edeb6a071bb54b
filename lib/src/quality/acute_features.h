#ifndef CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_
#define CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_

#include <cstdint>
#include <vector>

#include "quality/context3.h"

namespace circumball {

/// The input features that collars protect, as verification sees it: by vertex and by segment of
/// the complex.
struct ProtectedFeatures {
  std::vector<bool> vertices, segments;
};

/// Who makes a mesh decides what a right angle is that rounding bent: within 1e-6 of one, or what
/// rounding makes of the lengths involved.
enum class RightAngles : std::uint8_t { kOpen, kProtected };

/// All that meet others (`options.protect_all`), or those that are met at less than 90 degrees:
/// segments by two sides of faces; vertices by two segments, by a segment and a face that does not
/// contain it, or as ends of such segments. Angles that may be right count as said.
ProtectedFeatures protected_features(const VerifyContext3& context, RightAngles right);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_
