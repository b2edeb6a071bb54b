// The two phases of an insertion in space: a cavity is dug, then filled.
#include <algorithm>
#include <cassert>
#include <utility>

#include "delaunay/delaunay3.h"
#include "predicates/fast.h"

namespace circumball {
namespace {

/// Marks of cells while a cavity is dug.
constexpr std::uint8_t kInside = 1, kOutside = 2, kPending = 4;

/// Vertices of a cavity's boundary that link_by_table can number; few cavities have more.
constexpr std::size_t kTableSide = 64;

}  // namespace

// ---- probe --------------------------------------------------------------------------------------

// A ghost whose plane holds p: the disk of its facet is the intersection of that plane with the
// ball of the cell behind, whose fourth vertex has no say in a tie there (its coefficient is
// orient3d of the coplanar four).
bool Delaunay3::in_conflict(const Links& c, const Point3& p, std::uint32_t number) const {
  if (c.v[3] == kGhost) {
    const double side = orient3d_filtered(point(c.v[0]), point(c.v[1]), point(c.v[2]), p);
    if (side != 0) return side > 0;
    return in_conflict(links_[c.n[3] >> 2], p, number);
  }
  const double in =
      insphere_filtered(point(c.v[0]), point(c.v[1]), point(c.v[2]), point(c.v[3]), p);
  return in > 0 || (in == 0 && wins_tie(c.v, p, number));
}

// Five cospherical points: the lift of the highest number whose coefficient is not zero decides.
// That of p is minus the orientation of the cell. That of a corner is the orientation of the cell
// with p in its place: p and the corner must be on one side of the facet opposite it.
bool Delaunay3::wins_tie(const VertexId* v, const Point3& p, std::uint32_t p_number) const {
  const Point3* const corner[4] = {&point(v[0]), &point(v[1]), &point(v[2]), &point(v[3])};
  std::uint32_t bound = kNone;
  for (;;) {
    // The corner of the highest number (plus one, so that zero is none) below the one looked at
    // last.
    std::uint32_t top = 0, top_number = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t n = number(v[i]) + 1;
      const bool higher = n <= bound && n > top_number;
      top = higher ? i : top;
      top_number = higher ? n : top_number;
    }
    if (top_number == 0 || p_number >= top_number) return false;
    const Point3& a = top == 0 ? p : *corner[0];
    const Point3& b = top == 1 ? p : *corner[1];
    const Point3& c = top == 2 ? p : *corner[2];
    const Point3& d = top == 3 ? p : *corner[3];
    const double side = orient3d_filtered(a, b, c, d);
    if (side != 0) return side > 0;
    bound = top_number - 1;
  }
}

bool Delaunay3::equals_corner(const Point3& p, CellSlot c) {
  for (const VertexId v : links_[c].v) {
    if (v == kGhost || point(v) != p) continue;
    duplicate_of_ = v;
    return true;
  }
  return false;
}

// Breadth first: `frontier` has the facets of the cells found last. The cells across them that are
// not known are listed, then tested two at a time, and those in conflict make the next frontier.
// Whether a cell is in conflict cannot be foreseen: so lists are written past their ends, and grow
// by what the decision was, without a jump.
template <bool kPlain>
void Delaunay3::dig(const Point3& at_p, std::uint32_t number, CellSlot seed) {
  const Point3 p = at_p;
  const Links* const links = links_.data();
  const Point3* const points = points_.data();
  std::uint8_t* const mark = mark_.data();
  grow_lists(16);
  mark[seed] = kInside;
  found_[0] = seed;
  std::size_t cavity_size = 1, boundary_size = 0, frontier_size = 4;
  for (std::uint32_t i = 0; i < 4; ++i) frontier_[i] = 4 * seed + i;
  while (frontier_size > 0) {
    // At most one cell joins the cavity for each facet of the frontier, and a cell has four facets.
    grow_lists(4 * (cavity_size + frontier_size) + 4);
    CellSlot* const cavity = found_.data();
    CellFacet *const frontier = frontier_.data(), *const next = next_frontier_.data();
    CellFacet *const boundary = outer_.data(), *const tests = tests_.data();
    std::size_t next_size = 0, tests_size = 0;
    for (std::size_t k = 0; k < frontier_size; ++k) {
      const CellFacet f = frontier[k];
      const CellSlot c = links[f >> 2].n[f & 3] >> 2;
      const std::uint8_t known = mark[c];
      boundary[boundary_size] = f;
      boundary_size += known == kOutside;
      next[next_size] = f;
      next_size += known == kPending;
      tests[tests_size] = f;
      tests_size += known == 0;
      mark[c] = static_cast<std::uint8_t>(known | (known == 0) * kPending);
    }
    const auto decide = [&](CellFacet f, CellSlot c, bool conflict) {
      mark[c] = conflict ? kInside : kOutside;
      boundary[boundary_size] = f;
      boundary_size += !conflict;
      cavity[cavity_size] = c;
      cavity_size += conflict;
      // The facets of c but the one that we came through.
      const std::uint32_t i = links[f >> 2].n[f & 3] & 3;
      for (std::uint32_t j = 1; j < 4; ++j) next[next_size + j - 1] = 4 * c + ((i + j) & 3);
      next_size += conflict ? 3 : 0;
    };
    const auto across = [&](std::size_t k) { return links[tests[k] >> 2].n[tests[k] & 3] >> 2; };
    const auto is_ghost = [&](CellSlot c) { return links[c].v[3] == kGhost; };
    std::size_t k = 0;
    while (k < tests_size) {
      const CellSlot c0 = across(k), c1 = k + 1 < tests_size ? across(k + 1) : c0;
      if (is_ghost(c0) || is_ghost(c1)) {
        const CellSlot c = c0;
        decide(tests[k], c, in_conflict(links[c], p, number));
        ++k;
        continue;
      }
      const VertexId *v = links[c0].v, *w = links[c1].v;
      const internal::Pair in = insphere_pair_filtered(
          {&points[v[0].value], &points[w[0].value]}, {&points[v[1].value], &points[w[1].value]},
          {&points[v[2].value], &points[w[2].value]}, {&points[v[3].value], &points[w[3].value]}, p,
          k + 1 < tests_size ? 2 : 1);
      bool conflict[2] = {in[0] > 0, in[1] > 0};
      if (in[0] == 0) conflict[0] = wins_tie(v, p, number);
      decide(tests[k], c0, conflict[0]);
      if (++k == tests_size) break;
      if (in[1] == 0) conflict[1] = wins_tie(w, p, number);
      decide(tests[k], c1, conflict[1]);
      ++k;
    }
    frontier_.swap(next_frontier_);
    frontier_size = next_size;
  }
  ring_.resize(boundary_size);
  for (std::size_t j = 0; j < boundary_size; ++j) {
    const CellFacet f = outer_[j];
    const Links& at = links[f >> 2];
    const auto& corner = kFacet[f & 3];
    const CellFacet outside = at.n[f & 3];
    ring_[j] = {{at.v[corner[0]], at.v[corner[1]], at.v[corner[2]]}, outside};
    mark[outside >> 2] = 0;
  }
  for (std::size_t j = 0; j < cavity_size; ++j) mark[found_[j]] = 0;
  cavity_.assign(found_.data(), found_.data() + cavity_size);
  if (!kPlain) boundary_.assign(outer_.data(), outer_.data() + boundary_size);
}

void Delaunay3::grow_lists(std::size_t size) {
  if (size <= frontier_.size()) return;
  size *= 2;
  for (std::vector<CellFacet>* list : {&frontier_, &next_frontier_, &tests_, &found_, &outer_})
    list->resize(size);
}

template <bool kPlain>
Delaunay3::Probe Delaunay3::look(const Point3& p, std::uint32_t number, CellSlot start) {
  cavity_.clear();
  boundary_.clear();
  ring_.clear();
  flat_ring_.clear();
  duplicate_of_ = VertexId();
  if (!alive(start)) start = last_born_;
  if (dimension_ < 3) return probe_flat(p, number, start);
  dimension_after_ = 3;
  const CellSlot seed = walk(p, start);
  if (equals_corner(p, seed)) return Probe::kDuplicate;
  dig<kPlain>(p, number, seed);
  return Probe::kOk;
}

// ---- commit -------------------------------------------------------------------------------------

// cavity_ becomes a list of `count` slots: the dead lend theirs, then come free ones, then new
// ones.
void Delaunay3::take_slots(std::size_t count) {
  while (cavity_.size() < count && !free_.empty()) {
    cavity_.push_back(free_.back());
    free_.pop_back();
  }
  while (cavity_.size() < count) {
    cavity_.push_back(slot_count());
    links_.emplace_back();
    mark_.push_back(0);
  }
  for (; cavity_.size() > count; cavity_.pop_back()) {
    links_[cavity_.back()].v[0] = VertexId();
    free_.push_back(cavity_.back());
  }
}

void Delaunay3::record_dead() {
  died_.clear();
  born_.clear();
  for (const CellSlot c : cavity_) died_.push_back(cell(c));
  labels_.clear();
  for (const CellFacet f : boundary_) labels_.push_back(notes_[f >> 2].label);
}

// Born cells share the edges of the cavity's boundary, a sphere: each directed edge belongs to one
// cell, the other direction to its neighbor. Vertices get local numbers, for a table of all edges;
// cell_of_ remembers them, as it must be written anyway: k is the number of v if vertices[k] is v.
// Says no if there are too many vertices for the table.
bool Delaunay3::link_by_table() {
  VertexId vertices[kTableSide];
  CellSlot cells[kTableSide];
  std::uint32_t known = 0, ghost = kNone;
  const std::size_t count = ring_.size();
  if (count > 2 * kTableSide - 4) return false;  // a sphere of triangles with more vertices
  std::uint16_t keys[3 * 2 * kTableSide];
  if (table_.size() < kTableSide * kTableSide) table_.resize(kTableSide * kTableSide);
  std::uint32_t* const table = table_.data();
  Links* const links = links_.data();
  const CellSlot* const slots = cavity_.data();
  std::uint32_t* const cell_of = cell_of_.data();
  for (std::size_t j = 0; j < count; ++j) {
    const CellSlot here = slots[j];
    std::uint32_t k[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = ring_[j].v[i];
      std::uint32_t& number = i == 2 && v == kGhost ? ghost : cell_of[v.value];
      std::uint32_t at = number;
      if (at >= known || vertices[at] != v) {
        number = at = known++;
        vertices[at] = v;
      }
      cells[at] = here;
      k[i] = at;
      keys[3 * j + i] = static_cast<std::uint16_t>(at);
    }
    table[kTableSide * k[1] + k[2]] = 4 * here + 1;
    table[kTableSide * k[2] + k[0]] = 4 * here + 2;
    table[kTableSide * k[0] + k[1]] = 4 * here + 3;
  }
  for (std::size_t j = 0; j < count; ++j) {
    const std::uint16_t* k = keys + 3 * j;
    Links& c = links[slots[j]];
    c.n[1] = table[kTableSide * k[2] + k[1]];
    c.n[2] = table[kTableSide * k[0] + k[2]];
    c.n[3] = table[kTableSide * k[1] + k[0]];
  }
  for (std::uint32_t k = 0; k < known; ++k)
    if (vertices[k] != kGhost) cell_of[vertices[k].value] = cells[k];
  return true;
}

// The same for a boundary of many vertices, by open addressing with the directed edge as key.
void Delaunay3::link_by_hash() {
  std::size_t size = 16;
  while (size < 6 * ring_.size()) size *= 2;
  table_.assign(size, kNone);
  const auto place = [&](VertexId a, VertexId b) {
    const std::uint64_t key = std::uint64_t{a.value} << 32 | b.value;
    std::size_t at = (key * 0x9e3779b97f4a7c15u >> 20) & (size - 1);
    while (table_[at] != kNone) {
      const Links& c = links_[table_[at] >> 2];
      const std::uint32_t i = table_[at] & 3;
      if (c.v[i % 3 + 1] == a && c.v[(i + 1) % 3 + 1] == b) break;
      at = (at + 1) & (size - 1);
    }
    return at;
  };
  // The directed edge after corner i of (v1, v2, v3) is opposite i.
  for (std::size_t j = 0; j < ring_.size(); ++j)
    for (std::uint32_t i = 1; i < 4; ++i) {
      const Links& c = links_[cavity_[j]];
      table_[place(c.v[i % 3 + 1], c.v[(i + 1) % 3 + 1])] = 4 * cavity_[j] + i;
    }
  for (std::size_t j = 0; j < ring_.size(); ++j)
    for (std::uint32_t i = 1; i < 4; ++i) {
      Links& c = links_[cavity_[j]];
      c.n[i] = table_[place(c.v[(i + 1) % 3 + 1], c.v[i % 3 + 1])];
      if (c.v[i] != kGhost) cell_of_[c.v[i].value] = cavity_[j];
    }
}

// kPlain: all labels are 0, and no record is wanted.
template <bool kPlain>
void Delaunay3::fill(VertexId p) {
  const std::size_t count = ring_.size();
  if (!kPlain) record_dead();
  take_slots(count);
  if (!kPlain) {
    notes_.resize(links_.size());
    for (std::size_t j = 0; j < count; ++j)
      notes_[cavity_[j]] = {labels_[j], births_ + static_cast<std::uint32_t>(j)};
  }
  births_ += static_cast<std::uint32_t>(count);
  Links* const links = links_.data();
  const RingFacet* const ring = ring_.data();
  const CellSlot* const slots = cavity_.data();
  for (std::size_t j = 0; j < count; ++j) {
    const RingFacet& f = ring[j];
    const CellSlot here = slots[j];
    Links& c = links[here];
    c.v[0] = p;
    c.v[1] = f.v[0];
    c.v[2] = f.v[1];
    c.v[3] = f.v[2];
    c.n[0] = f.outside;
    links[f.outside >> 2].n[f.outside & 3] = 4 * here;
    if (f.v[2] == kGhost) ghost_cell_ = here;
  }
  if (!link_by_table()) link_by_hash();
  last_born_ = slots[0];
  cell_of_[p.value] = last_born_;
  dimension_ = 3;
  if (!kPlain) born_.swap(cavity_);
  cavity_.clear();
}

void Delaunay3::commit(VertexId v) {
  assert(!inserted(v) && !duplicate_of_.valid());
  if (dimension_after_ < 3) {
    fill_flat(v);
  } else {
    fill<false>(v);
  }
}

bool Delaunay3::insert_plainly(VertexId v) {
  if (look<true>(point(v), number(v), last_born_) == Probe::kDuplicate) return false;
  if (dimension_after_ < 3) {
    fill_flat(v);
  } else {
    fill<true>(v);
  }
  return true;
}

template void Delaunay3::dig<false>(const Point3&, std::uint32_t, CellSlot);
template Delaunay3::Probe Delaunay3::look<false>(const Point3&, std::uint32_t, CellSlot);

}  // namespace circumball
