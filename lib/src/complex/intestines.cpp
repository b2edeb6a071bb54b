#include "complex/intestines.h"

#include <algorithm>
#include <utility>

#include "delaunay/constructions.h"

namespace circumball {

// --- construction

Intestines::On& Intestines::on(VertexId v) {
  if (on_.size() <= v.value) on_.resize(v.value + 1);
  return on_[v.value];
}

std::uint32_t Intestines::add_ring(Ring ring, std::uint32_t before) {
  const std::uint32_t number = ring_count();
  Tube& tube = tubes_[ring.tube];
  if (before == kNoIndex) {
    tube.first_ring = number;
  } else {
    rings_[before].next = number;
    ring.previous = before;
  }
  const Point3 d{ring.center.x - tube.origin.x, ring.center.y - tube.origin.y,
                 ring.center.z - tube.origin.z};
  tube.profile.push_back({d.x * tube.axis.x + d.y * tube.axis.y + d.z * tube.axis.z, ring.radius});
  rings_.push_back(std::move(ring));
  return number;
}

void Intestines::add_to_ring(std::uint32_t ring, RingKey key, VertexId v) {
  auto& vertices = rings_[ring].vertices;
  const auto at = std::lower_bound(vertices.begin(), vertices.end(), key,
                                   [](const RingVertex& r, RingKey k) { return r.key < k; });
  vertices.insert(at, {key, v});
  on(v).tube = rings_[ring].tube;
  on(v).ring = ring;
}

void Intestines::add_sphere(VertexId center, double radius) {
  if (sphere_at_.size() <= center.value) sphere_at_.resize(center.value + 1, kNoIndex);
  sphere_at_[center.value] = static_cast<std::uint32_t>(spheres_.size());
  spheres_.push_back({center, radius, {}, nullptr});
}

void Intestines::add_to_sphere(std::uint32_t center, VertexId v) {
  spheres_[sphere_at_[center]].vertices.push_back(v);
  on(v).sphere = center;
}

double Intestines::radius(std::uint32_t v) const {
  return v < sphere_at_.size() && sphere_at_[v] != kNoIndex ? spheres_[sphere_at_[v]].radius : 0;
}

const std::vector<VertexId>& Intestines::sphere_vertices(std::uint32_t v) const {
  return spheres_[sphere_at_[v]].vertices;
}

void Intestines::make_patches(const Delaunay3& dt, const std::vector<bool>& is_tip) {
  is_tip_ = is_tip;
  made_ = true;
  cells_.resize(rings_.size());
  for (std::uint32_t r = 0; r < rings_.size(); ++r) {
    cells_[r].resize(tube_of(rings_[r]).bases.size());
    for (std::uint32_t gap = 0; gap < cells_[r].size(); ++gap) {
      if (structured_) rebuild(r, gap);
    }
  }
  if (!structured_) {
    developed_.resize(rings_.size());
    for (std::uint32_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].next == kNoIndex) continue;
      const Tube& tube = tube_of(rings_[r]);
      for (std::uint32_t gap = 0; gap < tube.bases.size(); ++gap) develop(r, gap);
    }
  }
  for (Sphere& s : spheres_) {
    std::sort(s.vertices.begin(), s.vertices.end());
    s.local = std::make_unique<Delaunay3>();
    s.local->add_vertex(dt.point(s.center));
    for (const VertexId v : s.vertices) s.local->add_vertex(dt.point(v));
    s.local->insert_batch(0, s.local->vertex_count(), nullptr);
    std::vector<CellSlot> star;
    s.local->cells_at(VertexId(0), &star);
    for (const CellSlot c : star) create_of_sphere(s, c);
  }
}

// --- rings

Point3 Intestines::place(const Ring& ring, RingKey key) const {
  const Point3 d = tube_of(ring).direction(key);
  return {ring.center.x + ring.radius * d.x, ring.center.y + ring.radius * d.y,
          ring.center.z + ring.radius * d.z};
}

RingKey Intestines::middle_key(std::uint32_t r, VertexId a, VertexId b) const {
  const Ring& ring = rings_[r];
  RingKey low = ring.key_of(a), high = ring.key_of(b);
  if (low > high) std::swap(low, high);
  const RingKey turn = tube_of(ring).bases.size() * kRingGap;
  // From the last vertex to the first one.
  if (low == 0 && high / kRingGap + 1 == turn / kRingGap && high > turn / 2) {
    low = high;
    high = turn;
  }
  return low + (high - low) / 2;
}

std::uint32_t Intestines::ring_before(VertexId a, VertexId b, RingKey* key) const {
  const std::uint32_t ra = ring_of(a), rb = ring_of(b);
  if (ra == kNoIndex || rb == kNoIndex) return kNoIndex;
  const bool forward = rings_[ra].next == rb;
  if (!forward && rings_[rb].next != ra) return kNoIndex;
  *key = rings_[ra].key_of(a);
  return forward ? ra : rb;
}

Ring Intestines::ring_between(std::uint32_t before) const {
  const Ring &a = rings_[before], &b = rings_[a.next];
  Ring ring;
  ring.tube = a.tube;
  ring.about = a.about;
  ring.center = midpoint(a.center, b.center);
  ring.radius = 0.5 * (a.radius + b.radius);
  for (const auto* list : {&a.vertices, &b.vertices}) {
    for (const RingVertex& v : *list) ring.vertices.push_back({v.key, VertexId()});
  }
  const auto less = [](const RingVertex& p, const RingVertex& q) { return p.key < q.key; };
  std::sort(ring.vertices.begin(), ring.vertices.end(), less);
  const auto same = [](const RingVertex& p, const RingVertex& q) { return p.key == q.key; };
  ring.vertices.erase(std::unique(ring.vertices.begin(), ring.vertices.end(), same),
                      ring.vertices.end());
  return ring;
}

// --- patches

PatchId Intestines::patch_with(VertexId a, VertexId b, VertexId c) const {
  if (a.value >= patches_at_.size()) return PatchId();
  for (const PatchId p : patches_at_[a.value]) {
    if (patches_[p.value].has(b) && patches_[p.value].has(c)) return p;
  }
  return PatchId();
}

void Intestines::create(const Corners& v, std::uint32_t sphere, std::uint32_t ring,
                        std::uint32_t gap) {
  const PatchId id(patch_count());
  Patch p;
  std::copy(v.begin(), v.end(), p.v);
  p.sphere = sphere;
  p.ring = ring;
  p.gap = gap;
  patches_.push_back(p);
  for (const VertexId corner : v) {
    if (!corner.valid()) continue;
    if (patches_at_.size() <= corner.value) patches_at_.resize(corner.value + 1);
    patches_at_[corner.value].push_back(id);
  }
  if (ring != kNoIndex) cells_[ring][gap].push_back(id);
  born_.push_back(id);
}

void Intestines::kill(PatchId id) {
  Patch& p = patches_[id.value];
  p.alive = false;
  for (const VertexId corner : p.v) {
    if (!corner.valid()) continue;
    auto& at = patches_at_[corner.value];
    at.erase(std::find(at.begin(), at.end(), id));
  }
  if (p.ring != kNoIndex) {
    auto& cell = cells_[p.ring][p.gap];
    cell.erase(std::find(cell.begin(), cell.end(), id));
  }
  const auto born = std::find(born_.begin(), born_.end(), id);
  if (born != born_.end()) {
    born_.erase(born);
  } else {
    died_.push_back(id);
  }
}

std::vector<PatchId> Intestines::take_born() { return std::exchange(born_, {}); }
std::vector<PatchId> Intestines::take_died() { return std::exchange(died_, {}); }

VertexId Intestines::at_wrapped(const Ring& ring, RingKey key, RingKey turn) {
  return ring.at(key == turn ? 0 : key);
}

/// Between two rings, and between two keys that both have. Where neither has the middle key: chord
/// against chord, a trapezoid. Where one has it, the other has nothing in between: a triangle, its
/// apex at the middle, and fans to both sides.
void Intestines::add_between(const Ring& a, const Ring& b, RingKey low, RingKey high,
                             std::vector<Corners>* list) const {
  const RingKey turn = tube_of(a).bases.size() * kRingGap;
  const VertexId a0 = at_wrapped(a, low, turn), a1 = at_wrapped(a, high, turn),
                 b0 = at_wrapped(b, low, turn), b1 = at_wrapped(b, high, turn);
  if (!a0.valid() || !a1.valid() || !b0.valid() || !b1.valid()) return;  // never inserted
  const RingKey middle = low + (high - low) / 2;
  const VertexId am = middle > low ? a.at(middle) : VertexId(),
                 bm = middle > low ? b.at(middle) : VertexId();
  if (am.valid() && bm.valid()) {
    add_between(a, b, low, middle, list);
    add_between(a, b, middle, high, list);
    return;
  }
  if (!am.valid() && !bm.valid()) {
    list->push_back({a0, a1, b1, b0});
    return;
  }
  const Ring& dense = am.valid() ? a : b;
  const VertexId apex = am.valid() ? am : bm;
  const VertexId s0 = am.valid() ? b0 : a0, s1 = am.valid() ? b1 : a1;
  list->push_back({apex, s0, s1, VertexId()});
  VertexId before = am.valid() ? a0 : b0;
  for (const RingVertex& v : dense.vertices) {
    if (v.key <= low || v.key >= high) continue;
    list->push_back({v.key <= middle ? s0 : s1, before, v.vertex, VertexId()});
    before = v.vertex;
  }
  list->push_back({s1, before, am.valid() ? a1 : b1, VertexId()});
}

void Intestines::rebuild(std::uint32_t r, std::uint32_t gap) {
  if (rings_[r].next == kNoIndex) return;
  std::vector<Corners> wanted;
  add_between(rings_[r], rings_[rings_[r].next], gap * kRingGap, (gap + 1) * kRingGap, &wanted);
  const auto old = cells_[r][gap];
  for (const PatchId id : old) {
    const Patch& p = patches_[id.value];
    const auto same = std::find_if(wanted.begin(), wanted.end(), [&](const Corners& c) {
      return std::equal(c.begin(), c.end(), p.v);
    });
    if (same == wanted.end()) {
      kill(id);
    } else {
      wanted.erase(same);
    }
  }
  for (const Corners& c : wanted) create(c, kNoIndex, r, gap);
}

void Intestines::split_arc(const Delaunay3& dt, std::uint32_t r, RingKey key, VertexId v) {
  add_to_ring(r, key, v);
  const auto gap = static_cast<std::uint32_t>(key / kRingGap);
  for (const std::uint32_t piece : {r, rings_[r].previous}) {
    if (piece == kNoIndex) continue;
    if (structured_) {
      rebuild(piece, gap);
    } else {
      insert_in_cell(piece, gap, v);
    }
  }
  if (rings_[r].sphere != kNoIndex) split_sphere(dt, rings_[r].sphere, v);
}

std::uint32_t Intestines::insert_ring(const Delaunay3&, std::uint32_t before, Ring ring) {
  const std::uint32_t number = ring_count();
  for (const RingVertex& v : ring.vertices) {
    on(v.vertex).tube = ring.tube;
    on(v.vertex).ring = number;
  }
  ring.next = rings_[before].next;
  ring.previous = before;
  rings_[ring.next].previous = number;
  rings_.push_back(std::move(ring));
  rings_[before].next = number;
  const std::size_t gaps = cells_[before].size();
  cells_.emplace_back(gaps);
  for (const std::uint32_t r : {before, number}) {
    for (std::uint32_t gap = 0; gap < gaps; ++gap) rebuild(r, gap);
  }
  return number;
}

// --- cells of 6.3

Point2 Intestines::place_in_cell(VertexId v, std::uint32_t r, std::uint32_t gap) const {
  const On& on = on_[v.value];
  if (on.ring != kNoIndex) {
    const RingKey key = rings_[on.ring].key_of(v), low = gap * kRingGap;
    const double t = on.ring == r ? 0 : 1;
    // The first base direction ends the last gap, too.
    if (key < low || key > low + kRingGap) return {1, t};
    return {static_cast<double>(key - low) / static_cast<double>(kRingGap), t};
  }
  return {on.gap == gap ? on.part : 1, on.t};
}

std::uint32_t Intestines::piece_of(VertexId a, VertexId b, VertexId c) const {
  std::uint32_t low = kNoIndex, high = kNoIndex;  // rings that corners are on
  for (const VertexId v : {a, b, c}) {
    if (tube_at(v) == kNoIndex) return kNoIndex;
    const On& on = on_[v.value];
    if (on.piece != kNoIndex) return on.piece;
    if (low == kNoIndex) {
      low = on.ring;
    } else if (on.ring != low) {
      high = on.ring;
    }
  }
  if (high == kNoIndex) return kNoIndex;
  return rings_[low].next == high ? low : rings_[high].next == low ? high : kNoIndex;
}

void Intestines::develop(std::uint32_t r, std::uint32_t gap) {
  const Ring &a = rings_[r], &b = rings_[a.next];
  const auto gaps = static_cast<std::uint32_t>(tube_of(a).bases.size());
  developed_[r].emplace_back(tube_of(a), gap, a, b);
  TubeCell& cell = developed_[r].back();
  std::vector<VertexId> corners;
  for (const Ring* ring : {&a, &b}) {
    for (const RingVertex& v : ring->vertices) {
      if (v.key / kRingGap == gap || v.key == (gap + 1) % gaps * kRingGap) {
        corners.push_back(v.vertex);
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  for (const VertexId v : corners) {
    const Point2 at = place_in_cell(v, r, gap);
    cell.add(v, at.x, at.y);
  }
  cell.insert_all();
  cell.triangulation().for_each_triangle([&](TriangleId t) { create_in_cell(r, gap, t); });
}

/// All triangles but those with all corners on one ring, or on one generator.
void Intestines::create_in_cell(std::uint32_t r, std::uint32_t gap, TriangleId t) {
  const TubeCell& cell = developed_[r][gap];
  Corners v;
  int at[4] = {0, 0, 0, 0};
  for (unsigned i = 0; i < 3; ++i) {
    v[i] = cell.global(cell.triangulation().triangle(t).v[i]);
    const Point2 p = place_in_cell(v[i], r, gap);
    at[0] += p.x == 0;
    at[1] += p.x == 1;
    at[2] += p.y == 0;
    at[3] += p.y == 1;
  }
  if (std::any_of(at, at + 4, [](int corners) { return corners == 3; })) return;
  create(v, kNoIndex, r, gap);
}

void Intestines::insert_in_cell(std::uint32_t r, std::uint32_t gap, VertexId v) {
  if (rings_[r].next == kNoIndex) return;
  TubeCell& cell = developed_[r][gap];
  const Point2 at = place_in_cell(v, r, gap);
  if (!cell.insert(v, at.x, at.y)) return;
  for (const Delaunay2::Triangle& t : cell.triangulation().died()) {
    if (Delaunay2::is_ghost(t)) continue;
    const PatchId p = patch_with(cell.global(t.v[0]), cell.global(t.v[1]), cell.global(t.v[2]));
    if (p.valid() && patches_[p.value].ring == r && patches_[p.value].gap == gap) kill(p);
  }
  for (const TriangleId t : cell.triangulation().born()) {
    if (!cell.triangulation().is_ghost(t)) create_in_cell(r, gap, t);
  }
}

void Intestines::split_generator(VertexId a, VertexId b, VertexId v) {
  On between;
  RingKey key = 0;
  std::uint32_t r = ring_before(a, b, &key);
  for (const VertexId end : {a, b}) {
    const On& at = on_[end.value];
    if (at.piece == kNoIndex) continue;
    r = at.piece;
    key = at.gap * kRingGap;
  }
  if (r == kNoIndex) return;
  const auto gap = static_cast<std::uint32_t>(key / kRingGap);
  const auto gaps = static_cast<std::uint32_t>(tube_of(rings_[r]).bases.size());
  between.tube = rings_[r].tube;
  between.piece = r;
  between.gap = gap;
  between.t = 0.5 * (place_in_cell(a, r, gap).y + place_in_cell(b, r, gap).y);
  on(v) = between;
  insert_in_cell(r, gap, v);
  insert_in_cell(r, (gap + gaps - 1) % gaps, v);
}

void Intestines::split_patch(PatchId id, VertexId v) {
  const Patch patch = patches_[id.value];
  const TubeCell& cell = developed_[patch.ring][patch.gap];
  Point2 p[3];
  for (unsigned i = 0; i < 3; ++i) {
    const Point2 at = place_in_cell(patch.v[i], patch.ring, patch.gap);
    p[i] = cell.developed(at.x, at.y);
  }
  const Point2 at = cell.undeveloped(circumcenter_extended(p[0], p[1], p[2]));
  On between;
  between.tube = rings_[patch.ring].tube;
  between.piece = patch.ring;
  between.gap = patch.gap;
  between.part = at.x;
  between.t = at.y;
  on(v) = between;
  insert_in_cell(patch.ring, patch.gap, v);
}

// --- spheres

/// The facet opposite the center of a cell at it, unless a tip is a corner: its cap would bulge
/// into the tube.
void Intestines::create_of_sphere(const Sphere& s, CellSlot c) {
  if (s.local->is_ghost(c)) return;
  Corners v;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const VertexId corner = s.local->corner(c, i);
    if (corner == VertexId(0)) continue;
    if (count == 3) return;  // not at the center
    const VertexId global = s.vertices[corner.value - 1];
    if (global.value < is_tip_.size() && is_tip_[global.value]) return;
    v[count++] = global;
  }
  create(v, s.center.value, kNoIndex, 0);
}

void Intestines::split_sphere(const Delaunay3& dt, std::uint32_t center, VertexId v) {
  add_to_sphere(center, v);
  Sphere& s = spheres_[sphere_at_[center]];
  const VertexId local = s.local->add_vertex(dt.point(v));
  if (s.local->probe(local, s.local->cell_of(VertexId(0))) != Delaunay3::Probe::kOk) return;
  s.local->commit(local);
  for (const Delaunay3::Cell& cell : s.local->died()) {
    VertexId corners[3];
    std::size_t count = 0;
    bool at_center = false;
    for (const VertexId c : cell.v) {
      if (c == VertexId(0)) {
        at_center = true;
      } else if (c != Delaunay3::kGhost && count < 3) {
        corners[count++] = s.vertices[c.value - 1];
      }
    }
    if (!at_center || count < 3) continue;
    const PatchId p = patch_with(corners[0], corners[1], corners[2]);
    if (p.valid() && patches_[p.value].sphere == center) kill(p);
  }
  for (const CellSlot c : s.local->born()) {
    if (s.local->is_ghost(c)) continue;
    bool at_center = false;
    for (std::uint32_t i = 0; i < 4; ++i) at_center |= s.local->corner(c, i) == VertexId(0);
    if (at_center) create_of_sphere(s, c);
  }
}

std::size_t Intestines::bytes() const {
  std::size_t bytes = patches_.capacity() * sizeof(Patch) + on_.capacity() * sizeof(On) +
                      rings_.capacity() * sizeof(Ring) +
                      patches_at_.capacity() * sizeof(patches_at_[0]);
  bytes += 3 * patches_.size() * sizeof(PatchId);
  for (const Sphere& s : spheres_) {
    bytes += s.vertices.capacity() * sizeof(VertexId) + (s.local ? s.local->bytes() : 0);
  }
  for (const Ring& r : rings_) bytes += r.vertices.capacity() * sizeof(RingVertex);
  return bytes;
}

}  // namespace circumball
