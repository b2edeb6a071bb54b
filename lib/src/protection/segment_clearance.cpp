#include "protection/segment_clearance.h"

#include <algorithm>
#include <cmath>

#include "delaunay/constructions.h"

namespace circumball {
namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Squared height of p above the triangle, where its foot is inside; infinite elsewhere.
double squared_height(const Point3* t, const Point3& p) {
  const Point3 n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const double nn = dot(n, n);
  for (int i = 0; i < 3; ++i) {
    if (dot(cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i])), n) < 0) return HUGE_VAL;
  }
  const double height = dot(minus(p, t[0]), n);
  return nn > 0 ? height * height / nn : HUGE_VAL;
}

/// Squared distance between a segment and a triangle that do not cross.
double squared_distance_to_triangle(const Point3& a, const Point3& b, const Point3* t) {
  double d2 = std::min(squared_height(t, a), squared_height(t, b));
  for (int i = 0; i < 3; ++i) {
    d2 = std::min(d2, squared_distance_of_segments(a, b, t[i], t[(i + 1) % 3]));
  }
  return d2;
}

double squared_distance_of_boxes(const Box3& p, const Box3& q) {
  const double dx = std::max({p.lo_x - q.hi_x, q.lo_x - p.hi_x, 0.0});
  const double dy = std::max({p.lo_y - q.hi_y, q.lo_y - p.hi_y, 0.0});
  const double dz = std::max({p.lo_z - q.hi_z, q.lo_z - p.hi_z, 0.0});
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace

SegmentClearance::SegmentClearance(const Complex& complex, const Incidence3& incidence)
    : incidence_(incidence), complex_(complex) {
  const auto& v = complex.vertices;
  for (std::uint32_t i = 0; i < v.size(); ++i) {
    items_.push_back({FeatureKind::kVertex, i, {v[i], v[i], v[i]}});
  }
  for (std::uint32_t i = 0; i < complex.segments.size(); ++i) {
    const auto& s = complex.segments[i];
    items_.push_back({FeatureKind::kSegment, i, {v[s[0]], v[s[1]], v[s[1]]}});
  }
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    for (const auto& t : triangulate_face(complex, f)) {
      items_.push_back({FeatureKind::kFace, f, {v[t[0]], v[t[1]], v[t[2]]}});
    }
  }
  std::vector<Box3> boxes;
  for (const Item& item : items_) {
    boxes.push_back(Box3::of(item.corner[0], item.corner[1], item.corner[2]));
  }
  tree_ = BoxTree3(std::move(boxes));
}

template <class Skip>
double SegmentClearance::nearest(const Point3& a, const Point3& b, Skip skip) const {
  Box3 box = Box3::of(a);
  box.extend(Box3::of(b));
  double best2 = HUGE_VAL;
  tree_.query([&](const Box3& other) { return squared_distance_of_boxes(box, other) < best2; },
              [&](std::uint32_t i) {
                const Item& item = items_[i];
                if (skip(item)) return true;
                const double d2 =
                    item.kind == FeatureKind::kFace
                        ? squared_distance_to_triangle(a, b, item.corner)
                        : squared_distance_of_segments(a, b, item.corner[0], item.corner[1]);
                best2 = std::min(best2, d2);
                return true;
              });
  return std::sqrt(best2);
}

double SegmentClearance::of(const Point3& a, const Point3& b, std::uint32_t segment) const {
  return nearest(a, b, [&](const Item& item) {
    if (item.kind == FeatureKind::kFace) return incidence_.face_has_segment(item.feature, segment);
    return item.kind == FeatureKind::kSegment && item.feature == segment;
  });
}

double SegmentClearance::of_vertex(std::uint32_t vertex) const {
  const Point3& p = complex_.vertices[vertex];
  return nearest(p, p, [&](const Item& item) {
    if (item.kind == FeatureKind::kFace) return incidence_.face_has_vertex(item.feature, vertex);
    if (item.kind == FeatureKind::kVertex) return item.feature == vertex;
    const auto& ends = complex_.segments[item.feature];
    return ends[0] == vertex || ends[1] == vertex;
  });
}

}  // namespace circumball
