#ifndef CIRCUMBALL_REFINEMENT_STAGE3_H_
#define CIRCUMBALL_REFINEMENT_STAGE3_H_

#include <type_traits>

#include "complex/live3.h"
#include "refinement/recorder3.h"
#include "refinement/solid_view.h"
#include "refinement/stage.h"

namespace circumball {

/// The agenda of rules of chapter 4, which estimate feature sizes; and of those of chapter 6, which
/// look at tetrahedra.
template <class Rules>
class Agenda3;
template <class Rules>
class SolidAgenda;
template <class Rules, class = void>
struct AgendaInSpace {
  using Type = Agenda3<Rules>;
};
template <class Rules>
struct AgendaInSpace<Rules, std::void_t<decltype(Rules::kTetrahedra)>> {
  using Type = SolidAgenda<Rules>;
};

/// Space, as the loop and the steps see it; see `Plane`.
struct Space {
  using Live = Live3;
  using View = SolidView;
  using Recorder = Recorder3;
  using Point = Point3;
  template <class Rules>
  using Agenda = typename AgendaInSpace<Rules>::Type;
};

using Workspace3 = WorkspaceOf<Space>;
using Stage3 = StageOf<Space>;

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_STAGE3_H_
