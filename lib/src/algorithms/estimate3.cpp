#include "algorithms/estimate3.h"

#include <algorithm>
#include <utility>

#include "algorithms/feature_size3.h"
#include "algorithms/sweeps3.h"
#include "refinement/loop.h"

namespace circumball {

SizeEstimate3::SizeEstimate3(const Workspace3& w)
    : live_(w.live.complex(), w.live.domain()),
      recorder_(live_, nullptr),
      work_{live_, recorder_, w.limits, w.cancelled} {
  stages_.push_back(insert_vertices_in_space());
  stages_.push_back(split_at_thirds());
  stages_.push_back(std::make_unique<Loop<FeatureSize1b, Space>>("1b", "", FeatureSize1b{}));
  stages_.push_back(split_into_parts(Step2a::kFourths));
  stages_.push_back(std::make_unique<Loop<FeatureSize2b, Space>>("2b", "", FeatureSize2b{}));
}

bool SizeEstimate3::advance(Budget& budget) {
  while (at_ < stages_.size()) {
    if (!begun_) stages_[at_]->begin(work_);
    begun_ = true;
    if (!stages_[at_]->advance(work_, budget)) return false;
    begun_ = false;
    ++at_;
  }
  return true;
}

std::vector<std::vector<Point3>> SizeEstimate3::on_segments() const {
  const auto& segments = live_.complex().segments;
  std::vector<std::vector<std::pair<double, Point3>>> on(segments.size());
  const std::uint32_t count = live_.triangulation().vertex_count();
  for (std::uint32_t v = 0; v < count; ++v) {
    const Feature& f = live_.feature(VertexId(v));
    if (f.kind != FeatureKind::kSegment) continue;
    const Point3& p = live_.triangulation().point(VertexId(v));
    on[f.index].push_back({distance(live_.complex().vertices[segments[f.index][0]], p), p});
  }
  std::vector<std::vector<Point3>> lists(segments.size());
  for (std::size_t k = 0; k < on.size(); ++k) {
    std::sort(on[k].begin(), on[k].end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [at, p] : on[k]) lists[k].push_back(p);
  }
  return lists;
}

}  // namespace circumball
