#ifndef CIRCUMBALL_REFINEMENT_VIEW_H_
#define CIRCUMBALL_REFINEMENT_VIEW_H_

#include <algorithm>
#include <optional>
#include <vector>

#include "circumball/predicates.h"
#include "circumball/trace.h"
#include "complex/live2.h"
#include "delaunay/constructions.h"
#include "refinement/verdict.h"
#include "sizing/sizing.h"

/// What a rule may see, and say. Rules are pure queries over the local Delaunay triangulation; only
/// the loop inserts, queues and records.
namespace circumball {

/// A triangle as the queue knows it: slots are reused, births are not.
struct TriangleRef {
  TriangleId id = kNone;
  std::uint32_t birth = 0;
};

using Proposal = ProposalOf<Point2>;
inline Proposal insert(const Point2& at, Reason why) { return {ProposalKind::kInsert, why, at}; }
/// Queue the subsegments that `at` encroaches (View::encroached) instead.
inline Proposal yield_to_encroached(const Point2& at) {
  return {ProposalKind::kYield, Reason::kYieldedTo, at};
}
inline Proposal refuse(const Point2& at, Reason why) { return {ProposalKind::kRefuse, why, at}; }

/// What is around a point that is not inserted yet.
enum class Outlook : std::uint8_t {
  kFree,        ///< inside the domain, in no diametral disk
  kEncroaches,  ///< in the open diametral disk of the subsegments in View::encroached
  kOutside,     ///< outside the domain
  kCoincides,   ///< at a vertex, in double precision
};

class View {
 public:
  /// `measuring`: whether somebody wants to know the measures behind the verdicts.
  View(Live2& live, bool measuring)
      : live_(live), dt_(live.triangulation()), measuring_(measuring) {}

  // --- what the loop asks
  /// Identity of a simplex among all that a run ever has.
  static std::uint64_t key(SubsegmentId s) { return std::uint64_t{s.value} << 1; }
  static std::uint64_t key(TriangleRef t) { return std::uint64_t{t.birth} << 1 | 1; }
  bool in_domain(SubsegmentId) const { return true; }
  /// Finds a lost label again.
  bool in_domain(TriangleRef t) const { return live_.in_domain(t.id); }
  /// A subsegment that was missing may be an edge again.
  void found_acceptable(SubsegmentId s) { live_.tag_edge(s); }
  void found_acceptable(TriangleRef) {}
  /// Whether p can be inserted to split the simplex that it was proposed for: it has been looked
  /// at, coincides with no vertex, and the predicates are exact for it (architecture.md, Numbers).
  bool ready(const Point2& p, SubsegmentId s) {
    return look_at_midpoint(p, s) != Outlook::kCoincides && representable(p);
  }
  bool ready(const Point2& p, TriangleRef) const { return representable(p); }
  /// Whether a circumcenter may yield to it.
  bool may_split(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    return u.alive && !u.frozen && !u.is_collar;
  }

  // --- subsegments
  bool alive(SubsegmentId s) const { return live_.subsegment(s).alive; }
  const Subsegment& subsegment(SubsegmentId s) const { return live_.subsegment(s); }
  /// Of an arc: the midpoint of the arc.
  Point2 midpoint(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    if (u.is_arc()) {
      return arc_midpoint(dt_.point(u.center), live_.protection_distance(u.center), dt_.point(u.a),
                          dt_.point(u.b));
    }
    return outward(circumball::midpoint(dt_.point(u.a), dt_.point(u.b)), s);
  }
  /// Concentric shells: where s is split, if it is an end segment at a center of them.
  std::optional<Shells::Shell> shell_of(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    return live_.shells().shell_of(u.a, u.b, u.segment);
  }
  /// Where s crosses it: rounded within a few ulp of the larger end.
  Point2 shell_point(SubsegmentId s, const Shells::Shell& shell) const;
  /// p, a rounded point of s. Where s is an edge of the convex hull and rounding put p inside, the
  /// next point that is not: else the edge would stay in the triangulation, under a flat triangle.
  /// At most one ulp a coordinate.
  Point2 outward(const Point2& p, SubsegmentId s) const;

  /// Whether the open diametral disk of s holds a vertex (Algorithm 2.3), exactly; or s is not an
  /// edge of the triangulation, although the open disk is empty: vertices on its circle took the
  /// edge by a tie. If some vertex is inside the disk of an edge, one of the edge's two apexes is
  /// (Proposition 2.1). Of an arc, the disk of its chord; the center of the circle, which is on the
  /// disk's border for a quarter turn, never counts.
  Verdict encroachment(SubsegmentId s) const {
    const HalfEdge h = live_.edge_of(s);
    if (h == kNone) return {Reason::kMissing, VertexId(), 0};
    if (const VertexId p = encroaching_apex(s, h); p.valid()) return {Reason::kEncroached, p, 0};
    if (const VertexId p = encroaching_apex(s, dt_.twin(h)); p.valid()) {
      return {Reason::kEncroached, p, 0};
    }
    return {};
  }

  /// The same, where v is an apex of the edge of s and all else is known.
  Verdict encroached_by(SubsegmentId s, VertexId v) const {
    const Subsegment& u = live_.subsegment(s);
    return v != u.center && disk_holds(u, dt_.point(v)) ? Verdict{Reason::kEncroached, v, 0}
                                                        : Verdict{};
  }

  /// Whether s is not an edge of the triangulation.
  Verdict missing(SubsegmentId s) const {
    return live_.edge_of(s) == kNone ? Verdict{Reason::kMissing, VertexId(), 0} : Verdict{};
  }

  /// An end segment has an input vertex as an endpoint (Definition 2.1.5).
  bool is_input_vertex(VertexId v) const { return live_.feature(v).kind == FeatureKind::kVertex; }
  double squared_length(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    return squared_distance(dt_.point(u.a), dt_.point(u.b));
  }
  /// The squared length of the shortest segment of Spind(s): s and, where s is an end segment, all
  /// end segments at its input vertices (Definition 2.1.5).
  double shortest2_of_spindle(SubsegmentId s) const;
  /// Whether s, with the vertex `inside` in its disk, is more than twice as long as the shortest
  /// segment of Spind(s).
  Verdict too_long_for_spindle(SubsegmentId s, VertexId inside) const {
    const double length2 = squared_length(s);
    if (!(length2 > 4 * kLengthSlack * kLengthSlack * shortest2_of_spindle(s))) return {};
    return {Reason::kTooLong, inside, std::sqrt(length2)};
  }
  /// Whether p is a 1-feature size witness for s (Definition 2.1.7): p lies in an input feature of
  /// dimension at most 1 that is disjoint from the simplex s. A vertex knows the smallest feature
  /// that it lies in.
  bool is_witness(VertexId p, SubsegmentId s) const;
  /// The unacceptability of Algorithm 3.2, mended: see feature_size.h.
  Verdict too_large_an_estimate(SubsegmentId s) const;

  // --- triangles
  bool alive(TriangleRef t) const {  // false for none
    return dt_.alive(t.id) && dt_.triangle(t.id).birth == t.birth;
  }
  TriangleShape shape(TriangleRef t) const {
    const auto& v = dt_.triangle(t.id).v;
    return shape_of(dt_.point(v[0]), dt_.point(v[1]), dt_.point(v[2]));
  }
  Point2 circumcenter(TriangleRef t) const {
    const auto& v = dt_.triangle(t.id).v;
    return circumball::circumcenter(dt_.point(v[0]), dt_.point(v[1]), dt_.point(v[2]));
  }
  /// Off-center of t (see `off_center`) over its shortest edge, the first of them.
  Point2 off_center(TriangleRef t, double tau) const;
  /// Whether a shortest edge of t is seditious (Shewchuk): its ends are vertices in two input
  /// segments that meet at less than 60 degrees, equally far from where they meet. Needs shells.
  bool shortest_edge_is_seditious(TriangleRef t) const;
  /// A measure that only a trace shows: not computed if nobody records.
  template <class Measure>
  double measure(Measure m) const {
    return measuring_ ? m() : 0;
  }
  /// Whether the circumradius of t exceeds the infimum of h over t; see Sizing::exceeded_by.
  bool exceeds(const Sizing& h, TriangleRef t, const TriangleShape& shape) const {
    const auto& v = dt_.triangle(t.id).v;
    return h.exceeded_by(shape.circumradius(), dt_.point(v[0]), dt_.point(v[1]), dt_.point(v[2]));
  }
  double area_bound(TriangleRef t) const { return live_.area_bound(t.id); }

  /// Looks at c before leaping: c is the point that splits t, in its circumdisk. Finds the cavity
  /// of c.
  Outlook look(Point2& c, TriangleRef t);
  /// The same for a point of the circumdisk of t that is known well: kCoincides where rounding put
  /// it outside.
  Outlook look_exactly(const Point2& p, TriangleRef t);
  /// Looks at the midpoint of s.
  Outlook look_at_midpoint(const Point2& m, SubsegmentId s);
  /// The subsegments that the last look found encroached.
  const std::vector<SubsegmentId>& encroached() const { return encroached_; }
  /// Whether the point last looked at lies outside the domain, or its cavity swallows a subsegment.
  bool separates() const {
    return !dt_.cavity_tagged_inside().empty() || !live_.in_domain(dt_.cavity()[0]);
  }
  /// Whether t is one of the fan in a protecting disk: an input vertex, over an arc about it.
  bool in_protecting_disk(TriangleRef t) const {
    const auto& corners = dt_.triangle(t.id).v;
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t tag = dt_.tag(4 * t.id + i);
      if (tag != kNone && live_.subsegment(SubsegmentId(tag)).center == corners[i]) return true;
    }
    return false;
  }
  template <class F>
  void for_each_encroached(F f) const {
    for (const SubsegmentId s : encroached_) f(s);
  }
  /// Whether all of them are collar simplices.
  bool encroaches_upon_collar_only() const {
    return std::all_of(encroached_.begin(), encroached_.end(),
                       [this](SubsegmentId s) { return live_.subsegment(s).is_collar; });
  }
  /// Whether a collar simplex is among them.
  bool encroaches_upon_collar() const {
    return std::any_of(encroached_.begin(), encroached_.end(),
                       [this](SubsegmentId s) { return live_.subsegment(s).is_collar; });
  }
  /// Distance from the point last looked at to its nearest vertex: r_q, if it is inserted
  /// (Definition 2.1.5).
  double insertion_radius(const Point2& p) const;

 private:
  Outlook outlook(const Point2& p);
  static bool representable(const Point2& p) {
    const auto fine = [](double x) { return x == 0 || x >= 1e-45 || x <= -1e-45; };
    return fine(p.x) && fine(p.y);
  }
  bool is_seditious(VertexId u, VertexId v) const;
  VertexId encroaching_apex(SubsegmentId s, HalfEdge h) const {
    const VertexId p = dt_.apex(h);
    if (p == Delaunay2::kGhost) return VertexId();
    const Subsegment& u = live_.subsegment(s);
    return p != u.center && disk_holds(u, dt_.point(p)) ? p : VertexId();
  }
  /// Whether p lies in the open diametral disk: exact, but for arcs.
  bool disk_holds(const Subsegment& u, const Point2& p) const {
    const Point2 &a = dt_.point(u.a), &b = dt_.point(u.b);
    return u.is_arc() ? in_diametral_disk_of_chord(a, b, p)
                      : in_diametral_ball(a, b, p) == Sign::kPositive;
  }
  bool cavity_holds(TriangleId t) const {
    const auto& cavity = dt_.cavity();
    return std::find(cavity.begin(), cavity.end(), t) != cavity.end();
  }

  Live2& live_;
  Delaunay2& dt_;  // only its scratch (the cavity of a probe) is ever written here
  bool measuring_;
  std::vector<SubsegmentId> encroached_;
  // Scratch of too_large_an_estimate: vertices seen, and those inside of a disk.
  mutable std::vector<std::uint32_t> marks_;
  mutable std::uint32_t mark_ = 0;
  mutable std::vector<VertexId> inside_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_VIEW_H_
