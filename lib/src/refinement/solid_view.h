#ifndef CIRCUMBALL_REFINEMENT_SOLID_VIEW_H_
#define CIRCUMBALL_REFINEMENT_SOLID_VIEW_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "complex/solid_domain.h"
#include "delaunay/tetrahedron_shape.h"
#include "refinement/round_marks.h"
#include "refinement/view3.h"

namespace circumball {

/// Who proposed a point that yielded: a triangle of a face or a tetrahedron, or nobody.
struct Proposer3 {
  FaceTriangle triangle;
  CellRef cell;
  PatchId patch;
};

/// What is around a point of space that is not inserted yet.
enum class Outlook3 : std::uint8_t {
  kFree,
  kEncroaches,  ///< in the open ball of what SolidView::for_each_encroached tells
  kOutside,     ///< outside of the domain
  kCoincides,   ///< at a vertex, in double precision; or rounding put it elsewhere
};

/// What the rules of chapter 6 may see beyond View3: tetrahedra, and who encroaches upon whom.
///
/// Rounding. Vertices of a sloping face are not exactly in its plane, so it is settled by numbers
/// who belongs to a face: its own vertices never encroach upon its triangles, whose triangulation
/// is Delaunay in the plane. Balls of segments are exact, those of triangles of faces have the
/// slack kLengthSlack. A triangle that is not a facet, although its ball is empty, is let be,
/// unless something crosses it (`encroachment`): the facets of the tetrahedralization tile the face
/// in another way then, as they may where vertices of the face are nearly cocircular.
class SolidView : public View3 {
 public:
  using View3::View3;

  // --- what the loop asks
  using View3::alive;
  using View3::key;
  static std::uint64_t key(const CellRef& c) { return std::uint64_t{c.birth} << 2 | 2; }
  bool alive(const CellRef& c) const {  // false for none
    return c.slot != kNone && dt_.alive(c.slot) && dt_.cell(c.slot).birth == c.birth;
  }
  static std::uint64_t key(PatchId p) { return std::uint64_t{p.value} << 2 | 3; }
  bool alive(PatchId p) const {  // false for none
    return p.valid() && live_.has_intestine() && live_.intestine().patch(p).alive;
  }
  bool alive(const Proposer3& p) const {
    return alive(p.cell) || alive(p.triangle) || alive(p.patch);
  }
  using View3::in_domain;
  bool in_domain(const CellRef& c) const { return live_.is_in_domain(c.slot); }
  using View3::ready;
  bool ready(const Point3& p, SubsegmentId s);
  void found_acceptable(SubsegmentId s) {
    if (live_.tracks_collars()) live_.tag_edges(s);
  }
  void found_acceptable(const FaceTriangle&) {}
  void found_acceptable(const CellRef&) {}
  void found_acceptable(PatchId) {}
  bool ready(const Point3&, const CellRef&) const { return true; }  // looked at by the action
  bool ready(const Point3& p, PatchId patch);
  bool may_split(PatchId p) const { return alive(p) && !live_.intestine().patch(p).frozen; }
  bool may_split(SubsegmentId s) const { return alive(s) && !live_.subsegment(s).frozen; }
  bool may_split(const FaceTriangle& t) const { return alive(t) && !live_.is_frozen(t); }
  /// Calls f for what the point last looked at encroaches upon, and yields to: subsegments, or
  /// where there are none triangles of faces.
  template <class F>
  void for_each_encroached(F f) const {
    for (const SubsegmentId s : segments_) f(s);
    for (const FaceTriangle& t : triangles_) f(t);
    for (const PatchId p : patches_) f(p);
  }

  // --- subsegments, collar segments and collar arcs
  /// Of an arc: the midpoint of the arc.
  Point3 midpoint(SubsegmentId s) const {
    const Subsegment& u = live_.subsegment(s);
    if (u.is_ring_arc()) return ring_arc_midpoint(u);
    if (!u.is_arc()) return View3::midpoint(s);
    return arc_midpoint(dt_.point(u.center), dt_.point(u.a), dt_.point(u.b));
  }
  /// Whether the open diametral ball of s holds a vertex, exactly; or s is not an edge of the
  /// tetrahedralization, or of the triangulation of a face that it lies in, although the ball is
  /// empty: vertices on its sphere took the edge by a tie.
  Verdict encroachment(SubsegmentId s) const;
  /// The same, where v is new and all else is known.
  Verdict encroached_by(SubsegmentId s, VertexId v) const;

  // --- triangles of faces
  /// Whether t lies inside of its face (Live3::is_in_face).
  bool is_in_face(const FaceTriangle& t) const;
  /// Whether the smallest ball of t holds a vertex that does not belong to the face, by more than
  /// the slack; or else, where t is not a facet, whether an edge of the tetrahedralization that
  /// joins the two sides of the face crosses t.
  Verdict encroachment(const FaceTriangle& t) const;
  /// The same, where v is new and all else is known.
  Verdict encroached_by(const FaceTriangle& t, VertexId v) const;
  bool is_in_collar(const FaceTriangle& t) const { return live_.is_in_collar(t); }
  /// Finds what is to be split for an encroached triangle of a collar, so that collars line up: the
  /// collar element in whose disk the projection of the encroaching vertex lies, the counterpart of
  /// what that vertex split in another face. Where there is none, the collar elements at the
  /// triangle, or those at the triangles beside it, but for those that are short beside it already.
  void propose_collar_elements(const FaceTriangle& t);
  /// Leaves out what collar simplices are: protected subsegments and triangles of collars. Returns
  /// whether there were some.
  bool leave_out_protected();
  /// Looks at the circumcenter c of t: whether it encroaches upon segments.
  Outlook3 look(const Point3& c, const FaceTriangle& t);

  // --- the whole
  /// Whether every subsegment is an edge, and nothing crosses a face: whatever keeps inside and
  /// outside apart is there. O(triangles of faces).
  bool conforms() const;

  // --- tetrahedra
  TetrahedronShape shape(const CellRef& c) const {
    return tetrahedron_shape(dt_.point(dt_.corner(c.slot, 0)), dt_.point(dt_.corner(c.slot, 1)),
                             dt_.point(dt_.corner(c.slot, 2)), dt_.point(dt_.corner(c.slot, 3)));
  }
  /// Whether c is a layer of a face: four vertices that belong to it, and no volume but what
  /// rounding made. Such a cell is not refined: outside of the domain where it is on the boundary;
  /// elsewhere its circumcenter lies between those of the cells on its sides, so that it is as good
  /// as they are.
  bool is_flat(const CellRef& c, const TetrahedronShape& shape) const;
  double volume_bound(const CellRef& c) const { return live_.volume_bound(c.slot); }
  /// Looks at p, a point of the plane of the face of t near t, as a vertex of that face: whether it
  /// encroaches upon segments, or upon triangles of other faces.
  Outlook3 look_in_face(const Point3& p, const FaceTriangle& t);
  /// Where p, just looked at, encroaches upon no segment, but upon triangles of faces beyond all
  /// collars: the first of them; face kNone elsewhere.
  FaceTriangle triangle_in_the_way() const;
  /// The projection of p onto the plane of a face.
  Point3 projection(const Point3& p, std::uint32_t face) const {
    const FacePlane& plane = live_.face(face).plane();
    return plane.to_space(plane.to_plane(p));
  }
  /// Looks at the circumcenter p of c: whether it encroaches upon segments, or where upon none,
  /// upon triangles of faces.
  Outlook3 look(const Point3& p, const CellRef& c);
  /// Of the smallest dihedral angle of c.
  double least_dihedral_cosine(const CellRef& c) const {
    return circumball::least_dihedral_cosine(
        dt_.point(dt_.corner(c.slot, 0)), dt_.point(dt_.corner(c.slot, 1)),
        dt_.point(dt_.corner(c.slot, 2)), dt_.point(dt_.corner(c.slot, 3)));
  }
  template <class Measure>
  double measure(Measure m) const {
    return measuring() ? m() : 0;
  }

  // --- what the point last looked at would change
  /// Whether all cells that die belong to the same part of the domain as c, and no facet between
  /// them lies in a face.
  bool cavity_is_in_one_part(const CellRef& c) const;
  /// Calls f for each cell that dies.
  template <class F>
  void for_each_dying(F f) const {
    for (const CellSlot c : dt_.cavity()) f(CellRef{c, dt_.cell(c).birth});
  }
  /// Calls f(dead, a, b, c) -> bool (go on?) for each cell born: its corners beside the point
  /// itself, and the cell that dies there, whose part of the domain it will belong to.
  template <class F>
  void for_each_in_star(F f) const {
    for (const CellFacet facet : dt_.cavity_boundary()) {
      const CellSlot dead = facet / 4;
      if (dt_.is_ghost(dead)) continue;
      if (!f(CellRef{dead, dt_.cell(dead).birth}, dt_.point(dt_.facet_corner(facet, 0)),
             dt_.point(dt_.facet_corner(facet, 1)), dt_.point(dt_.facet_corner(facet, 2)))) {
        return;
      }
    }
  }
  // --- intestines (thesis, 6.3)
  bool is_in_intestine(SubsegmentId s) const { return live_.subsegment(s).is_collar; }
  bool is_structured() const { return live_.intestine().structured(); }
  const Patch& patch(PatchId p) const { return live_.intestine().patch(p); }
  /// Whether the smallest ball of a patch holds a vertex, by more than the slack. (If it does not,
  /// the patch is a facet, or with all its corners on one circle two of them, but for ties.)
  Verdict encroachment(PatchId p) const;
  Verdict encroached_by(PatchId p, VertexId v) const;
  /// Whether a patch of a sphere has an angular radius above 45 degrees, so that its ball holds the
  /// center of the sphere.
  bool is_wide(PatchId p) const;
  /// The point of the sphere above the circumcenter of a patch of it.
  Point3 top(PatchId p) const;
  /// Finds the ring arcs that a patch of a tube has for sides, if one is longer than 1.2 times the
  /// patch along its tube: rings alone would run away. False if there is none.
  bool propose_arcs(PatchId p);
  /// Finds the elements of dimension 1 among the sides of a patch; false if there are none.
  bool propose_sides(PatchId p);
  /// Of a patch of a tube: its circumcenter in the developed surface, mapped back (6.3). `inside`:
  /// whether it is within its cell.
  Point3 projected_circumcenter(PatchId p, bool* inside) const;
  /// Of a patch of a tube: where the ring that splits it is at the key of its first corner.
  Point3 place_on_new_ring(PatchId p) const;
  /// Looks at a point on the surface of p: whether it encroaches upon subsegments, collar elements
  /// or ring arcs.
  Outlook3 look(const Point3& c, PatchId p);
  bool is_in_intestine(const CellRef& c) const {
    return live_.has_intestine() && !dt_.is_ghost(c.slot) && live_.is_in_intestine(c.slot);
  }
  /// Of what the point last looked at encroaches upon, leaves out what is inside of the intestine:
  /// subsegments of protected segments, triangles of collars. Where dimension 1 is left, only that
  /// stays. Returns whether something was left out.
  bool leave_out_intestine();

  // --- what cells touch
  /// Calls f for each subsegment that is an edge of a cell with these vertices; some twice.
  template <class F>
  void for_each_subsegment(const VertexId* v, F f) const {
    for (unsigned i = 0; i < 4; ++i) {
      if (!can_end_subsegment(v[i])) continue;
      for (unsigned j = i + 1; j < 4; ++j) {
        if (!can_end_subsegment(v[j])) continue;
        const SubsegmentId s = live_.subsegment_between(v[i], v[j]);
        if (s.valid()) f(s);
      }
    }
  }
  /// Calls f for each patch that is, or has, a facet of a cell with these vertices; some twice. Of
  /// 6.3, where a facet on a tube is no patch, for all patches with two of its corners: those in
  /// its place, where corners are nearly cocircular, are among them.
  template <class F>
  void for_each_patch(const VertexId* v, F f) const {
    if (!live_.has_intestine()) return;
    const Intestines& intestine = live_.intestine();
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId a = v[(i + 1) % 4], b = v[(i + 2) % 4], c = v[(i + 3) % 4];
      if (a == Delaunay3::kGhost || b == Delaunay3::kGhost || c == Delaunay3::kGhost) continue;
      if (!intestine.is_on_surface(a)) continue;
      const PatchId p = intestine.patch_with(a, b, c);
      if (p.valid()) {
        f(p);
      } else if (!intestine.structured()) {
        intestine.for_each_patch_beside(a, b, c, f);
      }
    }
  }
  /// Begins a round of for_each_face_triangle over cells.
  void begin_face_triangles() const {
    corners_met_.begin();
    triangles_met_.begin();
  }
  /// Calls f for each triangle of a face that is a facet of a cell with these vertices. Where a
  /// facet lies in a face, but is no triangle of it, for all triangles at its corners: some of them
  /// are in its place. Each triangle comes once in a round.
  template <class F>
  void for_each_face_triangle(const VertexId* v, F f) const {
    for_each_face_triangle(
        v, [](unsigned) { return false; }, f);
  }
  /// The same but for facets i with skip(i).
  template <class Skip, class F>
  void for_each_face_triangle(const VertexId* v, Skip skip, F f) const {
    for (unsigned i = 0; i < 4; ++i) {
      if (skip(i)) continue;
      const VertexId a = v[(i + 1) % 4], b = v[(i + 2) % 4], c = v[(i + 3) % 4];
      if (!can_lie_in_face(a) || !can_lie_in_face(b) || !can_lie_in_face(c)) continue;
      // Of one that lies in few faces: vertices of segments may lie in many.
      const auto has_one = [&](VertexId u) { return live_.feature(u).kind == FeatureKind::kFace; };
      const VertexId least = has_one(a) ? a : has_one(b) ? b : has_one(c) ? c : a;
      for (const std::uint32_t face : live_.faces_of(live_.feature(least))) {
        if (!live_.lies_in_face(a, face) || !live_.lies_in_face(b, face) ||
            !live_.lies_in_face(c, face)) {
          continue;
        }
        const FaceTriangle t = live_.face_triangle(face, a, b, c);
        if (t.face != kNone) {
          if (triangles_met_.meet(t.face, t.id)) f(t);
        } else {
          for (const VertexId corner : {a, b, c}) {
            if (!corners_met_.meet(face, live_.local(corner, face).value)) continue;
            for_each_around(corner, face, [&](const FaceTriangle& u) {
              if (triangles_met_.meet(u.face, u.id)) f(u);
            });
          }
        }
      }
    }
  }

 private:
  bool can_lie_in_face(VertexId v) const {
    return v != Delaunay3::kGhost && live_.feature(v).kind != FeatureKind::kFree;
  }
  bool can_end_subsegment(VertexId v) const {
    if (v == Delaunay3::kGhost) return false;
    const FeatureKind last = live_.tracks_collars() ? FeatureKind::kFace : FeatureKind::kSegment;
    return live_.feature(v).kind <= last ||
           (live_.has_intestine() && live_.intestine().is_on_surface(v));
  }
  template <class F>
  void for_each_around(VertexId v, std::uint32_t face, F f) const {
    const Delaunay2& dt = live_.face(face).triangulation();
    dt.for_each_outgoing(live_.local(v, face), [&](HalfEdge h) {
      const TriangleId t = h / 4;
      if (!dt.is_ghost(t)) f(FaceTriangle{face, t, dt.triangle(t).birth});
      return true;
    });
  }
  bool segment_ball_holds(SubsegmentId s, const Point3& p) const {
    const Subsegment& u = live_.subsegment(s);
    const Point3 &a = dt_.point(u.a), &b = dt_.point(u.b);
    if (u.is_collar_element() || u.is_of_tube())
      return in_diametral_ball_of_chord(a, b, p, live_.rounding());
    return in_diametral_ball(a, b, p) == Sign::kPositive;
  }
  /// The smallest ball of a triangle of a face, with the slack of what rounding moved.
  struct Ball {
    TriangleBall ball;
    double most = 0;  ///< the power of points in it is less
    bool holds(const Point3& p) const { return ball.power(p) < most; }
  };
  Ball ball(const FaceTriangle& t) const;
  bool is_missing(SubsegmentId s) const;
  struct Box3;
  Box3 box_of_facet(CellFacet f) const;
  bool is_hull_side(std::uint32_t face, CellFacet f) const;
  VertexId encroacher_behind(const FaceTriangle& t, CellFacet f) const;
  Verdict encroachment_of_missing(const FaceTriangle& t) const;
  VertexId crosser_in_cavity(const FaceTriangle& t) const;
  bool crosses(const FaceTriangle& t, VertexId p, VertexId q) const;
  void find_encroached_segments(const Point3& p);
  void find_encroached_triangles(const Point3& p);
  void find_encroached_patches(const Point3& p);
  bool ready_for_ring(VertexId a, VertexId b, const Point3& p);
  Point3 ring_arc_midpoint(const Subsegment& u) const;
  Ball ball(PatchId patch) const;
  bool cavity_holds(CellSlot c) const;
  Outlook3 outside_or_free() const;

  std::vector<SubsegmentId> segments_;
  std::vector<FaceTriangle> triangles_;
  std::vector<PatchId> patches_;
  mutable std::vector<CellSlot> flat_;  // scratch
  // By face: corners, and slots of triangles; row 0: subsegments, cells.
  mutable RoundMarks corners_met_, triangles_met_, segments_met_, cells_met_;
  // By face and slot of a triangle: its birth, and whether it lies in the face.
  struct Known {
    std::uint32_t birth = kNone;
    bool inside = false;
  };
  mutable std::vector<std::vector<Known>> known_;
  // By face: the side of its plane on which nothing is.
  enum class HullSide : std::uint8_t { kUnknown, kNone, kAbove, kBelow };
  mutable std::vector<HullSide> hull_sides_;
};

/// Tells which cells belong to the domain and its regions (solid_domain.h), where nothing leaks;
/// else labels stay as they are.
std::vector<RelabeledCell> classify_if_conforming(Live3* live);

inline Proposal3 yield3(const Point3& at) { return {ProposalKind::kYield, Reason::kYieldedTo, at}; }
inline Proposal3 refuse(const Point3& at, Reason why) { return {ProposalKind::kRefuse, why, at}; }

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_SOLID_VIEW_H_
