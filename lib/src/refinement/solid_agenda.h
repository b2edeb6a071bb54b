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

/// What the loop needs to know of space where rules look at subsegments, triangles of faces and
/// tetrahedra (chapter 6): simplices wait by dimension, lower first; of one dimension who was
/// queued first goes first. Of `Rules` it asks, beside the four:
/// - kTetrahedra: whether tetrahedra are looked at
/// - encroached_by(SolidView, simplex, VertexId v) -> Verdict: as `unacceptable`, of subsegments
/// and
///   triangles, where only v is new
template <class Rules>
class SolidAgenda {
 public:
  static constexpr bool kNeedsBegin = false;
  static constexpr bool kYields = true;
  void begin(Live3&) {}
  bool empty() const { return segments_.empty() && triangles_.empty() && cells_.empty(); }
  std::size_t size() const { return segments_.size() + triangles_.size() + cells_.size(); }

  /// Calls f for all that the rules look at: subsegments, triangles of faces, tetrahedra; by birth.
  template <class F>
  void for_each_simplex(const Live3& live, const Rules&, F f) const {
    for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
      if (live.subsegment(SubsegmentId(i)).alive) f(SubsegmentId(i));
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
  /// Why a simplex is unacceptable still that was when it was queued: nothing is remembered.
  template <class Simplex>
  Verdict remembered(const SolidView&, const Rules&, const Simplex&) const {
    return {};
  }
  void push_yielded(SubsegmentId s, const FaceTriangle& t) { segments_.push({s, {t, {}}}); }
  void push_yielded(SubsegmentId s, const CellRef& c) { segments_.push({s, {{}, c}}); }
  void push_yielded(const FaceTriangle& t, const CellRef& c) { triangles_.push({t, {{}, c}}); }
  void push_yielded(const FaceTriangle&, const FaceTriangle&) {}  // triangles yield to segments
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

  /// Inserts the point of p, just looked at, to split s; calls queue(simplex, verdict) for what
  /// became unacceptable.
  template <class Simplex, class F>
  void insert(Workspace3& w, const SolidView& view, const Rules& rules, const Simplex& s,
              const Proposal3& p, F queue) {
    SubsegmentId splitting;
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) splitting = s;
    const VertexId v = insert_vertex(w, view, w.recorder.insertion_of(s, p.reason), p.at,
                                     feature_of(w.live, s), splitting);
    ++insertions_;
    const auto ask = [&](const auto& simplex, const Verdict& why) {
      if (why) queue(simplex, why);
    };
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) {
      const std::array<SubsegmentId, 2> halves = w.live.split(s, v);
      w.recorder.protection_split(s, halves);
      for (const SubsegmentId half : halves) ask(half, rules.unacceptable(view, half));
    }
    ask_in_faces(w.live, view, rules, v, ask);
    ask_dead(w.live, view, rules, v, ask);
    if constexpr (Rules::kTetrahedra) {
      const Delaunay3& dt = w.live.triangulation();
      for (const CellSlot c : dt.born()) {
        if (!w.live.is_in_domain(c)) continue;
        const CellRef born{c, dt.cell(c).birth};
        ask(born, rules.unacceptable(view, born));
      }
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
    if (live.classified()) w.recorder.relabeled(classify(&live));
    for_each_simplex(live, rules, [&](const auto& s) {
      if (!is_frozen(live, s)) {
        if (const Verdict why = rules.unacceptable(view, s)) queue(s, why);
      }
    });
  }

 private:
  struct QueuedSegment {
    SubsegmentId subsegment;
    Proposer3 proposer;
  };
  struct QueuedTriangle {
    FaceTriangle triangle;
    Proposer3 proposer;
  };

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
    for (const Delaunay3::Cell& cell : live.triangulation().died()) {
      view.for_each_subsegment(cell.v, [&](SubsegmentId s) { died_segments_.push_back(s); });
      view.for_each_face_triangle(cell.v,
                                  [&](const FaceTriangle& t) { died_triangles_.push_back(t); });
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
  }

  static bool is_frozen(const Live3& live, SubsegmentId s) { return live.subsegment(s).frozen; }
  static bool is_frozen(const Live3& live, const FaceTriangle& t) { return live.is_frozen(t); }
  static bool is_frozen(const Live3&, const CellRef&) { return false; }
  static Feature feature_of(const Live3& live, SubsegmentId s) {
    const Subsegment& u = live.subsegment(s);
    if (u.is_collar_element()) return {FeatureKind::kFace, u.face};
    return {FeatureKind::kSegment, u.segment.value};
  }
  static Feature feature_of(const Live3&, const FaceTriangle& t) {
    return {FeatureKind::kFace, t.face};
  }
  static Feature feature_of(const Live3&, const CellRef&) { return {FeatureKind::kFree, kNoIndex}; }

  FifoQueue<QueuedSegment> segments_;
  FifoQueue<QueuedTriangle> triangles_;
  FifoQueue<CellRef> cells_;
  std::vector<bool> segment_waits_;
  // By face and slot: the birth that waits.
  std::vector<std::vector<std::uint32_t>> triangle_waits_;
  std::uint64_t insertions_ = 0, looked_at_ = 0;
  std::vector<SubsegmentId> died_segments_;   // scratch
  std::vector<FaceTriangle> died_triangles_;  // scratch
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SOLID_AGENDA_H_
