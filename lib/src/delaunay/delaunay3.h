#ifndef CIRCUMBALL_DELAUNAY_DELAUNAY3_H_
#define CIRCUMBALL_DELAUNAY_DELAUNAY3_H_

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "circumball/types.h"
#include "delaunay/slot.h"

namespace circumball {

using CellSlot = std::uint32_t;   ///< index of a slot
using CellFacet = std::uint32_t;  ///< 4 * cell + i: the facet opposite vertex i

/// Exact Delaunay triangulation of points in space, by incremental insertion (Bowyer 1981, Watson
/// 1981).
///
/// The hull is closed by ghost cells, which share the vertex kGhost; the ghost (a, b, c, kGhost)
/// stands for the open half-space on the side of the plane abc from which a, b, c are clockwise
/// (where orient3d is positive), and the open facet abc. So the cells form a 3-sphere, and every
/// facet has a twin.
///
/// Ties of insphere are settled by lifting each vertex infinitesimally off the paraboloid, a higher
/// number by infinitely more than a lower one (Devillers and Teillaud, "Perturbations for Delaunay
/// and weighted Delaunay 3D triangulations", 2011, with the vertex number as the order). So the
/// triangulation is unique for the numbered points, whatever the order of insertion. Only the
/// numbers of slots and births depend on that order.
///
/// While all inserted vertices are coplanar (dimension 2), each triangle abc of their Delaunay
/// triangulation has two ghosts, (a, b, c, kGhost) and (b, a, c, kGhost), joined by abc, and at an
/// edge ab of the hull also by ab and kGhost; every query works there too. Collinear vertices
/// (dimension 1) have no cells; edges and neighbors are those of their chain.
///
/// Slots of dead cells are used again. Queries share scratch memory: one thread at a time.
class Delaunay3 {
 public:
  static constexpr VertexId kGhost{0xfffffffeu};

  struct Cell {
    VertexId v[4];        ///< orient3d is positive; in a ghost, v[3] is kGhost
    CellFacet n[4];       ///< n[i]: the same facet in the neighbor
    std::uint32_t label;  ///< the caller's; inherited from the dead cell at the outer facet
    std::uint32_t birth;  ///< running number: identity of a cell while slots are reused
  };

  // ---- vertices
  // -------------------------------------------------------------------------------------------------

  void reserve(std::size_t vertices);
  /// Gives the next number; the vertex is not inserted yet.
  VertexId add_vertex(const Point3& p) {
    points_.push_back(p);
    cell_of_.push_back(kNone);
    vertex_mark_.push_back(0);
    return VertexId(vertex_count() - 1);
  }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }
  const Point3& point(VertexId v) const { return points_[v.value]; }
  bool inserted(VertexId v) const { return cell_of_[v.value] != kNone; }
  /// Takes back the last add_vertex, which must not be inserted.
  void pop_vertex() {
    points_.pop_back();
    cell_of_.pop_back();
    vertex_mark_.pop_back();
  }

  // ---- cells
  // ----------------------------------------------------------------------------------------------------

  /// -1 none inserted, 0 one vertex, 1 all collinear, 2 all coplanar, 3.
  int dimension() const { return dimension_; }
  std::uint32_t slot_count() const { return static_cast<std::uint32_t>(links_.size()); }
  bool alive(CellSlot c) const { return c < slot_count() && links_[c].v[0].valid(); }
  bool is_ghost(CellSlot c) const { return links_[c].v[3] == kGhost; }
  static bool is_ghost(const Cell& c) { return c.v[3] == kGhost; }
  /// A copy; what the caller does not read of it costs nothing.
  Cell cell(CellSlot c) const {
    const Links& at = links_[c];
    return {{at.v[0], at.v[1], at.v[2], at.v[3]},
            {at.n[0], at.n[1], at.n[2], at.n[3]},
            notes_[c].label,
            notes_[c].birth};
  }
  VertexId corner(CellSlot c, std::uint32_t i) const { return links_[c].v[i]; }
  std::uint32_t label(CellSlot c) const { return notes_[c].label; }
  void set_label(CellSlot c, std::uint32_t label) { notes_[c].label = label; }
  /// The same facet in the neighbor.
  CellFacet twin(CellFacet f) const { return links_[f >> 2].n[f & 3]; }
  /// The corner of the facet's cell that is not in the facet; may be kGhost.
  VertexId apex(CellFacet f) const { return links_[f >> 2].v[f & 3]; }
  /// The corners of the facet, i of 0 to 2: orient3d of the apex and the three is positive. Only
  /// the last may be kGhost.
  VertexId facet_corner(CellFacet f, std::uint32_t i) const {
    return links_[f >> 2].v[kFacet[f & 3][i]];
  }
  /// Some cell at v; kNone if v is not inserted, and below dimension 2.
  CellSlot cell_of(VertexId v) const {
    const CellSlot c = cell_of_[v.value];
    return c < slot_count() ? c : kNone;
  }
  /// Some ghost; kNone below dimension 2.
  CellSlot some_ghost() const { return ghost_cell_; }
  /// Calls f(CellSlot) for every cell that is no ghost, by slot.
  template <class F>
  void for_each_cell(F f) const {
    for (CellSlot c = 0; c < slot_count(); ++c)
      if (alive(c) && !is_ghost(c)) f(c);
  }

  // ---- neighbors; nothing is allocated once the scratch memory has grown
  // ---------------------------------------

  /// Clears `out` and fills it with the Delaunay neighbors of v, each once, kGhost left out; in a
  /// lower dimension, those of the triangulation of that dimension.
  void neighbors(VertexId v, std::vector<VertexId>* out) const;
  /// Clears `out` and fills it with the cells at v, ghosts too. None below dimension 2.
  void cells_at(VertexId v, std::vector<CellSlot>* out) const;
  /// Calls f(VertexId) -> bool (go on?) for the Delaunay neighbors of v. Of this class f may call
  /// has_edge, find_facet, locate and what looks at a vertex or cell; no neighbor query, no probe.
  template <class F>
  void for_each_neighbor(VertexId v, F f) const {
    neighbors(v, &neighbors_);
    for (const VertexId u : neighbors_)
      if (!f(u)) return;
  }
  /// The one at fewer cells; a if it does not matter, or below dimension 2. O(the lesser number).
  VertexId of_lesser_degree(VertexId a, VertexId b) const;
  /// Both must be inserted. In dimension 3 a walk around a, otherwise O(the degree of a).
  bool has_edge(VertexId a, VertexId b) const;
  /// A facet with these corners, which must be inserted; kNone if there is none. In dimension 2, of
  /// a ghost.
  CellFacet find_facet(VertexId a, VertexId b, VertexId c) const;

  /// A cell whose closure contains p: a ghost where p is strictly outside the hull. In dimension 2,
  /// a ghost on p's side, and for p in the plane one of a triangle that contains p, or whose edge
  /// p sees from outside; kNone below. By a visibility walk from `hint` (any number; a slot near p
  /// makes it fast), which ends as the triangulation is Delaunay (Edelsbrunner 1989).
  CellSlot locate(const Point3& p, CellSlot hint) const;

  // ---- two-phase insertion: look, then leap
  // ---------------------------------------------------------------------

  enum class Probe : std::uint8_t { kOk, kDuplicate };
  /// Finds the cells that inserting p would kill, with p seen as a vertex numbered higher than
  /// every other: those whose circumball holds p. For kDuplicate, duplicate_of() says of which
  /// vertex. `start` is a hint as in locate.
  Probe probe(const Point3& p, CellSlot start) { return look<false>(p, kNone, start); }
  /// The same for p = point(v), with ties settled by v's number.
  Probe probe(VertexId v, CellSlot start) { return look<false>(point(v), v.value, start); }
  VertexId duplicate_of() const { return duplicate_of_; }
  /// The dead-to-be, ghosts too (alive until commit). Empty where a chain of collinear vertices
  /// grows, or a planar triangulation outwards.
  const std::vector<CellSlot>& cavity() const { return cavity_; }
  /// Facets of the cavity's cells whose twin is outside.
  const std::vector<CellFacet>& cavity_boundary() const { return boundary_; }
  /// Clears `out` and fills it with the Delaunay neighbors that the probed point would have, kGhost
  /// left out.
  void cavity_neighbors(std::vector<VertexId>* out) const;
  /// Inserts v into the cavity just probed for v's point. A born cell has v at corner 0, and
  /// inherits the label of the dead cell that owned its outer facet; 0 if there is none.
  void commit(VertexId v);
  /// The change record of the last commit: copies of the dead, and the slots of the born; ghosts
  /// too.
  const std::vector<Cell>& died() const { return died_; }
  const std::vector<CellSlot>& born() const { return born_; }

  // ---- batches
  // --------------------------------------------------------------------------------------------------

  struct Duplicate {
    VertexId vertex, of;
  };
  /// Inserts the vertices [first, last) that are not inserted yet, in Hilbert order with random
  /// rounds (Amenta, Choi and Rote 2003), and calls observer(VertexId) after each commit; nullptr
  /// for no observer, which is faster and leaves no change record. Returns the vertices that are
  /// not inserted, by number, as another vertex has their coordinates: the lowest number of the
  /// batch stays, unless one inserted before holds the place.
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
  /// cell_of_ of a vertex inserted below dimension 2.
  static constexpr CellSlot kOnLine = 0xfffffffeu;
  /// Corners of the facet opposite i. A ghost's kGhost stays last.
  static constexpr std::uint32_t kFacet[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {1, 0, 2}};

  /// What walks and cavities read of a cell: half a cache line.
  struct alignas(32) Links {
    VertexId v[4];
    CellFacet n[4];
  };
  struct Note {
    std::uint32_t label = 0, birth = 0;
  };
  /// A facet of the cavity's boundary: the born cell (p, v[0], v[1], v[2]) takes it.
  struct RingFacet {
    VertexId v[3];
    CellFacet outside;
  };
  /// In dimension 2, an edge of the boundary of p's cavity, counter-clockwise around p as seen from
  /// off_plane_: the born triangle (p, a, b) takes it. What is outside, as facets of the ghosts on
  /// either side; kNone at the hull. Dead cells that owned it; kNone if p is beyond the hull.
  struct RingEdge {
    VertexId a, b;
    CellFacet outside[2];
    CellSlot owner[2];
  };
  struct Batch {
    std::vector<std::uint32_t> order;
    std::vector<Duplicate> duplicates;
  };

  std::uint32_t number(VertexId v) const { return numbers_ ? numbers_[v.value] : v.value; }
  CellSlot walk(const Point3& p, CellSlot c) const;
  CellSlot walk_in_star(VertexId a, VertexId b) const;
  bool equals_corner(const Point3& p, CellSlot c);
  bool in_conflict(const Links& c, const Point3& p, std::uint32_t number) const;
  bool wins_tie(const VertexId* v, const Point3& p, std::uint32_t number) const;
  template <bool kPlain>
  Probe look(const Point3& p, std::uint32_t number, CellSlot start);
  template <bool kPlain>
  void dig(const Point3& p, std::uint32_t number, CellSlot seed);
  void grow_lists(std::size_t size);
  template <bool kPlain>
  void fill(VertexId v);
  void take_slots(std::size_t count);
  void free_slots(std::size_t first);
  bool link_by_table();
  void link_by_hash();
  void record_dead();
  bool insert_plainly(VertexId v);

  // Below dimension 3: delaunay3_flat.cpp.
  std::size_t place_on_line(const Point3& p) const;
  bool on_line(const Point3& p) const;
  void line_neighbors(VertexId v, VertexId* before, VertexId* after) const;
  CellSlot upper(CellSlot c) const;
  CellSlot walk_in_plane(const Point3& p, CellSlot c, std::uint32_t* seen) const;
  CellSlot locate_in_plane(const Point3& p, CellSlot c) const;
  CellSlot cell_with_edge_in_plane(VertexId a, VertexId b) const;
  int side_in_plane(VertexId a, VertexId b, const Point3& p) const;
  bool sees_hull_edge(CellFacet edge, const Point3& p) const;
  bool in_circle(CellSlot c, const Point3& p, std::uint32_t number) const;
  CellFacet next_on_hull(CellFacet edge, bool forward) const;
  CellFacet lower(CellFacet edge) const;
  Probe probe_flat(const Point3& p, std::uint32_t number, CellSlot start);
  Probe probe_on_line(const Point3& p);
  void dig_in_plane(const Point3& p, std::uint32_t number, CellSlot seed, std::uint32_t seen);
  void raise_from_line(const Point3& p);
  void fill_flat(VertexId v);

  Batch begin_batch(std::uint32_t first, std::uint32_t last);
  void deal(Batch* batch);
  void insert_silently(Batch* batch);
  void build_in_order(Batch* batch);
  bool insert_next(std::uint32_t v, Batch* batch);
  std::vector<Duplicate> end_batch(Batch* batch);

  std::vector<Point3> points_;
  std::vector<CellSlot> cell_of_;
  std::vector<Links> links_;
  std::vector<Note> notes_;  // of the same size, except within build_in_order
  std::vector<CellSlot> free_;
  int dimension_ = -1;
  std::vector<VertexId> line_;  // below dimension 2: the inserted, in lexicographic order
  Point3 off_plane_;            // in dimension 2: some point off the plane
  CellSlot ghost_cell_ = kNone;
  CellSlot last_born_ = kNone;
  std::uint32_t births_ = 0;
  const std::uint32_t* numbers_ =
      nullptr;  // numbers that settle ties, where vertices are stored in another order

  // The probe, and the last commit: reused, so that an insertion allocates nothing.
  VertexId duplicate_of_;
  int dimension_after_ = -1;
  Point3 off_plane_after_;
  std::vector<CellSlot> cavity_;
  std::vector<CellFacet> boundary_;
  std::vector<RingFacet> ring_;
  std::vector<RingEdge> flat_ring_;
  std::vector<Cell> died_;
  std::vector<CellSlot> born_;
  std::vector<CellFacet> frontier_, next_frontier_, tests_, found_, outer_;  // of one size
  std::vector<std::uint32_t> table_, labels_;
  // Scratch of queries. Marks are zero between calls.
  mutable std::vector<std::uint8_t> mark_, vertex_mark_;
  mutable std::vector<CellSlot> star_, other_star_;
  mutable std::vector<VertexId> neighbors_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_DELAUNAY3_H_
