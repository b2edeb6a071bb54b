#include "refinement/sizing.h"

#include <algorithm>
#include <array>

namespace circumball {

bool Sizing::exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const {
  constexpr int kBoxes = 256;
  struct Piece {
    Point2 a, b, c;
  };
  std::array<Piece, 3 * kBoxes + 4> open;
  int count = 0;
  open[count++] = {a, b, c};
  for (int boxes = 0; count > 0; ++boxes) {
    if (boxes == kBoxes) return true;
    const Piece t = open[--count];
    const auto extent = [](double u, double v, double w) {
      return Interval(std::min(u, std::min(v, w)), std::max(u, std::max(v, w)));
    };
    const Interval h = expression_.over(extent(t.a.x, t.b.x, t.c.x), extent(t.a.y, t.b.y, t.c.y));
    if (h.lo >= radius) continue;
    for (const Point2& p : {t.a, t.b, t.c}) {
      if (expression_.at(p.x, p.y) < radius) return true;
    }
    const auto mid = [](const Point2& p, const Point2& q) {
      return Point2{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
    };
    const Point2 ab = mid(t.a, t.b), bc = mid(t.b, t.c), ca = mid(t.c, t.a);
    open[count++] = {t.a, ab, ca};
    open[count++] = {ab, t.b, bc};
    open[count++] = {ca, bc, t.c};
    open[count++] = {ab, bc, ca};
  }
  return false;
}

}  // namespace circumball
