#include "refinement/split_at.h"

#include "refinement/view.h"

namespace circumball {
namespace {

/// Limits::min_edge, for the point just probed.
bool too_close(const Workspace& w, const View& view, const Point2& p) {
  return w.limits.min_edge > 0 && view.insertion_radius(p) < w.limits.min_edge;
}

/// Inserts p into the cavity just probed.
VertexId commit(Workspace& w, const View& view, const Point2& p, Feature feature,
                std::uint32_t splitting, const Event& event) {
  const double radius = w.recorder.on() ? view.insertion_radius(p) : 0;
  const VertexId v = w.live.add_vertex(p, feature);
  w.live.commit(v, splitting);
  ++w.inserted;
  ++w.iterations;
  w.recorder.inserted(event, v, radius);
  return v;
}

}  // namespace

std::optional<std::array<SubsegmentId, 2>> split_at(Workspace& w, SubsegmentId s, const Point2& p,
                                                    Reason why) {
  View view(w.live, w.recorder.on());
  const Point2 at = view.outward(p, s);
  if (view.look_at_midpoint(at, s) == Outlook::kCoincides) {
    ++w.refused;
    w.refusal_limit = Reason::kLimitPrecision;
    w.recorder.refused(s, Reason::kPrecision, at);
    return std::nullopt;
  }
  if (too_close(w, view, at)) {
    ++w.refused;
    w.refusal_limit = Reason::kLimitMinEdge;
    w.recorder.refused(s, Reason::kMinEdge, at);
    return std::nullopt;
  }
  const Feature feature{FeatureKind::kSegment, w.live.subsegment(s).segment.value};
  const VertexId v = commit(w, view, at, feature, s.value, w.recorder.insertion_of(s, why));
  return w.live.split(s, v);
}

VertexId insert_free(Workspace& w, const Point2& p, VertexId near, Reason why) {
  View view(w.live, w.recorder.on());
  Delaunay2& dt = w.live.triangulation();
  if (dt.probe(p, dt.triangle_of(near)) == Delaunay2::Probe::kDuplicate) return VertexId();
  if (too_close(w, view, p)) {
    w.refusal_limit = Reason::kLimitMinEdge;
    return VertexId();
  }
  return commit(w, view, p, {FeatureKind::kFree, kNoIndex}, kNone, w.recorder.insertion(why));
}

}  // namespace circumball
