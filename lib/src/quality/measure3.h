#ifndef CIRCUMBALL_QUALITY_MEASURE3_H_
#define CIRCUMBALL_QUALITY_MEASURE3_H_

#include "circumball/verify.h"

namespace circumball {

/// What `measure` says of a mesh of dimension 3.
Quality measure3(const Mesh& mesh);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_MEASURE3_H_
