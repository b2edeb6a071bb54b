#ifndef CIRCUMBALL_REFINEMENT_RECORDER_H_
#define CIRCUMBALL_REFINEMENT_RECORDER_H_

#include <vector>

#include "circumball/trace.h"
#include "complex/live2.h"
#include "refinement/view.h"

namespace circumball {

/// Puts what happens into events, if somebody listens. With a null sink each call is one
/// predictable branch.
class Recorder {
 public:
  Recorder(const Live2& live, TraceSink* sink) : live_(live), sink_(sink) {}
  bool on() const { return sink_ != nullptr; }

  void step_began(std::uint8_t step) {
    step_ = step;
    if (sink_) send(blank(EventKind::kStepBegan));
  }
  void step_ended(std::uint64_t inserted, std::uint64_t refused) {
    if (!sink_) return;
    Event e = blank(EventKind::kStepEnded);
    e.subject = static_cast<std::uint32_t>(inserted);
    e.other[0] = static_cast<std::uint32_t>(refused);
    send(e);
  }
  template <class Simplex>
  void queued(Simplex s, const Verdict& why) {
    if (!sink_) return;
    Event e = of(EventKind::kQueued, s);
    e.reason = why.reason;
    e.subject = why.witness.value;
    e.value = why.value;
    send(e);
  }
  template <class Simplex>
  void dropped(Simplex s, Reason why) {
    if (!sink_) return;
    Event e = of(EventKind::kDropped, s);
    e.reason = why;
    send(e);
  }
  template <class Simplex>
  void refused(Simplex s, Reason why, const Point2& at) {
    if (!sink_) return;
    Event e = of(EventKind::kRefused, s);
    e.reason = why;
    place(at, &e);
    send(e);
  }
  void yielded(TriangleRef t, const Point2& at, SubsegmentId to) {
    if (!sink_) return;
    Event e = of(EventKind::kYielded, t);
    const Subsegment& u = live_.subsegment(to);
    e.reason = Reason::kYieldedTo;
    e.subject = u.segment.value;
    e.other[0] = u.a.value;
    e.other[1] = u.b.value;
    place(at, &e);
    send(e);
  }
  /// After the insertion of v, which split `split` (as an event of kind kInserted without its
  /// record).
  void inserted(Event split, VertexId v, double insertion_radius);
  template <class Simplex>
  Event insertion_of(Simplex s, Reason why) const {
    if (!sink_) return Event();
    Event e = of(EventKind::kInserted, s);
    e.reason = why;
    return e;
  }
  Event insertion(Reason why) const {
    Event e = blank(EventKind::kInserted);
    e.reason = why;
    return e;
  }
  /// Triangles that got another label while they live.
  void relabeled(const std::vector<Live2::Relabeled>& triangles);
  void limit(Reason why) {
    if (!sink_) return;
    Event e = blank(EventKind::kLimit);
    e.reason = why;
    send(e);
  }

 private:
  Event blank(EventKind kind) const {
    Event e;
    e.kind = kind;
    e.step = step_;
    return e;
  }
  Event of(EventKind kind, TriangleRef t) const {
    Event e = blank(kind);
    e.dimension = 2;
    const auto& v = live_.triangulation().triangle(t.id).v;
    for (int i = 0; i < 3; ++i) e.simplex[i] = v[i].value;
    return e;
  }
  Event of(EventKind kind, SubsegmentId s) const {
    Event e = blank(kind);
    e.dimension = 1;
    const Subsegment& u = live_.subsegment(s);
    e.simplex[0] = u.a.value;
    e.simplex[1] = u.b.value;
    e.simplex[2] = u.center.value;
    e.simplex[3] = u.segment.value;
    return e;
  }
  static void place(const Point2& at, Event* e) {
    e->at[0] = at.x;
    e->at[1] = at.y;
  }
  bool append(const Delaunay2::Triangle& t, std::uint32_t label);
  void send(const Event& e) { sink_->event(e, stream_.data(), 0); }

  const Live2& live_;
  TraceSink* sink_;
  std::uint8_t step_ = 0;
  std::vector<std::uint32_t> stream_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_RECORDER_H_
