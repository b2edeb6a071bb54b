#ifndef CIRCUMBALL_REFINEMENT_RECORDER_BASE_H_
#define CIRCUMBALL_REFINEMENT_RECORDER_BASE_H_

#include <vector>

#include "circumball/trace.h"
#include "refinement/verdict.h"

namespace circumball {

/// Labels in the trace (trace.h); regions are inside, too.
enum TracedLabel : std::uint32_t { kTracedUnknown = 0, kTracedInside = 1, kTracedOutside = 2 };

/// Puts what happens into events, if somebody listens. With a null sink each call is one
/// predictable branch. What is the same in the plane and in space; `Derived` states
/// of(EventKind, simplex) for its kinds of simplices.
template <class Derived, class Point>
class RecorderBase {
 public:
  explicit RecorderBase(TraceSink* sink) : sink_(sink) {}
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
  void queued(const Simplex& s, const Verdict& why) {
    if (!sink_) return;
    Event e = of(EventKind::kQueued, s);
    e.reason = why.reason;
    e.subject = why.witness.value;
    e.value = why.value;
    send(e);
  }
  template <class Simplex>
  void dropped(const Simplex& s, Reason why) {
    if (!sink_) return;
    Event e = of(EventKind::kDropped, s);
    e.reason = why;
    send(e);
  }
  template <class Simplex>
  void refused(const Simplex& s, Reason why, const Point& at) {
    if (!sink_) return;
    Event e = of(EventKind::kRefused, s);
    e.reason = why;
    place(at, &e);
    send(e);
  }
  /// The event of an insertion that splits s, or nothing: `inserted` completes it.
  template <class Simplex>
  Event insertion_of(const Simplex& s, Reason why) const {
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
  void limit(Reason why) {
    if (!sink_) return;
    Event e = blank(EventKind::kLimit);
    e.reason = why;
    send(e);
  }

 protected:
  Event blank(EventKind kind) const {
    Event e;
    e.kind = kind;
    e.step = step_;
    return e;
  }
  static void place(const Point2& at, Event* e) {
    e->at[0] = at.x;
    e->at[1] = at.y;
  }
  static void place(const Point3& at, Event* e) {
    e->at[0] = at.x;
    e->at[1] = at.y;
    e->at[2] = at.z;
  }
  void send(const Event& e) { sink_->event(e, stream_.data(), 0); }
  void send_with_stream(const Event& e) { sink_->event(e, stream_.data(), stream_.size()); }

  TraceSink* sink_;
  std::vector<std::uint32_t> stream_;  // simplices of the event that is put together

 private:
  template <class Simplex>
  Event of(EventKind kind, const Simplex& s) const {
    return static_cast<const Derived*>(this)->of(kind, s);
  }

  std::uint8_t step_ = 0;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_RECORDER_BASE_H_
