#ifndef CIRCUMBALL_COMPLEX_LIVE3_H_
#define CIRCUMBALL_COMPLEX_LIVE3_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "circumball/complex.h"
#include "complex/domain_label.h"
#include "complex/face_refinement.h"
#include "complex/intestines.h"
#include "complex/subsegment.h"
#include "delaunay/delaunay3.h"

namespace circumball {

/// A triangle of the refinement of a face. Slots are reused, births are not.
struct FaceTriangle {
  std::uint32_t face = kNone;
  TriangleId id = kNone;
  std::uint32_t birth = 0;
};

/// A tetrahedron as the queue knows it: slots are reused, births are not.
struct CellRef {
  CellSlot slot = kNone;
  std::uint32_t birth = 0;
};

/// The features of a 3D complex and which of them touch: worked out once, by numbers alone.
class Incidence3 {
 public:
  explicit Incidence3(const Complex& complex);

  /// A run of indices.
  struct Range {
    const std::uint32_t *first, *last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  /// Vertices of a face: of its loops, of its segments, and isolated ones; ascending.
  Range vertices_of_face(std::uint32_t face) const { return row(face_vertices_, face); }
  /// Faces that an input vertex belongs to, and those that an input segment lies in; ascending.
  Range faces_of_vertex(std::uint32_t v) const { return row(vertex_faces_, v); }
  Range faces_of_segment(std::uint32_t s) const { return row(segment_faces_, s); }
  /// Input segments at an input vertex; ascending.
  Range segments_of_vertex(std::uint32_t v) const { return row(vertex_segments_, v); }
  bool face_has_vertex(std::uint32_t face, std::uint32_t v) const;
  bool face_has_segment(std::uint32_t face, std::uint32_t s) const;

 private:
  struct Table {
    std::vector<std::uint32_t> first, items;
  };
  static Range row(const Table& t, std::uint32_t i) {
    return {t.items.data() + t.first[i], t.items.data() + t.first[i + 1]};
  }
  /// Of pairs (row, item): each row's items ascending, each once.
  static Table table(std::size_t rows, std::vector<std::array<std::uint32_t, 2>>* pairs);

  Table face_vertices_, vertex_faces_, segment_faces_, vertex_segments_;
};

/// The live refinement C' = (P', S', F') of a 3D complex (thesis, Definition 2.1.4): the Delaunay
/// tetrahedralization of all its vertices, its subsegments, and the Delaunay triangulation of each
/// face.
class Live3 {
 public:
  /// `complex` must be valid (see `check`), with every side of a loop among its segments, and
  /// outlive this. Nothing is inserted yet.
  Live3(const Complex& complex, Domain domain);

  const Complex& complex() const { return *complex_; }
  const Incidence3& incidence() const { return incidence_; }
  Domain domain() const { return domain_; }
  Delaunay3& triangulation() { return triangulation_; }
  const Delaunay3& triangulation() const { return triangulation_; }

  // --- vertices: each knows its feature from its birth
  const Feature& feature(VertexId v) const { return features_[v.value]; }
  bool is_input_vertex(VertexId v) const { return feature(v).kind == FeatureKind::kVertex; }
  /// The corners of the box are the last eight vertices of its complex.
  bool is_box_corner(VertexId v) const {
    const auto given = static_cast<std::uint32_t>(complex_->vertices.size());
    return domain_ == Domain::kBox && v.value < given && v.value + 8 >= given;
  }
  /// Appends a vertex (not inserted) with the smallest feature that it lies on.
  VertexId add_vertex(const Point3& p, Feature feature);
  /// The faces that a vertex on this feature belongs to.
  Incidence3::Range faces_of(const Feature& feature) const {
    if (feature.kind == FeatureKind::kFace) {  // most of them
      const std::uint32_t* self = face_numbers_.data() + feature.index;
      return {self, self + 1};
    }
    return faces_of_lower(feature);
  }
  bool lies_in_face(VertexId v, std::uint32_t face) const {
    const Feature& f = feature(v);
    if (f.kind == FeatureKind::kFace) return f.index == face;
    if (f.kind == FeatureKind::kFree) return false;
    const Incidence3::Range faces = faces_of_lower(f);
    return std::binary_search(faces.begin(), faces.end(), face);
  }
  /// Whether some input segment holds all three.
  bool on_one_segment(VertexId a, VertexId b, VertexId c) const;
  /// Whether two features are disjoint: in a valid complex exactly when they share no input vertex.
  bool disjoint(const Feature& f, const Feature& g) const;

  // --- subsegments
  std::uint32_t subsegment_count() const { return static_cast<std::uint32_t>(subsegments_.size()); }
  const Subsegment& subsegment(SubsegmentId s) const { return subsegments_[s.value]; }
  void freeze(SubsegmentId s) { subsegments_[s.value].frozen = true; }
  const std::vector<SubsegmentId>& subsegments_at(VertexId v) const { return incident_[v.value]; }
  /// The subsegment with these ends; invalid if there is none.
  SubsegmentId subsegment_between(VertexId a, VertexId b) const;
  /// Makes a subsegment of every input segment, and the refinement of every face. After the input
  /// vertices are in.
  void create_features();
  /// Ends s; makes (a, m) and (m, b). m is inserted already.
  std::array<SubsegmentId, 2> split(SubsegmentId s, VertexId m);

  // --- collars (thesis, 6.2): segments and arcs in faces, kept like subsegments
  /// From now on edges of the refinements of faces bear their subsegments as tags, and triangles
  /// the side of the collars that they are on as labels.
  void track_collars();
  bool tracks_collars() const { return tracks_collars_; }
  /// Makes a collar segment between two vertices of a face, or a collar arc about `center`.
  SubsegmentId create_collar_element(VertexId a, VertexId b, std::uint32_t face, VertexId center);
  /// From now on these input vertices (those with a radius above 0) and input segments are
  /// protected: subsegments of these, and at these, are never split.
  void protect(std::vector<double> radii, const std::vector<bool>& segments);
  /// The length of the end segments at an input vertex, and radius of the circles about it, in the
  /// faces that it belongs to; 0 if it is not protected.
  double protection_radius(VertexId q0) const {
    return q0.value < protection_radii_.size() ? protection_radii_[q0.value] : 0;
  }
  bool is_protected(VertexId q0) const { return protection_radius(q0) > 0; }
  bool is_protected(SegmentId s) const {
    return s.value < protected_segments_.size() && protected_segments_[s.value];
  }
  bool protects_anything() const { return !protection_radii_.empty(); }
  /// Tags its edges, where there are some.
  void tag_edges(SubsegmentId s);
  /// Whether t lies between the collars and the segments of its face. Finds a lost label again.
  bool is_in_collar(const FaceTriangle& t);
  /// Labels all triangles of faces. After all collar elements are edges.
  void label_collars();

  // --- intestines (thesis, 6.3): arcs of rings are kept like subsegments
  /// From now on there are protecting surfaces.
  void begin_intestine(bool structured) { intestine_ = std::make_unique<Intestines>(structured); }
  bool has_intestine() const { return intestine_ != nullptr; }
  Intestines& intestine() { return *intestine_; }
  const Intestines& intestine() const { return *intestine_; }
  SubsegmentId create_ring_arc(VertexId a, VertexId b, std::uint32_t ring);
  /// From a ring to the next one, along a base direction in no face: Algorithm 6.3 alone has such.
  SubsegmentId create_generator(VertexId a, VertexId b, std::uint32_t ring);
  /// Whether it is on a protected segment, or a protected input vertex: inside, no Delaunay
  /// simplex at it is refined.
  bool is_in_intestine(VertexId v) const;
  /// Whether a cell belongs to the intestine: a corner of it is on a protected feature, or all four
  /// are on one sphere, or all four on one tube with the centroid inside.
  bool is_in_intestine(CellSlot c) const;
  /// Whether it belongs to a tube: no corner is a protected input vertex, and not all four are on
  /// one sphere.
  bool is_in_tube(CellSlot c) const;

  // --- faces
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
  FaceRefinement& face(std::uint32_t f) { return faces_[f]; }
  const FaceRefinement& face(std::uint32_t f) const { return faces_[f]; }
  /// Whether all three vertices of t lie on one input segment: t is flat, but for their rounding.
  /// Such triangles at the rim of a face's refinement are none of the face.
  bool is_pocket(std::uint32_t face, const Delaunay2::Triangle& t) const;
  /// Whether t is a triangle of the face: inside of its polygon, and no pocket.
  bool is_inside(std::uint32_t face, const Delaunay2::Triangle& t) const {
    return faces_[face].inside(t) && !is_pocket(face, t);
  }
  /// The number of v in the refinement of a face that it lies in; invalid elsewhere.
  VertexId local(VertexId v, std::uint32_t face) const;
  /// The triangle of the refinement of a face with these corners (numbers in the complex, in any
  /// order); face kNone if there is none.
  FaceTriangle face_triangle(std::uint32_t face, VertexId a, VertexId b, VertexId c) const;
  /// Whether the triangle abc of vertices of a face lies in it: inside of the polygon, and no
  /// sliver between pieces of a straight side that rounding bent.
  bool is_in_face(std::uint32_t face, VertexId a, VertexId b, VertexId c) const;
  /// Faces that continue each other across a segment, in one plane but for rounding, are a group:
  /// rounding makes flat cells on vertices of several of them.
  std::uint32_t group_of_face(std::uint32_t face) const { return groups_[face]; }
  /// How far rounding moves a vertex off the face or segment that it lies on: 8 units in the last
  /// place of the largest coordinate.
  double rounding() const { return rounding_; }
  bool lies_in_group(VertexId v, std::uint32_t group) const;
  /// Whether the triangle abc of vertices of one group lies in its faces.
  bool is_in_group(VertexId a, VertexId b, VertexId c) const;
  /// It was refused for good: nothing yields to it any more.
  void freeze(const FaceTriangle& t);
  bool is_frozen(const FaceTriangle& t) const;
  /// Looks whether p can become a vertex of the refinement of every face that a vertex on this
  /// feature belongs to; finds their cavities. `near` is a vertex of those faces nearby.
  bool probe_faces(const Point3& p, const Feature& feature, VertexId near);
  /// Inserts v into the cavities found by probe_faces for its point and feature.
  /// `splitting` is the subsegment or collar element that v splits.
  void commit_to_faces(VertexId v, SubsegmentId splitting = SubsegmentId());

  // --- domain
  /// Whether labels of cells say which part they belong to (see solid_domain.h).
  bool classified() const { return classified_; }
  void set_classified() { classified_ = true; }
  bool is_in_domain(CellSlot c) const {
    return !triangulation_.is_ghost(c) && (!classified_ || triangulation_.label(c) != kOutside);
  }
  /// Bound on the volume of a cell of its region; 0 if there is none.
  double volume_bound(CellSlot c) const;

  std::size_t bytes() const;

 private:
  void link(SubsegmentId s);
  Incidence3::Range faces_of_lower(const Feature& feature) const;
  double tilt(std::uint32_t face) const;
  void group_faces();
  bool is_in_polygon(std::uint32_t face, VertexId a, VertexId b, VertexId c) const;

  const Complex* complex_;
  Incidence3 incidence_;
  Domain domain_;
  Delaunay3 triangulation_;
  std::vector<Feature> features_;
  std::vector<Subsegment> subsegments_;
  std::vector<std::vector<SubsegmentId>> incident_;  // by vertex
  std::vector<FaceRefinement> faces_;
  std::vector<std::uint32_t> face_numbers_;  // 0, 1, 2, …: the range of one face
  // For each vertex the numbers that it has in the faces of faces_of(its feature), in that order.
  std::vector<std::uint32_t> local_first_;
  std::vector<VertexId> locals_;
  std::vector<std::uint32_t> groups_;  // by face: the first face of its group
  // By face and slot, the birth of the triangle that is frozen.
  std::vector<std::vector<std::uint32_t>> frozen_triangles_;
  std::vector<double> protection_radii_;  // by input vertex
  std::vector<bool> protected_segments_;  // by input segment
  bool tracks_collars_ = false;
  std::unique_ptr<Intestines> intestine_;
  std::vector<TriangleId> stack_;  // scratch
  bool classified_ = false;
  double rounding_ = 0;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_LIVE3_H_
