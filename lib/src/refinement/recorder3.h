#ifndef CIRCUMBALL_REFINEMENT_RECORDER3_H_
#define CIRCUMBALL_REFINEMENT_RECORDER3_H_

#include <array>
#include <vector>

#include "complex/matching_region.h"
#include "complex/solid_domain.h"
#include "refinement/recorder_base.h"
#include "refinement/view3.h"

namespace circumball {

/// Events in space.
class Recorder3 : public RecorderBase<Recorder3, Point3> {
 public:
  Recorder3(const Live3& live, TraceSink* sink) : RecorderBase(sink), live_(live) {}

  /// The event of the insertion of a vertex that protects and splits nothing: the vertex of a
  /// segment that it stands across from, or the input vertex that its circle or sphere is about,
  /// and the feature that it lies on.
  Event insertion_on(Reason why, VertexId across, VertexId center, const Feature& feature) const {
    Event e = insertion(why);
    e.simplex[0] = across.value;
    e.simplex[1] = center.value;
    if (feature.kind == FeatureKind::kFace) e.simplex[3] = feature.index;
    return e;
  }
  /// After the insertion of v into the tetrahedralization, and into the faces that it belongs to.
  void inserted(Event insertion, VertexId v, double insertion_radius);
  /// What a circumcenter yields to, one event each.
  template <class Simplex>
  void yielded(const Simplex& proposer, const Point3& at, SubsegmentId to) {
    if (!sink_) return;
    const Subsegment& u = live_.subsegment(to);
    send_yielded(of(EventKind::kYielded, proposer), at, u.segment.value, u.a, u.b, VertexId());
  }
  template <class Simplex>
  void yielded(const Simplex& proposer, const Point3& at, const FaceTriangle& to) {
    if (!sink_) return;
    const FaceRefinement& face = live_.face(to.face);
    const auto& v = face.triangulation().triangle(to.id).v;
    send_yielded(of(EventKind::kYielded, proposer), at, to.face, face.global(v[0]),
                 face.global(v[1]), face.global(v[2]));
  }
  template <class Simplex>
  void yielded(const Simplex& proposer, const Point3& at, PatchId to) {
    if (!sink_) return;
    const Patch& p = live_.intestine().patch(to);
    send_yielded(of(EventKind::kYielded, proposer), at, kNoIndex, p.v[0], p.v[1], p.v[2]);
  }
  /// Cells that got another label while they live.
  void relabeled(const std::vector<RelabeledCell>& cells);
  /// What takes the place of the Delaunay cells in tubes.
  void replaced(const MatchingRegion& region);
  /// The triangles of a face as they are when its refinement begins.
  void face_created(std::uint32_t face);
  /// What protects acute input features: elements that end, and those that begin.
  void protection_changed(const std::vector<ProtectingElement>& died,
                          const std::vector<ProtectingElement>& born);
  /// The subsegments that are never split from now on (Live3::protect).
  void subsegments_protected();
  /// Patches of intestines that died, and that were born; a quadrangle is two triangles.
  void patches_changed(const std::vector<PatchId>& died, const std::vector<PatchId>& born);
  /// A collar element, or an arc of a ring, that was created.
  void protection_began(SubsegmentId s);
  /// s is split into these two: of interest if it is a collar element or an arc of a ring.
  void protection_split(SubsegmentId s, const std::array<SubsegmentId, 2>& halves);

 private:
  friend RecorderBase;
  Event of(EventKind kind, const CellRef& c) const;
  Event of(EventKind kind, const FaceTriangle& t) const;
  Event of(EventKind kind, SubsegmentId s) const;
  Event of(EventKind kind, PatchId p) const;
  std::uint32_t traced(std::uint32_t label) const;
  bool append(const Delaunay3::Cell& cell);
  void send_yielded(Event e, const Point3& at, std::uint32_t subject, VertexId a, VertexId b,
                    VertexId c);
  bool append(std::uint32_t face, const Delaunay2::Triangle& t);
  void face_changed(std::uint32_t face);
  ProtectingElement element(SubsegmentId s) const;

  const Live3& live_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_RECORDER3_H_
