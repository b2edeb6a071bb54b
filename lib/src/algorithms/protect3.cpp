#include "algorithms/protect3.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/estimate3.h"
#include "protection/acute3.h"
#include "protection/segment_clearance.h"
#include "refinement/split_at3.h"

namespace circumball {
namespace {

/// A bound that is to be kept strictly, in parts of it.
constexpr double kBelow = 1 - 1.0 / (1 << 20);

/// (H1) to (H3). End segments at a protected vertex q0 have the length d = c lfs(q0) / (1 + c), the
/// longest that (H2) allows: lfs is 1-Lipschitz, so that it is at least lfs(q0) - d = d / c on
/// them.
///
/// All else of a protected segment is halved until it is shorter than c times its distance from
/// every feature that does not contain the segment. That bounds mfs_1 from below, and lfs, as of
/// two disjoint features one does not contain the segment. The ends q0 are such features: pieces
/// grow by factors from the tips, and neighbors differ by a factor of two at most.
///
/// By the estimate of Algorithm 4.1, segments are cut at its vertices on them and halved once more
/// before; d is the length of the shortest end segment then.
class PrepareSegments final : public Stage3 {
 public:
  explicit PrepareSegments(SegmentSizes sizes)
      : Stage3("2b", "Split segments as feature sizes ask"), wanted_(sizes) {}

  void begin(Workspace3& w) override {
    const Complex& complex = w.live.complex();
    clearance_ = std::make_unique<SegmentClearance>(complex, w.live.incidence());
    find_protected(w.live);
    radii_.assign(complex.vertices.size(), 0);
    const bool any = std::find(vertices_.begin(), vertices_.end(), true) != vertices_.end();
    if (any && wanted_.estimate) estimate_ = std::make_unique<SizeEstimate3>(w);
    if (!any) at_ = Phase::kDone;
  }

  bool advance(Workspace3& w, Budget& budget) override {
    if (estimate_ && !estimate_->advance(budget)) {
      w.limit = estimate_->limit();
      return false;
    }
    if (estimate_) {
      points_ = estimate_->on_segments();
      estimate_.reset();
    }
    const auto each = [&](std::uint32_t count, Phase next, auto action) {
      for (; next_ < count; ++next_) {
        if (!budget.spend() || !w.within_limits()) return false;
        ++w.iterations;
        action(next_);
      }
      next_ = 0;
      at_ = next;
      return true;
    };
    const auto vertices = static_cast<std::uint32_t>(vertices_.size());
    const auto segments = static_cast<std::uint32_t>(segments_.size());
    if (at_ == Phase::kRadii &&
        !each(vertices, Phase::kTips, [&](std::uint32_t v) { find_radius(w.live, v); })) {
      return false;
    }
    if (at_ == Phase::kTips &&
        !each(segments, Phase::kPieces, [&](std::uint32_t s) { cut(w, s); })) {
      return false;
    }
    while (!waiting_.empty()) {
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      const SubsegmentId s = waiting_.back();
      waiting_.pop_back();
      look_at(w, s);
      if (waiting_.empty() && wanted_.graded && std::exchange(halved_, false)) queue_all(w);
    }
    if (at_ == Phase::kPieces) {
      w.live.protect(std::move(radii_), segments_);
      w.recorder.subsegments_protected();
    }
    at_ = Phase::kDone;
    return true;
  }

 private:
  enum class Phase : std::uint8_t { kRadii, kTips, kPieces, kDone };

  const Point3& point(const Workspace3& w, VertexId v) const {
    return w.live.triangulation().point(v);
  }

  /// All that meets something, or what is acute. A vertex of a single face alone meets nothing.
  void find_protected(const Live3& live) {
    const Complex& complex = live.complex();
    const Incidence3& incidence = live.incidence();
    segments_.assign(complex.segments.size(), false);
    vertices_.assign(complex.vertices.size(), false);
    if (!wanted_.all) {
      const Acute3 acute(complex, incidence);
      for (std::uint32_t s = 0; s < segments_.size(); ++s) segments_[s] = acute.segment(s);
      for (std::uint32_t v = 0; v < vertices_.size(); ++v) vertices_[v] = acute.vertex(v);
      return;
    }
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      const auto& ends = complex.segments[s];
      segments_[s] = wanted_.box || !live.is_box_corner(VertexId(ends[0])) ||
                     !live.is_box_corner(VertexId(ends[1]));
    }
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      vertices_[v] =
          (wanted_.box || !live.is_box_corner(VertexId(v))) &&
          (incidence.segments_of_vertex(v).size() > 0 || incidence.faces_of_vertex(v).size() > 1);
    }
  }

  void find_radius(const Live3& live, std::uint32_t v) {
    if (!vertices_[v]) return;
    double d = clearance_->of_vertex(v) * wanted_.clearance / (1 + wanted_.clearance) * kBelow;
    if (wanted_.estimate) {
      const Point3& q0 = live.complex().vertices[v];
      double shortest = HUGE_VAL;
      for (const std::uint32_t s : live.incidence().segments_of_vertex(v)) {
        if (points_[s].empty()) continue;
        const bool first = live.complex().segments[s][0] == v;
        shortest =
            std::min(shortest, 0.5 * distance(q0, first ? points_[s].front() : points_[s].back()));
      }
      if (shortest < HUGE_VAL) d = shortest;
    }
    radii_[v] = d;
  }

  /// Tips, and where there is an estimate, its vertices between them and the middles of its pieces.
  void cut(Workspace3& w, std::uint32_t segment) {
    const SubsegmentId whole(segment);
    if (!w.live.subsegment(whole).alive) return;  // given twice
    const std::uint32_t a = w.live.complex().segments[segment][0];
    const std::uint32_t b = w.live.complex().segments[segment][1];
    const Point3 p = point(w, VertexId(a)), q = point(w, VertexId(b));
    const double length = distance(p, q);
    std::vector<Point3> at;
    if (vertices_[a]) at.push_back(point_between(p, q, radii_[a] / length));
    if (segments_[segment] && wanted_.estimate) {
      Point3 last = p;
      const auto add = [&](const Point3& r) {
        if (distance(p, r) > kLengthSlack * radii_[a] + w.live.rounding() &&
            distance(q, r) > kLengthSlack * radii_[b] + w.live.rounding()) {
          at.push_back(r);
        }
      };
      for (const Point3& r : points_[segment]) {
        add(midpoint(last, r));
        add(r);
        last = r;
      }
      add(midpoint(last, q));
    }
    if (vertices_[b]) at.push_back(point_between(q, p, radii_[b] / length));
    SubsegmentId rest = whole;
    for (const Point3& r : at) {
      const auto halves = split_at(w, rest, r, Reason::kDivision);
      if (!halves) continue;
      rest = (*halves)[1];
      if (segments_[segment]) waiting_.push_back((*halves)[0]);
    }
    if (segments_[segment]) waiting_.push_back(rest);
  }

  void queue_all(const Workspace3& w) {
    for (std::uint32_t i = w.live.subsegment_count(); i-- > 0;) {
      const Subsegment& u = w.live.subsegment(SubsegmentId(i));
      if (u.alive && segments_[u.segment.value]) waiting_.push_back(SubsegmentId(i));
    }
  }

  /// (H2) of a piece between the tips; and that none is longer than the end segments beside it.
  void look_at(Workspace3& w, SubsegmentId s) {
    const Subsegment u = w.live.subsegment(s);
    if (!u.alive || u.frozen || w.live.is_input_vertex(u.a) || w.live.is_input_vertex(u.b)) return;
    const Point3 &a = point(w, u.a), &b = point(w, u.b);
    const double size = distance(a, b);
    bool is_short = size < wanted_.clearance * clearance_->of(a, b, u.segment.value);
    for (const VertexId q : {u.a, u.b}) {
      for (const SubsegmentId other : w.live.subsegments_at(q)) {
        const Subsegment& r = w.live.subsegment(other);
        const bool end = w.live.is_input_vertex(r.a) || w.live.is_input_vertex(r.b);
        if (!end && !wanted_.graded) continue;
        const double most = (end ? 1 : 2) * distance(point(w, r.a), point(w, r.b));
        is_short = is_short && size <= kLengthSlack * most + w.live.rounding();
      }
    }
    if (is_short) return;
    const auto halves = split_at(w, s, midpoint(a, b), Reason::kMidpoint);
    if (!halves) return w.live.freeze(s);
    halved_ = true;
    waiting_.push_back((*halves)[1]);
    waiting_.push_back((*halves)[0]);
  }

  const SegmentSizes wanted_;
  std::unique_ptr<SizeEstimate3> estimate_;
  std::unique_ptr<SegmentClearance> clearance_;
  std::vector<std::vector<Point3>> points_;  // of the estimate, by segment
  std::vector<bool> vertices_, segments_;    // which are protected
  std::vector<double> radii_;
  std::vector<SubsegmentId> waiting_;
  bool halved_ = false;  // since all pieces were queued
  Phase at_ = Phase::kRadii;
  std::uint32_t next_ = 0;
};

class LabelCollars final : public Stage3 {
 public:
  LabelCollars() : Stage3("3b", "Tell collars from what is beyond") {}
  bool advance(Workspace3& w, Budget&) override {
    if (w.live.tracks_collars()) w.live.label_collars();
    return true;
  }
};

}  // namespace

std::unique_ptr<Stage3> prepare_segments(SegmentSizes sizes) {
  return std::make_unique<PrepareSegments>(sizes);
}
std::unique_ptr<Stage3> label_collars() { return std::make_unique<LabelCollars>(); }

std::vector<VertexId> vertices_on_segment(const Live3& live, std::uint32_t segment) {
  std::vector<VertexId> list{VertexId(live.complex().segments[segment][0])};
  SubsegmentId from;
  for (;;) {
    SubsegmentId next;
    for (const SubsegmentId s : live.subsegments_at(list.back())) {
      if (live.subsegment(s).segment.value == segment && s != from) next = s;
    }
    if (!next.valid()) return list;
    const Subsegment& u = live.subsegment(next);
    list.push_back(u.a == list.back() ? u.b : u.a);
    from = next;
  }
}

}  // namespace circumball
