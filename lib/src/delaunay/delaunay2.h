#ifndef CIRCUMBALL_DELAUNAY_DELAUNAY2_H_
#define CIRCUMBALL_DELAUNAY_DELAUNAY2_H_
// CONTRACT DRAFT: names and meanings are fixed, layout and inlining are the implementer's.
#include <cstdint>
#include <vector>
#include "circumball/types.h"
namespace circumball {

using TriangleId = std::uint32_t;  // index of a slot
using HalfEdge = std::uint32_t;    // 4 * triangle + i: the directed edge opposite vertex i, from vertex i+1 to i+2 (ccw)
constexpr std::uint32_t kNone = 0xffffffffu;

/// Exact Delaunay triangulation of points in the plane, incremental, with ghost triangles on the hull (one vertex kGhost).
/// Ties of incircle: symbolic perturbation by vertex number => unique for the vertex sequence, whatever the order of insertion.
class Delaunay2 {
 public:
  static constexpr VertexId kGhost{0xfffffffeu};

  struct Triangle {          // 32 bytes: half a cache line
    VertexId v[3];           // ccw; a ghost has kGhost at some place
    std::uint32_t label = 0; // caller's: domain label; inherited from the dead triangle at the outer edge (or `fresh_label` when a tag was swallowed)
    HalfEdge n[3];           // n[i]: the same edge in the neighbour
    std::uint32_t birth = 0; // running number of birth: identity of a simplex while slots are reused
  };

  // vertices
  VertexId add_vertex(const Point2& p);          // gives the next number; not inserted yet
  std::uint32_t vertex_count() const;
  const Point2& point(VertexId v) const;
  void pop_vertex();                             // takes back the last add_vertex, if not inserted

  // queries, none allocates
  int dimension() const;                         // -1 none, 0 one vertex, 1 all collinear, 2
  bool alive(TriangleId t) const;
  bool is_ghost(TriangleId t) const;
  const Triangle& triangle(TriangleId t) const;
  std::uint32_t slot_count() const;              // slots, dead ones too
  TriangleId triangle_of(VertexId v) const;      // some live triangle at v; kNone if not inserted
  HalfEdge find_edge(VertexId a, VertexId b) const;   // half-edge from a to b, or kNone
  HalfEdge twin(HalfEdge h) const;
  VertexId origin(HalfEdge h) const; VertexId target(HalfEdge h) const; VertexId apex(HalfEdge h) const; // apex may be kGhost
  template <class F> void for_each_neighbor(VertexId v, F f) const;   // f(VertexId) -> bool continue
  TriangleId locate(const Point2& p, TriangleId hint) const;          // triangle (maybe ghost) containing p

  // tags: one number a (undirected) edge, kNone if untagged; kept while the edge lives
  std::uint32_t tag(HalfEdge h) const; void set_tag(HalfEdge h, std::uint32_t tag);
  void set_label(TriangleId t, std::uint32_t label);

  // two-phase insertion: look, then leap
  enum class Probe : std::uint8_t { kOk, kDuplicate };
  // Triangles whose circumdisk holds p, seen as a vertex numbered higher than every other. For kDuplicate, duplicate_of() says of which.
  Probe probe(const Point2& p, TriangleId start);
  Probe probe(VertexId v, TriangleId start);    // p = point(v), ties by v's number
  VertexId duplicate_of() const;
  const std::vector<TriangleId>& cavity() const;          // dead-to-be, ghosts too (still alive until commit)
  const std::vector<HalfEdge>& cavity_boundary() const;   // half-edges inside the cavity whose twin is outside
  const std::vector<HalfEdge>& cavity_tagged_inside() const; // tagged edges strictly inside the cavity (one half-edge each): commit loses their tags
  void commit(VertexId v);                                // inserts v into the cavity just probed
  // the change record of the last commit
  const std::vector<Triangle>& died() const;  // copies of the dead (ghosts too)
  const std::vector<TriangleId>& born() const;// ghosts too

  // batch: inserts vertices [first, last) in a spatially coherent order; calls observer(v) after each commit (if not null);
  // returns pairs (duplicate, earlier vertex with equal coordinates; the one with the LOWER number is kept)
  struct Duplicate { VertexId vertex, of; };
  template <class Observer> std::vector<Duplicate> insert_batch(std::uint32_t first, std::uint32_t last, Observer observer);
  std::size_t bytes() const;
};
}
#endif
