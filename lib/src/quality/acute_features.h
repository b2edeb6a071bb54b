#ifndef CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_
#define CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_

#include <vector>

#include "quality/context3.h"

namespace circumball {

/// The input features that collars protect, as verification sees it: by vertex and by segment of
/// the complex.
struct ProtectedFeatures {
  std::vector<bool> vertices, segments;
};

/// All that meet others (`options.protect_all`), or those that are met at clearly less than 90
/// degrees: segments by two sides of faces; vertices by two segments, by a segment and a face that
/// does not contain it, or as ends of such segments. What is within 1e-6 of a right angle, or
/// within what rounding makes of one, is left open: whoever made the mesh decides, so that it is
/// not looked at.
ProtectedFeatures protected_features(const VerifyContext3& context);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_ACUTE_FEATURES_H_
