#include "delaunay/delaunay3.h"

#include "predicates/fast.h"

namespace circumball {
namespace {

constexpr std::uint8_t kSeen = 1;  // mark of a cell

}  // namespace

constexpr VertexId Delaunay3::kGhost;
constexpr std::uint32_t Delaunay3::kFacet[4][3];

void Delaunay3::reserve(std::size_t vertices) {
  // Uniform points have 6.77 cells each (the mean of a Poisson process), others seldom more.
  const std::size_t cells = 7 * vertices;
  points_.reserve(vertices);
  cell_of_.reserve(vertices);
  vertex_mark_.reserve(vertices);
  links_.reserve(cells);
  notes_.reserve(cells);
  mark_.reserve(cells);
}

std::size_t Delaunay3::bytes() const {
  return points_.capacity() * sizeof(Point3) + links_.capacity() * sizeof(Links) +
         notes_.capacity() * sizeof(Note) + mark_.capacity() + vertex_mark_.capacity() +
         ring_.capacity() * sizeof(RingFacet) + flat_ring_.capacity() * sizeof(RingEdge) +
         died_.capacity() * sizeof(Cell) +
         (cell_of_.capacity() + free_.capacity() + line_.capacity() + cavity_.capacity() +
          boundary_.capacity() + born_.capacity() + table_.capacity() + labels_.capacity() +
          5 * frontier_.capacity() + star_.capacity() + other_star_.capacity() +
          neighbors_.capacity()) *
             sizeof(std::uint32_t);
}

// ---- queries ------------------------------------------------------------------------------------

void Delaunay3::cells_at(VertexId v, std::vector<CellSlot>* out) const {
  out->clear();
  const CellSlot first = cell_of(v);
  if (first == kNone) return;
  out->push_back(first);
  mark_[first] = kSeen;
  for (std::size_t k = 0; k < out->size(); ++k) {
    const Links& at = links_[(*out)[k]];
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellSlot next = at.n[i] >> 2;
      if (at.v[i] == v || mark_[next]) continue;
      mark_[next] = kSeen;
      out->push_back(next);
    }
  }
  for (const CellSlot c : *out) mark_[c] = 0;
}

// Both stars grow by turns, each with a mark of its own.
VertexId Delaunay3::of_lesser_degree(VertexId a, VertexId b) const {
  const VertexId ends[2] = {a, b};
  std::vector<CellSlot>* const stars[2] = {&star_, &other_star_};
  if (cell_of(a) == kNone || cell_of(b) == kNone) return a;
  for (int s = 0; s < 2; ++s) {
    const CellSlot first = cell_of(ends[s]);
    stars[s]->assign(1, first);
    mark_[first] |= 1 << s;
  }
  VertexId lesser = a;
  for (std::size_t k = 0;; ++k) {
    if (k == star_.size()) break;
    if (k == other_star_.size()) {
      lesser = b;
      break;
    }
    for (int s = 0; s < 2; ++s) {
      const Links& at = links_[(*stars[s])[k]];
      for (std::uint32_t i = 0; i < 4; ++i) {
        const CellSlot next = at.n[i] >> 2;
        if (at.v[i] == ends[s] || mark_[next] & 1 << s) continue;
        mark_[next] |= 1 << s;
        stars[s]->push_back(next);
      }
    }
  }
  for (const std::vector<CellSlot>* star : stars)
    for (const CellSlot c : *star) mark_[c] = 0;
  return lesser;
}

void Delaunay3::neighbors(VertexId v, std::vector<VertexId>* out) const {
  out->clear();
  if (!inserted(v)) return;
  if (dimension_ < 2) {
    VertexId sides[2];
    line_neighbors(v, &sides[0], &sides[1]);
    for (const VertexId u : sides)
      if (u.valid()) out->push_back(u);
    return;
  }
  cells_at(v, &star_);
  vertex_mark_[v.value] = 1;
  for (const CellSlot c : star_)
    for (const VertexId u : links_[c].v) {
      if (u == kGhost || vertex_mark_[u.value]) continue;
      vertex_mark_[u.value] = 1;
      out->push_back(u);
    }
  vertex_mark_[v.value] = 0;
  for (const VertexId u : *out) vertex_mark_[u.value] = 0;
}

void Delaunay3::cavity_neighbors(std::vector<VertexId>* out) const {
  out->clear();
  const auto take = [&](VertexId u) {
    if (!u.valid() || u == kGhost || vertex_mark_[u.value]) return;
    vertex_mark_[u.value] = 1;
    out->push_back(u);
  };
  for (const RingFacet& f : ring_)
    for (const VertexId u : f.v) take(u);
  for (const RingEdge& e : flat_ring_) {
    take(e.a);
    take(e.b);
  }
  for (const VertexId u : *out) vertex_mark_[u.value] = 0;
}

// A visibility walk toward b through cells at a: a cell whose cone from a holds b in its closure.
// It never enters a ghost, as b is not outside the hull; and it ends for the reason that `walk`
// does: the power of b with respect to the circumball falls with every step.
CellSlot Delaunay3::walk_in_star(VertexId a, VertexId b) const {
  CellSlot c = cell_of_[a.value];
  if (is_ghost(c)) c = links_[c].n[3] >> 2;
  const Point3& p = point(b);
  CellFacet came_through = kNone;
  for (bool moved = true; moved;) {
    moved = false;
    const Links& at = links_[c];
    for (std::uint32_t i = 0; i < 4 && !moved; ++i) {
      if (at.v[i] == b) return c;
      if (at.v[i] == a || 4 * c + i == came_through) continue;
      const auto& f = kFacet[i];
      if (orient3d_filtered(p, point(at.v[f[0]]), point(at.v[f[1]]), point(at.v[f[2]])) >= 0)
        continue;
      came_through = at.n[i];
      c = came_through >> 2;
      moved = true;
    }
  }
  return c;
}

bool Delaunay3::has_edge(VertexId a, VertexId b) const {
  if (a == b) return false;
  if (dimension_ < 2) {
    VertexId before, after;
    line_neighbors(a, &before, &after);
    return before == b || after == b;
  }
  if (dimension_ == 2) return cell_with_edge_in_plane(a, b) != kNone;
  const Links& at = links_[walk_in_star(a, b)];
  return at.v[0] == b || at.v[1] == b || at.v[2] == b || at.v[3] == b;
}

CellFacet Delaunay3::find_facet(VertexId a, VertexId b, VertexId c) const {
  if (dimension_ < 2 || a == b || b == c || c == a) return kNone;
  const CellSlot first = dimension_ == 2 ? cell_with_edge_in_plane(a, b) : walk_in_star(a, b);
  if (first == kNone) return kNone;
  const auto place = [this](CellSlot at, VertexId v) {
    std::uint32_t i = 0;
    while (i < 4 && links_[at].v[i] != v) ++i;
    return i;
  };
  const std::uint32_t ia = place(first, a), ib = place(first, b);
  if (ia == 4 || ib == 4) return kNone;
  // Around ab: out through the facet opposite `behind`, which leaves `ahead` behind.
  std::uint32_t i = 0;
  while (i == ia || i == ib) ++i;
  std::uint32_t k = 6 - ia - ib - i;
  CellSlot at = first;
  do {
    if (links_[at].v[i] == c) return 4 * at + k;
    const VertexId pivot = links_[at].v[i];
    const CellFacet next = links_[at].n[k];
    at = next >> 2;
    i = next & 3;  // the new corner
    k = place(at, pivot);
  } while (at != first);
  return kNone;
}

// ---- point location -----------------------------------------------------------------------------

CellSlot Delaunay3::locate(const Point3& p, CellSlot hint) const {
  if (dimension_ < 2) return kNone;
  if (!alive(hint)) hint = last_born_;
  return dimension_ == 2 ? locate_in_plane(p, hint) : walk(p, hint);
}

CellSlot Delaunay3::walk(const Point3& p, CellSlot c) const {
  CellFacet came_through = kNone;
  if (is_ghost(c)) {
    const Links& at = links_[c];
    if (orient3d_filtered(point(at.v[0]), point(at.v[1]), point(at.v[2]), p) > 0) return c;
    came_through = at.n[3];
    c = came_through >> 2;
  }
  for (;;) {
    const Links& at = links_[c];
    if (at.v[3] == kGhost) return c;
    std::uint32_t i = 0;
    for (; i < 4; ++i) {
      if (4 * c + i == came_through) continue;
      const auto& f = kFacet[i];
      if (orient3d_filtered(p, point(at.v[f[0]]), point(at.v[f[1]]), point(at.v[f[2]])) < 0) break;
    }
    if (i == 4) return c;
    came_through = at.n[i];
    c = came_through >> 2;
  }
}

}  // namespace circumball
