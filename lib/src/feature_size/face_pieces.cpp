#include "feature_size/face_pieces.h"

#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "feature_size/vectors.h"

namespace circumball {
namespace {

/// The projection along the axis that is nearest to the normal: coordinates stay exact.
class Flattened {
 public:
  Flattened(const Complex& complex, const Face& face) {
    // The vector area of the loop of the largest area (Newell), doubled.
    double largest2 = 0;
    Point3 normal;
    for (const auto& loop : face.loops) {
      Point3 area;
      for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        const Point3& o = complex.vertices[loop[0]];
        area =
            along(area, 1, cross(complex.vertices[loop[k]] - o, complex.vertices[loop[k + 1]] - o));
      }
      if (!(dot(area, area) > largest2)) continue;
      largest2 = dot(area, area);
      normal = area;
    }
    valid_ = largest2 > 0 && std::isfinite(largest2);
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    axis_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }
  bool valid() const { return valid_; }
  Point2 operator()(const Point3& p) const {
    return axis_ == 0 ? Point2{p.y, p.z} : axis_ == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  }

 private:
  bool valid_ = false;
  int axis_ = 2;
};

/// A side of a loop that is not level, upwards.
struct Side {
  Point2 low, high;
  Point3 from, to;
  std::size_t loop;

  double x(double y) const {
    if (y <= low.y) return low.x;
    if (y >= high.y) return high.x;
    return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
  }
  Point3 at(double y) const {
    if (y <= low.y) return from;
    if (y >= high.y) return to;
    return along(from, (y - low.y) / (high.y - low.y), to - from);
  }
};

/// Of each loop, whether the place is inside it: an odd number of its sides is to the left.
using Signature = std::vector<bool>;

Signature signature_of(const Point2& p, const std::vector<Side>& sides, std::size_t loops) {
  Signature inside(loops, false);
  for (const Side& side : sides)
    if (side.low.y <= p.y && p.y < side.high.y &&
        orient2d(side.low, side.high, p) == Sign::kNegative)
      inside[side.loop] = !inside[side.loop];
  return inside;
}

bool in_range(const Complex& complex, const Face& face) {
  for (const auto& loop : face.loops)
    for (const std::uint32_t v : loop)
      if (v >= complex.vertices.size()) return false;
  return true;
}

bool is_convex(const std::vector<Point2>& corners) {
  const std::size_t n = corners.size();
  Sign turn = Sign::kZero;
  int rises = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 &a = corners[k], &b = corners[(k + 1) % n], &c = corners[(k + 2) % n];
    const Sign here = orient2d(a, b, c);
    if (here == Sign::kZero || (turn != Sign::kZero && here != turn)) return false;
    turn = here;
    if (!(a.y < b.y || (a.y == b.y && a.x < b.x)) && (b.y < c.y || (b.y == c.y && b.x < c.x)))
      ++rises;
  }
  return rises == 1;  // and not a star that winds around twice
}

}  // namespace

FacePieces face_pieces(const Complex& complex, std::uint32_t face) {
  const Face& f = complex.faces[face];
  FacePieces pieces;
  if (!in_range(complex, f)) return pieces;
  const Flattened flat(complex, f);
  if (!flat.valid()) return pieces;

  std::vector<Side> sides;
  std::vector<double> levels;
  std::vector<Point2> corners;
  std::vector<std::uint32_t> loop_number;  // of those with three corners or more
  for (std::uint32_t l = 0; l < f.loops.size(); ++l) {
    const auto& loop = f.loops[l];
    if (loop.size() < 3) continue;
    const std::size_t number = loop_number.size();
    loop_number.push_back(l);
    corners.clear();
    for (const std::uint32_t v : loop) corners.push_back(flat(complex.vertices[v]));
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t next = (k + 1) % loop.size();
      const Side side{corners[k], corners[next], complex.vertices[loop[k]],
                      complex.vertices[loop[next]], number};
      levels.push_back(side.low.y);
      if (side.low.y < side.high.y) sides.push_back(side);
      if (side.low.y > side.high.y)
        sides.push_back({side.high, side.low, side.to, side.from, number});
    }
  }
  const std::size_t loops = loop_number.size();
  if (loops == 1 && f.holes.empty() && is_convex(corners)) {
    const auto& loop = f.loops[loop_number[0]];
    pieces.bounds = loop_number;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
      pieces.triangles.push_back(
          {complex.vertices[loop[0]], complex.vertices[loop[k]], complex.vertices[loop[k + 1]]});
    return pieces;
  }

  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  // Loops do not cross: what is inside of the same loops as a hole point is not separated from it.
  std::vector<Signature> holes;
  for (const Point3& hole : f.holes) holes.push_back(signature_of(flat(hole), sides, loops));
  const Signature outside(loops, false);

  struct Trapezoid {
    std::size_t left, right;
    double low;
  };
  const auto close = [&](const Trapezoid& t, double high) {
    const Side &left = sides[t.left], &right = sides[t.right];
    pieces.triangles.push_back({left.at(t.low), right.at(t.low), right.at(high)});
    pieces.triangles.push_back({left.at(t.low), right.at(high), left.at(high)});
  };
  std::vector<std::uint8_t> bounds(loops, 0);
  std::vector<Trapezoid> open, still_open;
  std::vector<std::size_t> across;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double middle = 0.5 * (levels[k] + levels[k + 1]);
    across.clear();
    for (std::size_t s = 0; s < sides.size(); ++s)
      if (sides[s].low.y <= levels[k] && sides[s].high.y >= levels[k + 1]) across.push_back(s);
    std::sort(across.begin(), across.end(), [&](std::size_t s, std::size_t t) {
      const double x = sides[s].x(middle), y = sides[t].x(middle);
      return x != y ? x < y : s < t;
    });
    Signature inside(loops, false);
    bool in_face = false;
    still_open.clear();
    for (std::size_t s = 0; s < across.size(); ++s) {
      const std::size_t loop = sides[across[s]].loop;
      inside[loop] = !inside[loop];
      const bool was_in_face = in_face;
      in_face = inside != outside && std::find(holes.begin(), holes.end(), inside) == holes.end();
      if (in_face != was_in_face) bounds[loop] = 1;
      if (!in_face || s + 1 == across.size()) continue;
      const auto same = std::find_if(open.begin(), open.end(), [&](const Trapezoid& t) {
        return t.left == across[s] && t.right == across[s + 1];
      });
      still_open.push_back({across[s], across[s + 1], same == open.end() ? levels[k] : same->low});
      if (same != open.end()) open.erase(same);
    }
    for (const Trapezoid& t : open) close(t, levels[k]);
    open = still_open;
  }
  for (const Trapezoid& t : open) close(t, levels.back());
  for (std::size_t loop = 0; loop < loops; ++loop)
    if (bounds[loop]) pieces.bounds.push_back(loop_number[loop]);
  return pieces;
}

}  // namespace circumball
