#ifndef CIRCUMBALL_REFINEMENT_RECORDER_H_
#define CIRCUMBALL_REFINEMENT_RECORDER_H_

#include <vector>

#include "complex/live2.h"
#include "refinement/recorder_base.h"
#include "refinement/view.h"

namespace circumball {

/// Events in the plane.
class Recorder : public RecorderBase<Recorder, Point2> {
 public:
  Recorder(const Live2& live, TraceSink* sink) : RecorderBase(sink), live_(live) {}

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
  /// After the insertion of v: `insertion` is what insertion_of or insertion made of it before.
  void inserted(Event insertion, VertexId v, double insertion_radius);
  /// Triangles that got another label while they live.
  void relabeled(const std::vector<Live2::Relabeled>& triangles);

 private:
  friend RecorderBase;
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
  bool append(const Delaunay2::Triangle& t, std::uint32_t label);

  const Live2& live_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_RECORDER_H_
