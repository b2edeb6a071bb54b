#ifndef CIRCUMBALL_ALGORITHMS_TERMINATOR_H_
#define CIRCUMBALL_ALGORITHMS_TERMINATOR_H_

#include <memory>

#include "algorithms/ruppert.h"
#include "refinement/stage.h"

namespace circumball {

/// Marks the input vertices of acute angles: concentric shells are drawn about them.
std::unique_ptr<Stage> mark_shell_centers();

/// The part of the terminator about segments alone (see Conform): its Action.
struct ConformOnShells : Conform {
  using Conform::action;
  /// Action: an end segment at an input vertex of an acute angle is split on the shell about that
  /// vertex, of a radius that is a power of two, nearest to its middle; any other segment at its
  /// midpoint.
  Proposal action(const View& view, SubsegmentId s) const {
    if (const auto shell = view.shell_of(s)) {
      return insert(view.shell_point(s, *shell), Reason::kShell);
    }
    return insert(view.midpoint(s), Reason::kMidpoint);
  }
};

/// What the field does at small angles: Ruppert's concentric shells (Ruppert 1995, section 5), and
/// Shewchuk's terminator (J. R. Shewchuk, Mesh Generation for Domains with Small Angles, 2000;
/// Delaunay Refinement Algorithms for Triangular Mesh Generation, 2002) in its later form with
/// seditious edges (S.-W. Cheng, T. K. Dey, J. R. Shewchuk, Delaunay Mesh Generation, 2013, 6.6),
/// which is the rule of G. L. Miller, S. E. Pav and N. J. Walkington (When and Why Ruppert's
/// Algorithm Works, 2003). The paper of 2000 compares insertion radii across a cluster of segments
/// instead; that is not built here.
///
/// Wherever it ends, the mesh conforms, and every triangle with RE(t) > tau has a seditious
/// shortest edge. Miller, Pav and Walkington prove the end for every complex up to 26.45 degrees,
/// where segments at acute angles were cut beforehand so that their lengths agree modulo powers of
/// two. Here that comes about as they are split; tested, not proved (docs/algorithms.md).
struct Terminator : Ruppert {
  using Ruppert::safe;
  /// Safety: a triangle with RE(t) > tau is not safe to split if its shortest edge is seditious:
  /// its ends lie in two input segments that meet at less than 60 degrees, equally far from there.
  /// That edge is as short as the angle makes it, and splitting would only make the next one. A
  /// triangle that is too large is split all the same.
  Verdict safe(const View& view, TriangleRef t) const {
    if (!view.shortest_edge_is_seditious(t) || too_large(view, t, view.shape(t))) return {};
    return {Reason::kSeditious, VertexId(), 0};
  }

  using Ruppert::action;
  /// Action: as Ruppert's, but for end segments at acute angles.
  Proposal action(const View& view, SubsegmentId s) const {
    return ConformOnShells().action(view, s);
  }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_TERMINATOR_H_
