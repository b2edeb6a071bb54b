#include "circumball/report.h"

namespace circumball {

const char* version() { return CIRCUMBALL_VERSION; }

}  // namespace circumball
