#ifndef CIRCUMBALL_REFINEMENT_STAGE3_H_
#define CIRCUMBALL_REFINEMENT_STAGE3_H_

#include "complex/live3.h"
#include "refinement/recorder3.h"
#include "refinement/stage.h"
#include "refinement/view3.h"

namespace circumball {

/// Space, as the loop and the steps see it; see `Plane`.
template <class Rules>
class Agenda3;
struct Space {
  using Live = Live3;
  using View = View3;
  using Recorder = Recorder3;
  using Point = Point3;
  template <class Rules>
  using Agenda = Agenda3<Rules>;
};

using Workspace3 = WorkspaceOf<Space>;
using Stage3 = StageOf<Space>;

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_STAGE3_H_
