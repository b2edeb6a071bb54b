#include "quality/convex_boundary.h"

#include <algorithm>
#include <array>

#include "circumball/predicates.h"

namespace circumball {
namespace {

/// The boundary of a mesh as a surface: facets with corners counter-clockwise seen from outside.
class Boundary {
 public:
  explicit Boundary(const VerifyContext3& context) : context_(context) {
    for (std::uint32_t f = 0; f < context.twin.size(); ++f)
      if (context.twin[f] == kNoIndex) facets_.push_back(context.corners(f));
  }

  std::string why_not_convex(std::vector<std::uint32_t>* worst) {
    if (facets_.empty()) return "the mesh has no boundary";
    std::string why = pair_edges(worst);
    if (why.empty()) why = look_at_edges(worst);
    if (why.empty()) why = look_at_vertices(worst);
    return why;
  }

 private:
  using Facet = VerifyContext3::Facet;
  const Point3& point(std::uint32_t v) const { return context_.point(v); }
  std::uint32_t origin(std::uint32_t h) const { return facets_[h / 3][h % 3]; }
  std::uint32_t target(std::uint32_t h) const { return facets_[h / 3][(h % 3 + 1) % 3]; }
  std::uint32_t apex(std::uint32_t h) const { return facets_[h / 3][(h % 3 + 2) % 3]; }
  static std::uint32_t next(std::uint32_t h) { return h - h % 3 + (h % 3 + 1) % 3; }

  /// Half-edge 3 f + i runs from corner i to the next; finds the other half of each.
  std::string pair_edges(std::vector<std::uint32_t>* worst) {
    const auto halves = static_cast<std::uint32_t>(3 * facets_.size());
    std::vector<std::uint32_t> order(halves);
    for (std::uint32_t h = 0; h < halves; ++h) order[h] = h;
    const auto key = [&](std::uint32_t h) {
      return std::array<std::uint32_t, 2>{std::min(origin(h), target(h)),
                                          std::max(origin(h), target(h))};
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
      return key(g) != key(h) ? key(g) < key(h) : g < h;
    });
    twin_.assign(halves, kNoIndex);
    for (std::size_t i = 0; i < halves; i += 2) {
      const bool two = i + 1 < halves && key(order[i]) == key(order[i + 1]);
      const bool more = i + 2 < halves && two && key(order[i]) == key(order[i + 2]);
      if (!two || more || origin(order[i]) == origin(order[i + 1])) {
        *worst = {origin(order[i]), target(order[i])};
        return "the boundary is no surface at the edge " + vertices_text(*worst);
      }
      twin_[order[i]] = order[i + 1];
      twin_[order[i + 1]] = order[i];
    }
    // In one piece?
    std::vector<std::uint8_t> seen(facets_.size(), 0);
    std::vector<std::uint32_t> stack = {0};
    seen[0] = 1;
    std::size_t count = 1;
    while (!stack.empty()) {
      const std::uint32_t f = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::uint32_t g = twin_[h] / 3;
        if (seen[g]) continue;
        seen[g] = 1;
        ++count;
        stack.push_back(g);
      }
    }
    return count == facets_.size() ? std::string() : "the boundary has several parts";
  }

  /// Corners in a coordinate plane onto which the facet is not projected to a line.
  std::array<Point2, 4> flattened(const Facet& f, std::uint32_t other) const {
    std::array<Point2, 4> p;
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < 4; ++i) p[i] = flattened(i < 3 ? f[i] : other, axis);
      if (orient2d(p[0], p[1], p[2]) != Sign::kZero) break;
    }
    return p;
  }
  Point2 flattened(std::uint32_t v, int axis) const {
    const Point3& q = point(v);
    return axis == 0 ? Point2{q.y, q.z} : axis == 1 ? Point2{q.z, q.x} : Point2{q.x, q.y};
  }

  std::string look_at_edges(std::vector<std::uint32_t>* worst) {
    strict_.assign(twin_.size(), 0);
    for (std::uint32_t h = 0; h < twin_.size(); ++h) {
      const std::uint32_t t = twin_[h];
      const Facet f = {origin(h), target(h), apex(h)};
      const Sign bend = orient3d(point(f[0]), point(f[1]), point(f[2]), point(apex(t)));
      bool fine = bend == Sign::kPositive;
      strict_[h] = fine ? 1 : 0;
      if (bend == Sign::kZero) {  // flat is fine, folded is not
        const auto p = flattened(f, apex(t));
        const Sign one = orient2d(p[0], p[1], p[2]), other = orient2d(p[0], p[1], p[3]);
        fine = static_cast<int>(one) * static_cast<int>(other) < 0;
      }
      if (fine) continue;
      *worst = {f[0], f[1], f[2], apex(t)};
      return "the boundary is not convex at the edge " + vertices_text({f[0], f[1]}) +
             ", between " + vertices_text({f[2], apex(t)});
    }
    return {};
  }

  /// The link of v, from half-edge h, which starts there: counter-clockwise seen from outside.
  std::vector<std::uint32_t> link(std::uint32_t h) const {
    std::vector<std::uint32_t> around;
    std::uint32_t at = h;
    do {
      around.push_back(at);
      at = twin_[next(next(at))];
    } while (at != h && around.size() <= twin_.size());
    return around;
  }

  std::string look_at_vertices(std::vector<std::uint32_t>* worst) {
    std::vector<std::uint32_t> degree(context_.mesh.vertices.size(), 0);
    for (const Facet& f : facets_)
      for (const std::uint32_t v : f) ++degree[v];
    std::vector<std::uint8_t> seen(degree.size(), 0);
    for (std::uint32_t h = 0; h < twin_.size(); ++h) {
      const std::uint32_t v = origin(h);
      if (seen[v]) continue;
      seen[v] = 1;
      std::vector<std::uint32_t> around = link(h);
      const auto bend = std::find_if(around.begin(), around.end(),
                                     [&](std::uint32_t g) { return strict_[g] != 0; });
      bool fine = around.size() == degree[v];
      if (fine && bend == around.end()) {
        fine = winds_once(v, around);
      } else if (fine) {
        std::rotate(around.begin(), bend, around.end());
        fine = is_convex_cone(v, around);
      }
      if (fine) continue;
      *worst = {v};
      return "the boundary is not convex at vertex " + std::to_string(v);
    }
    return {};
  }

  /// For a vertex in the middle of a flat part: its neighbors go around it once. The direction to
  /// them turns from below to above once in every turn.
  bool winds_once(std::uint32_t v, const std::vector<std::uint32_t>& around) const {
    const Facet f = {v, target(around[0]), target(around[1])};
    int axis = 0;
    while (axis < 2 && orient2d(flattened(f[0], axis), flattened(f[1], axis),
                                flattened(f[2], axis)) == Sign::kZero)
      ++axis;
    const Point2 center = flattened(v, axis);
    const auto above = [&](std::uint32_t h) {
      const Point2 p = flattened(target(h), axis);
      return p.y > center.y || (p.y == center.y && p.x > center.x);
    };
    int turns = 0;
    for (std::size_t i = 0; i < around.size(); ++i)
      turns += !above(around[i]) && above(around[(i + 1) % around.size()]) ? 1 : 0;
    return turns == 1;
  }

  /// For a vertex with a strictly convex edge, to p0 = the first of its neighbors p: all of them in
  /// the wedge of the two facets at that edge (of less than half a turn), and seen from it one
  /// after the other. A polygon that is convex at its corners and star-shaped from one is convex.
  bool is_convex_cone(std::uint32_t v, const std::vector<std::uint32_t>& around) const {
    const Point3 &o = point(v), &p0 = point(target(around[0])), &p1 = point(target(around[1])),
                 &last = point(target(around.back()));
    for (std::size_t i = 1; i < around.size(); ++i) {
      const Point3& p = point(target(around[i]));
      if (orient3d(o, p0, p1, p) == Sign::kNegative) return false;
      if (orient3d(o, last, p0, p) == Sign::kNegative) return false;
      if (i + 1 == around.size()) break;
      const Point3& q = point(target(around[i + 1]));
      if (orient3d(o, p0, p, q) == Sign::kNegative) return false;
    }
    return true;
  }

  const VerifyContext3& context_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint8_t> strict_;
};

/// A cell, other than the first positive one, that holds the middle of that one; kNoIndex if none.
std::uint32_t second_cover(const VerifyContext3& context) {
  std::size_t first = 0;
  while (first < context.cells.size() && !context.positive[first]) ++first;
  if (first == context.cells.size()) return kNoIndex;
  const auto corner = [&](std::size_t cell, std::size_t i) -> const Point3& {
    return context.point(context.cells[cell][i]);
  };
  Point3 x;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3& p = corner(first, i);
    x = {x.x + 0.25 * p.x, x.y + 0.25 * p.y, x.z + 0.25 * p.z};
  }
  const auto inside = [&](std::size_t cell) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto f = context.corners(static_cast<std::uint32_t>(4 * cell) + i);
      if (orient3d(context.point(f[0]), context.point(f[1]), context.point(f[2]), x) !=
          Sign::kPositive)
        return false;
    }
    return true;
  };
  if (!inside(first)) return kNoIndex;  // too flat to have a middle: nothing is shown
  for (std::size_t c = first + 1; c < context.cells.size(); ++c)
    if (context.positive[c] && inside(c)) return static_cast<std::uint32_t>(c);
  return kNoIndex;
}

}  // namespace

std::string why_not_convex(const VerifyContext3& context, std::vector<std::uint32_t>* worst) {
  std::string why = Boundary(context).why_not_convex(worst);
  if (!why.empty()) return why;
  const std::uint32_t again = second_cover(context);
  if (again == kNoIndex) return {};
  worst->assign(context.cells[again].begin(), context.cells[again].end());
  return "the cell " + vertices_text(*worst) + " overlaps another";
}

}  // namespace circumball
