#ifndef CIRCUMBALL_DELAUNAY_CONSTRUCTIONS_H_
#define CIRCUMBALL_DELAUNAY_CONSTRUCTIONS_H_

#include <cmath>

#include "circumball/types.h"

/// Points that refinement inserts, and the measures that decide which simplices it splits. All are
/// rounded doubles made with + - * / and sqrt alone, so they are the same bits on every platform;
/// each says its error.
namespace circumball {

/// Lengths of constructed pieces (thesis, chapters 3 and 4), and balls whose vertices were rounded
/// onto arcs (chapter 5), are compared strictly with this relative slack: such positions are
/// rounded anyway, and ties are the norm.
constexpr double kLengthSlack = 1 + 1e-10;

inline double squared_distance(const Point2& a, const Point2& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

inline double distance(const Point2& a, const Point2& b) {
  return std::sqrt(squared_distance(a, b));
}

inline double squared_distance(const Point3& a, const Point3& b) {
  const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
  return dx * dx + dy * dy + dz * dz;
}

inline double distance(const Point3& a, const Point3& b) {
  return std::sqrt(squared_distance(a, b));
}

/// Midpoint of ab: each coordinate within half an ulp of (a + b) / 2; the same for ab and ba.
inline Point2 midpoint(const Point2& a, const Point2& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}

inline Point3 midpoint(const Point3& a, const Point3& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}

/// The point of ab at a part s of it from a; each coordinate within 2 ulp of the larger end's.
inline Point3 point_between(const Point3& a, const Point3& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
}

/// The i-th of the points that divide ab into n equal parts; each coordinate within 2 ulp of the
/// larger end's.
inline Point2 division_point(const Point2& a, const Point2& b, unsigned i, unsigned n) {
  const double s = static_cast<double>(i) / n;
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

/// Midpoint of the arc from a to b about `center`, less than half a turn: each coordinate within a
/// few ulp of the largest coordinate, and `radius` from the center but for that.
inline Point2 arc_midpoint(const Point2& center, double radius, const Point2& a, const Point2& b) {
  // a and b are equally far from the center, so that the sum points to the middle.
  const double x = (a.x - center.x) + (b.x - center.x), y = (a.y - center.y) + (b.y - center.y);
  const double scale = radius / std::sqrt(x * x + y * y);
  return {center.x + scale * x, center.y + scale * y};
}

/// Midpoint of the arc from a to b about `center`, less than half a turn, in space: the mean of the
/// two radii; each coordinate within a few ulp of the largest coordinate.
inline Point3 arc_midpoint(const Point3& center, const Point3& a, const Point3& b) {
  const double x = (a.x - center.x) + (b.x - center.x), y = (a.y - center.y) + (b.y - center.y),
               z = (a.z - center.z) + (b.z - center.z);
  const double radius = 0.5 * (distance(center, a) + distance(center, b));
  const double scale = radius / std::sqrt(x * x + y * y + z * z);
  return {center.x + scale * x, center.y + scale * y, center.z + scale * z};
}

/// Whether p lies in the open diametral disk of ab, where a and b were rounded onto an arc: inside
/// by more than the slack, relative to the diameter.
inline bool in_diametral_disk_of_chord(const Point2& a, const Point2& b, const Point2& p) {
  const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
  return dot < (1 - kLengthSlack) * squared_distance(a, b);
}

/// The same of a ball in space, where a and b were rounded into a sloping face, by up to
/// `rounding`.
inline bool in_diametral_ball_of_chord(const Point3& a, const Point3& b, const Point3& p,
                                       double rounding) {
  const double dot =
      (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) + (a.z - p.z) * (b.z - p.z);
  const double length2 = squared_distance(a, b);
  return dot < (1 - kLengthSlack) * length2 - rounding * std::sqrt(length2);
}

/// Shape of a triangle: what RE(t) and R_t (thesis, Definition 2.1.2) are made of.
struct TriangleShape {
  double shortest2, middle2, longest2;  ///< squared edge lengths
  double area4;                         ///< 4 times the area; <= 0 where rounding ate it

  /// RE(t) > tau? With R = abc / 4A, RE^2 = (b^2 / 4A)(c^2 / 4A) for the two longer edges b, c: no
  /// overflow in the range of coordinates. Relative error of the comparison below 1e-14 for
  /// triangles that are near the threshold.
  bool radius_edge_exceeds(double tau) const {
    const double bound = tau * area4;
    return area4 <= 0 || middle2 * longest2 > bound * bound;
  }
  /// Whether the circumcenter is farther from the shortest edge than the off-center is: where
  /// sqrt(RE^2 - 1/4) > tau + sqrt(tau^2 - 1/4).
  bool circumcenter_is_beyond_off_center(double tau) const {
    const double h = tau + std::sqrt(tau * tau - 0.25);
    return radius_edge_exceeds(std::sqrt(h * h + 0.25));
  }
  double radius_edge() const {
    return area4 > 0 ? std::sqrt(middle2) / area4 * std::sqrt(longest2) : HUGE_VAL;
  }
  double circumradius() const {
    return area4 > 0 ? std::sqrt(middle2) / area4 * std::sqrt(longest2) * std::sqrt(shortest2)
                     : HUGE_VAL;
  }
  double area() const { return 0.25 * area4; }
};

inline TriangleShape shape_of(const Point2& a, const Point2& b, const Point2& c) {
  double p = squared_distance(a, b), q = squared_distance(b, c), r = squared_distance(c, a);
  const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (p > q) {
    const double t = p;
    p = q;
    q = t;
  }
  if (q > r) {
    const double t = q;
    q = r;
    r = t;
  }
  if (p > q) {
    const double t = p;
    p = q;
    q = t;
  }
  return {p, q, r, 2 * cross};
}

/// Circumcentre of counter-clockwise abc, relative to a. Relative error about 1e-15 times the
/// squared ratio of the circumradius to the shortest edge; `circumcenter_extended` is for triangles
/// where that is not enough.
inline Point2 circumcenter(const Point2& a, const Point2& b, const Point2& c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double d = 0.5 / (bx * cy - by * cx);
  return {a.x + (cy * b2 - by * c2) * d, a.y + (bx * c2 - cx * b2) * d};
}

/// Off-center of a triangle over its shortest edge pq, the third vertex on the left of it (A.
/// Üngör, Off-centers: a new type of Steiner points, 2004): on the bisector of pq, so far that the
/// new triangle over pq has a radius-edge ratio of just tau. Its height is |pq| (tau + sqrt(tau^2 -
/// 1/4)): the circumcenter of that triangle, and its circumradius above. A little lower, by the
/// slack, so that rounding does not make it a bad triangle. Needs tau > 1/2. Relative error about
/// 1e-16, however thin the triangle.
inline Point2 off_center(const Point2& p, const Point2& q, double tau) {
  const double h = (tau + std::sqrt(tau * tau - 0.25)) / kLengthSlack;  // in |pq|
  const double dx = q.x - p.x, dy = q.y - p.y;
  return {0.5 * (p.x + q.x) - h * dy, 0.5 * (p.y + q.y) + h * dx};
}

/// Squared distance between the segments ab and cd (each may be a point): relative error about
/// 1e-15 times the squared ratio of the longer one to the distance. By the nearest points of the
/// lines, clamped (Ericson, Real-Time Collision Detection, 2005, 5.1.9).
double squared_distance_of_segments(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d);

/// The same as circumcenter, in double-double arithmetic: relative error about 1e-31 times that
/// ratio squared. Not finite for collinear points.
Point2 circumcenter_extended(const Point2& a, const Point2& b, const Point2& c);

}  // namespace circumball

#endif  // CIRCUMBALL_DELAUNAY_CONSTRUCTIONS_H_
