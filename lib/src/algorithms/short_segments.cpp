#include "algorithms/short_segments.h"

#include <algorithm>
#include <cmath>

#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// Looks around one subsegment after the other; the scratch is kept.
class Surroundings {
 public:
  explicit Surroundings(const Live3& live) : live_(live), dt_(live.triangulation()) {
    seen_.assign(dt_.vertex_count(), 0);
  }

  bool has_disjoint_features_near(SubsegmentId s) {
    const Subsegment& u = live_.subsegment(s);
    const Point3 a = dt_.point(u.a), b = dt_.point(u.b);
    const double length2 = squared_distance(a, b);
    const double reach2 = 8 * length2 * kLengthSlack * kLengthSlack;
    // A segment as near as that is at most 4 |s| long, so that an end of it is 2 |s| farther at
    // most.
    const double walk2 = (2 + 2 * M_SQRT2) * (2 + 2 * M_SQRT2) * length2 * kLengthSlack;
    features_.clear();
    stack_.assign({u.a, u.b});
    ++round_;
    seen_[u.a.value] = seen_[u.b.value] = round_;
    while (!stack_.empty()) {
      const VertexId q = stack_.back();
      stack_.pop_back();
      if (live_.is_input_vertex(q)) note(live_.feature(q), q, q, a, b, reach2);
      for (const SubsegmentId other : live_.subsegments_at(q)) {
        const Subsegment& r = live_.subsegment(other);
        note({FeatureKind::kSegment, r.segment.value}, r.a, r.b, a, b, reach2);
      }
      dt_.neighbors(q, &neighbors_);
      for (const VertexId p : neighbors_) {
        if (seen_[p.value] == round_) continue;
        seen_[p.value] = round_;
        const Point3 at = dt_.point(p);
        if (squared_distance_of_segments(at, at, a, b) <= walk2) stack_.push_back(p);
      }
    }
    for (std::size_t i = 0; i < features_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (live_.disjoint(features_[i], features_[j])) return true;
      }
    }
    return false;
  }

 private:
  void note(const Feature& feature, VertexId p, VertexId q, const Point3& a, const Point3& b,
            double reach2) {
    if (std::find(features_.begin(), features_.end(), feature) != features_.end()) return;
    if (squared_distance_of_segments(dt_.point(p), dt_.point(q), a, b) < reach2) {
      features_.push_back(feature);
    }
  }

  const Live3& live_;
  const Delaunay3& dt_;
  std::vector<std::uint32_t> seen_;  // by vertex: the round in which it was
  std::uint32_t round_ = 0;
  std::vector<VertexId> stack_, neighbors_;
  std::vector<Feature> features_;
};

}  // namespace

std::vector<SubsegmentId> not_known_to_be_short(const Live3& live,
                                                const std::vector<SubsegmentId>& subsegments) {
  Surroundings surroundings(live);
  std::vector<bool> in_doubt(live.subsegment_count(), false);
  std::vector<SubsegmentId> stack;
  const auto doubt = [&](SubsegmentId s) {
    if (!in_doubt[s.value]) stack.push_back(s);
    in_doubt[s.value] = true;
  };
  for (const SubsegmentId s : subsegments) {
    if (surroundings.has_disjoint_features_near(s)) doubt(s);
  }
  while (!stack.empty()) {
    const Subsegment& s = live.subsegment(stack.back());
    stack.pop_back();
    for (const VertexId end : {s.a, s.b}) {
      if (!live.is_input_vertex(end)) continue;
      for (const SubsegmentId other : live.subsegments_at(end)) doubt(other);
    }
  }
  std::vector<SubsegmentId> found;
  for (const SubsegmentId s : subsegments) {
    if (in_doubt[s.value]) found.push_back(s);
  }
  return found;
}

}  // namespace circumball
