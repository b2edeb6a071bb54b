#ifndef CIRCUMBALL_COMPLEX_SPACE_VIEW_H_
#define CIRCUMBALL_COMPLEX_SPACE_VIEW_H_

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "circumball/complex.h"
#include "complex/face_triangulation.h"

namespace circumball {

/// What of a 3D complex can be reasoned about: usable segments without duplicates, by their ends.
struct SpaceView {
  struct Incident {
    std::uint32_t neighbor, segment;
  };
  std::vector<std::uint8_t> usable_vertex;
  std::vector<std::uint32_t> segments;   ///< of the complex, the first of duplicates; ascending
  std::vector<std::uint32_t> canonical;  ///< of each segment: the first with its ends, or kNoIndex
  std::vector<std::uint32_t> first;      ///< vertices + 1: where the star of a vertex begins
  std::vector<Incident> star;            ///< ascending by neighbor
  /// Pairs (duplicate, first segment with the same ends), in order.
  std::vector<std::array<std::uint32_t, 2>> duplicate_segments;

  explicit SpaceView(const Complex& complex);
  std::uint32_t degree(std::uint32_t v) const { return first[v + 1] - first[v]; }
  /// The segment between two vertices, or kNoIndex. O(log degree).
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
};

/// A face as `check` sees it: its own triangles, exact, on its vertices.
///
/// Members of a face (its vertices by number) are in its plane as far as the tolerance of planarity
/// says, and whatever is between members is decided in the face's projection: exactly, as if the
/// face were planar. To everything else the face is the surface of its triangles in space, the same
/// as it looks, to within that tolerance; contacts with it are decided exactly, too. So no decision
/// but planarity itself depends on a tolerance.
struct FaceSurface {
  std::vector<std::uint32_t> members;  ///< ascending; empty if the face is not usable
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< empty if it has none
  std::vector<std::uint8_t> inner;                      ///< as in FaceTriangles
  FaceProjection projection;
  bool has_member(std::uint32_t v) const;
};

/// Pairs of features whose relative interiors meet, each with the face in whose plane they do, or
/// kNoIndex.
using MeetingMap = std::map<std::array<std::uint32_t, 2>, std::uint32_t>;
struct SpaceMeetings {
  MeetingMap vertex_on_segment, segments_cross, segments_overlap, segment_in_face, vertex_in_face;
  bool incomplete = false;
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_SPACE_VIEW_H_
