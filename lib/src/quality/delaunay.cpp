#include <algorithm>
#include <cmath>
#include <limits>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "complex/product_sum.h"
#include "quality/context.h"

namespace circumball {
namespace {

bool upward(const Point2& from, const Point2& to) {
  return to.y > from.y || (to.y == from.y && to.x > from.x);
}

/// Whether q is as near to the line pr as rounding can put it, and between its ends.
bool within_rounding(const VerifyContext& context, const Point2& p, const Point2& q,
                     const Point2& r) {
  const double dx = r.x - p.x, dy = r.y - p.y, ux = q.x - p.x, uy = q.y - p.y;
  const double length2 = dx * dx + dy * dy, along = ux * dx + uy * dy;
  return along > 0 && along < length2 &&
         std::fabs(ux * dy - uy * dx) <= 2 * context.rounding * std::sqrt(length2);
}

/// Empty if the boundary of the mesh is one convex polygon, run through once. A mesh of
/// counter-clockwise cells, each edge between at most two, with such a boundary covers the polygon
/// exactly once: every point inside is covered as often as the boundary winds around it. Then
/// locally Delaunay is Delaunay.
/// A boundary that is convex but for the rounding of vertices on it sets `nearly`, and proves
/// nothing of winding.
std::string why_not_convex(const VerifyContext& context, std::vector<std::uint32_t>* worst,
                           bool* nearly) {
  std::vector<std::uint32_t> after(context.mesh.vertices.size(), kNoIndex);
  std::uint32_t start = kNoIndex;
  std::size_t boundary = 0;
  for (std::uint32_t h = 0; h < context.twin.size(); ++h) {
    if (context.twin[h] != kNoIndex) continue;
    const std::uint32_t v = context.origin(h);
    if (after[v] != kNoIndex) {
      *worst = {v};
      return "the boundary passes vertex " + std::to_string(v) + " twice";
    }
    after[v] = context.target(h);
    start = v;
    ++boundary;
  }
  if (start == kNoIndex) return "the mesh has no boundary";
  std::size_t length = 0;
  int turns = 0;
  std::uint32_t u = start;
  do {
    const std::uint32_t v = after[u];
    const std::uint32_t w = v == kNoIndex ? kNoIndex : after[v];
    if (w == kNoIndex) {
      *worst = {u};
      return "the boundary ends at vertex " + std::to_string(u);
    }
    const Point2 p = context.point(u), q = context.point(v), r = context.point(w);
    const Sign turn = orient2d(p, q, r);
    // straight on is fine, straight back is not
    const bool back = turn == Sign::kZero && upward(p, q) != upward(q, r);
    if (turn == Sign::kNegative && !back && within_rounding(context, p, q, r)) {
      *nearly = true;
    } else if (turn == Sign::kNegative || back) {
      *worst = {u, v, w};
      return "the boundary is not convex at vertex " + std::to_string(v) + ", between " +
             vertices_text({u, w});
    }
    if (!upward(p, q) && upward(q, r)) ++turns;
    u = v;
    ++length;
  } while (u != start && length <= boundary);
  if (length != boundary) {
    *worst = {start};
    return "the boundary has several parts";
  }
  if (turns != 1 && !*nearly) {
    *worst = {start};
    return "the boundary winds around more than once";
  }
  return {};
}

/// A vertex in the open circumdisk of a counter-clockwise cell, or kNoIndex. Exact: the search is
/// for candidates in a disk that surely contains the circumdisk, each is decided by the predicate.
class DiskSearch {
 public:
  explicit DiskSearch(const VerifyContext& context) : context_(context) {
    std::vector<Box2> boxes;
    for (std::uint32_t v = 0; v < context.mesh.vertices.size(); ++v) {
      const Point2 p = context.point(v);
      if (!usable(p.x) || !usable(p.y)) continue;
      vertex_.push_back(v);
      boxes.push_back(Box2::of(p));
    }
    tree_ = BoxTree(std::move(boxes));
  }

  std::uint32_t find(const VerifyContext::Cell& cell) const {
    const Point2 a = context_.point(cell[0]), b = context_.point(cell[1]),
                 c = context_.point(cell[2]);
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    const double u2 = ux * ux + uy * uy, v2 = vx * vx + vy * vy;
    const double det = ux * vy - uy * vx;
    const double det_error = 0x1p-50 * (std::fabs(ux * vy) + std::fabs(uy * vx));
    Point2 center = a;
    double reach2 = std::numeric_limits<double>::infinity();
    if (std::fabs(det) > 4 * det_error) {
      // Center minus a; errors of the numerators are below 2^-49 of their terms, that of det is
      // det_error.
      const double nx = u2 * vy - v2 * uy, ny = v2 * ux - u2 * vx;
      const double terms =
          u2 * (std::fabs(vx) + std::fabs(vy)) + v2 * (std::fabs(ux) + std::fabs(uy));
      const double cx = nx / (2 * det), cy = ny / (2 * det);
      const double size = std::fabs(cx) + std::fabs(cy);
      const double error =
          (0x1p-48 * terms + 2 * size * det_error) / std::fabs(det) + 0x1p-49 * size;
      center = {a.x + cx, a.y + cy};
      const double place = 0x1p-51 * (std::fabs(center.x) +
                                      std::fabs(center.y));  // of the sums, here and in distances
      const double reach = (std::sqrt(cx * cx + cy * cy) + 2 * error + 2 * place) * (1 + 0x1p-48);
      reach2 = reach * reach;
    }
    std::uint32_t found = kNoIndex;
    tree_.query([&](const Box2& box) { return !(box.distance2(center) > reach2); },
                [&](std::uint32_t i) {
                  const std::uint32_t v = vertex_[i];
                  if (v == cell[0] || v == cell[1] || v == cell[2]) return true;
                  if (incircle(a, b, c, context_.point(v)) != Sign::kPositive) return true;
                  found = v;
                  return false;
                });
    return found;
  }

 private:
  const VerifyContext& context_;
  std::vector<std::uint32_t> vertex_;
  BoxTree tree_;
};

bool all_collinear(const VerifyContext& context) {
  std::vector<Point2> p;
  for (const Point3& v : context.mesh.vertices)
    if (usable(v.x) && usable(v.y)) p.push_back(xy(v));
  std::size_t second = 1;
  while (second < p.size() && p[second] == p[0]) ++second;
  for (std::size_t i = second + 1; i < p.size(); ++i)
    if (orient2d(p[0], p[second], p[i]) != Sign::kZero) return false;
  return true;
}

}  // namespace

Check check_delaunay(const VerifyContext& context) {
  Check check;
  check.name = "delaunay";
  check.bound = 0;
  std::size_t violations = 0;
  const auto fail = [&](std::vector<std::uint32_t> worst, std::string sentence) {
    if (violations++ > 0) return;
    check.worst = std::move(worst);
    check.detail = std::move(sentence);
  };
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    if (context.positive[i]) continue;
    const auto& c = context.cells[i];
    fail({c[0], c[1], c[2]}, "cell " + vertices_text({c[0], c[1], c[2]}) + " is clockwise or flat");
  }
  std::size_t edges = 0;
  for (std::uint32_t h = 0; h < context.twin.size(); ++h) {
    const std::uint32_t t = context.twin[h];
    if (t == kNoIndex || t < h || !context.positive[h / 3] || !context.positive[t / 3]) continue;
    ++edges;
    const std::uint32_t a = context.origin(h), b = context.target(h), c = context.apex(h),
                        d = context.apex(t);
    if (incircle(context.point(a), context.point(b), context.point(c), context.point(d)) ==
        Sign::kPositive)
      fail({a, b, c, d}, "edge " + vertices_text({a, b}) + " is not locally Delaunay: vertex " +
                             std::to_string(d) + " lies inside the circumcircle of " +
                             vertices_text({a, b, c}));
  }
  const auto search_all = [&] {
    const DiskSearch search(context);
    for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
      if (!context.positive[i]) continue;
      const auto& c = context.cells[i];
      const std::uint32_t v = search.find(c);
      if (v != kNoIndex)
        fail({c[0], c[1], c[2], v}, "vertex " + std::to_string(v) +
                                        " lies inside the circumcircle of " +
                                        vertices_text({c[0], c[1], c[2]}));
    }
    return "no vertex lies inside any of the " + count_text(context.cells.size(), "circumcircle");
  };
  std::string scope;
  if (context.closed()) {
    scope = search_all();
  } else if (context.cells.empty()) {
    if (!all_collinear(context))
      fail({}, "there are no cells, though not all vertices are collinear");
    scope = "there are no cells, and all vertices are collinear";
  } else {
    std::vector<std::uint32_t> worst;
    bool nearly = false;
    const std::string why = why_not_convex(context, &worst, &nearly);
    if (!why.empty()) fail(worst, "the cells do not tile the convex hull: " + why);
    for (std::uint32_t v = 0; v < context.used.size(); ++v) {
      if (!context.used[v])
        fail({v}, "vertex " + std::to_string(v) + " is not a vertex of any cell");
    }
    scope = "the cells tile their convex hull, so that every circumdisk is empty";
    if (nearly) scope = search_all() + "; their boundary is convex but for rounding";
  }
  check.ok = violations == 0;
  check.observed = static_cast<double>(violations);
  if (check.ok)
    check.detail = count_text(edges, "edge") +
                   " between two cells, all locally Delaunay by exact incircle; " + scope;
  else if (violations > 1)
    check.detail += " (" + std::to_string(violations) + " violations in all)";
  return check;
}

}  // namespace circumball
