#ifndef CIRCUMBALL_ALGORITHMS_PLAN_H_
#define CIRCUMBALL_ALGORITHMS_PLAN_H_

#include <memory>
#include <string>
#include <vector>

#include "algorithms/settings.h"
#include "refinement/stage.h"
#include "refinement/stage3.h"

namespace circumball {

/// Name of the step that removes slivers, in space.
constexpr char kSliverStep[] = "slivers";

/// The steps of an algorithm, in order: the driver is this list. Step names are the thesis' where
/// it names them.
std::vector<std::unique_ptr<Stage>> plan(const Settings& settings);
std::vector<std::unique_ptr<Stage3>> plan_in_space(const Settings& settings);

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_PLAN_H_
