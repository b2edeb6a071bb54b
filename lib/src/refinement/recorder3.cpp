#include "refinement/recorder3.h"

namespace circumball {

Event Recorder3::of(EventKind kind, const FaceTriangle& t) const {
  Event e = blank(kind);
  e.dimension = 2;
  const FaceRefinement& face = live_.face(t.face);
  const auto& v = face.triangulation().triangle(t.id).v;
  for (int i = 0; i < 3; ++i) e.simplex[i] = face.global(v[i]).value;
  e.simplex[3] = t.face;
  return e;
}

Event Recorder3::of(EventKind kind, PatchId p) const {
  Event e = blank(kind);
  e.dimension = 2;
  for (int i = 0; i < 3; ++i) e.simplex[i] = live_.intestine().patch(p).v[i].value;
  return e;
}

Event Recorder3::of(EventKind kind, const CellRef& c) const {
  Event e = blank(kind);
  e.dimension = 3;
  for (std::uint32_t i = 0; i < 4; ++i) {
    e.simplex[i] = live_.triangulation().corner(c.slot, i).value;
  }
  return e;
}

Event Recorder3::of(EventKind kind, SubsegmentId s) const {
  Event e = blank(kind);
  e.dimension = 1;
  const Subsegment& u = live_.subsegment(s);
  e.simplex[0] = u.a.value;
  e.simplex[1] = u.b.value;
  e.simplex[2] = u.center.value;
  e.simplex[3] = u.segment.value;
  if (u.is_ring_arc()) {
    const Ring& ring = live_.intestine().ring(u.ring);
    e.simplex[2] = ring.about.value;
    e.simplex[3] = live_.intestine().tube_of(ring).segment;
  }
  return e;
}

/// Regions are inside, too; and everything is, before the domain is known.
std::uint32_t Recorder3::traced(std::uint32_t label) const {
  return label == kOutside ? kTracedOutside : kTracedInside;
}

void Recorder3::send_yielded(Event e, const Point3& at, std::uint32_t subject, VertexId a,
                             VertexId b, VertexId c) {
  e.reason = Reason::kYieldedTo;
  e.subject = subject;
  e.other[0] = a.value;
  e.other[1] = b.value;
  if (c.valid()) e.value = c.value + 1.0;
  place(at, &e);
  send(e);
}

void Recorder3::relabeled(const std::vector<RelabeledCell>& cells) {
  if (!sink_) return;
  const Delaunay3& dt = live_.triangulation();
  const auto differs = [&](const RelabeledCell& r) {
    return traced(r.before) != traced(dt.label(r.cell));
  };
  Event e = blank(EventKind::kRelabeled);
  stream_.clear();
  e.other[0] = 0;
  for (const bool after : {false, true}) {
    for (const RelabeledCell& r : cells) {
      if (!differs(r)) continue;
      Delaunay3::Cell cell = dt.cell(r.cell);
      if (!after) cell.label = r.before;
      e.other[0] += append(cell) && !after;
    }
  }
  e.other[1] = e.other[0];
  if (e.other[0] > 0) send_with_stream(e);
}

void Recorder3::replaced(const MatchingRegion& region) {
  if (!sink_) return;
  const Delaunay3& dt = live_.triangulation();
  Event e = blank(EventKind::kRelabeled);
  e.reason = Reason::kMatching;
  stream_.clear();
  e.other[0] = e.other[1] = 0;
  dt.for_each_cell([&](CellSlot c) {
    if (region.replaced[c]) e.other[0] += append(dt.cell(c));
  });
  for (const MatchingRegion::Cell& cell : region.cells) {
    for (const VertexId v : cell.v) stream_.push_back(v.value);
    stream_.push_back(traced(cell.label));
    ++e.other[1];
  }
  if (e.other[0] > 0) send_with_stream(e);
}

bool Recorder3::append(const Delaunay3::Cell& cell) {
  for (const VertexId v : cell.v) {
    if (v == Delaunay3::kGhost) return false;
  }
  for (const VertexId v : cell.v) stream_.push_back(v.value);
  stream_.push_back(traced(cell.label));
  return true;
}

bool Recorder3::append(std::uint32_t face, const Delaunay2::Triangle& t) {
  if (Delaunay2::is_ghost(t)) return false;
  const FaceRefinement& refinement = live_.face(face);
  for (const VertexId v : t.v) stream_.push_back(refinement.global(v).value);
  stream_.push_back(kNoIndex);
  stream_.push_back(face * 4 + (live_.is_inside(face, t) ? kTracedInside : kTracedOutside));
  return true;
}

void Recorder3::inserted(Event e, VertexId v, double insertion_radius) {
  if (!sink_) return;
  const Delaunay3& dt = live_.triangulation();
  e.subject = v.value;
  place(dt.point(v), &e);
  e.value = insertion_radius;
  stream_.clear();
  e.other[0] = e.other[1] = 0;
  for (const Delaunay3::Cell& cell : dt.died()) e.other[0] += append(cell);
  for (const CellSlot cell : dt.born()) e.other[1] += append(dt.cell(cell));
  send_with_stream(e);
  if (live_.face_count() == 0) return;  // step 0: the faces come at its end
  for (const std::uint32_t face : live_.faces_of(live_.feature(v))) face_changed(face);
}

void Recorder3::face_changed(std::uint32_t face) {
  const Delaunay2& dt = live_.face(face).triangulation();
  Event e = blank(EventKind::kFaceChanged);
  e.subject = face;
  stream_.clear();
  e.other[0] = e.other[1] = 0;
  for (const Delaunay2::Triangle& t : dt.died()) e.other[0] += append(face, t);
  for (const TriangleId t : dt.born()) e.other[1] += append(face, dt.triangle(t));
  send_with_stream(e);
}

void Recorder3::face_created(std::uint32_t face) {
  if (!sink_) return;
  Event e = blank(EventKind::kFaceChanged);
  e.subject = face;
  stream_.clear();
  e.other[0] = e.other[1] = 0;
  const Delaunay2& dt = live_.face(face).triangulation();
  dt.for_each_triangle([&](TriangleId t) { e.other[1] += append(face, dt.triangle(t)); });
  send_with_stream(e);
}

ProtectingElement Recorder3::element(SubsegmentId s) const {
  const Subsegment& u = live_.subsegment(s);
  if (u.is_ring_arc()) {
    const Ring& ring = live_.intestine().ring(u.ring);
    return {ProtectingKind::kRingArc, u.a.value, u.b.value, ring.about.value,
            live_.intestine().tube_of(ring).segment};
  }
  const ProtectingKind kind = !u.is_collar_element() ? ProtectingKind::kProtectedSubsegment
                              : u.is_arc()           ? ProtectingKind::kCollarArc
                                                     : ProtectingKind::kCollarSegment;
  return {kind, u.a.value, u.b.value, u.center.value,
          u.is_collar_element() ? u.face : u.segment.value};
}

void Recorder3::protection_changed(const std::vector<ProtectingElement>& died,
                                   const std::vector<ProtectingElement>& born) {
  if (!sink_ || (died.empty() && born.empty())) return;
  Event e = blank(EventKind::kProtection);
  stream_.clear();
  e.other[0] = static_cast<std::uint32_t>(died.size());
  e.other[1] = static_cast<std::uint32_t>(born.size());
  for (const auto* list : {&died, &born}) {
    for (const ProtectingElement& p : *list) {
      stream_.insert(stream_.end(), {p.a, p.b, p.c, p.carrier, std::uint32_t(p.kind)});
    }
  }
  send_with_stream(e);
}

void Recorder3::subsegments_protected() {
  if (!sink_) return;
  std::vector<ProtectingElement> born;
  for (std::uint32_t i = 0; i < live_.subsegment_count(); ++i) {
    const Subsegment& u = live_.subsegment(SubsegmentId(i));
    if (u.alive && u.is_collar && !u.is_collar_element()) born.push_back(element(SubsegmentId(i)));
  }
  protection_changed({}, born);
}

void Recorder3::protection_began(SubsegmentId s) {
  if (sink_) protection_changed({}, {element(s)});
}

void Recorder3::patches_changed(const std::vector<PatchId>& died,
                                const std::vector<PatchId>& born) {
  if (!sink_) return;
  const Intestines& intestine = live_.intestine();
  std::vector<ProtectingElement> elements[2];
  const std::vector<PatchId>* lists[2] = {&died, &born};
  for (int i = 0; i < 2; ++i) {
    for (const PatchId id : *lists[i]) {
      const Patch& p = intestine.patch(id);
      const bool sphere = p.is_of_sphere();
      const std::uint32_t carrier =
          sphere ? p.sphere : intestine.tube_of(intestine.ring(p.ring)).segment;
      const auto kind = sphere ? ProtectingKind::kSpherePatch : ProtectingKind::kTubePatch;
      elements[i].push_back({kind, p.v[0].value, p.v[1].value, p.v[2].value, carrier});
      if (p.is_quad()) {
        elements[i].push_back({kind, p.v[0].value, p.v[2].value, p.v[3].value, carrier});
      }
    }
  }
  protection_changed(elements[0], elements[1]);
}

void Recorder3::protection_split(SubsegmentId s, const std::array<SubsegmentId, 2>& halves) {
  const Subsegment& u = live_.subsegment(s);
  if (!sink_ || !(u.is_collar_element() || u.is_ring_arc())) return;
  protection_changed({element(s)}, {element(halves[0]), element(halves[1])});
}

}  // namespace circumball
