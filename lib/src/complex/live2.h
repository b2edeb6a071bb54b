#ifndef CIRCUMBALL_COMPLEX_LIVE2_H_
#define CIRCUMBALL_COMPLEX_LIVE2_H_

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"
#include "complex/domain_label.h"
#include "complex/shells.h"
#include "complex/subsegment.h"
#include "delaunay/delaunay2.h"

namespace circumball {

/// The live refinement C' = (P', S') of a 2D complex (thesis, Definition 2.1.3): the Delaunay
/// triangulation of all its vertices, its subsegments, and which triangles belong to the domain.
class Live2 {
 public:
  /// `complex` must be valid (see `check`) and outlive this. Nothing is inserted yet.
  Live2(const Complex& complex, Domain domain);

  const Complex& complex() const { return *complex_; }
  Domain domain() const { return domain_; }
  Delaunay2& triangulation() { return triangulation_; }
  const Delaunay2& triangulation() const { return triangulation_; }

  // --- vertices: each knows its feature from its birth
  const Feature& feature(VertexId v) const { return features_[v.value]; }
  /// The corners of the box are the last four vertices of its complex.
  bool is_box_corner(VertexId v) const {
    const auto given = static_cast<std::uint32_t>(complex_->vertices.size());
    return domain_ == Domain::kBox && v.value < given && v.value + 4 >= given;
  }
  /// Appends a vertex (not inserted) with the smallest feature it lies on.
  VertexId add_vertex(const Point2& p, Feature feature);
  void pop_vertex();

  /// Inserts v into the cavity just probed, splitting the subsegment whose tag is `splitting`.
  /// Where all that dies has one label, so has what is born. Else, where the cavity swallowed a
  /// subsegment, or held triangles that have no label, the new triangles have none either.
  void commit(VertexId v, std::uint32_t splitting);

  // --- subsegments
  std::uint32_t subsegment_count() const { return static_cast<std::uint32_t>(subsegments_.size()); }
  const Subsegment& subsegment(SubsegmentId s) const { return subsegments_[s.value]; }
  void freeze(SubsegmentId s) { subsegments_[s.value].frozen = true; }
  void make_collar(SubsegmentId s) { subsegments_[s.value].is_collar = true; }
  /// The distance at which an input vertex is protected (d of the thesis, 5.2.1); 0: it is not.
  void protect(VertexId q0, double distance);
  double protection_distance(VertexId q0) const {
    return q0.value < protection_.size() ? protection_[q0.value] : 0;
  }
  /// Makes a subsegment of the arc from a to b about a protected input vertex.
  SubsegmentId create_arc(VertexId a, VertexId b, VertexId center);
  /// Keeps the list of subsegments at each vertex from now on (feature sizes want it; it costs
  /// memory).
  void track_incidence();
  const std::vector<SubsegmentId>& subsegments_at(VertexId v) const { return incident_[v.value]; }
  /// The squared length of the shortest end segment at an input vertex; with incidence only.
  double shortest2_at(VertexId q0) const { return shortest2_[q0.value]; }
  /// Concentric shells about the input vertices that are marked, from now on; before the first
  /// split.
  void track_shells(std::vector<bool> centers) { shells_.track(*complex_, std::move(centers)); }
  const Shells& shells() const { return shells_; }
  /// Whether h is an edge on an input segment: what keeps labels apart.
  bool on_segment(HalfEdge h) const {
    const std::uint32_t tag = triangulation_.tag(h);
    return tag != kNone && !subsegments_[tag].is_arc();
  }
  /// The half-edge from a to b, or kNone where the subsegment is not an edge of the triangulation.
  HalfEdge edge_of(SubsegmentId s) const {
    const Subsegment& u = subsegments_[s.value];
    return triangulation_.find_edge(u.a, u.b);
  }
  /// Makes a subsegment of every input segment; tags those that are edges. After the vertices are
  /// in.
  void create_subsegments();
  /// Tags its edge, where there is one. Returns whether there is.
  bool tag_edge(SubsegmentId s);
  /// Ends s; makes (a, m) and (m, b). m is inserted already.
  std::array<SubsegmentId, 2> split(SubsegmentId s, VertexId m);

  // --- domain
  /// Labels every triangle by flooding from outside across untagged edges (levels: see HoleRule).
  /// Triangles that a missing subsegment crosses are not flooded through; they belong to the domain
  /// where it reaches them through other such triangles.
  void classify();
  bool classified() const { return classified_; }
  /// Whether every piece of an input segment is an edge: only then do subsegments keep labels
  /// apart. O(n).
  bool conforms() const;
  /// Whether t is in the domain. Finds a lost label again by a local flood.
  bool in_domain(TriangleId t);
  /// As it stands, without repair: kUnknown counts as inside.
  bool maybe_in_domain(TriangleId t) const {
    return !triangulation_.is_ghost(t) && triangulation_.triangle(t).label != kOutside;
  }
  /// Area bound of the region that t is in; 0 where there is none. Of a triangle without a label,
  /// the least of all: it is asked again when its label is found.
  double area_bound(TriangleId t) const {
    const std::uint32_t label = triangulation_.triangle(t).label;
    if (label == kUnknown) return least_area_bound_;
    return label >= kFirstRegion ? complex_->regions[label - kFirstRegion].max : 0;
  }
  /// A trace wants to know of labels that change while their triangle lives.
  struct Relabeled {
    TriangleId triangle;
    std::uint32_t before;
  };
  void track_labels() { tracking_ = true; }
  /// Those since the last call, each once, with the label that it had then.
  std::vector<Relabeled> take_relabeled();

  std::size_t bytes() const;

 private:
  /// Whether all three vertices of t lie on one input segment: t is flat, but for their rounding.
  /// Such a triangle at the hull lies outside of the subsegments there.
  bool is_pocket(TriangleId t) const;
  void note_length(const Subsegment& s);
  void relabel(TriangleId t, std::uint32_t before, std::uint32_t label);
  void flood_levels(const std::vector<std::uint8_t>& crossed);
  void label_crossed(const std::vector<std::uint8_t>& crossed);
  void mark_crossed(SubsegmentId s, std::vector<std::uint8_t>* crossed) const;

  const Complex* complex_;
  Domain domain_;
  Delaunay2 triangulation_;
  std::vector<Feature> features_;
  std::vector<Subsegment> subsegments_;
  std::vector<double> protection_;  // by input vertex; empty if none is protected
  Shells shells_;
  double least_area_bound_ = 0;  // of all regions; 0 where there is none
  bool classified_ = false;
  std::vector<std::vector<SubsegmentId>> incident_;  // by vertex; empty if not tracked
  std::vector<double> shortest2_;  // by input vertex: of its end segments; empty likewise
  bool tracking_ = false;
  std::vector<Relabeled> relabeled_;
  std::vector<TriangleId> stack_;  // scratch of the local flood
};

/// Whether some segments form a closed loop.
bool encloses_something(const Complex& complex);

/// Whether loops inside loops are holes by nesting (HoleRule::kAuto resolved).
bool holes_by_parity(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_LIVE2_H_
