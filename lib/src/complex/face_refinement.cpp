#include "complex/face_refinement.h"

#include <algorithm>

namespace circumball {

bool FaceRefinement::cavity_holds(TriangleId t) const {
  const auto& cavity = triangulation_.cavity();
  return std::find(cavity.begin(), cavity.end(), t) != cavity.end();
}

bool FaceRefinement::inside(const Delaunay2::Triangle& t) const {
  const Point2 a = point(t.v[0]), b = point(t.v[1]), c = point(t.v[2]);
  return plane_.contains({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
}

}  // namespace circumball
