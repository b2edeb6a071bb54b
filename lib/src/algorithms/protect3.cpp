#include "algorithms/protect3.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/feature_size3.h"
#include "algorithms/sweeps3.h"
#include "protection/segment_clearance.h"
#include "refinement/loop.h"
#include "refinement/split_at3.h"

namespace circumball {
namespace {

/// Algorithm 4.1, by itself: only its vertices on segments are kept.
class FeatureSizeRun3 {
 public:
  explicit FeatureSizeRun3(const Workspace3& w)
      : live_(w.live.complex(), w.live.domain()),
        recorder_(live_, nullptr),
        work_{live_, recorder_, w.limits, w.cancelled} {
    stages_.push_back(insert_vertices_in_space());
    stages_.push_back(split_at_thirds());
    stages_.push_back(std::make_unique<Loop<FeatureSize1b, Space>>("1b", "", FeatureSize1b{}));
    stages_.push_back(split_into_parts(Step2a::kFourths));
    stages_.push_back(std::make_unique<Loop<FeatureSize2b, Space>>("2b", "", FeatureSize2b{}));
  }
  bool advance(Budget& budget) {
    while (at_ < stages_.size()) {
      if (!begun_) stages_[at_]->begin(work_);
      begun_ = true;
      if (!stages_[at_]->advance(work_, budget)) return false;
      begun_ = false;
      ++at_;
    }
    return true;
  }
  Reason limit() const { return work_.limit; }
  const Live3& live() const { return live_; }

 private:
  Live3 live_;
  Recorder3 recorder_;
  Workspace3 work_;
  std::vector<std::unique_ptr<Stage3>> stages_;
  std::size_t at_ = 0;
  bool begun_ = false;
};

class PrepareSegments final : public Stage3 {
 public:
  explicit PrepareSegments(SegmentSizes sizes)
      : Stage3("2b", "Split segments as feature sizes ask"), wanted_(sizes) {}

  void begin(Workspace3& w) override {
    sizes_ = std::make_unique<FeatureSizeRun3>(w);
    clearance_ = std::make_unique<SegmentClearance>(w.live.complex(), w.live.incidence());
  }

  bool advance(Workspace3& w, Budget& budget) override {
    if (sizes_) {
      const bool done = sizes_->advance(budget);
      if (!done) {
        w.limit = sizes_->limit();
        return false;
      }
      keep_vertices_on_segments(w);
      sizes_.reset();
      queue_all(w);
    }
    while (!waiting_.empty()) {
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      const SubsegmentId s = waiting_.back();
      waiting_.pop_back();
      if (w.live.subsegment(s).alive) look_at(w, s);
      if (!waiting_.empty()) continue;
      equalize(w);
      // A piece that was halved may be too short now for one beside it.
      if (waiting_.empty() && wanted_.graded && changed_) queue_all(w);
      changed_ = false;
    }
    return true;
  }

 private:
  const Point3& point(const Workspace3& w, VertexId v) const {
    return w.live.triangulation().point(v);
  }
  double length(const Workspace3& w, SubsegmentId s) const {
    const Subsegment& u = w.live.subsegment(s);
    return distance(point(w, u.a), point(w, u.b));
  }

  /// By more than rounding of the ends can do.
  static bool is_longer(const Workspace3& w, double size, double other) {
    return size > kLengthSlack * other + w.live.rounding();
  }

  /// (H1). Each input segment is cut at the vertices that the run put on it, in their order, and
  /// each piece is halved.
  void keep_vertices_on_segments(Workspace3& w) {
    const Live3& sized = sizes_->live();
    const auto& segments = w.live.complex().segments;
    std::vector<std::vector<std::pair<double, Point3>>> on(segments.size());
    const std::uint32_t count = sized.triangulation().vertex_count();
    for (std::uint32_t v = 0; v < count; ++v) {
      const Feature& f = sized.feature(VertexId(v));
      if (f.kind != FeatureKind::kSegment) continue;
      const Point3& p = sized.triangulation().point(VertexId(v));
      on[f.index].push_back({distance(w.live.complex().vertices[segments[f.index][0]], p), p});
    }
    const std::uint32_t whole = w.live.subsegment_count();
    for (std::uint32_t k = 0; k < whole; ++k) {
      const SubsegmentId first(k);
      if (!w.live.subsegment(first).alive) continue;
      auto& points = on[w.live.subsegment(first).segment.value];
      std::sort(points.begin(), points.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      SubsegmentId rest = first;
      std::vector<SubsegmentId> pieces;
      for (const auto& [at, p] : points) {
        const auto halves = split_at(w, rest, p, Reason::kDivision);
        if (!halves) continue;
        pieces.push_back((*halves)[0]);
        rest = (*halves)[1];
      }
      pieces.push_back(rest);
      for (const SubsegmentId s : pieces) halve(w, s);
    }
  }

  void halve(Workspace3& w, SubsegmentId s) {
    const Subsegment u = w.live.subsegment(s);
    const auto halves = split_at(w, s, midpoint(point(w, u.a), point(w, u.b)), Reason::kMidpoint);
    if (!halves) return w.live.freeze(s);
    changed_ = true;
    waiting_.push_back((*halves)[1]);
    waiting_.push_back((*halves)[0]);
  }

  void queue_all(const Workspace3& w) {
    waiting_.clear();
    for (std::uint32_t i = w.live.subsegment_count(); i-- > 0;) {
      if (w.live.subsegment(SubsegmentId(i)).alive) waiting_.push_back(SubsegmentId(i));
    }
  }

  /// (H2), and that no piece is longer than the end segment beside it.
  void look_at(Workspace3& w, SubsegmentId s) {
    const Subsegment& u = w.live.subsegment(s);
    if (u.frozen) return;
    const bool at_a = w.live.is_input_vertex(u.a), at_b = w.live.is_input_vertex(u.b);
    if (at_a && at_b) return halve(w, s);
    const double size = length(w, s);
    if (at_a || at_b) {
      if (!wanted_.graded) return;
      const VertexId q0 = at_a ? u.a : u.b, tip = at_a ? u.b : u.a;
      bool is_alone = false;  // between two input vertices there is nothing but two end segments
      for (const SubsegmentId other : w.live.subsegments_at(tip)) {
        const Subsegment& r = w.live.subsegment(other);
        is_alone |= other != s && w.live.is_input_vertex(r.a == tip ? r.b : r.a);
      }
      if (is_alone || !(size < wanted_.clearance * clearance_->of_vertex(q0.value))) halve(w, s);
      return;
    }
    if (!(size <
          wanted_.clearance * clearance_->of(point(w, u.a), point(w, u.b), u.segment.value))) {
      return halve(w, s);
    }
    for (const VertexId q : {u.a, u.b}) {
      for (const SubsegmentId other : w.live.subsegments_at(q)) {
        const Subsegment& r = w.live.subsegment(other);
        const bool end = w.live.is_input_vertex(r.a) || w.live.is_input_vertex(r.b);
        if (other == s || !(end || wanted_.graded)) continue;
        if (is_longer(w, size, (end ? 1 : 2) * length(w, other))) return halve(w, s);
      }
    }
  }

  /// (H3): where end segments at a vertex differ, the longer are cut at the length of the shortest.
  /// Ends of a segment are looked at once all else is settled; what is left over is looked at
  /// again.
  void equalize(Workspace3& w) {
    const auto vertices = static_cast<std::uint32_t>(w.live.complex().vertices.size());
    for (std::uint32_t v = 0; v < vertices; ++v) {
      const VertexId q0(v);
      std::vector<SubsegmentId> at(w.live.subsegments_at(q0));
      double shortest = HUGE_VAL;
      for (const SubsegmentId s : at) shortest = std::min(shortest, length(w, s));
      for (const SubsegmentId s : at) {
        const double size = length(w, s);
        if (!is_longer(w, size, shortest) || w.live.subsegment(s).frozen) continue;
        const Subsegment u = w.live.subsegment(s);
        const VertexId other = u.a == q0 ? u.b : u.a;
        const Point3 p = point_between(point(w, q0), point(w, other), shortest / size);
        const auto parts = split_at(w, s, p, Reason::kEqualLength);
        if (!parts) {
          w.live.freeze(s);
          continue;
        }
        waiting_.push_back((*parts)[u.a == q0 ? 1 : 0]);
      }
    }
    if (!waiting_.empty()) queue_all(w);
  }

  SegmentSizes wanted_;
  bool changed_ = false;  // since all pieces were queued
  std::unique_ptr<FeatureSizeRun3> sizes_;
  std::unique_ptr<SegmentClearance> clearance_;
  std::vector<SubsegmentId> waiting_;
};

class LabelCollars final : public Stage3 {
 public:
  LabelCollars() : Stage3("3b", "Tell collars from what is beyond") {}
  bool advance(Workspace3& w, Budget&) override {
    w.live.label_collars();
    return true;
  }
};

}  // namespace

std::unique_ptr<Stage3> prepare_segments(SegmentSizes sizes) {
  return std::make_unique<PrepareSegments>(sizes);
}
std::unique_ptr<Stage3> label_collars() { return std::make_unique<LabelCollars>(); }

}  // namespace circumball
