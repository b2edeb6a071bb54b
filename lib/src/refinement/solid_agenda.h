#ifndef CIRCUMBALL_REFINEMENT_SOLID_AGENDA_H_
#define CIRCUMBALL_REFINEMENT_SOLID_AGENDA_H_

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "complex/solid_domain.h"
#include "refinement/queue.h"
#include "refinement/split_at3.h"

namespace circumball {

/// Whether rules look at patches of intestines: they say so by a member kPatches.
template <class Rules, class = void>
struct HasPatches : std::false_type {};
template <class Rules>
struct HasPatches<Rules, std::void_t<decltype(Rules::kPatches)>> : std::true_type {};

/// What the loop needs to know of space where rules look at subsegments, triangles of faces and
/// tetrahedra (chapter 6): simplices wait by dimension, lower first; of one dimension who was
/// queued first goes first. Of `Rules` it asks, beside the four:
/// - kTetrahedra: whether tetrahedra are looked at
/// - encroached_by(SolidView, simplex, VertexId v) -> Verdict: as `unacceptable`, of subsegments
/// and
///   triangles, where only v is new
/// - kPatches, if there are intestines: patches wait behind dimension 1, before triangles of faces
template <class Rules>
class SolidAgenda {
 public:
  static constexpr bool kNeedsBegin = false;
  static constexpr bool kYields = true;
  void begin(Live3&) {}
  bool empty() const { return size() == 0; }
  std::size_t size() const {
    return segments_.size() + patches_.size() + triangles_.size() + cells_.size();
  }

  /// Calls f for all that the rules look at: subsegments, triangles of faces, tetrahedra; by birth.
  template <class F>
  void for_each_simplex(const Live3& live, const Rules&, F f) const {
    for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
      if (live.subsegment(SubsegmentId(i)).alive) f(SubsegmentId(i));
    }
    if constexpr (HasPatches<Rules>::value) {
      for (std::uint32_t i = 0; live.has_intestine() && i < live.intestine().patch_count(); ++i) {
        if (live.intestine().patch(PatchId(i)).alive) f(PatchId(i));
      }
    }
    const auto by_birth = [](const auto& a, const auto& b) { return a.birth < b.birth; };
    std::vector<FaceTriangle> triangles;
    for (std::uint32_t face = 0; face < live.face_count(); ++face) {
      triangles.clear();
      const Delaunay2& dt = live.face(face).triangulation();
      dt.for_each_triangle([&](TriangleId t) {
        triangles.push_back({face, t, dt.triangle(t).birth});
      });
      std::sort(triangles.begin(), triangles.end(), by_birth);
      for (const FaceTriangle& t : triangles) f(t);
    }
    if constexpr (Rules::kTetrahedra) {
      const Delaunay3& dt = live.triangulation();
      std::vector<CellRef> cells;
      dt.for_each_cell([&](CellSlot c) {
        if (live.is_in_domain(c)) cells.push_back({c, dt.cell(c).birth});
      });
      std::sort(cells.begin(), cells.end(), by_birth);
      for (const CellRef& c : cells) f(c);
    }
  }

  /// Returns whether it was not waiting yet.
  bool push(const SolidView&, const Rules&, SubsegmentId s, const Verdict&) {
    if (segment_waits_.size() <= s.value) segment_waits_.resize(s.value + 1, false);
    if (segment_waits_[s.value]) return false;
    segment_waits_[s.value] = true;
    segments_.push({s, {}});
    return true;
  }
  bool push(const SolidView&, const Rules&, const FaceTriangle& t, const Verdict&) {
    if (triangle_waits_.size() <= t.face) triangle_waits_.resize(t.face + 1);
    auto& waits = triangle_waits_[t.face];
    if (waits.size() <= t.id) waits.resize(t.id + std::size_t{t.id} / 2 + 1, kNone);
    if (waits[t.id] == t.birth) return false;
    waits[t.id] = t.birth;
    triangles_.push({t, {}});
    return true;
  }
  bool push(const SolidView&, const Rules&, const CellRef& c, const Verdict&) {
    cells_.push(c);
    return true;
  }
  bool push(const SolidView&, const Rules&, PatchId p, const Verdict&) {
    if (patch_waits_.size() <= p.value) patch_waits_.resize(p.value + p.value / 2 + 1, false);
    if (patch_waits_[p.value]) return false;
    patch_waits_[p.value] = true;
    patches_.push({p, {}});
    return true;
  }
  /// Why a simplex is unacceptable still that was when it was queued: nothing is remembered.
  template <class Simplex>
  Verdict remembered(const SolidView&, const Rules&, const Simplex&) const {
    return {};
  }
  void push_yielded(SubsegmentId s, const FaceTriangle& t) { segments_.push({s, {t, {}, {}}}); }
  void push_yielded(SubsegmentId s, const CellRef& c) { segments_.push({s, {{}, c, {}}}); }
  void push_yielded(SubsegmentId s, PatchId p) { segments_.push({s, {{}, {}, p}}); }
  void push_yielded(const FaceTriangle& t, const CellRef& c) { triangles_.push({t, {{}, c, {}}}); }
  void push_yielded(PatchId p, const CellRef& c) { patches_.push({p, {{}, c, {}}}); }
  // Triangles and patches yield to dimension 1 only.
  template <class Simplex>
  void push_yielded(const FaceTriangle&, const Simplex&) {}
  template <class Simplex>
  void push_yielded(PatchId, const Simplex&) {}
  void push_front(PatchId p, double) { patches_.push_front({p, {}}); }
  void push_front(const FaceTriangle& t, double) { triangles_.push_front({t, {}}); }
  void push_front(const CellRef& c, double) { cells_.push_front(c); }

  /// Takes the simplex of highest priority, and calls f with it and with who yielded to it.
  template <class F>
  void take(const Live3&, F f) {
    if (!segments_.empty()) {
      const QueuedSegment item = segments_.pop();
      if (item.subsegment.value < segment_waits_.size()) {
        segment_waits_[item.subsegment.value] = false;
      }
      return f(item.subsegment, item.proposer);
    }
    if constexpr (HasPatches<Rules>::value) {
      if (!patches_.empty()) {
        const QueuedPatch item = patches_.pop();
        if (item.patch.value < patch_waits_.size()) patch_waits_[item.patch.value] = false;
        return f(item.patch, item.proposer);
      }
    }
    if (!triangles_.empty()) {
      const QueuedTriangle item = triangles_.pop();
      const FaceTriangle& t = item.triangle;
      if (t.face < triangle_waits_.size() && t.id < triangle_waits_[t.face].size() &&
          triangle_waits_[t.face][t.id] == t.birth) {
        triangle_waits_[t.face][t.id] = kNone;
      }
      return f(t, item.proposer);
    }
    f(cells_.pop(), Proposer3());
  }

  /// What is refused stays refused.
  void refused(Live3& live, SubsegmentId s, Reason) { live.freeze(s); }
  void refused(Live3& live, const FaceTriangle& t, Reason) { live.freeze(t); }
  void refused(Live3&, const CellRef&, Reason) {}
  void refused(Live3& live, PatchId p, Reason) { live.intestine().freeze(p); }

  /// Inserts the point of p, just looked at, to split s; calls queue(simplex, verdict) for what
  /// became unacceptable.
  template <class Simplex, class F>
  void insert(Workspace3& w, const SolidView& view, const Rules& rules, const Simplex& s,
              const Proposal3& p, F queue) {
    SubsegmentId splitting;
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) splitting = s;
    if constexpr (std::is_same_v<Simplex, PatchId>) splitting = generator_of(w.live, s);
    const VertexId v = insert_vertex(w, view, w.recorder.insertion_of(s, p.reason), p.at,
                                     feature_of(w.live, s, p), splitting);
    ++insertions_;
    const auto ask = [&](const auto& simplex, const Verdict& why) {
      if (why) queue(simplex, why);
    };
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) {
      const std::array<SubsegmentId, 2> halves = w.live.split(s, v);
      w.recorder.protection_split(s, halves);
      for (const SubsegmentId half : halves) ask(half, rules.unacceptable(view, half));
    }
    ask_about(w.live, view, rules, v, ask);
    if constexpr (HasPatches<Rules>::value) {
      grow_intestine(w, view, rules, s, v, ask);
    }
  }

  /// When nothing waits any more, everything is asked once more: of the domain, cells that rounding
  /// gave to the wrong side of a face. Calls queue(simplex, verdict) for all that is unacceptable
  /// and was not refused for good.
  template <class F>
  void look_again(Workspace3& w, SolidView& view, const Rules& rules, F queue) {
    Live3& live = w.live;
    if (insertions_ == looked_at_) return;
    looked_at_ = insertions_;
    if (live.classified()) w.recorder.relabeled(classify_if_conforming(&live));
    for_each_simplex(live, rules, [&](const auto& s) {
      if (!is_frozen(live, s)) {
        if (const Verdict why = rules.unacceptable(view, s)) queue(s, why);
      }
    });
  }

 private:
  struct QueuedPatch {
    PatchId patch;
    Proposer3 proposer;
  };
  struct QueuedSegment {
    SubsegmentId subsegment;
    Proposer3 proposer;
  };
  struct QueuedTriangle {
    FaceTriangle triangle;
    Proposer3 proposer;
  };

  /// What the insertion of v concerns.
  template <class Ask>
  void ask_about(const Live3& live, const SolidView& view, const Rules& rules, VertexId v,
                 Ask ask) {
    ask_in_faces(live, view, rules, v, ask);
    ask_dead(live, view, rules, v, ask);
    if constexpr (Rules::kTetrahedra) {
      const Delaunay3& dt = live.triangulation();
      for (const CellSlot c : dt.born()) {
        if (!live.is_in_domain(c)) continue;
        const CellRef born{c, dt.cell(c).birth};
        ask(born, rules.unacceptable(view, born));
      }
    }
  }

  /// The vertex v of the intestine was inserted to split s: the intestine learns of it.
  template <class Simplex, class Ask>
  void grow_intestine(Workspace3& w, const SolidView& view, const Rules& rules, const Simplex& s,
                      VertexId v, Ask ask) {
    Live3& live = w.live;
    Intestines& intestine = live.intestine();
    const Delaunay3& dt = live.triangulation();
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) {
      const Subsegment u = live.subsegment(s);
      if (u.is_ring_arc()) {
        intestine.split_arc(dt, u.ring, intestine.middle_key(u.ring, u.a, u.b), v);
      } else if (u.is_arc()) {
        intestine.split_sphere(dt, u.center.value, v);
      } else if (!intestine.structured() && (u.is_collar_element() || u.is_generator)) {
        intestine.split_generator(u.a, u.b, v);
      } else if (u.is_collar_element()) {
        RingKey key = 0;
        const std::uint32_t before = intestine.ring_before(u.a, u.b, &key);
        if (before != kNoIndex) put_ring(w, view, rules, before, key, v, ask);
      }
    } else if constexpr (std::is_same_v<Simplex, PatchId>) {
      const Patch patch = intestine.patch(s);
      if (patch.is_of_sphere()) {
        intestine.split_sphere(dt, patch.sphere, v);
      } else if (!intestine.structured()) {
        intestine.split_patch(s, v);
      } else {
        const Ring& before = intestine.ring(patch.ring);
        split_generator(w, view, rules, patch.ring, before.vertices[0].key, v, ask);
        put_ring(w, view, rules, patch.ring, before.vertices[0].key, v, ask);
      }
    }
    const std::vector<PatchId> born = intestine.take_born();
    w.recorder.patches_changed(intestine.take_died(), born);
    for (const PatchId p : born) ask(p, rules.unacceptable(view, p));
  }

  /// The collar segment that a ring splits first, if the patch is of a tube, and it is in a face.
  static SubsegmentId generator_of(const Live3& live, PatchId id) {
    const Intestines& intestine = live.intestine();
    const Patch& patch = intestine.patch(id);
    if (patch.is_of_sphere() || !intestine.structured()) return SubsegmentId();
    const Ring& ring = intestine.ring(patch.ring);
    const VertexId beyond = intestine.ring(ring.next).at(ring.vertices[0].key);
    return beyond.valid() ? live.subsegment_between(ring.vertices[0].vertex, beyond)
                          : SubsegmentId();
  }

  /// The collar segment along a key, behind a ring, if it is in a face, was split by v.
  template <class Ask>
  void split_generator(Workspace3& w, const SolidView& view, const Rules& rules,
                       std::uint32_t before, RingKey key, VertexId v, Ask ask) {
    const Intestines& intestine = w.live.intestine();
    const Ring& ring = intestine.ring(before);
    const SubsegmentId s =
        w.live.subsegment_between(ring.at(key), intestine.ring(ring.next).at(key));
    if (!s.valid()) return;
    const std::array<SubsegmentId, 2> halves = w.live.split(s, v);
    w.recorder.protection_split(s, halves);
    for (const SubsegmentId half : halves) ask(half, rules.unacceptable(view, half));
  }

  /// A ring in the middle behind another one. Its vertex `first`, along `key`, is there already.
  template <class Ask>
  void put_ring(Workspace3& w, const SolidView& view, const Rules& rules, std::uint32_t before,
                RingKey key, VertexId first, Ask ask) {
    Live3& live = w.live;
    Intestines& intestine = live.intestine();
    Ring ring = intestine.ring_between(before);
    for (RingVertex& r : ring.vertices) {
      if (r.key == key) {
        r.vertex = first;
        continue;
      }
      const Point3 p = intestine.place(ring, r.key);
      const BaseDirection& base = intestine.tube_of(ring).bases[r.key / kRingGap];
      const bool in_face = r.key % kRingGap == 0 && base.face != kNoIndex;
      const Feature feature =
          in_face ? Feature{FeatureKind::kFace, base.face} : Feature{FeatureKind::kFree, kNoIndex};
      const VertexId beside = intestine.ring(before).at(r.key);
      Delaunay3& dt = live.triangulation();
      if (dt.probe(p, dt.cell_of(first)) != Delaunay3::Probe::kOk ||
          (in_face && (!beside.valid() || !live.probe_faces(p, feature, beside)))) {
        ++w.refused;
        w.refusal_limit = Reason::kLimitPrecision;
        continue;
      }
      SubsegmentId splitting;
      if (in_face) {
        const Ring& from = intestine.ring(before);
        splitting = live.subsegment_between(beside, intestine.ring(from.next).at(r.key));
      }
      r.vertex = insert_vertex(
          w, view, w.recorder.insertion_on(Reason::kRing, ring.about, VertexId(), feature), p,
          feature, splitting);
      if (in_face) split_generator(w, view, rules, before, r.key, r.vertex, ask);
      ask_about(live, view, rules, r.vertex, ask);
    }
    ring.vertices.erase(std::remove_if(ring.vertices.begin(), ring.vertices.end(),
                                       [](const RingVertex& r) { return !r.vertex.valid(); }),
                        ring.vertices.end());
    const std::uint32_t number = intestine.insert_ring(live.triangulation(), before, ring);
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
      const VertexId a = ring.vertices[i].vertex,
                     b = ring.vertices[(i + 1) % ring.vertices.size()].vertex;
      const SubsegmentId arc = live.create_ring_arc(a, b, number);
      w.recorder.protection_began(arc);
      ask(arc, rules.unacceptable(view, arc));
    }
  }

  /// In the triangulations of the faces that v is in: the triangles born, and subsegments that lost
  /// their edges.
  template <class Ask>
  void ask_in_faces(const Live3& live, const SolidView& view, const Rules& rules, VertexId v,
                    Ask ask) {
    for (const std::uint32_t f : live.faces_of(live.feature(v))) {
      const FaceRefinement& face = live.face(f);
      const Delaunay2& dt = face.triangulation();
      for (const Delaunay2::Triangle& t : dt.died()) {
        if (Delaunay2::is_ghost(t)) continue;
        for (unsigned i = 0; i < 3; ++i) {
          const SubsegmentId s =
              live.subsegment_between(face.global(t.v[i]), face.global(t.v[(i + 1) % 3]));
          if (s.valid()) ask(s, rules.encroached_by(view, s, v));
        }
      }
      for (const TriangleId t : dt.born()) {
        if (dt.is_ghost(t)) continue;
        const FaceTriangle born{f, t, dt.triangle(t).birth};
        ask(born, rules.unacceptable(view, born));
      }
    }
  }

  /// What v encroaches upon was an edge or a facet of a cell that died, or is in the place of one.
  template <class Ask>
  void ask_dead(const Live3& live, const SolidView& view, const Rules& rules, VertexId v, Ask ask) {
    died_segments_.clear();
    died_triangles_.clear();
    view.begin_face_triangles();
    died_patches_.clear();
    for (const Delaunay3::Cell& cell : live.triangulation().died()) {
      view.for_each_subsegment(cell.v, [&](SubsegmentId s) { died_segments_.push_back(s); });
      view.for_each_face_triangle(cell.v,
                                  [&](const FaceTriangle& t) { died_triangles_.push_back(t); });
      if constexpr (HasPatches<Rules>::value) {
        view.for_each_patch(cell.v, [&](PatchId p) { died_patches_.push_back(p); });
      }
    }
    std::sort(died_segments_.begin(), died_segments_.end());
    died_segments_.erase(std::unique(died_segments_.begin(), died_segments_.end()),
                         died_segments_.end());
    for (const SubsegmentId s : died_segments_) ask(s, rules.encroached_by(view, s, v));
    const auto key = [](const FaceTriangle& t) { return std::uint64_t{t.face} << 32 | t.birth; };
    std::sort(died_triangles_.begin(), died_triangles_.end(),
              [&](const FaceTriangle& a, const FaceTriangle& b) { return key(a) < key(b); });
    died_triangles_.erase(
        std::unique(died_triangles_.begin(), died_triangles_.end(),
                    [&](const FaceTriangle& a, const FaceTriangle& b) { return key(a) == key(b); }),
        died_triangles_.end());
    for (const FaceTriangle& t : died_triangles_) ask(t, rules.encroached_by(view, t, v));
    if constexpr (HasPatches<Rules>::value) {
      std::sort(died_patches_.begin(), died_patches_.end());
      died_patches_.erase(std::unique(died_patches_.begin(), died_patches_.end()),
                          died_patches_.end());
      for (const PatchId p : died_patches_) ask(p, rules.encroached_by(view, p, v));
    }
  }

  static bool is_frozen(const Live3& live, SubsegmentId s) { return live.subsegment(s).frozen; }
  static bool is_frozen(const Live3& live, const FaceTriangle& t) { return live.is_frozen(t); }
  static bool is_frozen(const Live3&, const CellRef&) { return false; }
  static bool is_frozen(const Live3& live, PatchId p) { return live.intestine().patch(p).frozen; }
  static Feature feature_of(const Live3& live, SubsegmentId s, const Proposal3&) {
    const Subsegment& u = live.subsegment(s);
    if (u.is_collar_element()) return {FeatureKind::kFace, u.face};
    if (u.is_of_tube()) return {FeatureKind::kFree, kNoIndex};
    return {FeatureKind::kSegment, u.segment.value};
  }
  static Feature feature_of(const Live3&, const FaceTriangle& t, const Proposal3&) {
    return {FeatureKind::kFace, t.face};
  }
  static Feature feature_of(const Live3&, const CellRef&, const Proposal3& p) { return p.feature; }
  /// Rings begin in the first base direction.
  static Feature feature_of(const Live3& live, PatchId id, const Proposal3&) {
    const Patch& patch = live.intestine().patch(id);
    if (patch.is_of_sphere() || !live.intestine().structured()) {
      return {FeatureKind::kFree, kNoIndex};
    }
    const Ring& ring = live.intestine().ring(patch.ring);
    const RingKey key = ring.vertices[0].key;
    const std::uint32_t face = live.intestine().tube_of(ring).bases[key / kRingGap].face;
    if (face == kNoIndex || key % kRingGap != 0) return {FeatureKind::kFree, kNoIndex};
    return {FeatureKind::kFace, face};
  }

  FifoQueue<QueuedSegment> segments_;
  FifoQueue<QueuedPatch> patches_;
  FifoQueue<QueuedTriangle> triangles_;
  FifoQueue<CellRef> cells_;
  std::vector<bool> segment_waits_, patch_waits_;
  // By face and slot: the birth that waits.
  std::vector<std::vector<std::uint32_t>> triangle_waits_;
  std::uint64_t insertions_ = 0, looked_at_ = 0;
  std::vector<SubsegmentId> died_segments_;   // scratch
  std::vector<FaceTriangle> died_triangles_;  // scratch
  std::vector<PatchId> died_patches_;         // scratch
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SOLID_AGENDA_H_
