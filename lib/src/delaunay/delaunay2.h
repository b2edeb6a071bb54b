#ifndef CIRCUMBALL_DELAUNAY_DELAUNAY2_H_
#define CIRCUMBALL_DELAUNAY_DELAUNAY2_H_

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "circumball/types.h"
#include "delaunay/slot.h"

namespace circumball {

using TriangleId = std::uint32_t;  ///< index of a slot
/// 4 * triangle + i: the directed edge opposite vertex i, from vertex i+1 to vertex i+2
/// (counter-clockwise).
using HalfEdge = std::uint32_t;

/// Exact Delaunay triangulation of points in the plane, by incremental insertion (Bowyer 1981,
/// Watson 1981).
///
/// The hull is closed by ghost triangles, which share the vertex kGhost; the ghost (a, b, kGhost)
/// stands for the open half-plane to the left of ab, and the open edge ab. So the triangles form a
/// sphere, and every half-edge has a twin.
///
/// Ties of incircle are settled by lifting each vertex infinitesimally off the paraboloid, a higher
/// number by infinitely more than a lower one (Devillers and Teillaud, "Perturbations for Delaunay
/// and weighted Delaunay 3D triangulations", 2011, with the vertex number as the order). So the
/// triangulation is unique for the numbered points, whatever the order of insertion. Only the
/// numbers of slots and births depend on that order.
///
/// While all inserted vertices are collinear (dimension 1), each edge ab of their chain has two
/// ghosts, (a, b, kGhost) and (b, a, kGhost); every query works there too. A single vertex
/// (dimension 0) has no triangles.
///
/// No triangle is ever freed: each insertion reuses the slots of its dead and takes two more.
class Delaunay2 {
 public:
  static constexpr VertexId kGhost{0xfffffffeu};

  /// 32 bytes: half a cache line.
  struct Triangle {
    VertexId v[3];  ///< counter-clockwise; a ghost has kGhost at some place
    std::uint32_t label =
        0;  ///< the caller's; inherited from the dead triangle at the outer edge (see commit)
    HalfEdge n[3];  ///< n[i]: the same edge in the neighbor
    std::uint32_t birth =
        0;  ///< running number of birth: identity of a triangle while slots are reused
  };

  // ---- vertices
  // -------------------------------------------------------------------------------------------------

  void reserve(std::size_t vertices);
  /// Gives the next number; the vertex is not inserted yet.
  VertexId add_vertex(const Point2& p) {
    points_.push_back(p);
    triangle_of_.push_back(kNone);
    return VertexId(vertex_count() - 1);
  }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }
  const Point2& point(VertexId v) const { return points_[v.value]; }
  bool inserted(VertexId v) const { return triangle_of_[v.value] != kNone; }
  /// Takes back the last add_vertex, which must not be inserted.
  void pop_vertex() {
    points_.pop_back();
    triangle_of_.pop_back();
  }

  // ---- queries; none allocates
  // ----------------------------------------------------------------------------------

  /// -1 none inserted, 0 one vertex, 1 all collinear, 2.
  int dimension() const { return dimension_; }
  std::uint32_t slot_count() const { return static_cast<std::uint32_t>(triangles_.size()); }
  /// Every slot below slot_count() is alive, between insertions.
  bool alive(TriangleId t) const { return t < slot_count(); }
  bool is_ghost(TriangleId t) const { return is_ghost(triangles_[t]); }
  static bool is_ghost(const Triangle& t) {
    return t.v[0] == kGhost || t.v[1] == kGhost || t.v[2] == kGhost;
  }
  const Triangle& triangle(TriangleId t) const { return triangles_[t]; }
  /// Some triangle at v; kNone if v is not inserted, or is the only vertex inserted.
  TriangleId triangle_of(VertexId v) const {
    const TriangleId t = triangle_of_[v.value];
    return t < slot_count() ? t : kNone;
  }
  /// Some ghost triangle; kNone below dimension 1.
  TriangleId some_ghost() const { return ghost_triangle_; }
  HalfEdge twin(HalfEdge h) const { return triangles_[h >> 2].n[h & 3]; }
  VertexId origin(HalfEdge h) const { return triangles_[h >> 2].v[kNext[h & 3]]; }
  VertexId target(HalfEdge h) const { return triangles_[h >> 2].v[kPrev[h & 3]]; }
  /// May be kGhost.
  VertexId apex(HalfEdge h) const { return triangles_[h >> 2].v[h & 3]; }
  /// The next half-edge of the same triangle, counter-clockwise; and the one before.
  static HalfEdge next(HalfEdge h) { return h + 1 - 3 * (h >> 1 & 1); }
  static HalfEdge prev(HalfEdge h) { return h - 1 + 3 * ((h & 3) == 0); }

  /// A half-edge out of v; kNone if v is not inserted, or is the only vertex inserted.
  HalfEdge some_outgoing(VertexId v) const {
    const TriangleId t = triangle_of(v);
    if (t == kNone) return kNone;
    const Triangle& at = triangles_[t];
    const std::uint32_t i = at.v[0] == v ? 0 : at.v[1] == v ? 1 : 2;
    return 4 * t + kPrev[i];
  }
  /// Calls f(HalfEdge) -> bool (go on?) for the half-edges out of v, counter-clockwise, those to
  /// kGhost too.
  template <class F>
  void for_each_outgoing(VertexId v, F f) const {
    const HalfEdge first = some_outgoing(v);
    if (first == kNone) return;
    HalfEdge h = first;
    do {
      if (!f(h)) return;
      h = twin(prev(h));
    } while (h != first);
  }
  /// Calls f(VertexId) -> bool (go on?) for the neighbors of v, counter-clockwise, kGhost left out.
  template <class F>
  void for_each_neighbor(VertexId v, F f) const {
    for_each_outgoing(v, [&](HalfEdge h) {
      const VertexId u = target(h);
      return u == kGhost || f(u);
    });
  }
  /// Calls f(TriangleId) for every triangle that is no ghost, by slot.
  template <class F>
  void for_each_triangle(F f) const {
    for (TriangleId t = 0; t < slot_count(); ++t)
      if (!is_ghost(t)) f(t);
  }
  /// The half-edge from a to b, or kNone. By turns about a and about b: O(the lesser degree).
  HalfEdge find_edge(VertexId a, VertexId b) const {
    const HalfEdge first_a = some_outgoing(a), first_b = some_outgoing(b);
    if (first_a == kNone || first_b == kNone) return kNone;
    HalfEdge from_a = first_a, from_b = first_b;
    do {
      if (target(from_a) == b) return from_a;
      if (target(from_b) == a) return twin(from_b);
      from_a = twin(prev(from_a));
      from_b = twin(prev(from_b));
    } while (from_a != first_a && from_b != first_b);
    return kNone;
  }
  /// The one of fewer Delaunay neighbors; a if it does not matter. O(the lesser degree).
  VertexId of_lesser_degree(VertexId a, VertexId b) const {
    const HalfEdge first_a = some_outgoing(a), first_b = some_outgoing(b);
    if (first_a == kNone || first_b == kNone) return a;
    HalfEdge from_a = first_a, from_b = first_b;
    for (;;) {
      if ((from_a = twin(prev(from_a))) == first_a) return a;
      if ((from_b = twin(prev(from_b))) == first_b) return b;
    }
  }
  /// A triangle whose closure contains p: a ghost where p is strictly outside the hull. In
  /// dimension 1, a ghost on p's side at the edge or end nearest to the walk; kNone below. By a
  /// visibility walk from `hint` (any number; a slot near p makes it fast), which ends as the
  /// triangulation is Delaunay (Edelsbrunner 1989).
  TriangleId locate(const Point2& p, TriangleId hint) const;

  // ---- tags and labels
  // ------------------------------------------------------------------------------------------

  /// One number an undirected edge, kNone if untagged; kept while the edge lives. Memory is taken
  /// at the first tag.
  std::uint32_t tag(HalfEdge h) const { return tags_.empty() ? kNone : tags_[h]; }
  void set_tag(HalfEdge h, std::uint32_t tag);
  void set_label(TriangleId t, std::uint32_t label) { triangles_[t].label = label; }

  // ---- two-phase insertion: look, then leap
  // ---------------------------------------------------------------------

  enum class Probe : std::uint8_t { kOk, kDuplicate };
  /// Finds the triangles that inserting p would kill, with p seen as a vertex numbered higher than
  /// every other: those whose circumdisk holds p. For kDuplicate, duplicate_of() says of which
  /// vertex. `start` is a hint as in locate.
  Probe probe(const Point2& p, TriangleId start) { return probe_at(p, kNone, start); }
  /// The same for p = point(v), with ties settled by v's number.
  Probe probe(VertexId v, TriangleId start) { return probe_at(point(v), v.value, start); }
  VertexId duplicate_of() const { return duplicate_of_; }
  /// The dead-to-be, ghosts too (alive until commit). Empty where a chain of collinear vertices
  /// grows at its end.
  const std::vector<TriangleId>& cavity() const { return cavity_; }
  /// Half-edges inside the cavity whose twin is outside, counter-clockwise around it.
  const std::vector<HalfEdge>& cavity_boundary() const { return boundary_; }
  /// Tagged edges strictly inside the cavity, one half-edge each: commit loses their tags.
  const std::vector<HalfEdge>& cavity_tagged_inside() const { return tagged_inside_; }
  /// Inserts v into the cavity just probed for v's point. Tags on the boundary of the cavity stay.
  /// A born triangle inherits the label of the dead triangle that owned its outer edge; but 0 if an
  /// edge strictly inside the cavity bore a tag other than `splitting_tag`, as then the cavity may
  /// have joined what the tagged edge kept apart.
  void commit(VertexId v, std::uint32_t splitting_tag = kNone);
  /// The change record of the last commit: copies of the dead, and the slots of the born; ghosts
  /// too.
  const std::vector<Triangle>& died() const { return died_; }
  const std::vector<TriangleId>& born() const { return born_; }

  // ---- batches
  // --------------------------------------------------------------------------------------------------

  struct Duplicate {
    VertexId vertex, of;
  };
  /// Inserts the vertices [first, last) that are not inserted yet, in Hilbert order with random
  /// rounds (Amenta, Choi and Rote 2003), and calls observer(VertexId) after each commit; nullptr
  /// for no observer, which is faster and leaves no change record. Returns the vertices that are
  /// not inserted, by number, as another vertex has their coordinates: the lowest number of the
  /// batch stays, unless one inserted before holds the place. O(n log n) in expectation.
  template <class Observer>
  std::vector<Duplicate> insert_batch(std::uint32_t first, std::uint32_t last, Observer observer) {
    Batch batch = begin_batch(first, last);
    if constexpr (std::is_same_v<Observer, std::nullptr_t>) {
      insert_silently(&batch);
    } else {
      deal(&batch);
      for (const std::uint32_t v : batch.order)
        if (insert_next(v, &batch)) observer(VertexId(v));
    }
    return end_batch(&batch);
  }

  /// Memory taken.
  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t kNext[3] = {1, 2, 0}, kPrev[3] = {2, 0, 1};
  /// triangle_of_ of the only vertex inserted, which has no triangle.
  static constexpr TriangleId kAlone = 0xfffffffeu;

  /// An edge of the cavity's boundary: the born triangle (p, origin, origin of the next one) takes
  /// it.
  struct RingEdge {
    HalfEdge outside;
    VertexId origin;
  };
  struct Inheritance {
    std::uint32_t label, tag;
  };
  /// A vertex seen from the point that is located or inserted: offset, its squared length, and the
  /// edge that ends there.
  struct Sight {
    double x, y, lift;
    VertexId v;
    HalfEdge h;
  };
  struct Batch {
    std::vector<std::uint32_t> order;
    std::vector<Duplicate> duplicates;
  };

  std::uint32_t number(VertexId v) const { return numbers_ ? numbers_[v.value] : v.value; }
  Sight sight(VertexId v, const Point2& p, HalfEdge h) const;
  double turn(const Sight& a, const Sight& b, const Point2& p) const;
  TriangleId walk(const Point2& p, TriangleId t) const;
  TriangleId walk_on_line(const Point2& p, TriangleId t) const;
  bool in_conflict(const Triangle& t, const Point2& p, std::uint32_t number) const;
  bool wins_tie(const Triangle& t, const Point2& p, std::uint32_t number) const;
  Probe probe_at(const Point2& p, std::uint32_t number, TriangleId start);
  Probe probe_below_plane(const Point2& p, std::uint32_t number, TriangleId start);
  Probe probe_on_line(const Point2& p, std::uint32_t number, TriangleId start);
  bool equals_corner(const Point2& p, TriangleId t);
  template <bool kPlain>
  Probe look(const Point2& p, std::uint32_t number, TriangleId start);
  template <bool kPlain>
  void dig(const Point2& p, std::uint32_t number, TriangleId seed);
  void link_on_line(TriangleId fresh);
  template <bool kPlain>
  void fill(VertexId v, std::uint32_t splitting_tag);
  bool insert_plainly(VertexId v);
  Batch begin_batch(std::uint32_t first, std::uint32_t last);
  void deal(Batch* batch);
  void insert_silently(Batch* batch);
  void build_in_order(Batch* batch);
  bool insert_next(std::uint32_t v, Batch* batch);
  std::vector<Duplicate> end_batch(Batch* batch);

  std::vector<Point2> points_;
  std::vector<TriangleId> triangle_of_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> tags_;  // by half-edge; empty until the first tag
  int dimension_ = -1;
  VertexId only_vertex_;  // in dimension 0
  TriangleId ghost_triangle_ = kNone;
  TriangleId last_born_ = kNone;
  std::uint32_t births_ = 0;
  const std::uint32_t* numbers_ =
      nullptr;  // numbers that settle ties, where vertices are stored in another order

  // The probe, and the last commit: reused, so that an insertion allocates nothing.
  VertexId duplicate_of_;
  int dimension_after_ = -1;
  std::vector<TriangleId> cavity_;
  std::vector<HalfEdge> boundary_, tagged_inside_;
  std::vector<RingEdge> ring_;
  std::vector<Inheritance> inheritance_;
  std::vector<Sight> pending_;
  std::vector<Triangle> died_;
  std::vector<TriangleId> born_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_DELAUNAY2_H_
