#ifndef CIRCUMBALL_REFINEMENT_AGENDA3_H_
#define CIRCUMBALL_REFINEMENT_AGENDA3_H_

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "refinement/split_at3.h"

namespace circumball {

/// Priority in space: a higher rank first, then the larger value, then who was queued first.
struct Priority {
  int rank = 0;
  double value = 0;
};

/// What the loop needs to know of space: which simplices there are, in which order they wait, and
/// which an insertion concerns. Of `Rules` it asks, beside the four:
/// - priority(View3, simplex) -> Priority
/// - kFaceTriangles: whether triangles of faces are looked at
/// - near_vertex(View3, simplex, VertexId q, VertexId p) -> Verdict: as `unacceptable`, where only
///   the Delaunay neighbor p of q is new
/// - kRemembersWitness: whether a segment that was queued for a witness stays unacceptable for it
/// - kSpindle: whether the neighbors of a segment's whole spindle make it unacceptable, not only
///   those of its own ends
template <class Rules>
class Agenda3 {
 public:
  static constexpr bool kNeedsBegin = false;
  static constexpr bool kYields = false;
  void begin(Live3&) {}
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }

  /// Calls f for all that the rules look at, by birth.
  template <class F>
  void for_each_simplex(const Live3& live, const Rules&, F f) const {
    for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
      if (live.subsegment(SubsegmentId(i)).alive) f(SubsegmentId(i));
    }
    if constexpr (Rules::kFaceTriangles) {
      std::vector<FaceTriangle> by_birth;
      for (std::uint32_t face = 0; face < live.face_count(); ++face) {
        by_birth.clear();
        const Delaunay2& dt = live.face(face).triangulation();
        dt.for_each_triangle([&](TriangleId t) {
          const Delaunay2::Triangle& triangle = dt.triangle(t);
          if (!live.is_pocket(face, triangle)) by_birth.push_back({face, t, triangle.birth});
        });
        std::sort(by_birth.begin(), by_birth.end(),
                  [](const FaceTriangle& a, const FaceTriangle& b) { return a.birth < b.birth; });
        for (const FaceTriangle& t : by_birth) f(t);
      }
    }
  }

  /// Returns whether it was not waiting yet.
  template <class Simplex>
  bool push(const View3& view, const Rules& rules, const Simplex& s, const Verdict& why) {
    if (!mark_waiting(s)) return false;
    remember(s, why.witness);
    heap_.push_back({rules.priority(view, s), pushed_++, item_of(s)});
    std::push_heap(heap_.begin(), heap_.end());
    return true;
  }

  /// Why a simplex is unacceptable still that was when it was queued.
  Verdict remembered(const View3& view, const Rules& rules, SubsegmentId s) const {
    if (!Rules::kRemembersWitness || s.value >= witnesses_.size()) return {};
    const VertexId p = witnesses_[s.value];
    if (!p.valid()) return {};
    const Subsegment& u = view.subsegment(s);
    const Verdict why = rules.near_vertex(view, s, u.a, p);
    return why ? why : rules.near_vertex(view, s, u.b, p);
  }
  Verdict remembered(const View3&, const Rules&, const FaceTriangle&) const { return {}; }

  /// Takes the simplex of highest priority. Nothing yields in these rules.
  template <class F>
  void take(const Live3&, F f) {
    std::pop_heap(heap_.begin(), heap_.end());
    const FaceTriangle item = heap_.back().simplex;
    heap_.pop_back();
    if (item.face == kNone) {
      const SubsegmentId s(item.id);
      segment_waits_[s.value] = false;
      return f(s, FaceTriangle());
    }
    if constexpr (Rules::kFaceTriangles) {
      if (triangle_waits_[item.face][item.id] == item.birth) {
        triangle_waits_[item.face][item.id] = kNone;
      }
      f(item, FaceTriangle());
    }
  }

  /// What rounding or the shortest edge allowed refuse stays refused; triangles that are not safe
  /// may become so.
  void refused(Live3& live, SubsegmentId s, Reason) { live.freeze(s); }
  void refused(Live3&, const FaceTriangle& t, Reason why) {
    if (why == Reason::kPrecision || why == Reason::kMinEdge) frozen_.push_back(t);
  }

  /// Inserts the point of p, just looked at, to split s; calls queue(simplex, verdict) for what
  /// became unacceptable.
  template <class Simplex, class F>
  void insert(Workspace3& w, const View3& view, const Rules& rules, const Simplex& s,
              const Proposal3& p, F queue) {
    const VertexId v =
        insert_vertex(w, view, w.recorder.insertion_of(s, p.reason), p.at, feature_of(w.live, s));
    const auto ask = [&](const auto& simplex, const Verdict& why) {
      if (why) queue(simplex, why);
    };
    if constexpr (std::is_same_v<Simplex, SubsegmentId>) {
      for (const SubsegmentId half : w.live.split(s, v)) {
        if (s.value < witnesses_.size()) remember(half, witnesses_[s.value]);
        const Verdict why = rules.unacceptable(view, half);
        ask(half, why ? why : remembered(view, rules, half));
      }
    }
    ask_neighbors(w.live, view, rules, v, ask);
  }

  /// A triangle that was refused may have become safe when a segment was split. Calls
  /// queue(simplex, verdict) for all that is unacceptable and safe when nothing waits any more.
  template <class F>
  void look_again(const Workspace3& w, View3& view, const Rules& rules, F queue) {
    const Live3& live = w.live;
    for_each_simplex(live, rules, [&](const auto& s) {
      if (is_frozen(live, s)) return;
      const Verdict why = rules.unacceptable(view, s);
      if (why && !rules.safe(view, s)) queue(s, why);
    });
  }

 private:
  struct Item {
    Priority priority;
    std::uint64_t order;
    FaceTriangle simplex;  // of a subsegment: face kNone, id its number
    friend bool operator<(const Item& a, const Item& b) {
      if (a.priority.rank != b.priority.rank) return a.priority.rank < b.priority.rank;
      if (a.priority.value != b.priority.value) return a.priority.value < b.priority.value;
      return a.order > b.order;
    }
  };
  static FaceTriangle item_of(SubsegmentId s) { return {kNone, s.value, 0}; }
  static FaceTriangle item_of(const FaceTriangle& t) { return t; }

  bool mark_waiting(SubsegmentId s) {
    if (segment_waits_.size() <= s.value) segment_waits_.resize(s.value + 1, false);
    if (segment_waits_[s.value]) return false;
    return segment_waits_[s.value] = true;
  }
  bool mark_waiting(const FaceTriangle& t) {
    if (triangle_waits_.size() <= t.face) triangle_waits_.resize(t.face + 1);
    auto& waits = triangle_waits_[t.face];
    if (waits.size() <= t.id) waits.resize(t.id + 1, kNone);
    if (waits[t.id] == t.birth) return false;
    waits[t.id] = t.birth;
    return true;
  }
  void remember(SubsegmentId s, VertexId witness) {
    if (!Rules::kRemembersWitness) return;
    if (witnesses_.size() <= s.value) witnesses_.resize(s.value + 1);
    witnesses_[s.value] = witness;
  }
  void remember(const FaceTriangle&, VertexId) {}
  static bool is_frozen(const Live3& live, SubsegmentId s) { return live.subsegment(s).frozen; }
  bool is_frozen(const Live3&, const FaceTriangle& t) const {
    return std::any_of(frozen_.begin(), frozen_.end(), [&](const FaceTriangle& u) {
      return u.face == t.face && u.id == t.id && u.birth == t.birth;
    });
  }

  /// Only v and its new Delaunay neighbors have other neighbors than before: what has one of them
  /// for a vertex, or in its spindle, is asked about the two.
  template <class Ask>
  void ask_neighbors(const Live3& live, const View3& view, const Rules& rules, VertexId v,
                     Ask ask) {
    if constexpr (Rules::kFaceTriangles) {
      for (const std::uint32_t face : live.faces_of(live.feature(v))) {
        const Delaunay2& dt = live.face(face).triangulation();
        for (const TriangleId t : dt.born()) {
          if (dt.is_ghost(t) || live.is_pocket(face, dt.triangle(t))) continue;
          const FaceTriangle born{face, t, dt.triangle(t).birth};
          ask(born, rules.unacceptable(view, born));
        }
      }
    }
    live.triangulation().neighbors(v, &around_);
    for (const VertexId u : around_) {
      ask_at(live, view, rules, u, v, ask);
      if (Rules::kSpindle) ask_segments(live, view, rules, v, u, ask);
    }
  }

  /// Asks what has u for a vertex (or in its spindle) about its new neighbor v.
  template <class Ask>
  void ask_at(const Live3& live, const View3& view, const Rules& rules, VertexId u, VertexId v,
              Ask ask) {
    ask_segments(live, view, rules, u, v, ask);
    if constexpr (Rules::kFaceTriangles) {
      for (const std::uint32_t face : live.faces_of(live.feature(u))) {
        if (live.lies_in_face(v, face)) continue;
        const Delaunay2& dt = live.face(face).triangulation();
        dt.for_each_outgoing(live.local(u, face), [&](HalfEdge h) {
          const TriangleId t = h / 4;
          if (!dt.is_ghost(t) && !live.is_pocket(face, dt.triangle(t))) {
            const FaceTriangle at{face, t, dt.triangle(t).birth};
            ask(at, rules.near_vertex(view, at, u, v));
          }
          return true;
        });
      }
    }
  }

  template <class Ask>
  void ask_segments(const Live3& live, const View3& view, const Rules& rules, VertexId q,
                    VertexId p, Ask ask) {
    for (const SubsegmentId s : live.subsegments_at(q)) {
      if constexpr (Rules::kSpindle) {
        view.for_each_in_spindle(
            s, [&](SubsegmentId other) { ask(other, rules.near_vertex(view, other, q, p)); });
      } else {
        ask(s, rules.near_vertex(view, s, q, p));
      }
    }
  }

  static Feature feature_of(const Live3& live, SubsegmentId s) {
    return {FeatureKind::kSegment, live.subsegment(s).segment.value};
  }
  static Feature feature_of(const Live3&, const FaceTriangle& t) {
    return {FeatureKind::kFace, t.face};
  }

  std::vector<Item> heap_;
  std::uint64_t pushed_ = 0;
  std::vector<bool> segment_waits_;
  std::vector<VertexId>
      witnesses_;  // by subsegment: for which it, or what it is a half of, was queued
  std::vector<std::vector<std::uint32_t>>
      triangle_waits_;  // by face and slot: the birth that waits
  std::vector<FaceTriangle> frozen_;
  std::vector<VertexId> around_;  // scratch
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_AGENDA3_H_
