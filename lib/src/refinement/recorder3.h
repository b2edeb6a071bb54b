#ifndef CIRCUMBALL_REFINEMENT_RECORDER3_H_
#define CIRCUMBALL_REFINEMENT_RECORDER3_H_

#include "complex/live3.h"
#include "refinement/recorder_base.h"
#include "refinement/view3.h"

namespace circumball {

/// Events in space.
class Recorder3 : public RecorderBase<Recorder3, Point3> {
 public:
  Recorder3(const Live3& live, TraceSink* sink) : RecorderBase(sink), live_(live) {}

  /// After the insertion of v into the tetrahedralization, and into the faces that it belongs to.
  void inserted(Event insertion, VertexId v, double insertion_radius);
  /// The triangles of a face as they are when its refinement begins.
  void face_created(std::uint32_t face);

 private:
  friend RecorderBase;
  Event of(EventKind kind, const FaceTriangle& t) const;
  Event of(EventKind kind, SubsegmentId s) const;
  bool append(const Delaunay3::Cell& cell);
  bool append(std::uint32_t face, const Delaunay2::Triangle& t);
  void face_changed(std::uint32_t face);

  const Live3& live_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_RECORDER3_H_
