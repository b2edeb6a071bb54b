#include "algorithms/protect.h"

#include <algorithm>
#include <cmath>

#include "algorithms/feature_size.h"
#include "circumball/predicates.h"
#include "delaunay/constructions.h"
#include "refinement/loop.h"
#include "refinement/split_at.h"

namespace circumball {
namespace {

/// N(q0) after Algorithm 3.1, for each vertex of the complex. Nothing of it stays.
class FeatureSizeEstimate {
 public:
  explicit FeatureSizeEstimate(const Workspace& w)
      : live_(w.live.complex(), Domain::kHull),
        recorder_(live_, nullptr),
        work_{live_, recorder_, w.limits, w.cancelled},
        loop_("1a", "", FeatureSize{}) {
    Delaunay2& dt = live_.triangulation();
    dt.insert_batch(0, dt.vertex_count(), nullptr);
    live_.create_subsegments();
    loop_.begin(work_);
  }
  bool advance(Budget& budget) { return loop_.advance(work_, budget); }
  Reason limit() const { return work_.limit; }
  double nearest_neighbor(VertexId v) const {
    double nearest2 = HUGE_VAL;
    const Delaunay2& dt = live_.triangulation();
    dt.for_each_neighbor(v, [&](VertexId p) {
      nearest2 = std::min(nearest2, squared_distance(dt.point(v), dt.point(p)));
      return true;
    });
    return std::sqrt(nearest2);
  }

 private:
  Live2 live_;
  Recorder recorder_;
  Workspace work_;
  Loop<FeatureSize> loop_;
};

class ProtectAcuteAngles final : public Stage {
 public:
  explicit ProtectAcuteAngles(Protection how)
      : Stage("1b", "Protect acute input angles"), how_(std::move(how)) {}

  void begin(Workspace& w) override {
    acute_ = acute_vertices(w.live.complex());
    if (how_.all) acute_.assign(acute_.size(), true);
    if (std::find(acute_.begin(), acute_.end(), true) == acute_.end()) return;
    estimate_ = std::make_unique<FeatureSizeEstimate>(w);
  }

  bool advance(Workspace& w, Budget& budget) override {
    if (!estimate_) return true;
    if (!estimate_->advance(budget)) {
      w.limit = estimate_->limit();
      return false;
    }
    const auto count = static_cast<std::uint32_t>(w.live.complex().segments.size());
    for (; next_ < count; ++next_) {
      if (!budget.spend() || !w.within_limits()) return false;
      if (w.live.subsegment(SubsegmentId(next_)).alive) protect(w, SubsegmentId(next_));
    }
    estimate_.reset();
    return true;
  }

 private:
  /// Splits the segment at its protected ends; what is left between such an end and the new vertex
  /// is a collar simplex.
  void protect(Workspace& w, SubsegmentId s) {
    const Subsegment whole = w.live.subsegment(s);
    if (acute_[whole.a.value]) {
      const auto halves = split(w, s, whole.a, whole.b);
      if (!halves) return;
      w.live.make_collar((*halves)[0]);
      s = (*halves)[1];
    }
    if (acute_[whole.b.value]) {
      if (const auto halves = split(w, s, whole.b, whole.a)) w.live.make_collar((*halves)[1]);
    }
  }

  /// Splits s at distance d from its end q0.
  std::optional<std::array<SubsegmentId, 2>> split(Workspace& w, SubsegmentId s, VertexId q0,
                                                   VertexId far) {
    const Delaunay2& dt = w.live.triangulation();
    const Point2 a = dt.point(q0), b = dt.point(far);
    if (w.live.protection_distance(q0) == 0) {
      w.live.protect(q0, protection_distance(w.live.complex(), a, q0));
    }
    // Rounded: within a few ulp of the larger end in each coordinate, like the distance d itself.
    const double t = w.live.protection_distance(q0) / distance(a, b);
    return split_at(w, s, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, Reason::kCollar);
  }

  double protection_distance(const Complex& complex, const Point2& at, VertexId q0) const {
    double d = how_.fraction * estimate_->nearest_neighbor(q0);
    if (how_.size > 0) d = std::min(d, how_.size);
    for (const Region& region : complex.regions) {
      // The largest area of a triangle whose circumradius is d / sqrt 2 is below 0.65 d^2.
      if (region.max > 0) d = std::min(d, std::sqrt(region.max / 0.65));
    }
    for (int i = 0; how_.sizing && i < 64; ++i) {
      // A certified bound on a box that holds every triangle in question.
      const Interval x(at.x - 2 * d, at.x + 2 * d), y(at.y - 2 * d, at.y + 2 * d);
      const double least = how_.sizing->over(x, y).lo;
      if (d <= least) break;
      d = std::max(least, 0.5 * d);
    }
    return d;
  }

  Protection how_;
  std::vector<bool> acute_;
  std::unique_ptr<FeatureSizeEstimate> estimate_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::unique_ptr<Stage> protect_acute_angles(Protection how) {
  return std::make_unique<ProtectAcuteAngles>(std::move(how));
}

std::vector<bool> acute_vertices(const Complex& complex) {
  const std::size_t n = complex.vertices.size();
  std::vector<std::vector<Point2>> ends(n);  // the other ends of the segments at a vertex
  for (const auto& s : complex.segments) {
    ends[s[0]].push_back(xy(complex.vertices[s[1]]));
    ends[s[1]].push_back(xy(complex.vertices[s[0]]));
  }
  std::vector<bool> acute(n, false);
  for (std::size_t v = 0; v < n; ++v) {
    const Point2 p = xy(complex.vertices[v]);
    auto& e = ends[v];
    std::sort(e.begin(), e.end(),
              [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    e.erase(std::unique(e.begin(), e.end()), e.end());  // a segment given twice makes no angle
    for (std::size_t i = 0; i < e.size() && !acute[v]; ++i) {
      for (std::size_t j = 0; j < i && !acute[v]; ++j) {
        // (a - p) . (b - p) > 0. Of five directions two are at most 72 degrees apart, so that this
        // stops soon.
        acute[v] = in_diametral_ball(e[i], e[j], p) == Sign::kNegative;
      }
    }
  }
  return acute;
}

}  // namespace circumball
