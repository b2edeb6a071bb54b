#include "algorithms/sweeps3.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/short_segments.h"
#include "complex/solid_domain.h"
#include "refinement/split_at3.h"

namespace circumball {
namespace {

class InsertVerticesInSpace final : public Stage3 {
 public:
  explicit InsertVerticesInSpace(bool by_birth)
      : Stage3("0", "Delaunay tetrahedralization of the input vertices"), by_birth_(by_birth) {}

  bool advance(Workspace3& w, Budget&) override {
    Delaunay3& dt = w.live.triangulation();
    const std::uint32_t count = dt.vertex_count();
    dt.reserve(2 * count);
    if (by_birth_ || w.recorder.on()) {
      dt.insert_batch(0, count, [&](VertexId v) {
        if (!w.recorder.on()) return;
        const Reason what = w.live.is_box_corner(v) ? Reason::kBox : Reason::kInput;
        w.recorder.inserted(w.recorder.insertion(what), v, 0);
      });
    } else {
      dt.insert_batch(0, count, nullptr);  // the faster way
    }
    w.inserted = count;
    w.live.create_features();
    for (std::uint32_t f = 0; f < w.live.face_count(); ++f) w.recorder.face_created(f);
    return true;
  }

 private:
  bool by_birth_;
};

class ClassifyCells final : public Stage3 {
 public:
  explicit ClassifyCells(std::string name) : Stage3(std::move(name), "Tell inside from outside") {}
  bool advance(Workspace3& w, Budget&) override {
    w.recorder.relabeled(classify_if_conforming(&w.live));
    return true;
  }
};

class SplitAtThirds final : public Stage3 {
 public:
  SplitAtThirds() : Stage3("1a", "Split segments at a third of the nearest neighbor's distance") {}

  void begin(Workspace3& w) override {
    const Delaunay3& dt = w.live.triangulation();
    nearest_.assign(w.live.complex().vertices.size(), HUGE_VAL);
    std::vector<VertexId> neighbors;
    for (std::uint32_t v = 0; v < nearest_.size(); ++v) {
      if (w.live.subsegments_at(VertexId(v)).empty()) continue;
      dt.neighbors(VertexId(v), &neighbors);
      for (const VertexId p : neighbors) {
        nearest_[v] = std::min(nearest_[v], distance(dt.point(VertexId(v)), dt.point(p)));
      }
    }
    segments_ = w.live.subsegment_count();
  }

  bool advance(Workspace3& w, Budget& budget) override {
    for (; at_ < 2 * segments_; ++at_) {
      const SubsegmentId whole(at_ / 2);
      if (at_ % 2 == 0) rest_ = whole;
      if (!w.live.subsegment(rest_).alive) continue;  // given twice
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      // The ends as given: rest_ still ends at the second when the first was split off.
      const Subsegment& s = w.live.subsegment(whole);
      const VertexId q0 = at_ % 2 == 0 ? s.a : s.b, other = at_ % 2 == 0 ? s.b : s.a;
      const Delaunay3& dt = w.live.triangulation();
      const double length = distance(dt.point(q0), dt.point(other));
      const Point3 p =
          point_between(dt.point(q0), dt.point(other), nearest_[q0.value] / 3 / length);
      if (const auto parts = split_at(w, rest_, p, Reason::kThird)) rest_ = (*parts)[1];
    }
    return true;
  }

 private:
  std::vector<double> nearest_;  // N(q0) after step 0, of input vertices on segments
  std::uint32_t segments_ = 0, at_ = 0;
  SubsegmentId rest_;  // of the segment at hand
};

class SplitIntoParts final : public Stage3 {
 public:
  explicit SplitIntoParts(Step2a how)
      : Stage3("2a", how == Step2a::kFourths  ? "Split segments into four equal parts"
                     : how == Step2a::kHalves ? "Split segments into two equal parts"
                                              : "Split segments into four where it is needed"),
        how_(how) {}

  void begin(Workspace3& w) override {
    std::vector<SubsegmentId> all;
    for (std::uint32_t i = 0; i < w.live.subsegment_count(); ++i) {
      if (w.live.subsegment(SubsegmentId(i)).alive) all.push_back(SubsegmentId(i));
    }
    if (how_ == Step2a::kAdaptive) all = not_known_to_be_short(w.live, all);
    // Taken from the back.
    for (auto s = all.rbegin(); s != all.rend(); ++s) {
      waiting_.push_back({*s, how_ == Step2a::kHalves ? 1 : 2});
    }
  }

  bool advance(Workspace3& w, Budget& budget) override {
    while (!waiting_.empty()) {
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      const Item item = waiting_.back();
      waiting_.pop_back();
      const Subsegment& s = w.live.subsegment(item.subsegment);
      const Delaunay3& dt = w.live.triangulation();
      const auto halves =
          split_at(w, item.subsegment, midpoint(dt.point(s.a), dt.point(s.b)), Reason::kDivision);
      if (!halves || item.splits == 1) continue;
      waiting_.push_back({(*halves)[1], item.splits - 1});
      waiting_.push_back({(*halves)[0], item.splits - 1});
    }
    return true;
  }

 private:
  struct Item {
    SubsegmentId subsegment;
    int splits;  // how often it is to be halved
  };
  Step2a how_;
  std::vector<Item> waiting_;
};

}  // namespace

std::unique_ptr<Stage3> insert_vertices_in_space(bool by_birth) {
  return std::make_unique<InsertVerticesInSpace>(by_birth);
}
std::unique_ptr<Stage3> classify_cells(std::string name) {
  return std::make_unique<ClassifyCells>(std::move(name));
}
std::unique_ptr<Stage3> split_at_thirds() { return std::make_unique<SplitAtThirds>(); }
std::unique_ptr<Stage3> split_into_parts(Step2a how) {
  return std::make_unique<SplitIntoParts>(how);
}

}  // namespace circumball
