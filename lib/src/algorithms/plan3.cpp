#include "algorithms/collar3.h"
#include "algorithms/draw_intestines.h"
#include "algorithms/feature_size3.h"
#include "algorithms/intestine3.h"
#include "algorithms/plan.h"
#include "algorithms/protect3.h"
#include "algorithms/ruppert3.h"
#include "algorithms/slivers3.h"
#include "algorithms/sweeps3.h"
#include "predicates/elementary.h"
#include "refinement/loop.h"

namespace circumball {
namespace {

template <class Rules>
std::unique_ptr<Stage3> loop(std::string name, std::string title, Rules rules) {
  return std::make_unique<Loop<Rules, Space>>(std::move(name), std::move(title), std::move(rules));
}

Step2a step2a(const Settings& settings) {
  return settings.step2a == "halves"     ? Step2a::kHalves
         : settings.step2a == "adaptive" ? Step2a::kAdaptive
                                         : Step2a::kFourths;
}

/// What it leaves is no failure of the refinement before it, whose rules account for the run.
std::unique_ptr<Stage3> remove_slivers(const Settings& settings) {
  Slivers3 rules;
  rules.quality.tau = settings.tau;
  rules.quality.size = settings.size;
  rules.cosine = elementary::cos(settings.sliver_degrees * (elementary::kPi / 180));
  rules.min_edge = settings.min_edge;
  return std::make_unique<Loop<Slivers3, Space>>(kSliverStep, "Remove slivers", rules,
                                                 Account::kNone);
}

}  // namespace

std::vector<std::unique_ptr<Stage3>> plan_in_space(const Settings& settings) {
  std::vector<std::unique_ptr<Stage3>> steps;
  steps.push_back(insert_vertices_in_space(settings.algorithm != "delaunay" &&
                                           settings.algorithm != "feature-size"));
  if (settings.algorithm == "feature-size") {
    steps.push_back(split_at_thirds());
    steps.push_back(loop("1b", "Estimate the 1-feature size on all segments", FeatureSize1b{}));
    steps.push_back(split_into_parts(step2a(settings)));
    steps.push_back(loop("2b", "Estimate the local feature size on all segments", FeatureSize2b{}));
  } else if (settings.algorithm == "collar") {
    SegmentSizes sizes;
    sizes.all = settings.protect_all;
    sizes.estimate = settings.estimate_sizes;
    sizes.clearance = settings.size_factor;
    steps.push_back(prepare_segments(sizes));
    steps.push_back(draw_collars(settings.height));
    steps.push_back(loop("3a", "Split encroached collar segments and arcs", CollarElements3{}));
    steps.push_back(label_collars());
    steps.push_back(
        loop("3c", "Split encroached segments and triangles beyond the collars", CollarFaces3{}));
    steps.push_back(classify_cells("3d"));
    Collar3 rules;
    rules.quality.tau = settings.tau;
    rules.quality.size = settings.size;
    steps.push_back(loop("3", "Refinement with collar", rules));
  } else if (settings.algorithm == "intestine" || settings.algorithm == "intestine-structured") {
    SegmentSizes sizes;
    sizes.all = settings.protect_all;
    sizes.box = false;
    sizes.estimate = settings.estimate_sizes;
    sizes.clearance = settings.size_factor;
    sizes.graded = true;
    steps.push_back(prepare_segments(sizes));
    steps.push_back(draw_intestines(settings.algorithm != "intestine"));
    steps.push_back(loop("3a", "Split encroached arcs and collar segments", IntestineElements3{}));
    steps.push_back(label_collars());
    steps.push_back(loop("3c", "Split encroached patches and triangles", IntestineFaces3{}));
    steps.push_back(classify_cells("3d"));
    Intestine3 rules;
    rules.quality.tau = settings.tau;
    rules.quality.size = settings.size;
    steps.push_back(loop("3", "Refinement with intestines", rules));
  } else if (settings.algorithm == "ruppert") {
    steps.push_back(loop("1", "Split encroached segments and triangles of faces", Conform3{}));
    steps.push_back(classify_cells("1b"));
    Ruppert3 rules;
    rules.tau = settings.tau;
    rules.size = settings.size;
    steps.push_back(loop("2", "Ruppert's algorithm", rules));
  }
  if (settings.sliver_degrees > 0) steps.push_back(remove_slivers(settings));
  return steps;
}

}  // namespace circumball
