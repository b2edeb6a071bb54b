// Triangulations in space whose vertices are coplanar, collinear, one or none.
//
// A chain of collinear vertices is a sorted list. A planar triangulation consists of ghosts, two a
// triangle: the upper ones, on the side of off_plane_, and the lower ones. Only upper ones are
// walked and tested here; circles are the intersections of the plane with spheres through
// off_plane_.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "delaunay/delaunay3.h"
#include "predicates/fast.h"

namespace circumball {
namespace {

/// Lexicographic order: along a line it is an order of its points, and exact.
bool before(const Point3& a, const Point3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Exactly: three points of space are collinear if they are in all three coordinate planes.
bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  return orient2d_filtered(a.x, a.y, b.x, b.y, c.x, c.y) == 0 &&
         orient2d_filtered(a.y, a.z, b.y, b.z, c.y, c.z) == 0 &&
         orient2d_filtered(a.z, a.x, b.z, b.x, c.z, c.x) == 0;
}

/// A point off the plane of three that are not collinear: at their size from it if rounding lets
/// it, so that filters decide.
Point3 point_off_plane(const Point3& a, const Point3& b, const Point3& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double nx = std::fabs(uy * vz - uz * vy), ny = std::fabs(uz * vx - ux * vz);
  const double nz = std::fabs(ux * vy - uy * vx);
  double size = 0;
  for (const double d : {ux, uy, uz, vx, vy, vz}) size = std::max(size, std::fabs(d));
  Point3 off = a;
  (nx >= ny && nx >= nz ? off.x : ny >= nz ? off.y : off.z) += size;
  if (orient3d_filtered(a, b, c, off) != 0) return off;
  // Of the corners of a tetrahedron one is off every plane.
  for (const Point3& corner : {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}})
    if (orient3d_filtered(a, b, c, corner) != 0) return corner;
  return {0, 0, 1};
}

constexpr std::uint32_t kNext[3] = {1, 2, 0}, kPrev[3] = {2, 0, 1};
constexpr std::uint8_t kInside = 1, kOutside = 2;

}  // namespace

// ---- on a line ----------------------------------------------------------------------------------

std::size_t Delaunay3::place_on_line(const Point3& p) const {
  const auto it =
      std::lower_bound(line_.begin(), line_.end(), p,
                       [this](VertexId v, const Point3& q) { return before(point(v), q); });
  return static_cast<std::size_t>(it - line_.begin());
}

bool Delaunay3::on_line(const Point3& p) const {
  return collinear(point(line_.front()), point(line_.back()), p);
}

void Delaunay3::line_neighbors(VertexId v, VertexId* left, VertexId* right) const {
  const std::size_t at = place_on_line(point(v));
  *left = at > 0 ? line_[at - 1] : VertexId();
  *right = at + 1 < line_.size() ? line_[at + 1] : VertexId();
}

// ---- in a plane: queries ------------------------------------------------------------------------

/// Of the two ghosts of a triangle, the upper one.
CellSlot Delaunay3::upper(CellSlot c) const {
  const Links& at = links_[c];
  const bool is_upper =
      orient3d_filtered(point(at.v[0]), point(at.v[1]), point(at.v[2]), off_plane_) > 0;
  return is_upper ? c : at.n[3] >> 2;
}

/// Positive if p is to the left of ab, seen from above.
int Delaunay3::side_in_plane(VertexId a, VertexId b, const Point3& p) const {
  const double side = orient3d_filtered(point(a), point(b), p, off_plane_);
  return (side > 0) - (side < 0);
}

// A visibility walk through upper ghosts. `seen` gets the edge of the hull that p sees from
// outside, as a facet of the ghost returned, or kNone.
CellSlot Delaunay3::walk_in_plane(const Point3& p, CellSlot c, std::uint32_t* seen) const {
  CellFacet came_through = kNone;
  for (;;) {
    const Links& at = links_[c];
    std::uint32_t i = 0;
    for (; i < 3; ++i)
      if (4 * c + i != came_through && side_in_plane(at.v[kNext[i]], at.v[kPrev[i]], p) < 0) break;
    *seen = i < 3 && at.n[i] >> 2 == at.n[3] >> 2 ? 4 * c + i : kNone;
    if (i == 3 || *seen != kNone) return c;
    came_through = at.n[i];
    c = came_through >> 2;
  }
}

CellSlot Delaunay3::locate_in_plane(const Point3& p, CellSlot c) const {
  c = upper(c);
  const Links& at = links_[c];
  const double side = orient3d_filtered(point(at.v[0]), point(at.v[1]), point(at.v[2]), p);
  std::uint32_t seen;
  return side > 0 ? c : side < 0 ? at.n[3] >> 2 : walk_in_plane(p, c, &seen);
}

// Around the edge from a to kGhost.
CellSlot Delaunay3::cell_with_edge_in_plane(VertexId a, VertexId b) const {
  const CellSlot first = cell_of_[a.value];
  const auto place = [this](CellSlot c, VertexId v) {
    std::uint32_t i = 0;
    while (links_[c].v[i] != v) ++i;
    return i;
  };
  std::uint32_t i = kNext[place(first, a)], k = kNext[i];
  CellSlot c = first;
  do {
    if (links_[c].v[i] == b || links_[c].v[k] == b) return c;
    const VertexId pivot = links_[c].v[i];
    const CellFacet next = links_[c].n[k];
    c = next >> 2;
    i = next & 3;
    k = place(c, pivot);
  } while (c != first);
  return kNone;
}

// ---- in a plane: probe --------------------------------------------------------------------------

bool Delaunay3::sees_hull_edge(CellFacet edge, const Point3& p) const {
  const Links& at = links_[edge >> 2];
  const VertexId a = at.v[kNext[edge & 3]], b = at.v[kPrev[edge & 3]];
  const int side = side_in_plane(a, b, p);
  if (side != 0) return side < 0;
  return before(point(a), p) == before(p, point(b));
}

bool Delaunay3::in_circle(CellSlot c, const Point3& p, std::uint32_t p_number) const {
  const VertexId* v = links_[c].v;
  const double in = insphere_filtered(point(v[0]), point(v[1]), point(v[2]), off_plane_, p);
  if (in != 0) return in > 0;
  // As in wins_tie; the highest number decides, as no three points of a circle are collinear.
  std::uint32_t top = 0;
  for (std::uint32_t i = 1; i < 3; ++i)
    if (number(v[i]) > number(v[top])) top = i;
  return p_number < number(v[top]) && side_in_plane(v[kNext[top]], v[kPrev[top]], p) > 0;
}

// The edge of the hull after (or before) an edge of the hull, both as facets of upper ghosts.
CellFacet Delaunay3::next_on_hull(CellFacet edge, bool forward) const {
  for (;;) {
    const Links& at = links_[edge >> 2];
    const std::uint32_t i = forward ? kNext[edge & 3] : kPrev[edge & 3];
    if (at.n[i] >> 2 == at.n[3] >> 2) return (edge & ~3u) + i;
    edge = at.n[i];
  }
}

/// An edge given as a facet of an upper ghost, as a facet of the lower one.
CellFacet Delaunay3::lower(CellFacet edge) const {
  const CellSlot mirror = links_[edge >> 2].n[3] >> 2;
  std::uint32_t i = 0;
  while (links_[mirror].v[i] != apex(edge)) ++i;
  return 4 * mirror + i;
}

// The triangles whose open disk holds p, and the edges of the hull that p sees (those are what
// ghosts are in the plane), and the boundary of their union.
void Delaunay3::dig_in_plane(const Point3& p, std::uint32_t p_number, CellSlot seed,
                             std::uint32_t seen) {
  const auto test = [&](CellSlot c) {
    if (mark_[c] != 0) return;
    mark_[c] = in_circle(c, p, p_number) ? kInside : kOutside;
    if (mark_[c] == kInside) cavity_.push_back(c);
  };
  std::vector<CellFacet>& sight = star_;
  sight.clear();
  if (seen != kNone) {
    sight.push_back(seen);
    for (const bool forward : {true, false})
      for (CellFacet e = next_on_hull(seen, forward); sees_hull_edge(e, p);
           e = next_on_hull(e, forward))
        sight.push_back(e);
    for (const CellFacet e : sight) test(e >> 2);
  } else {
    test(seed);
  }
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const CellSlot c = cavity_[k];
    const Links& at = links_[c];
    const CellSlot mirror = at.n[3] >> 2;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const CellFacet outside = at.n[i];
      const VertexId a = at.v[kNext[i]], b = at.v[kPrev[i]];
      if (outside >> 2 == mirror) {
        if (!sees_hull_edge(4 * c + i, p))
          flat_ring_.push_back({a, b, {kNone, kNone}, {c, mirror}});
        continue;
      }
      test(outside >> 2);
      if (mark_[outside >> 2] == kOutside)
        flat_ring_.push_back({a, b, {outside, lower(outside)}, {c, mirror}});
    }
  }
  for (const CellFacet e : sight) {
    const Links& at = links_[e >> 2];
    if (mark_[e >> 2] == kOutside)
      flat_ring_.push_back({at.v[kPrev[e & 3]], at.v[kNext[e & 3]], {e, lower(e)}, {kNone, kNone}});
  }
  const std::size_t count = cavity_.size();
  for (std::size_t k = 0; k < count; ++k) {
    mark_[cavity_[k]] = 0;
    cavity_.push_back(links_[cavity_[k]].n[3] >> 2);
  }
  for (const RingEdge& e : flat_ring_) {
    if (e.outside[0] == kNone) continue;
    mark_[e.outside[0] >> 2] = 0;
    if (e.owner[0] == kNone) continue;
    for (const CellFacet f : e.outside) boundary_.push_back(twin(f));
  }
}

// A point off the line sees all its edges.
void Delaunay3::raise_from_line(const Point3& p) {
  const Point3 &a = point(line_.front()), &b = point(line_.back());
  off_plane_after_ = point_off_plane(a, b, p);
  const bool turn = orient3d_filtered(p, a, b, off_plane_after_) < 0;
  for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
    RingEdge e{line_[i], line_[i + 1], {kNone, kNone}, {kNone, kNone}};
    if (turn) std::swap(e.a, e.b);
    flat_ring_.push_back(e);
  }
}

Delaunay3::Probe Delaunay3::probe_on_line(const Point3& p) {
  dimension_after_ = dimension_ + 1;
  if (dimension_ < 0) return Probe::kOk;
  const std::size_t at = place_on_line(p);
  if (at < line_.size() && point(line_[at]) == p) {
    duplicate_of_ = line_[at];
    return Probe::kDuplicate;
  }
  if (dimension_ == 1 && !on_line(p)) {
    raise_from_line(p);
    return Probe::kOk;
  }
  dimension_after_ = 1;
  RingEdge e{VertexId(), VertexId(), {kNone, kNone}, {kNone, kNone}};
  if (at > 0) e.a = line_[at - 1];
  if (at < line_.size()) e.b = line_[at];
  flat_ring_.push_back(e);
  return Probe::kOk;
}

Delaunay3::Probe Delaunay3::probe_flat(const Point3& p, std::uint32_t p_number, CellSlot start) {
  if (dimension_ < 2) return probe_on_line(p);
  const CellSlot c = upper(start);
  const Links& at = links_[c];
  const double side = orient3d_filtered(point(at.v[0]), point(at.v[1]), point(at.v[2]), p);
  if (side != 0) {
    dimension_after_ = 3;
    dig<false>(p, p_number, side > 0 ? c : at.n[3] >> 2);  // all the ghosts on this side die
    return Probe::kOk;
  }
  dimension_after_ = 2;
  off_plane_after_ = off_plane_;
  std::uint32_t seen;
  const CellSlot seed = walk_in_plane(p, c, &seen);
  if (equals_corner(p, seed)) return Probe::kDuplicate;
  dig_in_plane(p, p_number, seed, seen);
  return Probe::kOk;
}

// ---- commit -------------------------------------------------------------------------------------

void Delaunay3::fill_flat(VertexId p) {
  const std::size_t count = flat_ring_.size();
  died_.clear();
  born_.clear();
  if (dimension_after_ < 2) {
    const std::size_t at = place_on_line(point(p));
    line_.insert(line_.begin() + static_cast<std::ptrdiff_t>(at), p);
    cell_of_[p.value] = kOnLine;
    dimension_ = dimension_after_;
    return;
  }
  for (const CellSlot c : cavity_) died_.push_back(cell(c));
  labels_.clear();
  for (const RingEdge& e : flat_ring_)
    for (const CellSlot c : e.owner) labels_.push_back(c == kNone ? 0 : notes_[c].label);
  line_.clear();
  off_plane_ = off_plane_after_;
  take_slots(2 * count);
  notes_.resize(links_.size());
  const auto top = [this](std::size_t j) { return 4 * cavity_[2 * j]; };
  const auto bottom = [this](std::size_t j) { return 4 * cavity_[2 * j + 1]; };
  for (std::size_t j = 0; j < count; ++j) {
    const RingEdge& e = flat_ring_[j];
    const CellFacet t = top(j), b = bottom(j);
    // For now at the end of the hull on either side.
    links_[t >> 2] = {{p, e.a, e.b, kGhost}, {b, b + 2, b + 1, b + 3}};
    links_[b >> 2] = {{p, e.b, e.a, kGhost}, {t, t + 2, t + 1, t + 3}};
    const CellFacet born[2] = {t, b};
    for (int s = 0; s < 2; ++s) {
      notes_[born[s] >> 2] = {labels_[2 * j + s], births_++};
      if (e.outside[s] == kNone) continue;
      links_[born[s] >> 2].n[0] = e.outside[s];
      links_[e.outside[s] >> 2].n[e.outside[s] & 3] = born[s];
    }
    cell_of_[e.a.value] = cell_of_[e.b.value] = t >> 2;
  }
  // The triangle after (p, a, b) is that from b.
  std::vector<std::uint32_t>& by_origin = star_;
  by_origin.clear();
  for (std::uint32_t j = 0; j < count; ++j) by_origin.push_back(j);
  std::sort(by_origin.begin(), by_origin.end(),
            [this](std::uint32_t i, std::uint32_t j) { return flat_ring_[i].a < flat_ring_[j].a; });
  for (std::size_t j = 0; j < count; ++j) {
    const VertexId b = flat_ring_[j].b;
    const auto it =
        std::lower_bound(by_origin.begin(), by_origin.end(), b,
                         [this](std::uint32_t i, VertexId v) { return flat_ring_[i].a < v; });
    if (it == by_origin.end() || flat_ring_[*it].a != b) continue;
    links_[top(j) >> 2].n[1] = top(*it) + 2;
    links_[top(*it) >> 2].n[2] = top(j) + 1;
    links_[bottom(j) >> 2].n[2] = bottom(*it) + 1;
    links_[bottom(*it) >> 2].n[1] = bottom(j) + 2;
  }
  last_born_ = ghost_cell_ = cavity_[0];
  cell_of_[p.value] = last_born_;
  dimension_ = 2;
  born_.swap(cavity_);
  cavity_.clear();
}

}  // namespace circumball
