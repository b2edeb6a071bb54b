#ifndef CIRCUMBALL_COMPLEX_INTESTINES_H_
#define CIRCUMBALL_COMPLEX_INTESTINES_H_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "complex/ring.h"
#include "complex/tube_cell.h"
#include "delaunay/delaunay3.h"

namespace circumball {

using PatchId = Id<struct PatchTag>;

/// A piece of a sphere or tube, by its corners: a required triangle, or between rings a trapezoid,
/// whose corners are on one circle, so that its diagonal is left to the tetrahedralization.
struct Patch {
  VertexId v[4];                    ///< in cyclic order; v[3] invalid: a triangle
  std::uint32_t sphere = kNoIndex;  ///< the input vertex whose sphere it is of; or
  std::uint32_t ring = kNoIndex;  ///< of a tube, the first one of the two rings that it is between,
  std::uint32_t gap = 0;          ///< and the number of the base direction before it
  bool alive = true;
  bool frozen = false;  ///< it was refused for good
  bool is_quad() const { return v[3].valid(); }
  bool is_of_sphere() const { return sphere != kNoIndex; }
  bool has(VertexId p) const { return p == v[0] || p == v[1] || p == v[2] || p == v[3]; }
};

/// The intestines of thesis 6.3.1: spheres about input vertices, tubes about input segments, and
/// the patches that they are made of at present.
class Intestines {
 public:
  /// How tubes are refined: by rings (Algorithm 6.4), or cell by cell, between rings and base
  /// directions, by circumcenters in the developed surface (6.3).
  explicit Intestines(bool structured) : structured_(structured) {}
  bool structured() const { return structured_; }

  // --- construction (step 2c)
  std::uint32_t add_tube(Tube tube) {
    tubes_.push_back(std::move(tube));
    return static_cast<std::uint32_t>(tubes_.size() - 1);
  }
  /// Appends a ring behind those that its tube has, `before` the last of them.
  std::uint32_t add_ring(Ring ring, std::uint32_t before);
  /// A vertex of a ring, and of the sphere that it is on. Before patches are made.
  void add_to_ring(std::uint32_t ring, RingKey key, VertexId v);
  void add_sphere(VertexId center, double radius);
  void add_to_sphere(std::uint32_t center, VertexId v);
  /// All patches; `point(VertexId)` are the coordinates, and `is_tip` tells tips of protected
  /// segments.
  void make_patches(const Delaunay3& dt, const std::vector<bool>& is_tip);

  // --- rings, tubes, spheres
  const Ring& ring(std::uint32_t r) const { return rings_[r]; }
  std::uint32_t ring_count() const { return static_cast<std::uint32_t>(rings_.size()); }
  const Tube& tube(std::uint32_t t) const { return tubes_[t]; }
  const Tube& tube_of(const Ring& r) const { return tubes_[r.tube]; }
  std::uint32_t tube_count() const { return static_cast<std::uint32_t>(tubes_.size()); }
  /// Radius of the sphere about an input vertex; 0 if there is none.
  double radius(std::uint32_t input_vertex) const;
  const std::vector<VertexId>& sphere_vertices(std::uint32_t input_vertex) const;
  Point3 place(const Ring& ring, RingKey key) const;
  /// The key in the middle of an arc of a ring; its ends in any order.
  RingKey middle_key(std::uint32_t ring, VertexId a, VertexId b) const;
  /// The ring that a collar segment begins at, and the key that it is along: a, b on it and on the
  /// next one, in any order; kNoIndex if they are not.
  std::uint32_t ring_before(VertexId a, VertexId b, RingKey* key) const;
  /// The ring to be put in the middle between `before` and the next one, with the keys of both. Not
  /// added yet; its vertices are not inserted.
  Ring ring_between(std::uint32_t before) const;

  // --- where vertices are: on a sphere (input vertex), on a tube, or kNoIndex
  std::uint32_t sphere_of(VertexId v) const {
    return v.value < on_.size() ? on_[v.value].sphere : kNoIndex;
  }
  std::uint32_t tube_at(VertexId v) const {
    return v.value < on_.size() ? on_[v.value].tube : kNoIndex;
  }
  std::uint32_t ring_of(VertexId v) const {
    return v.value < on_.size() ? on_[v.value].ring : kNoIndex;
  }
  bool is_on_surface(VertexId v) const {
    return sphere_of(v) != kNoIndex || tube_at(v) != kNoIndex;
  }

  // --- cells of tubes (6.3), by the ring before them and the base direction before them
  const TubeCell& cell(std::uint32_t ring, std::uint32_t gap) const {
    return developed_[ring][gap];
  }
  /// Where a vertex is in a cell that it belongs to: part of the angle, part of the way.
  Point2 place_in_cell(VertexId v, std::uint32_t ring, std::uint32_t gap) const;
  /// The piece of a tube between two rings that three vertices on it share, by its first ring;
  /// kNoIndex if there is none.
  std::uint32_t piece_of(VertexId a, VertexId b, VertexId c) const;

  // --- patches
  std::uint32_t patch_count() const { return static_cast<std::uint32_t>(patches_.size()); }
  const Patch& patch(PatchId p) const { return patches_[p.value]; }
  void freeze(PatchId p) { patches_[p.value].frozen = true; }
  /// The patch with these three of its corners; invalid if there is none.
  PatchId patch_with(VertexId a, VertexId b, VertexId c) const;

  /// Calls f for the patches of tubes that have two of three vertices of one tube for corners.
  template <class F>
  void for_each_patch_beside(VertexId a, VertexId b, VertexId c, F f) const {
    if (tube_at(a) == kNoIndex || tube_at(a) != tube_at(b) || tube_at(a) != tube_at(c)) return;
    for (const VertexId p : {a, b}) {
      if (p.value >= patches_at_.size()) continue;
      for (const PatchId id : patches_at_[p.value]) {
        const Patch& patch = patches_[id.value];
        if (!patch.is_of_sphere() && patch.has(a) + patch.has(b) + patch.has(c) >= 2) f(id);
      }
    }
  }

  // --- refinement; each makes patches die and others be born
  /// v is the vertex at `key` of a ring, the middle of one of its arcs.
  void split_arc(const Delaunay3& dt, std::uint32_t ring, RingKey key, VertexId v);
  /// Puts a ring behind another one; its vertices are inserted.
  std::uint32_t insert_ring(const Delaunay3& dt, std::uint32_t before, Ring ring);
  /// v is the midpoint of a piece of a generator, or of a collar segment, of 6.3.
  void split_generator(VertexId a, VertexId b, VertexId v);
  /// v is the circumcenter of a patch of a tube, of 6.3.
  void split_patch(PatchId p, VertexId v);
  /// v was inserted, on the sphere about an input vertex.
  void split_sphere(const Delaunay3& dt, std::uint32_t center, VertexId v);
  /// What died, and was born, since this was asked last. A patch that died and was born again in
  /// between is in neither list.
  std::vector<PatchId> take_born();
  std::vector<PatchId> take_died();

  std::size_t bytes() const;

 private:
  struct Sphere {
    VertexId center;
    double radius = 0;
    std::vector<VertexId> vertices;
    /// Of the center and the vertices, numbered in this order: ties are settled as in the whole.
    /// The cells at the center are there as well, once their patches are not encroached.
    std::unique_ptr<Delaunay3> local;
  };
  struct On {
    std::uint32_t sphere = kNoIndex, tube = kNoIndex, ring = kNoIndex;
    // Of 6.3, of a vertex between rings: the ring before it, its base direction and the part of the
    // angle to the next one, the part of the way to the next ring.
    std::uint32_t piece = kNoIndex, gap = 0;
    double part = 0, t = 0;
  };
  using Corners = std::array<VertexId, 4>;

  On& on(VertexId v);
  void create(const Corners& v, std::uint32_t sphere, std::uint32_t ring, std::uint32_t gap);
  void kill(PatchId p);
  void rebuild(std::uint32_t ring, std::uint32_t gap);
  void add_between(const Ring& a, const Ring& b, RingKey low, RingKey high,
                   std::vector<Corners>* list) const;
  static VertexId at_wrapped(const Ring& ring, RingKey key, RingKey turn);
  void develop(std::uint32_t ring, std::uint32_t gap);
  void create_in_cell(std::uint32_t ring, std::uint32_t gap, TriangleId t);
  void insert_in_cell(std::uint32_t ring, std::uint32_t gap, VertexId v);
  void create_of_sphere(const Sphere& s, CellSlot c);

  bool structured_;
  std::vector<bool> is_tip_;  // by vertex
  std::vector<Tube> tubes_;
  std::vector<Ring> rings_;
  std::vector<Sphere> spheres_;
  std::vector<std::uint32_t> sphere_at_;  // by input vertex: index in spheres_
  std::vector<On> on_;                    // by vertex
  std::vector<Patch> patches_;
  std::vector<std::vector<PatchId>> patches_at_;          // by vertex
  std::vector<std::vector<std::vector<PatchId>>> cells_;  // by ring and gap
  std::vector<std::vector<TubeCell>> developed_;          // of 6.3, by ring and gap
  std::vector<PatchId> born_, died_;
  bool made_ = false;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_INTESTINES_H_
