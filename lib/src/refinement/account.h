#ifndef CIRCUMBALL_REFINEMENT_ACCOUNT_H_
#define CIRCUMBALL_REFINEMENT_ACCOUNT_H_

#include <string>

#include "circumball/refine.h"
#include "complex/live2.h"
#include "complex/live3.h"
#include "refinement/view.h"

namespace circumball {

/// The account of a simplex that stayed unacceptable: `rule` says why it is, `refusal` why it was
/// not split (kNone: its turn never came, for the reason in `stop`).
Unresolved account_for(const Live2& live, SubsegmentId s, Reason rule, Reason refusal,
                       const std::string& stop);
Unresolved account_for(const Live2& live, TriangleRef t, Reason rule, Reason refusal,
                       const std::string& stop);
Unresolved account_for(const Live3& live, SubsegmentId s, Reason rule, Reason refusal,
                       const std::string& stop);
Unresolved account_for(const Live3& live, const FaceTriangle& t, Reason rule, Reason refusal,
                       const std::string& stop);
Unresolved account_for(const Live3& live, PatchId p, Reason rule, Reason refusal,
                       const std::string& stop);
Unresolved account_for(const Live3& live, const CellRef& c, Reason rule, Reason refusal,
                       const std::string& stop);

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_ACCOUNT_H_
