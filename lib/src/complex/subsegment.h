#ifndef CIRCUMBALL_COMPLEX_SUBSEGMENT_H_
#define CIRCUMBALL_COMPLEX_SUBSEGMENT_H_

#include "circumball/types.h"

namespace circumball {

/// A subsegment: its slot in Live2 or Live3 is its identity; in the plane also the tag of its edge.
/// Splitting ends it and makes two new ones.
using SubsegmentId = Id<struct SubsegmentTag>;

struct Subsegment {
  VertexId a, b;
  SegmentId segment;  ///< the input segment (of the complex with its box) that it lies on
  bool alive = true;
  bool frozen = false;     ///< it was refused for good: nothing yields to it any more
  bool is_collar = false;  ///< a collar simplex (thesis, 5.2.1, 6.2.1): never split
  /// Valid for an arc of the circle that protects this input vertex (thesis, 5.3.1); its edge is
  /// the chord. An arc lies on no input segment, and is no boundary of the domain.
  VertexId center = {};
  /// In space, of a collar segment or collar arc (thesis, Table 6.1): the face that it lies in. It
  /// lies on no input segment.
  std::uint32_t face = kNoIndex;
  /// In space, of an arc of a ring (thesis, 6.3.1): its number in the intestine. It lies on no
  /// input segment and in no face.
  std::uint32_t ring = kNoIndex;
  /// In space, of a piece of a tube's generator that lies in no face: the ring before it.
  bool is_generator = false;
  bool is_ring_arc() const { return ring != kNoIndex && !is_generator; }
  bool is_of_tube() const { return ring != kNoIndex; }
  bool is_collar_element() const { return face != kNoIndex; }
  bool is_arc() const { return center.valid(); }
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_SUBSEGMENT_H_
