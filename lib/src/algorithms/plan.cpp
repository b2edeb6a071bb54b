#include "algorithms/plan.h"

#include <utility>

#include "algorithms/chew.h"
#include "algorithms/circles.h"
#include "algorithms/collar.h"
#include "algorithms/equal_lengths.h"
#include "algorithms/feature_size.h"
#include "algorithms/fem_size.h"
#include "algorithms/intestine.h"
#include "algorithms/protect.h"
#include "algorithms/ruppert.h"
#include "algorithms/sweeps.h"
#include "algorithms/terminator.h"
#include "refinement/loop.h"

namespace circumball {
namespace {

template <class Rules>
std::unique_ptr<Stage> loop(std::string name, std::string title, Rules rules) {
  return std::make_unique<Loop<Rules>>(std::move(name), std::move(title), std::move(rules));
}

/// The rules of an algorithm that splits triangles, with the bounds of the settings.
template <class Rules>
Rules bounded(const Settings& settings) {
  Rules rules;
  rules.tau = settings.tau;
  rules.size = settings.size;
  rules.sizing = settings.sizing;
  rules.off_centers = settings.off_centers;
  return rules;
}

Protection protection(const Settings& settings) {
  return {settings.protection, settings.protect_all, settings.size, settings.sizing};
}

}  // namespace

std::vector<std::unique_ptr<Stage>> plan(const Settings& settings) {
  std::vector<std::unique_ptr<Stage>> steps;
  steps.push_back(insert_vertices());
  if (settings.algorithm == "ruppert") {
    steps.push_back(loop("1", "Split encroached segments", Conform{}));
    steps.push_back(classify_triangles());
    steps.push_back(loop("2", "Ruppert's algorithm", bounded<Ruppert>(settings)));
  } else if (settings.algorithm == "feature-size") {
    steps.push_back(loop("1a", "Estimate the feature size at all input vertices", FeatureSize{}));
    steps.push_back(classify_triangles());
  } else if (settings.algorithm == "collar") {
    steps.push_back(protect_acute_angles(protection(settings)));
    steps.push_back(loop("1c", "Split encroached segments", ConformWithCollar{}));
    steps.push_back(classify_triangles());
    steps.push_back(loop("2", "Ruppert's algorithm, protected", bounded<Collar>(settings)));
  } else if (settings.algorithm == "intestine") {
    steps.push_back(protect_acute_angles(protection(settings)));
    steps.push_back(loop("1c", "Split encroached segments", ConformWithCollar{}));
    steps.push_back(classify_triangles());
    steps.push_back(draw_protecting_circles());
    steps.push_back(
        loop("2", "Ruppert's algorithm, outside of the disks", bounded<Intestine>(settings)));
  } else if (settings.algorithm == "terminator") {
    steps.push_back(mark_shell_centers());
    steps.push_back(loop("1", "Split encroached segments, on shells", ConformOnShells{}));
    steps.push_back(classify_triangles());
    steps.push_back(loop("2", "Terminator", bounded<Terminator>(settings)));
  } else if (settings.algorithm == "fem-size") {
    steps.push_back(split_at_equal_lengths());
    steps.push_back(loop("1b", "Split encroached segments", Conform{}));
    steps.push_back(classify_triangles());
    steps.push_back(loop("2", "Refinement by circumradius", bounded<FemSize>(settings)));
  } else if (settings.algorithm == "chew") {
    steps.push_back(divide_segments(settings.size));
    steps.push_back(loop("1b", "Recover segments that are no edges", Recover{}));
    steps.push_back(classify_triangles());
    Chew rules;
    rules.h = settings.size;
    steps.push_back(loop("2", "Chew's algorithm", rules));
  } else {
    steps.push_back(classify_triangles());
  }
  return steps;
}

}  // namespace circumball
