#ifndef CIRCUMBALL_COMPLEX_RING_H_
#define CIRCUMBALL_COMPLEX_RING_H_

#include <cstdint>
#include <vector>

#include "circumball/types.h"

/// Rings about input segments, and what is between them (thesis, 6.3.1).
namespace circumball {

/// Where a vertex is on a ring: the number of a base direction times kRingGap, plus the part of the
/// gap to the next one, a dyadic fraction. Rings about one segment that have a key in common have
/// vertices in one half-plane through it.
using RingKey = std::uint64_t;
constexpr RingKey kRingGap = RingKey{1} << 32;

/// A direction across a segment that every ring about it has a vertex in.
struct BaseDirection {
  Point3 direction;               ///< unit
  std::uint32_t face = kNoIndex;  ///< the face that it lies in, if any
  double angle = 0;               ///< about the axis, from the first one; ascending
};

struct RingVertex {
  RingKey key;
  VertexId vertex;
};

/// A circle about a segment, in the plane across it.
struct Ring {
  std::uint32_t tube = kNoIndex;
  Point3 center;
  double radius = 0;
  VertexId about;                   ///< the end of a subsegment that it is at, or behind
  std::uint32_t sphere = kNoIndex;  ///< the input vertex on whose sphere it is, if any
  std::uint32_t next = kNoIndex, previous = kNoIndex;  ///< along the segment
  std::vector<RingVertex> vertices;                    ///< by key

  VertexId at(RingKey key) const;    ///< invalid if there is none
  RingKey key_of(VertexId v) const;  ///< v is a vertex of it
};

/// The surface about an input segment, between the spheres at its ends: frusta between rings.
struct Tube {
  std::uint32_t segment = kNoIndex;
  Point3 origin, axis;  ///< of the segment; unit
  std::vector<BaseDirection> bases;
  std::uint32_t first_ring = kNoIndex;
  /// Distance along the axis, and radius, of the rings that it began with.
  std::vector<Point2> profile;

  /// Direction of a key: that of a base direction, or else the mean of those of the ends of the
  /// dyadic interval that it is the middle of. Square roots alone.
  Point3 direction(RingKey key) const;
  /// Whether p is nearer to the axis than the surface is.
  bool holds(const Point3& p) const;
};

/// How many parts an angle, in radians, is to be divided into so that none exceeds 60 degrees.
unsigned parts_of_sixty_degrees(double angle);

/// Adds directions between those given, which are sorted by their angles, so that gaps are at most
/// 60 degrees, and equal between two given ones. `first` and `second` are the axes that angles
/// count by.
void fill_gaps(std::vector<BaseDirection>* bases, const Point3& first, const Point3& second);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_RING_H_
