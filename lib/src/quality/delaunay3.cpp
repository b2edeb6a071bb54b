#include <algorithm>
#include <cmath>
#include <limits>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "complex/planar_sweep.h"
#include "feature_size/vectors.h"
#include "quality/context3.h"
#include "quality/convex_boundary.h"
#include "quality/surfaces3.h"

namespace circumball {
namespace {

/// A vertex in the open circumball of a positive cell, or kNoIndex. Exact: the search is for
/// candidates in a ball that surely contains the circumball, each is decided by the predicate.
class BallSearch {
 public:
  explicit BallSearch(const VerifyContext3& context) : context_(context) {
    std::vector<Box3> boxes;
    for (std::uint32_t v = 0; v < context.mesh.vertices.size(); ++v) {
      const Point3& p = context.point(v);
      if (!usable(p.x) || !usable(p.y) || !usable(p.z)) continue;
      vertex_.push_back(v);
      boxes.push_back(Box3::of(p));
    }
    tree_ = BoxTree3(std::move(boxes));
  }

  std::uint32_t find(const VerifyContext3::Cell& cell) const {
    const Point3 &o = context_.point(cell[0]), &p = context_.point(cell[1]),
                 &q = context_.point(cell[2]), &r = context_.point(cell[3]);
    const Point3 a = p - o, b = q - o, c = r - o;
    const Point3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double a2 = dot(a, a), b2 = dot(b, b), c2 = dot(c, c), det = dot(a, bc);
    // With unit roundoff e = 2^-53, coordinates of the differences are off by e, those of the cross
    // products by 4 e |b| |c| at most, so that the determinant is off by 12 e |a| |b| |c|, and the
    // numerator by 12 e of the sum of its terms' bounds. Four times that is granted.
    const double abc = std::sqrt(a2) * std::sqrt(b2) * std::sqrt(c2);
    const double det_error = 0x1p-47 * abc;
    Point3 center = o;
    double reach2 = std::numeric_limits<double>::infinity();
    if (std::fabs(det) > 4 * det_error) {
      const Point3 numerator =
          along(along(Point3{a2 * bc.x, a2 * bc.y, a2 * bc.z}, b2, ca), c2, ab);
      const Point3 d = {numerator.x / (2 * det), numerator.y / (2 * det), numerator.z / (2 * det)};
      const double terms = abc * (std::sqrt(a2) + std::sqrt(b2) + std::sqrt(c2));
      const double radius = std::sqrt(dot(d, d));
      const double error =
          (0x1p-46 * terms + 2 * radius * det_error) / std::fabs(det) + 0x1p-48 * radius;
      center = {o.x + d.x, o.y + d.y, o.z + d.z};
      const double place =
          0x1p-50 * (std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z));
      const double reach = (radius + 2 * error + 2 * place) * (1 + 0x1p-48);
      reach2 = reach * reach;
    }
    std::uint32_t found = kNoIndex;
    tree_.query([&](const Box3& box) { return !(box.distance2(center) > reach2); },
                [&](std::uint32_t i) {
                  const std::uint32_t v = vertex_[i];
                  if (std::find(cell.begin(), cell.end(), v) != cell.end()) return true;
                  if (insphere(o, p, q, r, context_.point(v)) != Sign::kPositive) return true;
                  found = v;
                  return false;
                });
    return found;
  }

 private:
  const VerifyContext3& context_;
  std::vector<std::uint32_t> vertex_;
  BoxTree3 tree_;
};

/// Whether the usable vertices of the mesh lie in one plane. O(n), exact.
bool all_coplanar(const VerifyContext3& context) {
  std::vector<Point3> p;
  for (const Point3& v : context.mesh.vertices)
    if (usable(v.x) && usable(v.y) && usable(v.z)) p.push_back(v);
  if (p.size() < 4) return true;
  const auto collinear = [](const Point3& a, const Point3& b, const Point3& c) {
    return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::kZero &&
           orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::kZero &&
           orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == Sign::kZero;
  };
  std::size_t second = 1;
  while (second < p.size() && p[second] == p[0]) ++second;
  std::size_t third = second + 1;
  while (third < p.size() && collinear(p[0], p[second], p[third])) ++third;
  for (std::size_t i = third + 1; i < p.size(); ++i)
    if (orient3d(p[0], p[second], p[third], p[i]) != Sign::kZero) return false;
  return true;
}

}  // namespace

Check check_delaunay(const VerifyContext3& context) {
  Check check;
  check.name = "delaunay";
  check.bound = 0;
  std::size_t violations = 0;
  const auto fail = [&](std::vector<std::uint32_t> worst, std::string sentence) {
    if (violations++ > 0) return;
    check.worst = std::move(worst);
    check.detail = std::move(sentence);
  };
  const auto list = [](const VerifyContext3::Cell& c) {
    return std::vector<std::uint32_t>(c.begin(), c.end());
  };
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    if (context.positive[i]) continue;
    fail(list(context.cells[i]),
         "cell " + vertices_text(list(context.cells[i])) + " is inverted or flat");
  }
  std::size_t facets = 0;
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    const std::uint32_t t = context.twin[f];
    if (t == kNoIndex || t < f || !context.positive[f / 4] || !context.positive[t / 4]) continue;
    ++facets;
    const auto& c = context.cells[f / 4];
    const std::uint32_t other = context.apex(t);
    if (insphere(context.point(c[0]), context.point(c[1]), context.point(c[2]), context.point(c[3]),
                 context.point(other)) != Sign::kPositive)
      continue;
    const auto corners = context.corners(f);
    std::vector<std::uint32_t> worst = list(c);
    worst.push_back(other);
    fail(worst, "facet " + vertices_text({corners[0], corners[1], corners[2]}) +
                    " is not locally Delaunay: vertex " + std::to_string(other) +
                    " lies inside the circumsphere of " + vertices_text(list(c)));
  }
  std::string scope;
  if (context.closed()) {
    const BallSearch search(context);
    for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
      if (!context.positive[i]) continue;
      const auto& c = context.cells[i];
      const std::uint32_t v = search.find(c);
      if (v == kNoIndex) continue;
      std::vector<std::uint32_t> worst = list(c);
      worst.push_back(v);
      fail(worst, "vertex " + std::to_string(v) + " lies inside the circumsphere of " +
                      vertices_text(list(c)));
    }
    scope = "no vertex lies inside any of the " + count_text(context.cells.size(), "circumsphere");
  } else if (context.cells.empty()) {
    if (!all_coplanar(context))
      fail({}, "there are no cells, though not all vertices are coplanar");
    scope = "there are no cells, and all vertices are coplanar";
  } else {
    std::vector<std::uint32_t> worst;
    const std::string why = why_not_convex(context, &worst);
    if (!why.empty()) fail(worst, "the cells do not tile the convex hull: " + why);
    for (std::uint32_t v = 0; v < context.used.size(); ++v)
      if (!context.used[v])
        fail({v}, "vertex " + std::to_string(v) + " is not a vertex of any cell");
    scope = "the cells tile their convex hull, so that every circumball is empty";
  }
  check.ok = violations == 0;
  check.observed = static_cast<double>(violations);
  if (check.ok)
    check.detail = count_text(facets, "facet") +
                   " between two cells, all locally Delaunay by exact insphere; " + scope;
  else if (violations > 1)
    check.detail += " (" + std::to_string(violations) + " violations in all)";
  return check;
}

/// Theorem 6.15: outside of the tubes about segments the mesh is Delaunay. Inside, where another
/// tetrahedralization takes its place, cells that are not are counted.
Check check_delaunay_outside(const VerifyContext3& context) {
  Check check;
  check.name = "delaunay-outside";
  check.bound = 0;
  const Surfaces3 surfaces(context);
  const BallSearch search(context);
  std::size_t bad = 0, flat = 0, inside = 0, exceptions = 0, first = kNoIndex;
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    const auto& c = context.cells[i];
    const bool in_tube = surfaces.holds_in_tube(c);
    inside += in_tube;
    flat += !context.positive[i];
    if (!context.positive[i] || search.find(c) == kNoIndex) continue;
    if (in_tube) {
      if (exceptions++ == 0) first = i;
    } else if (bad++ == 0) {
      check.worst = {c[0], c[1], c[2], c[3]};
    }
  }
  check.ok = bad + flat == 0;
  check.observed = static_cast<double>(bad + flat);
  if (flat > 0) {
    check.detail = count_text(flat, "cell") + " inverted or flat";
  } else if (bad > 0) {
    check.detail = count_text(bad, "cell") +
                   " outside of the tubes with a vertex in the circumball, the first is " +
                   vertices_text(check.worst);
  } else {
    check.detail = "no vertex lies inside any circumsphere of the " +
                   count_text(context.cells.size() - inside, "cell") + " outside of " +
                   count_text(surfaces.tubes(), "tube") + "; of the " + count_text(inside, "cell") +
                   " inside, " + std::to_string(exceptions) + " are not Delaunay";
    if (exceptions > 0) {
      const auto& c = context.cells[first];
      check.detail += ", the first is cell " + std::to_string(context.cell_number[first]) + ": " +
                      vertices_text({c[0], c[1], c[2], c[3]});
    }
  }
  return check;
}

}  // namespace circumball
