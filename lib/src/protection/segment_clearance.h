#ifndef CIRCUMBALL_PROTECTION_SEGMENT_CLEARANCE_H_
#define CIRCUMBALL_PROTECTION_SEGMENT_CLEARANCE_H_

#include <cstdint>
#include <vector>

#include "complex/box_tree.h"
#include "complex/live3.h"

namespace circumball {

/// How far pieces of input segments are from what they do not belong to: mfs_2 in the reading that
/// the collars need (docs/algorithms.md), by a box tree over vertices, segments and the triangles
/// of faces.
class SegmentClearance {
 public:
  explicit SegmentClearance(const Complex& complex, const Incidence3& incidence);

  /// Distance from the piece [a, b] of an input segment to the nearest feature that does not
  /// contain that segment.
  double of(const Point3& a, const Point3& b, std::uint32_t segment) const;
  /// Distance from an input vertex to the nearest feature that does not contain it.
  double of_vertex(std::uint32_t vertex) const;

 private:
  struct Item {
    FeatureKind kind;
    std::uint32_t feature;
    Point3 corner[3];
  };
  template <class Skip>
  double nearest(const Point3& a, const Point3& b, Skip skip) const;

  const Incidence3& incidence_;
  const Complex& complex_;
  std::vector<Item> items_;
  BoxTree3 tree_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_PROTECTION_SEGMENT_CLEARANCE_H_
