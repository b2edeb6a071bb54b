#ifndef CIRCUMBALL_REFINEMENT_VIEW3_H_
#define CIRCUMBALL_REFINEMENT_VIEW3_H_

#include <cstdint>
#include <vector>

#include "circumball/predicates.h"
#include "complex/live3.h"
#include "delaunay/constructions.h"
#include "refinement/verdict.h"

/// What a rule may see in space: pure queries over the local Delaunay tetrahedralization, and over
/// the Delaunay triangulations of the faces.
namespace circumball {

using Proposal3 = ProposalOf<Point3>;
inline Proposal3 insert(const Point3& at, Reason why) { return {ProposalKind::kInsert, why, at}; }

class View3 {
 public:
  View3(Live3& live, bool measuring)
      : live_(live), dt_(live.triangulation()), measuring_(measuring) {}

  // --- what the loop asks
  /// Identity of a simplex among all that a run ever has.
  static std::uint64_t key(SubsegmentId s) { return std::uint64_t{s.value} << 2; }
  static std::uint64_t key(const FaceTriangle& t) {
    return std::uint64_t{t.face} << 34 | std::uint64_t{t.birth} << 2 | 1;
  }
  bool alive(SubsegmentId s) const { return live_.subsegment(s).alive; }
  bool alive(const FaceTriangle& t) const {  // false for none
    if (t.face == kNone) return false;
    const Delaunay2& dt = live_.face(t.face).triangulation();
    return dt.alive(t.id) && dt.triangle(t.id).birth == t.birth;
  }
  template <class Simplex>
  bool in_domain(const Simplex&) const {
    return true;
  }
  template <class Simplex>
  void found_acceptable(const Simplex&) {}
  /// Looks at p, which splits the simplex: whether it can be inserted, in the tetrahedralization
  /// and in every face that it will belong to. Finds the cavities.
  bool ready(const Point3& p, SubsegmentId s);
  bool ready(const Point3& p, const FaceTriangle& t);
  /// Distance from the point last looked at to its nearest vertex: r_q, if it is inserted
  /// (Definition 2.1.5).
  double insertion_radius(const Point3& p) const;
  /// A measure that only a trace shows: not computed if nobody records.
  bool measuring() const { return measuring_; }

  // --- subsegments
  const Subsegment& subsegment(SubsegmentId s) const { return live_.subsegment(s); }
  Point3 midpoint(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    return circumball::midpoint(dt_.point(u.a), dt_.point(u.b));
  }
  double squared_length(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    return squared_distance(dt_.point(u.a), dt_.point(u.b));
  }
  double squared_distance_between(VertexId p, VertexId q) const {
    return squared_distance(dt_.point(p), dt_.point(q));
  }
  bool is_input_vertex(VertexId v) const { return live_.is_input_vertex(v); }
  bool is_end_of(VertexId q, SubsegmentId s) const {
    return q == live_.subsegment(s).a || q == live_.subsegment(s).b;
  }
  /// Calls f for every segment of Spind(s) (Definition 2.1.5): s and, where s is an end segment,
  /// all end segments at its input vertices.
  template <class F>
  void for_each_in_spindle(SubsegmentId s, F f) const {
    f(s);
    const Subsegment& u = live_.subsegment(s);
    for (const VertexId end : {u.a, u.b}) for_each_other_at(end, s, f);
  }
  /// The part of it at one end.
  template <class F>
  void for_each_other_at(VertexId end, SubsegmentId s, F f) const {
    if (!live_.is_input_vertex(end)) return;
    for (const SubsegmentId other : live_.subsegments_at(end)) {
      if (other != s) f(other);
    }
  }
  /// A squared distance below which no end of an end segment at q0 has a Delaunay neighbor that is
  /// a 1-feature size witness for any of them: so that not all are compared with all, where
  /// thousands meet. Infinite where q0 is no input vertex.
  double squared_clearance_of_spindle(VertexId q0) const;
  /// Calls f for the Delaunay neighbors p of q that are nearer than `length2` (squared) by more
  /// than the slack, with the squared distance. f returns whether to go on.
  template <class F>
  void for_each_near_neighbor(VertexId q, double length2, F f) const {
    dt_.neighbors(q, &neighbors_);
    for (const VertexId p : neighbors_) {
      const double d2 = squared_distance_between(p, q);
      if (is_less(d2, length2) && !f(p, d2)) return;
    }
  }
  /// Squared lengths of constructed pieces: less by more than the slack (architecture.md).
  static bool is_less(double d2, double length2) {
    return d2 * (kLengthSlack * kLengthSlack) < length2;
  }
  /// Whether p is a 1-feature size witness for s (Definition 2.1.7): p lies in an input feature of
  /// dimension at most 1 that is disjoint from the simplex s.
  bool is_witness(VertexId p, SubsegmentId s) const;
  /// Whether p is a local feature size witness for s: p lies in an input feature that is disjoint
  /// from some input feature containing s. What is disjoint from a face is disjoint from the
  /// segments in it, so that the input segment of s and the smallest feature that p lies in decide.
  bool is_local_witness(VertexId p, SubsegmentId s) const {
    return live_.disjoint(live_.feature(p),
                          {FeatureKind::kSegment, live_.subsegment(s).segment.value});
  }
  /// Whether q is an input vertex, and p lies in an input feature that is disjoint from it.
  bool is_disjoint_from_input_vertex(VertexId p, VertexId q) const {
    return live_.is_input_vertex(q) && live_.disjoint(live_.feature(p), live_.feature(q));
  }

  // --- triangles of faces
  /// Squared circumradius; infinite where rounding flattened t.
  double squared_circumradius(const FaceTriangle& t) const;
  /// The vertices of t, by their numbers in the complex.
  std::array<VertexId, 3> corners(const FaceTriangle& t) const {
    const FaceRefinement& face = live_.face(t.face);
    const auto& v = face.triangulation().triangle(t.id).v;
    return {face.global(v[0]), face.global(v[1]), face.global(v[2])};
  }
  bool lies_in_face(VertexId v, std::uint32_t face) const { return live_.lies_in_face(v, face); }
  /// The circumcenter of t, in the plane of its face.
  Point3 circumcenter(const FaceTriangle& t) const;
  /// Whether the circumcenter of t lies in its face.
  bool circumcenter_is_in_face(const FaceTriangle& t) const;
  /// Looks at c, near t: finds its cavity. False where it coincides with a vertex.
  bool look(const Point3& c, const FaceTriangle& t);
  /// Of the point last looked at: the first of its would-be Delaunay neighbors q that is an
  /// endpoint of a segment s in `face` with |c - q| < |s|; invalid if there is none.
  VertexId near_segment_of_face(const Point3& c, std::uint32_t face) const;

 protected:
  /// Finds the cavity of p, near a vertex or from a cell; false where p coincides with a vertex, or
  /// the predicates are not exact for it.
  bool probe(const Point3& p, VertexId near) const { return probe_from(p, dt_.cell_of(near)); }
  bool probe_from(const Point3& p, CellSlot start) const;
  Point2 center_in_plane(const FaceTriangle& t) const;

  Live3& live_;
  Delaunay3& dt_;  // only its scratch (the cavity of a probe) is ever written here
  bool measuring_;
  mutable std::vector<VertexId> neighbors_;  // scratch
  // Answers of squared_clearance_of_spindle, by vertex, and how many vertices there were.
  struct Clearance {
    std::uint32_t vertices = 0;
    double squared = 0;
  };
  mutable std::vector<Clearance> clearances_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_VIEW3_H_
