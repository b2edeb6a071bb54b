#include "delaunay/delaunay2.h"

#include <algorithm>
#include <cassert>

#include "circumball/predicates.h"
#include "delaunay/spatial_order.h"

namespace circumball {
namespace {

/// Lexicographic order: along a line it is an order of its points, and exact.
bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

}  // namespace

constexpr VertexId Delaunay2::kGhost;
constexpr std::uint32_t Delaunay2::kNext[3], Delaunay2::kPrev[3];

void Delaunay2::reserve(std::size_t vertices) {
  vertices_.reserve(vertices);
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
  return vertices_.capacity() * sizeof(Vertex) + triangles_.capacity() * sizeof(Triangle) +
         tags_.capacity() * sizeof(std::uint32_t) + ring_.capacity() * sizeof(RingEdge) +
         (cavity_.capacity() + boundary_.capacity() + tagged_inside_.capacity() +
          stack_.capacity() + born_.capacity()) *
             sizeof(std::uint32_t) +
         died_.capacity() * sizeof(Triangle);
}

// ---- point location
// -----------------------------------------------------------------------------------------------

TriangleId Delaunay2::locate(const Point2& p, TriangleId hint) const {
  if (dimension_ < 1) return kNone;
  if (!alive(hint)) hint = last_born_;
  return dimension_ == 1 ? walk_on_line(p, hint) : walk(p, hint);
}

// A visibility walk that does not look back across the edge it came through.
TriangleId Delaunay2::walk(const Point2& p, TriangleId t) const {
  std::uint32_t from = 3;  // index of the edge that we came through; 3: none
  if (is_ghost(t)) {
    const Triangle& at = triangles_[t];
    const std::uint32_t g = at.v[0] == kGhost ? 0 : at.v[1] == kGhost ? 1 : 2;
    if (orient2d(point(at.v[kNext[g]]), point(at.v[kPrev[g]]), p) == Sign::kPositive) return t;
    from = at.n[g] & 3;
    t = at.n[g] >> 2;
  }
  for (;;) {
    const Triangle& at = triangles_[t];
    HalfEdge through = kNone;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (i == from) continue;
      if (orient2d(point(at.v[kNext[i]]), point(at.v[kPrev[i]]), p) == Sign::kNegative) {
        through = at.n[i];
        break;
      }
    }
    if (through == kNone) return t;
    t = through >> 2;
    from = through & 3;
    if (is_ghost(t)) return t;
  }
}

// Dimension 1: the ghost on p's side of the line; for p on the line, a ghost (a, b, kGhost) with p
// in the closed edge ab, or beyond b at the end of the chain.
TriangleId Delaunay2::walk_on_line(const Point2& p, TriangleId t) const {
  bool first = true;
  for (;;) {
    const Triangle& at = triangles_[t];
    const std::uint32_t g = at.v[0] == kGhost ? 0 : at.v[1] == kGhost ? 1 : 2;
    const Point2 &a = point(at.v[kNext[g]]), &b = point(at.v[kPrev[g]]);
    const TriangleId mirror = at.n[g] >> 2;
    if (first) {
      const Sign side = orient2d(a, b, p);
      if (side == Sign::kPositive) return t;
      if (side == Sign::kNegative) return mirror;
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

// ---- probe
// --------------------------------------------------------------------------------------------------------

bool Delaunay2::in_conflict(const Triangle& t, const Point2& p, std::uint32_t number) const {
  for (std::uint32_t g = 0; g < 3; ++g) {
    if (t.v[g] != kGhost) continue;
    const Point2 &a = point(t.v[kNext[g]]), &b = point(t.v[kPrev[g]]);
    const Sign side = orient2d(a, b, p);
    if (side != Sign::kZero) return side == Sign::kPositive;
    return before(a, b) ? before(a, p) && before(p, b) : before(b, p) && before(p, a);
  }
  const Sign in = incircle(point(t.v[0]), point(t.v[1]), point(t.v[2]), p);
  if (in != Sign::kZero) return in == Sign::kPositive;
  // Four distinct cocircular points: the one of the highest number is lifted most. If it is p, it
  // is outside. If it is vertex i, that one leaves the disk of the other two and p: p is inside if
  // it is on i's side of the opposite edge.
  std::uint32_t top = 0;
  if (t.v[top] < t.v[1]) top = 1;
  if (t.v[top] < t.v[2]) top = 2;
  if (number > t.v[top].value) return false;
  return orient2d(point(t.v[kNext[top]]), point(t.v[kPrev[top]]), p) == Sign::kPositive;
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
// is inside it, so its dual graph is a tree: a depth-first walk from the seed needs no marks.
void Delaunay2::dig(const Point2& p, std::uint32_t number, TriangleId seed) {
  const bool tagged = !tags_.empty();
  cavity_.push_back(seed);
  stack_.assign({4 * seed + 2, 4 * seed + 1, 4 * seed});
  while (!stack_.empty()) {
    const HalfEdge h = stack_.back();
    stack_.pop_back();
    const HalfEdge o = twin(h);
    if (in_conflict(triangles_[o >> 2], p, number)) {
      cavity_.push_back(o >> 2);
      if (tagged && tags_[h] != kNone) tagged_inside_.push_back(h);
      stack_.push_back(prev(o));
      stack_.push_back(next(o));
    } else {
      boundary_.push_back(h);
      ring_.push_back({h, o, origin(h), 0, kNone});
    }
  }
}

Delaunay2::Probe Delaunay2::probe_at(const Point2& p, std::uint32_t number, TriangleId start) {
  cavity_.clear();
  boundary_.clear();
  tagged_inside_.clear();
  ring_.clear();
  duplicate_of_ = VertexId();
  dimension_after_ = 2;
  if (!alive(start)) start = last_born_;
  if (dimension_ == 2) {
    const TriangleId seed = walk(p, start);
    if (equals_corner(p, seed)) return Probe::kDuplicate;
    dig(p, number, seed);
    return Probe::kOk;
  }
  if (dimension_ == 1) return probe_on_line(p, number, start);
  dimension_after_ = dimension_ + 1;
  if (dimension_ == 0) {
    if (point(only_vertex_) == p) {
      duplicate_of_ = only_vertex_;
      return Probe::kDuplicate;
    }
    ring_.push_back({kNone, kNone, only_vertex_, 0, kNone});
    ring_.push_back({kNone, kNone, kGhost, 0, kNone});
  }
  return Probe::kOk;
}

Delaunay2::Probe Delaunay2::probe_on_line(const Point2& p, std::uint32_t number, TriangleId start) {
  const TriangleId t = walk_on_line(p, start);
  const Triangle& at = triangles_[t];
  const std::uint32_t g = at.v[0] == kGhost ? 0 : at.v[1] == kGhost ? 1 : 2;
  const Point2 &a = point(at.v[kNext[g]]), &b = point(at.v[kPrev[g]]);
  if (orient2d(a, b, p) != Sign::kZero) {
    dig(p, number, t);  // all the ghosts on this side die, and the triangulation becomes planar
    return Probe::kOk;
  }
  dimension_after_ = 1;
  if (equals_corner(p, t)) return Probe::kDuplicate;
  const HalfEdge ab = 4 * t + g, ba = at.n[g];
  if (before(a, b) ? before(b, p) : before(p, b)) {
    // The chain grows at b: two ghosts (p, kGhost, b), (p, b, kGhost) come between those of ab and
    // ba.
    ring_.push_back({kNone, next(ab), kGhost, 0, kNone});
    ring_.push_back({kNone, twin(next(ab)), at.v[kPrev[g]], 0, kNone});
  } else {
    cavity_.push_back(t);
    cavity_.push_back(ba >> 2);
    if (tag(ab) != kNone) tagged_inside_.push_back(ab);
    for (const HalfEdge h : {next(ba), prev(ba), next(ab), prev(ab)}) {
      boundary_.push_back(h);
      ring_.push_back({h, twin(h), origin(h), 0, kNone});
    }
  }
  return Probe::kOk;
}

// ---- commit
// -------------------------------------------------------------------------------------------------------

template <bool kRecord>
void Delaunay2::fill(VertexId v, std::uint32_t splitting_tag) {
  const std::size_t dead = cavity_.size(), count = ring_.size();
  if (kRecord) {
    died_.clear();
    born_.clear();
    for (const TriangleId t : cavity_) died_.push_back(triangles_[t]);
  }
  if (dimension_after_ == 0) {
    dimension_ = 0;
    only_vertex_ = v;
    vertices_[v.value].t = kAlone;
    return;
  }
  assert(count == dead + 2);
  const bool tagged = !tags_.empty();
  bool inherit = true;
  for (const HalfEdge h : tagged_inside_) inherit = inherit && tags_[h] == splitting_tag;
  for (RingEdge& e : ring_) {
    if (e.inside == kNone) continue;
    if (inherit) e.label = triangles_[e.inside >> 2].label;
    if (tagged) e.tag = tags_[e.inside];
  }

  const TriangleId fresh = slot_count();
  triangles_.resize(triangles_.size() + 2);
  if (tagged) tags_.resize(4 * triangles_.size(), kNone);
  const auto slot = [&](std::size_t j) {
    return j < dead ? cavity_[j] : fresh + static_cast<TriangleId>(j - dead);
  };
  if (dimension_after_ == 1) {
    // An outer edge may have its twin among the outer edges: link the born triangles there.
    HalfEdge outside[4];
    for (std::size_t j = 0; j < count; ++j) {
      outside[j] = ring_[j].outside;
      if (dimension_ == 0) outside[j] = 4 * slot(1 - j);
      for (std::size_t k = 0; k < count; ++k)
        if (outside[j] == ring_[k].inside && dead > 0) {
          outside[j] = 4 * slot(k);
          break;
        }
    }
    for (std::size_t j = 0; j < count; ++j) ring_[j].outside = outside[j];
  }

  TriangleId before_slot = slot(count - 1), here = slot(0);
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t after = j + 1 < count ? j + 1 : 0;
    const TriangleId after_slot = slot(after);
    const RingEdge& e = ring_[j];
    Triangle& t = triangles_[here];
    t.v[0] = v;
    t.v[1] = e.origin;
    t.v[2] = ring_[after].origin;
    t.label = e.label;
    t.n[0] = e.outside;
    t.n[1] = 4 * after_slot + 2;
    t.n[2] = 4 * before_slot + 1;
    t.birth = births_++;
    triangles_[e.outside >> 2].n[e.outside & 3] = 4 * here;
    if (e.origin == kGhost) {
      ghost_triangle_ = here;
    } else {
      vertices_[e.origin.value].t = here;
    }
    if (tagged) {
      std::uint32_t* tags = &tags_[4 * here];
      tags[0] = e.tag;
      tags[1] = tags[2] = kNone;
    }
    if (kRecord) born_.push_back(here);
    before_slot = here;
    here = after_slot;
  }
  vertices_[v.value].t = here;
  last_born_ = here;
  dimension_ = dimension_after_;
}

void Delaunay2::commit(VertexId v, std::uint32_t splitting_tag) {
  assert(!inserted(v) && !duplicate_of_.valid());
  fill<true>(v, splitting_tag);
}

// ---- batches
// ------------------------------------------------------------------------------------------------------

Delaunay2::Batch Delaunay2::begin_batch(std::uint32_t first, std::uint32_t last) {
  Batch batch;
  last = std::min(last, vertex_count());
  batch.order.reserve(last > first ? last - first : 0);
  for (std::uint32_t v = first; v < last; ++v)
    if (!inserted(VertexId(v))) batch.order.push_back(v);
  const auto at = [this](std::uint32_t v) -> const Point2& { return vertices_[v].p; };
  for (const auto& [vertex, of] : sort_along_hilbert_curve(at, &batch.order))
    batch.duplicates.push_back({VertexId(vertex), VertexId(of)});
  deal_rounds(&batch.order);
  triangles_.reserve(triangles_.size() + 2 * batch.order.size());
  if (!tags_.empty()) tags_.reserve(4 * triangles_.capacity());
  return batch;
}

bool Delaunay2::insert_next(std::uint32_t v, Batch* batch) {
  if (probe(VertexId(v), last_born_) == Probe::kDuplicate) {
    batch->duplicates.push_back({VertexId(v), duplicate_of_});
    return false;
  }
  fill<true>(VertexId(v), kNone);
  return true;
}

void Delaunay2::insert_silently(Batch* batch) {
  died_.clear();
  born_.clear();
  for (const std::uint32_t v : batch->order) {
    if (probe(VertexId(v), last_born_) == Probe::kOk) {
      fill<false>(VertexId(v), kNone);
    } else {
      batch->duplicates.push_back({VertexId(v), duplicate_of_});
    }
  }
}

std::vector<Delaunay2::Duplicate> Delaunay2::end_batch(Batch* batch) {
  // A vertex equal to one of the batch that turned out equal to one inserted before names the
  // latter.
  std::vector<Duplicate>& list = batch->duplicates;
  std::sort(list.begin(), list.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.vertex < b.vertex; });
  for (Duplicate& d : list) {
    if (inserted(d.of)) continue;
    const auto it = std::lower_bound(list.begin(), list.end(), d.of,
                                     [](const Duplicate& e, VertexId v) { return e.vertex < v; });
    d.of = it->of;
  }
  return std::move(list);
}

}  // namespace circumball
