#ifndef CIRCUMBALL_ALGORITHMS_FEATURE_SIZE_H_
#define CIRCUMBALL_ALGORITHMS_FEATURE_SIZE_H_

#include "refinement/queue.h"
#include "refinement/view.h"

namespace circumball {

/// Estimate feature size in the plane, step 1a: thesis Algorithm 3.2.
///
/// It ends for every valid complex, whatever its angles. Then 1/2 lfs(q0) <= N(q0) <= sqrt 2
/// lfs(q0) for every input vertex q0 (Theorems 3.2 and 3.3); the left side holds throughout.
/// Adjacent segments are not first split at equal lengths.
///
/// Mended: the thesis looks for witnesses among the Delaunay neighbors of the ends of s only. That
/// is not enough for Theorem 3.3. Its proof finds a neighbor p of the end q in the disk, and takes
/// it for a vertex of a segment that shares q; but where s is an end segment of a fan, p may lie on
/// another segment of the fan and hide an input vertex q0 deeper in the disk (N(q0) up to 3 lfs(q0)
/// on random fans). Here every vertex in the disk is looked at: those in a disk are connected by
/// Delaunay edges inside it, so this is as local. Then no input vertex is in the disk of a segment
/// disjoint from it, which is Theorem 3.3 at once; and the proof of Theorem 3.2 holds as it stands:
/// it asks no more of the witness than to be in the disk.
struct FeatureSize {
  static constexpr bool kTriangles = false;
  static constexpr bool kLooksAtNeighbors = true;

  /// Priority: segments may be processed in any order; by birth.
  using Triangles = TrianglesByBirth;

  /// Unacceptability: a segment s is unacceptable if a vertex inside its diametral disk is a
  /// 1-feature size witness for s (printed: a Delaunay neighbor of an endpoint), or if an endpoint
  /// has a Delaunay neighbor inside the disk and s is more than twice the length of the shortest
  /// segment in Spind(s).
  Verdict unacceptable(const View& view, SubsegmentId s) const {
    return view.too_large_an_estimate(s);
  }
  Verdict unacceptable(const View&, TriangleRef) const { return {}; }
  /// The verdict depends on the vertices in the disk, and on the spindle. Where only v is new, or
  /// only the spindle is shorter, the rest need not be looked at again.
  Verdict encroaches(const View& view, SubsegmentId s, VertexId v) const {
    if (!view.encroached_by(s, v)) return {};
    if (view.is_witness(v, s)) return {Reason::kWitness, v, 0};
    return view.too_long_for_spindle(s, v);
  }
  Verdict spindle_shrank(const View& view, SubsegmentId s) const {
    const Verdict inside = view.encroachment(s);
    if (inside.reason == Reason::kMissing) return view.too_large_an_estimate(s);
    return inside ? view.too_long_for_spindle(s, inside.witness) : Verdict{};
  }

  /// Safety: it is safe to split any simplex.
  Verdict safe(const View&, SubsegmentId) const { return {}; }
  Verdict safe(const View&, TriangleRef) const { return {}; }

  /// Action: insert the circumcenter of a segment.
  Proposal action(const View& view, SubsegmentId s) const {
    return insert(view.midpoint(s), Reason::kMidpoint);
  }
  Proposal action(const View&, TriangleRef) const { return {}; }
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_FEATURE_SIZE_H_
