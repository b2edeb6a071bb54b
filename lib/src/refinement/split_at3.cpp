#include "refinement/split_at3.h"

namespace circumball {

VertexId insert_vertex(Workspace3& w, const View3& view, const Event& event, const Point3& p,
                       const Feature& feature, SubsegmentId splitting) {
  const double radius = w.recorder.on() ? view.insertion_radius(p) : 0;
  const VertexId v = w.live.add_vertex(p, feature);
  w.live.triangulation().commit(v);
  w.live.commit_to_faces(v, splitting);
  ++w.inserted;
  w.recorder.inserted(event, v, radius);
  return v;
}

std::optional<std::array<SubsegmentId, 2>> split_at(Workspace3& w, SubsegmentId s, const Point3& p,
                                                    Reason why) {
  View3 view(w.live, w.recorder.on());
  const auto refuse = [&](Reason reason, Reason limit) {
    ++w.refused;
    w.refusal_limit = limit;
    w.recorder.refused(s, reason, p);
    return std::nullopt;
  };
  if (!view.ready(p, s)) return refuse(Reason::kPrecision, Reason::kLimitPrecision);
  if (w.limits.min_edge > 0 && view.insertion_radius(p) < w.limits.min_edge) {
    return refuse(Reason::kMinEdge, Reason::kLimitMinEdge);
  }
  const Feature on{FeatureKind::kSegment, view.subsegment(s).segment.value};
  return w.live.split(s, insert_vertex(w, view, w.recorder.insertion_of(s, why), p, on, s));
}

}  // namespace circumball
