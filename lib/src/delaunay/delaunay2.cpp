#include "delaunay/delaunay2.h"

#include <cassert>
#include <cmath>

#include "predicates/fast.h"

namespace circumball {
namespace {

/// Lexicographic order: along a line it is an order of its points, and exact.
bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Exact in sign only.
double orient(const Point2& a, const Point2& b, const Point2& c) {
  return orient2d_filtered(a.x, a.y, b.x, b.y, c.x, c.y);
}
double in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return incircle_filtered(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y);
}

/// Which corner of a triangle is kGhost; 3 if none.
std::uint32_t ghost_corner(const Delaunay2::Triangle& t) {
  for (std::uint32_t i = 0; i < 3; ++i)
    if (t.v[i] == Delaunay2::kGhost) return i;
  return 3;
}

}  // namespace

constexpr VertexId Delaunay2::kGhost;
constexpr std::uint32_t Delaunay2::kNext[3], Delaunay2::kPrev[3];

void Delaunay2::reserve(std::size_t vertices) {
  points_.reserve(vertices);
  triangle_of_.reserve(vertices);
  triangles_.reserve(2 * vertices);
}

void Delaunay2::set_tag(HalfEdge h, std::uint32_t tag) {
  if (tags_.empty()) {
    if (tag == kNone) return;
    tags_.reserve(4 * triangles_.capacity());
    tags_.resize(4 * triangles_.size(), kNone);
  }
  tags_[h] = tag;
  tags_[twin(h)] = tag;
}

std::size_t Delaunay2::bytes() const {
  return points_.capacity() * sizeof(Point2) + triangle_of_.capacity() * sizeof(TriangleId) +
         triangles_.capacity() * sizeof(Triangle) + tags_.capacity() * sizeof(std::uint32_t) +
         ring_.capacity() * sizeof(RingEdge) + inheritance_.capacity() * sizeof(Inheritance) +
         pending_.capacity() * sizeof(Sight) +
         (cavity_.capacity() + boundary_.capacity() + tagged_inside_.capacity() +
          born_.capacity()) *
             sizeof(std::uint32_t) +
         died_.capacity() * sizeof(Triangle);
}

inline Delaunay2::Sight Delaunay2::sight(VertexId v, const Point2& p, HalfEdge h) const {
  if (v == kGhost) return {0, 0, 0, v, h};
  const double x = point(v).x - p.x, y = point(v).y - p.y;
  return {x, y, x * x + y * y, v, h};
}

// orient2d_filtered of (a, b, p), with the offsets that are known: the same roundings, the same
// bound.
inline double Delaunay2::turn(const Sight& a, const Sight& b, const Point2& p) const {
  const double left = a.x * b.y, right = a.y * b.x, det = left - right;
  if (std::fabs(det) >= internal::kOrient2dBound * std::fabs(right)) return det;
  return orient(point(a.v), point(b.v), p);
}

// ---- point location -----------------------------------------------------------------------------

TriangleId Delaunay2::locate(const Point2& p, TriangleId hint) const {
  if (dimension_ < 1) return kNone;
  if (!alive(hint)) hint = last_born_;
  return dimension_ == 1 ? walk_on_line(p, hint) : walk(p, hint);
}

// A visibility walk that does not look back across the edge it came through. Offsets from p are
// carried from triangle to triangle: a step looks at one new vertex.
TriangleId Delaunay2::walk(const Point2& p, TriangleId t) const {
  HalfEdge o;  // the edge that we came through, from b to a; p is on its left, or on it
  {
    const Triangle& at = triangles_[t];
    const std::uint32_t g = ghost_corner(at), i = g < 3 ? g : 0;
    const double side = orient(point(at.v[kNext[i]]), point(at.v[kPrev[i]]), p);
    if (g < 3 && side > 0) return t;
    o = g < 3 || side < 0 ? at.n[i] : 4 * t + i;
  }
  Sight b = sight(origin(o), p, kNone), a = sight(target(o), p, kNone);
  for (;;) {
    t = o >> 2;
    const Triangle& at = triangles_[t];
    const std::uint32_t i = o & 3;
    if (at.v[i] == kGhost) return t;
    const Sight c = sight(at.v[i], p, kNone);
    if (turn(a, c, p) < 0) {
      b = c;
      o = at.n[kNext[i]];
    } else if (turn(c, b, p) < 0) {
      a = c;
      o = at.n[kPrev[i]];
    } else {
      return t;
    }
  }
}

// Dimension 1: the ghost on p's side of the line; for p on the line, a ghost (a, b, kGhost) with p
// in the closed edge ab, or beyond b at the end of the chain.
TriangleId Delaunay2::walk_on_line(const Point2& p, TriangleId t) const {
  bool first = true;
  for (;;) {
    const Triangle& at = triangles_[t];
    const std::uint32_t g = ghost_corner(at);
    const Point2 &a = point(at.v[kNext[g]]), &b = point(at.v[kPrev[g]]);
    const TriangleId mirror = at.n[g] >> 2;
    if (first) {
      const double side = orient(a, b, p);
      if (side > 0) return t;
      if (side < 0) return mirror;
      first = false;
    }
    const bool forward = before(a, b);
    if (forward ? before(p, a) : before(a, p)) {
      t = mirror;  // p is behind a: turn round
      continue;
    }
    if (forward ? before(b, p) : before(p, b)) {
      const TriangleId ahead = at.n[kNext[g]] >> 2;
      if (ahead == mirror) return t;  // b is the end
      t = ahead;
      continue;
    }
    return t;
  }
}

// ---- probe --------------------------------------------------------------------------------------

bool Delaunay2::in_conflict(const Triangle& t, const Point2& p, std::uint32_t number) const {
  const std::uint32_t g = ghost_corner(t);
  if (g < 3) {
    const Point2 &a = point(t.v[kNext[g]]), &b = point(t.v[kPrev[g]]);
    const double side = orient(a, b, p);
    if (side != 0) return side > 0;
    return before(a, b) ? before(a, p) && before(p, b) : before(b, p) && before(p, a);
  }
  const double in = in_circle(point(t.v[0]), point(t.v[1]), point(t.v[2]), p);
  return in > 0 || (in == 0 && wins_tie(t, p, number));
}

// Four distinct cocircular points: the one of the highest number is lifted most. If it is p, it is
// outside. If it is vertex i, that one leaves the disk of the other two and p: p is inside if it is
// on i's side of the opposite edge.
bool Delaunay2::wins_tie(const Triangle& t, const Point2& p, std::uint32_t p_number) const {
  std::uint32_t top = 0;
  if (number(t.v[top]) < number(t.v[1])) top = 1;
  if (number(t.v[top]) < number(t.v[2])) top = 2;
  if (p_number > number(t.v[top])) return false;
  return orient(point(t.v[kNext[top]]), point(t.v[kPrev[top]]), p) > 0;
}

bool Delaunay2::equals_corner(const Point2& p, TriangleId t) {
  for (const VertexId v : triangles_[t].v) {
    if (v == kGhost || point(v) != p) continue;
    duplicate_of_ = v;
    return true;
  }
  return false;
}

// Collects the triangles in conflict and, counter-clockwise, the boundary of their union. No vertex
// is inside it, so its dual graph is a tree: a depth-first walk from the seed needs no marks. The
// edge ab is looked across next; the boundary is settled up to a, and goes on from b to the
// vertices on the stack `pending_`, each with the half-edge that ends there.
template <bool kPlain>
void Delaunay2::dig(const Point2& at_p, std::uint32_t number, TriangleId seed) {
  const Point2 p = at_p;
  const bool tagged = !kPlain && !tags_.empty();
  const Triangle* const triangles = triangles_.data();
  const Point2* const points = points_.data();
  cavity_.push_back(seed);
  const Triangle& first = triangles[seed];
  bool at_hull = is_ghost(first);
  Sight a = sight(first.v[0], p, 4 * seed + 1), b = sight(first.v[1], p, 4 * seed + 2);
  if (pending_.empty()) pending_.resize(64);
  Sight *bottom = pending_.data(), *top = bottom, *limit = top + pending_.size();
  *top++ = a;
  *top++ = sight(first.v[2], p, 4 * seed);
  for (;;) {
    const HalfEdge o = triangles[b.h >> 2].n[b.h & 3];
    const TriangleId t = o >> 2;
    const Triangle& at = triangles[t];
    Sight c;
    c.v = at.v[o & 3];
    bool conflict;
    if (at_hull || c.v == kGhost) {
      c = sight(c.v, p, 0);
      conflict = in_conflict(at, p, number);
      at_hull = at_hull || conflict;
    } else {
      c.x = points[c.v.value].x - p.x;
      c.y = points[c.v.value].y - p.y;
      c.lift = c.x * c.x + c.y * c.y;
      // incircle_filtered of (b, a, c, p), with the offsets that are known.
      const double det = b.lift * (a.x * c.y - c.x * a.y) + a.lift * (c.x * b.y - b.x * c.y) +
                         c.lift * (b.x * a.y - a.x * b.y);
      const double bound =
          internal::kIncircleBound * (a.lift * (b.lift + c.lift) + b.lift * c.lift);
      conflict = det > bound;
      if (!conflict && !(det < -bound)) conflict = in_conflict(at, p, number);
    }
    if (conflict) {
      cavity_.push_back(t);
      if (tagged && tags_[o] != kNone) tagged_inside_.push_back(b.h);
      if (top == limit) {
        const std::size_t depth = pending_.size();
        pending_.resize(2 * depth);
        bottom = pending_.data();
        top = bottom + depth;
        limit = top + depth;
      }
      b.h = prev(o);
      *top++ = b;
      c.h = next(o);
      b = c;
    } else {
      if (!kPlain) boundary_.push_back(b.h);
      ring_.push_back({o, a.v});
      if (top == bottom) return;
      a = b;
      b = *--top;
    }
  }
}

template <bool kPlain>
Delaunay2::Probe Delaunay2::look(const Point2& p, std::uint32_t number, TriangleId start) {
  cavity_.clear();
  boundary_.clear();
  tagged_inside_.clear();
  ring_.clear();
  duplicate_of_ = VertexId();
  if (!alive(start)) start = last_born_;
  if (dimension_ < 2) return probe_below_plane(p, number, start);
  dimension_after_ = 2;
  const TriangleId seed = walk(p, start);
  if (equals_corner(p, seed)) return Probe::kDuplicate;
  dig<kPlain>(p, number, seed);
  return Probe::kOk;
}

Delaunay2::Probe Delaunay2::probe_at(const Point2& p, std::uint32_t number, TriangleId start) {
  return look<false>(p, number, start);
}

Delaunay2::Probe Delaunay2::probe_below_plane(const Point2& p, std::uint32_t number,
                                              TriangleId start) {
  if (dimension_ == 1) return probe_on_line(p, number, start);
  dimension_after_ = dimension_ + 1;
  if (dimension_ < 0) return Probe::kOk;
  if (point(only_vertex_) == p) {
    duplicate_of_ = only_vertex_;
    return Probe::kDuplicate;
  }
  ring_.push_back({kNone, only_vertex_});
  ring_.push_back({kNone, kGhost});
  return Probe::kOk;
}

Delaunay2::Probe Delaunay2::probe_on_line(const Point2& p, std::uint32_t number, TriangleId start) {
  const TriangleId t = walk_on_line(p, start);
  const Triangle& at = triangles_[t];
  const std::uint32_t g = ghost_corner(at);
  const Point2 &a = point(at.v[kNext[g]]), &b = point(at.v[kPrev[g]]);
  if (orient(a, b, p) != 0) {
    dimension_after_ = 2;
    dig<false>(p, number,
               t);  // all the ghosts on this side die, and the triangulation becomes planar
    return Probe::kOk;
  }
  dimension_after_ = 1;
  if (equals_corner(p, t)) return Probe::kDuplicate;
  const HalfEdge ab = 4 * t + g, ba = at.n[g];
  if (before(a, b) ? before(b, p) : before(p, b)) {
    // The chain grows at b: two ghosts (p, kGhost, b), (p, b, kGhost) come between those of ab, ba.
    ring_.push_back({next(ab), kGhost});
    ring_.push_back({twin(next(ab)), at.v[kPrev[g]]});
  } else {
    cavity_.push_back(t);
    cavity_.push_back(ba >> 2);
    if (tag(ab) != kNone) tagged_inside_.push_back(ab);
    for (const HalfEdge h : {next(ba), prev(ba), next(ab), prev(ab)}) {
      boundary_.push_back(h);
      ring_.push_back({twin(h), origin(h)});
    }
  }
  return Probe::kOk;
}

// ---- commit -------------------------------------------------------------------------------------

// On a line an outer edge may have its twin among the outer edges: links the triangles to be born.
void Delaunay2::link_on_line(TriangleId fresh) {
  const std::uint32_t dead = static_cast<std::uint32_t>(cavity_.size());
  const auto slot = [&](std::uint32_t j) { return j < dead ? cavity_[j] : fresh + (j - dead); };
  if (dimension_ == 0) {
    ring_[0].outside = 4 * slot(1);
    ring_[1].outside = 4 * slot(0);
    return;
  }
  for (RingEdge& e : ring_) {
    for (std::uint32_t k = 0; k < boundary_.size(); ++k) {
      if (boundary_[k] != e.outside) continue;
      e.outside = 4 * slot(k);
      break;
    }
  }
}

// kPlain: all labels are 0, there are no tags, and no record is wanted.
template <bool kPlain>
void Delaunay2::fill(VertexId v, std::uint32_t splitting_tag) {
  const std::size_t count = ring_.size();
  const bool tagged = !kPlain && !tags_.empty();
  if (!kPlain) {
    died_.clear();
    born_.clear();
    for (const TriangleId t : cavity_) died_.push_back(triangles_[t]);
    bool inherit = true;
    for (const HalfEdge h : tagged_inside_) inherit = inherit && tags_[h] == splitting_tag;
    inheritance_.assign(count, {0, kNone});
    for (std::size_t j = 0; j < boundary_.size(); ++j) {
      if (inherit) inheritance_[j].label = triangles_[boundary_[j] >> 2].label;
      if (tagged) inheritance_[j].tag = tags_[boundary_[j]];
    }
  }
  if (dimension_after_ == 0) {
    dimension_ = 0;
    only_vertex_ = v;
    triangle_of_[v.value] = kAlone;
    return;
  }
  assert(count == cavity_.size() + 2);
  const TriangleId fresh = slot_count();
  triangles_.emplace_back();
  triangles_.emplace_back();
  if (tagged) tags_.resize(4 * triangles_.size(), kNone);
  if (dimension_after_ == 1) link_on_line(fresh);

  // The dead lend their slots; a triangle is linked to those before and after it in the ring.
  cavity_.push_back(fresh);
  cavity_.push_back(fresh + 1);
  ring_.push_back(ring_[0]);
  const TriangleId* const slots = cavity_.data();
  const RingEdge* const ring = ring_.data();
  Triangle* const triangles = triangles_.data();
  TriangleId* const triangle_of = triangle_of_.data();
  std::uint32_t birth = births_;
  TriangleId previous = slots[count - 1], here = slots[0];
  VertexId origin = ring[0].origin;
  for (std::size_t j = 0; j < count; ++j) {
    const TriangleId following = slots[j + 1 < count ? j + 1 : 0];
    const VertexId target = ring[j + 1].origin;
    const HalfEdge outside = ring[j].outside;
    Triangle& t = triangles[here];
    t.v[0] = v;
    t.v[1] = origin;
    t.v[2] = target;
    t.label = kPlain ? 0 : inheritance_[j].label;
    t.n[0] = outside;
    t.n[1] = 4 * following + 2;
    t.n[2] = 4 * previous + 1;
    t.birth = birth++;
    triangles[outside >> 2].n[outside & 3] = 4 * here;
    if (origin == kGhost) {
      ghost_triangle_ = here;
    } else {
      triangle_of[origin.value] = here;
    }
    if (tagged) {
      std::uint32_t* tags = &tags_[4 * std::size_t{here}];
      tags[0] = inheritance_[j].tag;
      tags[1] = tags[2] = kNone;
    }
    previous = here;
    here = following;
    origin = target;
  }
  births_ = birth;
  triangle_of[v.value] = here;
  last_born_ = here;
  dimension_ = dimension_after_;
  if (!kPlain) born_.swap(cavity_);
  cavity_.clear();
}

void Delaunay2::commit(VertexId v, std::uint32_t splitting_tag) {
  assert(!inserted(v) && !duplicate_of_.valid());
  fill<false>(v, splitting_tag);
}

bool Delaunay2::insert_plainly(VertexId v) {
  if (look<true>(point(v), number(v), last_born_) == Probe::kDuplicate) return false;
  fill<true>(v, kNone);
  return true;
}

}  // namespace circumball
