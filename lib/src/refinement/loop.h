#ifndef CIRCUMBALL_REFINEMENT_LOOP_H_
#define CIRCUMBALL_REFINEMENT_LOOP_H_

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "refinement/account.h"
#include "refinement/queue.h"
#include "refinement/stage.h"

namespace circumball {

/// Algorithm 2.2, the generic Delaunay refinement algorithm, in the plane:
///
///   queue every unacceptable simplex
///   while the queue is not empty
///     take the simplex of highest priority
///     if it has died or become acceptable, drop it
///     if it is not safe to split, drop it
///     otherwise perform its action: insert a vertex, or queue other simplices instead
///     queue every simplex that became unacceptable
///
/// `Rules` states the four rules, as pure queries (see ruppert.h):
/// - Triangles: its queue, which is Priority; subsegments always go before triangles
/// - unacceptable(View, SubsegmentId), unacceptable(View, TriangleRef) -> Verdict
/// - safe(View, SubsegmentId), safe(View, TriangleRef) -> Verdict (kNone: safe)
/// - action(View, SubsegmentId), action(View, TriangleRef) -> Proposal
/// - encroaches(View, SubsegmentId, VertexId) -> Verdict: as `unacceptable`, where only the vertex
///   is new
/// - kTriangles: whether triangles are looked at, at all
/// - kLooksAtNeighbors: `unacceptable` looks at all Delaunay neighbors of a subsegment's ends, not
///   only at its apexes; Live2 tracks incidence then. Such rules state one more:
///   spindle_shrank(View, SubsegmentId) -> Verdict: as `unacceptable`, where only an end segment at
///   its input vertex is shorter than before
template <class Rules>
class Loop final : public Stage {
 public:
  Loop(std::string name, std::string title, Rules rules)
      : Stage(std::move(name), std::move(title)), rules_(std::move(rules)) {}

  void begin(Workspace& w) override {
    view_.emplace(w.live, w.recorder.on());
    if constexpr (Rules::kLooksAtNeighbors) w.live.track_incidence();
    for (std::uint32_t i = 0; i < w.live.subsegment_count(); ++i) {
      if (w.live.subsegment(SubsegmentId(i)).alive) queue_if_unacceptable(w, SubsegmentId(i));
    }
    if constexpr (Rules::kTriangles) {
      const Delaunay2& dt = w.live.triangulation();
      std::vector<TriangleRef> by_birth;
      for (TriangleId t = 0; t < dt.slot_count(); ++t) {
        if (dt.alive(t)) by_birth.push_back({t, dt.triangle(t).birth});
      }
      std::sort(by_birth.begin(), by_birth.end(),
                [](TriangleRef a, TriangleRef b) { return a.birth < b.birth; });
      for (const TriangleRef t : by_birth) queue_if_unacceptable(w, t);
    }
  }

  bool advance(Workspace& w, Budget& budget) override {
    for (;;) {
      w.queued = subsegments_.size() + triangles_.size();
      if (w.queued == 0 && !queue_again(w)) return true;
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      if (!subsegments_.empty()) {
        process(w, subsegments_.pop());
      } else {
        process(w, triangles_.pop());
      }
    }
  }

  bool has_rules() const override { return true; }

  void unresolved(const Workspace& w, const std::string& stop, std::size_t max,
                  std::vector<Unresolved>* list) const override {
    if (Rules::kLooksAtNeighbors && !view_) return;  // incidence is not tracked yet
    const View view(w.live, false);
    for (std::uint32_t i = 0; i < w.live.subsegment_count() && list->size() < max; ++i) {
      const SubsegmentId s(i);
      if (!view.alive(s)) continue;
      if (const Verdict why = rules_.unacceptable(view, s)) {
        list->push_back(account_for(w.live, s, why.reason, refusal_of(s), stop));
      }
    }
    if constexpr (!Rules::kTriangles) return;
    const Delaunay2& dt = w.live.triangulation();
    for (TriangleId t = 0; t < dt.slot_count() && list->size() < max; ++t) {
      if (!dt.alive(t) || !w.live.maybe_in_domain(t)) continue;
      const TriangleRef ref{t, dt.triangle(t).birth};
      if (const Verdict why = rules_.unacceptable(view, ref)) {
        list->push_back(account_for(w.live, ref, why.reason, refusal_of(ref), stop));
      }
    }
  }

 private:
  /// Why a simplex was refused; kNone if it was not.
  template <class Simplex>
  Reason refusal_of(Simplex s) const {
    const auto found = refusals_.find(key(s));
    return found == refusals_.end() ? Reason::kNone : found->second;
  }
  static std::uint64_t key(SubsegmentId s) { return std::uint64_t{s.value} << 1; }
  static std::uint64_t key(TriangleRef t) { return std::uint64_t{t.birth} << 1 | 1; }

  void process(Workspace& w, const QueuedSubsegment& item) {
    const SubsegmentId s = item.subsegment;
    if (s.value < waiting_.size()) waiting_[s.value] = false;
    if (!view_->alive(s)) return w.recorder.dropped(s, Reason::kDied);
    const Verdict why = rules_.unacceptable(*view_, s);
    // A subsegment that a circumcentre yielded to is split, as long as the triangle that proposed
    // it is alive.
    if (!why && !(item.proposer.id != kNone && view_->alive(item.proposer))) {
      w.live.tag_edge(s);  // it may have been missing before
      return w.recorder.dropped(s, Reason::kAcceptable);
    }
    if (const Verdict unsafe = rules_.safe(*view_, s)) return refuse(w, s, unsafe.reason, Point2());
    const Proposal p = rules_.action(*view_, s);
    if (view_->look_at_midpoint(p.at, s) == Outlook::kCoincides || !representable(p.at)) {
      return refuse(w, s, Reason::kPrecision, p.at);
    }
    if (too_close(w, p.at)) return refuse(w, s, Reason::kMinEdge, p.at);
    insert(w, s, p);
  }

  void process(Workspace& w, TriangleRef t) {
    if (!view_->alive(t)) return;
    if (!w.live.in_domain(t.id) || !rules_.unacceptable(*view_, t)) {
      return w.recorder.dropped(t, Reason::kAcceptable);
    }
    if (const Verdict unsafe = rules_.safe(*view_, t)) return refuse(w, t, unsafe.reason, Point2());
    const Proposal p = rules_.action(*view_, t);
    switch (p.kind) {
      case Proposal::kRefuse:
        return refuse(w, t, p.reason, p.at);
      case Proposal::kYield:
        return yield(w, t, p);
      case Proposal::kInsert:
        if (!representable(p.at)) return refuse(w, t, Reason::kPrecision, p.at);
        if (too_close(w, p.at)) return refuse(w, t, Reason::kMinEdge, p.at);
        return insert(w, t, p);
    }
  }

  /// The circumcentre yields to what it encroaches, and the triangle that proposed it goes back to
  /// the queue.
  void yield(Workspace& w, TriangleRef t, const Proposal& p) {
    bool queued = false;
    for (const SubsegmentId s : view_->encroached()) {
      const Subsegment& u = view_->subsegment(s);
      if (!u.alive || u.frozen || u.is_collar) continue;
      queued = true;
      w.recorder.yielded(t, p.at, s);
      w.recorder.queued(s, {Reason::kYieldedTo, VertexId(), 0});
      subsegments_.push({s, t});
    }
    if (!queued) return refuse(w, t, Reason::kFrozen, p.at);
    ++w.yielded;
    const Verdict why = rules_.unacceptable(*view_, t);
    w.recorder.queued(t, {Reason::kReturned, VertexId(), why.value});
    triangles_.push_front(t, why.value);
  }

  template <class Simplex>
  void refuse(Workspace& w, Simplex s, Reason why, const Point2& at) {
    ++w.refused;
    if (why == Reason::kMinEdge) w.refusal_limit = Reason::kLimitMinEdge;
    if (why == Reason::kPrecision && w.refusal_limit == Reason::kNone) {
      w.refusal_limit = Reason::kLimitPrecision;
    }
    freeze(w, s);
    refusals_[key(s)] = why;
    w.recorder.refused(s, why, at);
  }
  static void freeze(Workspace& w, SubsegmentId s) { w.live.freeze(s); }
  static void freeze(Workspace&, TriangleRef) {}

  /// Nothing is inserted whose coordinates are too small for the predicates to be exact
  /// (architecture.md, Numbers).
  static bool representable(const Point2& p) {
    const auto fine = [](double x) { return x == 0 || x >= 1e-45 || x <= -1e-45; };
    return fine(p.x) && fine(p.y);
  }

  bool too_close(const Workspace& w, const Point2& p) const {
    return w.limits.min_edge > 0 && view_->insertion_radius(p) < w.limits.min_edge;
  }

  template <class Simplex>
  void insert(Workspace& w, Simplex s, const Proposal& p) {
    Delaunay2& dt = w.live.triangulation();
    const double radius = w.recorder.on() ? view_->insertion_radius(p.at) : 0;
    const Event event = w.recorder.insertion_of(s, p.reason);
    swallowed_.clear();
    for (const HalfEdge h : dt.cavity_tagged_inside()) {
      if (dt.tag(h) != tag_of(s)) swallowed_.push_back(SubsegmentId(dt.tag(h)));
    }
    if (w.recorder.on()) w.recorder.relabeled(w.live.take_relabeled());
    const VertexId v = w.live.add_vertex(p.at, feature_of(w, s));
    w.live.commit(v, tag_of(s));
    ++w.inserted;
    w.recorder.inserted(event, v, radius);
    split(w, s, v);
    for (const SubsegmentId lost : swallowed_) queue_if_unacceptable(w, lost);
    queue_around(w, v);
  }

  void split(Workspace& w, SubsegmentId s, VertexId v) {
    for (const SubsegmentId half : w.live.split(s, v)) queue_if_unacceptable(w, half);
  }
  void split(Workspace&, TriangleRef, VertexId) {}

  /// Queues what became unacceptable by the insertion of v: all of it touches a triangle that was
  /// born.
  void queue_around(Workspace& w, VertexId v) {
    const Delaunay2& dt = w.live.triangulation();
    if constexpr (Rules::kLooksAtNeighbors) return queue_neighbors(w, v);
    for (const TriangleId t : dt.born()) {
      if (dt.is_ghost(t)) continue;
      const auto& corners = dt.triangle(t).v;
      const unsigned i = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
      const std::uint32_t tag = dt.tag(4 * t + i);
      if (tag != kNone) {
        if (const Verdict why = rules_.encroaches(*view_, SubsegmentId(tag), v)) {
          queue(w, SubsegmentId(tag), why);
        }
      }
      if constexpr (Rules::kTriangles) {
        queue_if_unacceptable(w, TriangleRef{t, dt.triangle(t).birth});
      }
    }
  }

  /// Rules that look deeper than the triangles that touch a new vertex are asked once more about
  /// everything when the queue runs empty.
  bool queue_again(Workspace& w) {
    if constexpr (!Rules::kLooksAtNeighbors) return false;
    for (std::uint32_t i = 0; i < w.live.subsegment_count(); ++i) {
      const SubsegmentId s(i);
      if (w.live.subsegment(s).alive && !w.live.subsegment(s).frozen) queue_if_unacceptable(w, s);
    }
    return !subsegments_.empty();
  }

  /// Only v and its new Delaunay neighbors have other neighbors than before, and only the spindles
  /// of the end segments at v have shorter members.
  void queue_neighbors(Workspace& w, VertexId v) {
    w.live.triangulation().for_each_neighbor(v, [&](VertexId u) {
      for (const SubsegmentId s : w.live.subsegments_at(u)) {
        queue_if(w, s, rules_.encroaches(*view_, s, v));
      }
      return true;
    });
    for (const SubsegmentId half : w.live.subsegments_at(v)) {
      const Subsegment& h = w.live.subsegment(half);
      const VertexId end = h.a == v ? h.b : h.a;
      if (!view_->is_input_vertex(end)) continue;
      for (const SubsegmentId s : w.live.subsegments_at(end)) {
        queue_if(w, s, rules_.spindle_shrank(*view_, s));
      }
    }
  }

  void queue_if_unacceptable(Workspace& w, SubsegmentId s) {
    queue_if(w, s, rules_.unacceptable(*view_, s));
  }
  void queue_if(Workspace& w, SubsegmentId s, const Verdict& why) {
    if (why) queue(w, s, why);
  }
  void queue_if_unacceptable(Workspace& w, TriangleRef t) {
    if (!w.live.maybe_in_domain(t.id)) return;
    const Verdict why = rules_.unacceptable(*view_, t);
    if (!why) return;
    w.recorder.queued(t, why);
    triangles_.push(t, why.value);
  }
  void queue(Workspace& w, SubsegmentId s, const Verdict& why) {
    if (waiting_.size() <= s.value) waiting_.resize(w.live.subsegment_count(), false);
    if (waiting_[s.value]) return;
    waiting_[s.value] = true;
    w.recorder.queued(s, why);
    subsegments_.push({s, TriangleRef()});
  }

  static std::uint32_t tag_of(SubsegmentId s) { return s.value; }
  static std::uint32_t tag_of(TriangleRef) { return kNone; }
  static Feature feature_of(const Workspace& w, SubsegmentId s) {
    const Subsegment& u = w.live.subsegment(s);
    if (u.is_arc()) return {FeatureKind::kFree, kNoIndex};
    return {FeatureKind::kSegment, u.segment.value};
  }
  static Feature feature_of(const Workspace&, TriangleRef) {
    return {FeatureKind::kFree, kNoIndex};
  }

  Rules rules_;
  std::optional<View> view_;
  FifoQueue<QueuedSubsegment> subsegments_;
  typename Rules::Triangles triangles_;
  std::vector<SubsegmentId> swallowed_;
  std::vector<bool> waiting_;  // by subsegment: in the queue as unacceptable
  std::map<std::uint64_t, Reason> refusals_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_LOOP_H_
