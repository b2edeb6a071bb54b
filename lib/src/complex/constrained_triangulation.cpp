#include "complex/constrained_triangulation.h"

#include <deque>

#include "circumball/predicates.h"

namespace circumball {

ConstrainedTriangulation::ConstrainedTriangulation(
    const std::vector<Point2>& points, const std::vector<std::array<std::uint32_t, 2>>& edges)
    : points_(points) {
  Delaunay2 delaunay;
  delaunay.reserve(points.size());
  for (const Point2& p : points) delaunay.add_vertex(p);
  const auto duplicates =
      delaunay.insert_batch(0, static_cast<std::uint32_t>(points.size()), nullptr);
  valid_ = duplicates.empty();
  triangle_at_.assign(points.size(), kNone);
  if (!valid_ || delaunay.dimension() < 2) return;
  triangles_.resize(delaunay.slot_count());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const Delaunay2::Triangle& from = delaunay.triangle(t);
    for (int i = 0; i < 3; ++i) {
      triangles_[t].v[i] = from.v[i].value;
      triangles_[t].n[i] = from.n[i];
      triangles_[t].edge[i] = kNone;
      if (from.v[i] != Delaunay2::kGhost) triangle_at_[from.v[i].value] = t;
    }
  }
  bool flipped = false;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const std::uint32_t a = edges[e][0], b = edges[e][1];
    if (a == b) continue;
    HalfEdge h = find_edge(a, b);
    if (h == kNone) {
      flipped = true;
      if (!recover(a, b) || (h = find_edge(a, b)) == kNone) {
        valid_ = false;
        triangles_.clear();
        return;
      }
    }
    if (triangles_[h >> 2].edge[h & 3] == kNone) constrain(h, e);
  }
  if (flipped) make_delaunay();
}

HalfEdge ConstrainedTriangulation::some_outgoing(std::uint32_t point) const {
  const std::uint32_t t = triangle_at_[point];
  if (t == kNone) return kNone;
  for (std::uint32_t i = 0; i < 3; ++i)
    if (triangles_[t].v[i] == point) return 4 * t + (i + 2) % 3;
  return kNone;
}

/// By turns about a and about b: O(the lesser degree).
HalfEdge ConstrainedTriangulation::find_edge(std::uint32_t a, std::uint32_t b) const {
  const HalfEdge first_a = some_outgoing(a), first_b = some_outgoing(b);
  if (first_a == kNone || first_b == kNone) return kNone;
  HalfEdge from_a = first_a, from_b = first_b;
  do {
    if (target(from_a) == b) return from_a;
    if (target(from_b) == a) return twin(from_b);
    from_a = twin(prev(from_a));
    from_b = twin(prev(from_b));
  } while (from_a != first_a && from_b != first_b);
  return kNone;
}

void ConstrainedTriangulation::link(HalfEdge h, HalfEdge g) {
  triangles_[h >> 2].n[h & 3] = g;
  triangles_[g >> 2].n[g & 3] = h;
}

void ConstrainedTriangulation::constrain(HalfEdge h, std::uint32_t edge) {
  const HalfEdge g = twin(h);
  triangles_[h >> 2].edge[h & 3] = edge;
  triangles_[g >> 2].edge[g & 3] = edge;
}

/// Whether the two triangles at an edge form a strictly convex quadrilateral.
bool ConstrainedTriangulation::convex(HalfEdge h) const {
  const std::uint32_t a = apex(h), b = origin(h), c = target(h), d = apex(twin(h));
  if (a == kGhost || b == kGhost || c == kGhost || d == kGhost) return false;
  return orient2d(points_[a], points_[b], points_[d]) == Sign::kPositive &&
         orient2d(points_[d], points_[c], points_[a]) == Sign::kPositive;
}

/// Replaces the edge bc of abc and dcb by ad: the slots of h and its twin become abd and dca.
void ConstrainedTriangulation::flip(HalfEdge h) {
  const HalfEdge g = twin(h);
  const HalfEdge ca = next(h), bd = next(g);
  const std::uint32_t a = apex(h), b = origin(h), c = target(h), d = apex(g);
  const HalfEdge beyond_ca = twin(ca), beyond_bd = twin(bd);
  Triangle &t = triangles_[h >> 2], &u = triangles_[g >> 2];
  const std::uint32_t edge_ca = t.edge[ca & 3], edge_bd = u.edge[bd & 3];
  t.v[prev(h) & 3] = d;  // where c was; the edge ab keeps its place
  u.v[prev(g) & 3] = a;  // where b was; the edge dc keeps its place
  t.edge[h & 3] = edge_bd;
  u.edge[g & 3] = edge_ca;
  t.edge[ca & 3] = u.edge[bd & 3] = kNone;
  link(h, beyond_bd);
  link(g, beyond_ca);
  link(ca, bd);
  triangle_at_[a] = triangle_at_[b] = triangle_at_[d] = h >> 2;
  triangle_at_[c] = g >> 2;
}

/// Flips until ab is an edge. False if it crosses a constraint or passes through a point.
bool ConstrainedTriangulation::recover(std::uint32_t a, std::uint32_t b) {
  const auto side = [&](std::uint32_t p) {
    return static_cast<int>(orient2d(points_[a], points_[b], points_[p]));
  };
  const HalfEdge first = some_outgoing(a);
  if (first == kNone) return false;
  HalfEdge h = first, crossed = kNone;
  do {  // the triangle at a that ab leaves through
    const std::uint32_t p = target(h), q = apex(h);
    if (p != kGhost && q != kGhost && side(p) < 0 && side(q) > 0) {
      crossed = next(h);
      break;
    }
    h = twin(prev(h));
  } while (h != first);
  if (crossed == kNone) return false;
  std::deque<std::array<std::uint32_t, 2>> crossing;
  for (;;) {
    if (triangles_[crossed >> 2].edge[crossed & 3] != kNone) return false;
    crossing.push_back({origin(crossed), target(crossed)});
    const HalfEdge across = twin(crossed);
    const std::uint32_t p = apex(across);
    if (p == b) break;
    if (p == kGhost) return false;
    const int s = side(p);
    if (s == 0) return false;
    // Right of ab are the origins of the edges that ab crosses, and the origins of their twins are
    // left of it.
    crossed = s > 0 ? next(across) : prev(across);
  }
  // Each pass over the crossing edges flips at least one of them so that it crosses no more (Sloan
  // 1993); so the bound is never reached.
  const std::uint64_t k = crossing.size();
  std::uint64_t left = k * k + 4 * k;
  while (!crossing.empty()) {
    if (left-- == 0) return false;
    const std::array<std::uint32_t, 2> edge = crossing.front();
    crossing.pop_front();
    const HalfEdge e = find_edge(edge[0], edge[1]);
    if (e == kNone) return false;
    if (!convex(e)) {
      crossing.push_back(edge);
      continue;
    }
    const std::uint32_t p = apex(e), q = apex(twin(e));
    flip(e);
    if (p == a || p == b || q == a || q == b) continue;
    if (side(p) * side(q) < 0) crossing.push_back({p, q});
  }
  return true;
}

void ConstrainedTriangulation::make_delaunay() {
  std::vector<HalfEdge> stack;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) stack.push_back(4 * t + i);
  while (!stack.empty()) {
    const HalfEdge h = stack.back();
    stack.pop_back();
    if (triangles_[h >> 2].edge[h & 3] != kNone) continue;
    const std::uint32_t a = apex(h), b = origin(h), c = target(h), d = apex(twin(h));
    if (a == kGhost || b == kGhost || c == kGhost || d == kGhost) continue;
    if (incircle(points_[a], points_[b], points_[c], points_[d]) != Sign::kPositive) continue;
    const HalfEdge g = twin(h);
    flip(h);
    for (const HalfEdge e : {h, g, prev(h), prev(g)}) stack.push_back(e);
  }
}

}  // namespace circumball
