#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "complex/product_sum.h"
#include "quality/context.h"

namespace circumball {
namespace {

void add_twice_area(const VerifyContext& context, const VerifyContext::Cell& c, ProductSum* sum) {
  for (int k = 0; k < 3; ++k) {
    const Point2 p = context.point(c[k]), q = context.point(c[(k + 1) % 3]);
    sum->add_cross(p.x, p.y, q.x, q.y);
  }
}

/// Area of the convex hull of the vertices (Andrew's chain, exact turns).
double hull_area(const PlanarView& view) {
  std::vector<Point2> points;  // in lexicographic order; seeds are no vertices
  for (std::size_t k = 0; k < view.points.size(); ++k) {
    if (view.vertex[k] != kNoIndex) points.push_back(view.points[k]);
  }
  std::vector<Point2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point2& p = points[pass == 0 ? k : points.size() - 1 - k];
      while (hull.size() >= base + 2 &&
             orient2d(hull[hull.size() - 2], hull[hull.size() - 1], p) != Sign::kPositive)
        hull.pop_back();
      hull.push_back(p);
    }
  }
  ProductSum twice;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Point2 &p = hull[k], &q = hull[(k + 1) % hull.size()];
    twice.add_cross(p.x, p.y, q.x, q.y);
  }
  return 0.5 * twice.value();
}

/// Connected parts of the mesh when its edges on input segments are walls.
struct Parts {
  std::vector<std::uint32_t> part_of_cell;
  std::vector<double> area;                   // of each part
  std::vector<std::uint32_t> representative;  // its cell of largest area
};
Parts find_parts(const VerifyContext& context) {
  std::vector<std::uint8_t> wall(context.twin.size(), 0);
  const ChainFinder finder(context);
  for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
    const Chain chain = finder.find(s);
    for (std::size_t k = 1; k < chain.vertices.size(); ++k) {
      const std::uint32_t h = context.find_edge(chain.vertices[k - 1], chain.vertices[k]);
      if (h == kNoIndex) continue;
      wall[h] = 1;
      if (context.twin[h] != kNoIndex) wall[context.twin[h]] = 1;
    }
  }
  Parts parts;
  parts.part_of_cell.assign(context.cells.size(), kNoIndex);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t start = 0; start < context.cells.size(); ++start) {
    if (parts.part_of_cell[start] != kNoIndex) continue;
    const std::uint32_t part = static_cast<std::uint32_t>(parts.area.size());
    ProductSum twice;
    double largest = -1;
    std::uint32_t representative = start;
    parts.part_of_cell[start] = part;
    stack.assign(1, start);
    while (!stack.empty()) {
      const std::uint32_t c = stack.back();
      stack.pop_back();
      ProductSum mine;
      add_twice_area(context, context.cells[c], &mine);
      twice.add(1, mine.value());
      if (mine.value() > largest) {
        largest = mine.value();
        representative = c;
      }
      for (std::uint32_t h = 3 * c; h < 3 * c + 3; ++h) {
        if (wall[h] || context.twin[h] == kNoIndex) continue;
        const std::uint32_t next = context.twin[h] / 3;
        if (parts.part_of_cell[next] != kNoIndex) continue;
        parts.part_of_cell[next] = part;
        stack.push_back(next);
      }
    }
    parts.area.push_back(0.5 * twice.value());
    parts.representative.push_back(representative);
  }
  return parts;
}

/// For each part the face of the arrangement that its largest cell's centroid lies in (kNoIndex: on
/// a segment).
std::vector<std::uint32_t> locate_parts(const VerifyContext& context, const Parts& parts) {
  std::vector<Point2> centroids;
  for (const std::uint32_t c : parts.representative) {
    const Point2 p = context.point(context.cells[c][0]);
    double x = 0, y = 0;
    for (int k = 1; k < 3; ++k) {
      const Point2 q = context.point(context.cells[c][k]);
      x += q.x - p.x;
      y += q.y - p.y;
    }
    centroids.push_back({p.x + x / 3, p.y + y / 3});
  }
  // The same segments in the same order, and so the same half-edges, swept once more with the
  // centroids.
  const PlanarView view(context.complex, centroids);
  const SweepResult swept = sweep(view);
  std::vector<std::uint32_t> face(centroids.size(), kNoIndex);
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    const std::uint32_t p = view.point_of_seed[i];
    if (p == kNoIndex || swept.through[p] != kNoIndex || view.vertex[p] != kNoIndex) continue;
    const std::uint32_t below = swept.below[p];
    face[i] = below == kNoIndex ? PlanarArrangement::kUnbounded
                                : context.arrangement->left_face(2 * below);
  }
  return face;
}

Check closed_area(const VerifyContext& context, Check check) {
  const PlanarArrangement& faces = *context.arrangement;
  double expected = 0;
  std::size_t inside = 0;
  for (std::uint32_t f = 0; f < faces.face_count(); ++f) {
    if (!context.inside[f]) continue;
    expected += faces.area(f);
    ++inside;
  }
  const Parts parts = find_parts(context);
  const std::vector<std::uint32_t> face = locate_parts(context, parts);
  std::vector<double> covered(faces.face_count(), 0);
  double observed = 0;
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    observed += parts.area[i];
    if (face[i] != kNoIndex) covered[face[i]] += parts.area[i];
  }
  check.bound = expected;
  check.observed = observed;
  const auto cell_of = [&](std::size_t part) {
    const auto& c = context.cells[parts.representative[part]];
    return std::vector<std::uint32_t>{c[0], c[1], c[2]};
  };
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    if (face[i] != kNoIndex && context.inside[face[i]]) continue;
    check.worst = cell_of(i);
    check.detail = "cells outside the domain, of area " + value_text(parts.area[i]) +
                   " around cell " + vertices_text(check.worst);
    return check;
  }
  for (std::uint32_t f = 0; f < faces.face_count(); ++f) {
    if (!context.inside[f] ||
        std::fabs(covered[f] - faces.area(f)) <= context.area_tolerance(faces.area(f)))
      continue;
    for (std::size_t i = 0; i < parts.area.size() && check.worst.empty(); ++i)
      if (face[i] == f) check.worst = cell_of(i);
    check.detail = "a part of the domain has area " + value_text(faces.area(f)) +
                   ", the cells in it add up to " + value_text(covered[f]);
    if (!check.worst.empty()) check.detail += " (around cell " + vertices_text(check.worst) + ")";
    return check;
  }
  check.ok = std::fabs(observed - expected) <= context.area_tolerance(expected);
  check.detail = "the domain has " + count_text(inside, "part") + " of area " +
                 value_text(expected) +
                 " in all, by signed areas of loops of input segments; the cells add up to it in "
                 "each part, within 1e-9";
  if (!check.ok)
    check.detail = "the domain has area " + value_text(expected) + ", the cells add up to " +
                   value_text(observed);
  return check;
}

}  // namespace

Check check_area(const VerifyContext& context) {
  Check check;
  check.name = "area";
  if (context.closed()) {
    if (context.arrangement) return closed_area(context, check);
    check.detail =
        "input segments cross, overlap or have vertices in their interiors: they bound no domain";
    return check;
  }
  const double expected = hull_area(context.view);
  ProductSum twice;
  for (const auto& c : context.cells) add_twice_area(context, c, &twice);
  const double observed = 0.5 * twice.value();
  check.bound = expected;
  check.observed = observed;
  check.ok = std::fabs(observed - expected) <= context.area_tolerance(expected);
  check.detail = std::string("the convex hull of the complex has area ") + value_text(expected) +
                 ", the cells add up to " + value_text(observed) +
                 (check.ok ? ", equal within 1e-9" : "");
  return check;
}

}  // namespace circumball
