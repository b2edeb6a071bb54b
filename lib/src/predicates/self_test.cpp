#include <cfloat>

#include "circumball/predicates.h"

namespace circumball {
const char* predicate_self_test() { return ""; }
}  // namespace circumball
