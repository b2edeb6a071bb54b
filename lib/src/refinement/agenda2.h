#ifndef CIRCUMBALL_REFINEMENT_AGENDA2_H_
#define CIRCUMBALL_REFINEMENT_AGENDA2_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "refinement/queue.h"
#include "refinement/stage.h"

namespace circumball {

/// What the loop needs to know of the plane: which simplices there are, in which order they wait,
/// and which an insertion concerns. Of `Rules` it asks, beside the four:
/// - Triangles: its queue, which is Priority; subsegments always go before triangles
/// - encroaches(View, SubsegmentId, VertexId) -> Verdict: as `unacceptable`, where only the vertex
///   is new
/// - kTriangles: whether triangles are looked at, at all
/// - kLooksAtNeighbors: `unacceptable` looks at all Delaunay neighbors of a subsegment's ends, not
///   only at its apexes; Live2 tracks incidence then. Such rules state one more:
///   spindle_shrank(View, SubsegmentId) -> Verdict: as `unacceptable`, where only an end segment at
///   its input vertex is shorter than before
template <class Rules>
class Agenda2 {
 public:
  /// Whether rules can only be asked once `begin` was called.
  static constexpr bool kNeedsBegin = Rules::kLooksAtNeighbors;
  /// Whether a circumcenter may yield.
  static constexpr bool kYields = true;
  void begin(Live2& live) {
    if constexpr (Rules::kLooksAtNeighbors) live.track_incidence();
  }
  bool empty() const { return subsegments_.empty() && triangles_.empty(); }
  std::size_t size() const { return subsegments_.size() + triangles_.size(); }

  /// Calls f for all that the rules look at: subsegments, then triangles, by birth.
  template <class F>
  void for_each_simplex(const Live2& live, const Rules&, F f) const {
    for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
      if (live.subsegment(SubsegmentId(i)).alive) f(SubsegmentId(i));
    }
    if constexpr (Rules::kTriangles) {
      const Delaunay2& dt = live.triangulation();
      std::vector<TriangleRef> by_birth;
      for (TriangleId t = 0; t < dt.slot_count(); ++t) {
        if (dt.alive(t) && live.maybe_in_domain(t)) by_birth.push_back({t, dt.triangle(t).birth});
      }
      std::sort(by_birth.begin(), by_birth.end(),
                [](TriangleRef a, TriangleRef b) { return a.birth < b.birth; });
      for (const TriangleRef t : by_birth) f(t);
    }
  }

  /// Returns whether it was not waiting yet.
  bool push(const View&, const Rules&, SubsegmentId s, const Verdict&) {
    if (waiting_.size() <= s.value) waiting_.resize(s.value + 1, false);
    if (waiting_[s.value]) return false;
    waiting_[s.value] = true;
    subsegments_.push({s, TriangleRef()});
    return true;
  }
  bool push(const View&, const Rules&, TriangleRef t, const Verdict& why) {
    triangles_.push(t, why.value);
    return true;
  }
  /// Why a simplex is unacceptable still that was when it was queued: nothing is remembered.
  template <class Simplex>
  Verdict remembered(const View&, const Rules&, Simplex) const {
    return {};
  }
  void push_yielded(SubsegmentId s, TriangleRef proposer) { subsegments_.push({s, proposer}); }
  void push_front(TriangleRef t, double value) { triangles_.push_front(t, value); }

  /// Takes the simplex of highest priority, and calls f with it and with the triangle whose
  /// circumcenter yielded to it, if one did.
  template <class F>
  void take(const Live2&, F f) {
    if (subsegments_.empty()) return f(triangles_.pop(), TriangleRef());
    const QueuedSubsegment item = subsegments_.pop();
    if (item.subsegment.value < waiting_.size()) waiting_[item.subsegment.value] = false;
    f(item.subsegment, item.proposer);
  }

  /// What is refused stays refused.
  void refused(Live2& live, SubsegmentId s, Reason) { live.freeze(s); }
  void refused(Live2&, TriangleRef, Reason) {}

  /// Inserts the point of p, just looked at, to split s; calls queue(simplex, verdict) for what
  /// became unacceptable.
  template <class Simplex, class F>
  void insert(Workspace& w, const View& view, const Rules& rules, Simplex s, const Proposal& p,
              F queue) {
    Delaunay2& dt = w.live.triangulation();
    const double radius = w.recorder.on() ? view.insertion_radius(p.at) : 0;
    const Event event = w.recorder.insertion_of(s, p.reason);
    swallowed_.clear();
    for (const HalfEdge h : dt.cavity_tagged_inside()) {
      if (dt.tag(h) != tag_of(s)) swallowed_.push_back(SubsegmentId(dt.tag(h)));
    }
    if (w.recorder.on()) w.recorder.relabeled(w.live.take_relabeled());
    const VertexId v = w.live.add_vertex(p.at, feature_of(w.live, s));
    w.live.commit(v, tag_of(s));
    ++w.inserted;
    w.recorder.inserted(event, v, radius);
    const auto ask = [&](auto simplex, const Verdict& why) {
      if (why) queue(simplex, why);
    };
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) {
      for (const SubsegmentId half : w.live.split(s, v)) {
        ask(half, rules.unacceptable(view, half));
      }
    }
    for (const SubsegmentId lost : swallowed_) ask(lost, rules.unacceptable(view, lost));
    if constexpr (Rules::kLooksAtNeighbors) {
      ask_neighbors(w.live, view, rules, v, ask);
    } else {
      ask_born(w.live, view, rules, v, ask);
    }
  }

  /// Calls queue(simplex, verdict) for what is unacceptable after all when nothing waits any more.
  template <class F>
  void look_again(const Workspace& w, const View& view, const Rules& rules, F queue) {
    const Live2& live = w.live;
    if constexpr (Rules::kLooksAtNeighbors) {
      for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
        const SubsegmentId s(i);
        if (!live.subsegment(s).alive || live.subsegment(s).frozen) continue;
        if (const Verdict why = rules.unacceptable(view, s)) queue(s, why);
      }
    }
  }

 private:
  /// All that became unacceptable by the insertion of v touches a triangle that was born.
  template <class Ask>
  void ask_born(const Live2& live, const View& view, const Rules& rules, VertexId v, Ask ask) {
    const Delaunay2& dt = live.triangulation();
    for (const TriangleId t : dt.born()) {
      if (dt.is_ghost(t)) continue;
      const auto& corners = dt.triangle(t).v;
      const unsigned i = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
      const std::uint32_t tag = dt.tag(4 * t + i);
      if (tag != kNone) ask(SubsegmentId(tag), rules.encroaches(view, SubsegmentId(tag), v));
      if constexpr (Rules::kTriangles) {
        const TriangleRef born{t, dt.triangle(t).birth};
        if (live.maybe_in_domain(t)) ask(born, rules.unacceptable(view, born));
      }
    }
  }

  /// Only v and its new Delaunay neighbors have other neighbors than before, and only the spindles
  /// of the end segments at v have shorter members.
  template <class Ask>
  void ask_neighbors(const Live2& live, const View& view, const Rules& rules, VertexId v, Ask ask) {
    live.triangulation().for_each_neighbor(v, [&](VertexId u) {
      for (const SubsegmentId s : live.subsegments_at(u)) ask(s, rules.encroaches(view, s, v));
      return true;
    });
    for (const SubsegmentId half : live.subsegments_at(v)) {
      const Subsegment& h = live.subsegment(half);
      const VertexId end = h.a == v ? h.b : h.a;
      if (!view.is_input_vertex(end)) continue;
      for (const SubsegmentId s : live.subsegments_at(end)) ask(s, rules.spindle_shrank(view, s));
    }
  }

  static std::uint32_t tag_of(SubsegmentId s) { return s.value; }
  static std::uint32_t tag_of(TriangleRef) { return kNone; }
  static Feature feature_of(const Live2& live, SubsegmentId s) {
    const Subsegment& u = live.subsegment(s);
    if (u.is_arc()) return {FeatureKind::kFree, kNoIndex};
    return {FeatureKind::kSegment, u.segment.value};
  }
  static Feature feature_of(const Live2&, TriangleRef) { return {FeatureKind::kFree, kNoIndex}; }

  FifoQueue<QueuedSubsegment> subsegments_;
  typename Rules::Triangles triangles_;
  std::vector<SubsegmentId> swallowed_;
  std::vector<bool> waiting_;  // by subsegment: in the queue as unacceptable
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_AGENDA2_H_
