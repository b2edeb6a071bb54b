#include "quality/context3.h"

#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "complex/planar_sweep.h"

namespace circumball {
namespace {

VerifyContext3::Facet ascending(VerifyContext3::Facet f) {
  std::sort(f.begin(), f.end());
  return f;
}

/// Whether the corners are in an even permutation of their ascending order.
bool even(const VerifyContext3::Facet& f) {
  return ((f[0] > f[1]) + (f[1] > f[2]) + (f[0] > f[2])) % 2 == 0;
}

bool usable_point(const Point3& p) { return usable(p.x) && usable(p.y) && usable(p.z); }

}  // namespace

VerifyContext3::VerifyContext3(const Mesh& m, const Complex& c, const VerifyOptions& o)
    : mesh(m), complex(c), options(o) {
  read_cells();
  pair_facets();
  list_neighbors();
  match_vertices();
  if (options.domain == "closed") leave_out_vertices_outside();
  measure();
  face_wanted.assign(complex.faces.size(), 1);
  if (closed()) leave_out_what_is_outside();
  const auto read = [](const std::vector<std::vector<std::uint32_t>>& from, std::vector<Cell>* to) {
    for (const auto& cell : from) {
      if (cell.size() != 4) continue;
      to->push_back({cell[0], cell[1], cell[2], cell[3]});
      std::sort(to->back().begin(), to->back().end());
    }
    std::sort(to->begin(), to->end());
  };
  read(options.excused, &excused_);
  read(options.beyond_hull, &beyond_hull_);
}

bool VerifyContext3::lies_in_face(std::uint32_t v, std::uint32_t face) const {
  if (v >= mesh.vertex_features.size()) return false;
  const Feature& f = mesh.vertex_features[v];
  if (f.kind == FeatureKind::kFace) return f.index == face;
  if (face >= complex.faces.size()) return false;
  const Face& in = complex.faces[face];
  const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  if (f.kind == FeatureKind::kVertex) {
    for (const std::uint32_t s : in.segments) {
      if (s >= complex.segments.size()) continue;
      if (has({complex.segments[s].begin(), complex.segments[s].end()}, f.index)) return true;
    }
    return has(in.vertices, f.index) ||
           std::any_of(in.loops.begin(), in.loops.end(),
                       [&](const auto& loop) { return has(loop, f.index); });
  }
  if (f.kind != FeatureKind::kSegment || f.index >= complex.segments.size()) return false;
  if (has(in.segments, f.index)) return true;
  const auto& ends = complex.segments[f.index];
  for (const auto& loop : in.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::uint32_t p = loop[k], q = loop[(k + 1) % loop.size()];
      if ((p == ends[0] && q == ends[1]) || (p == ends[1] && q == ends[0])) return true;
    }
  }
  return false;
}

bool VerifyContext3::is_layer(const Cell& cell) const {
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    if (std::all_of(cell.begin(), cell.end(), [&](auto v) { return lies_in_face(v, f); }))
      return true;
  }
  return false;
}

bool VerifyContext3::is_between_layers(const MeshFacet& facet) const {
  Facet sorted{facet.a, facet.b, facet.c};
  std::sort(sorted.begin(), sorted.end());
  const std::uint32_t some = find_facet(sorted);
  if (some == kNoIndex) return false;
  const auto ends = [&](std::uint32_t f) {
    return f == kNoIndex || lies_in_face(apex(f), facet.face);
  };
  return ends(some) && ends(twin[some]);
}

bool VerifyContext3::is_in(const std::vector<Cell>& list, const Cell& cell) {
  if (list.empty()) return false;
  Cell sorted = cell;
  std::sort(sorted.begin(), sorted.end());
  return std::binary_search(list.begin(), list.end(), sorted);
}

void VerifyContext3::read_cells() {
  used.assign(mesh.vertices.size(), 0);
  if (mesh.dimension != 3) return;
  cells.reserve(mesh.cell_count());
  for (std::uint32_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    Cell cell = {v[0], v[1], v[2], v[3]};
    if (!std::all_of(cell.begin(), cell.end(), [&](std::uint32_t w) {
          return w < mesh.vertices.size() && usable_point(mesh.vertices[w]);
        }))
      continue;
    Cell sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
    cells.push_back(cell);
    cell_number.push_back(i);
    positive.push_back(orient3d(point(v[0]), point(v[1]), point(v[2]), point(v[3])) ==
                       Sign::kPositive);
    for (const std::uint32_t w : cell) used[w] = 1;
  }
}

void VerifyContext3::pair_facets() {
  const auto count = static_cast<std::uint32_t>(4 * cells.size());
  const std::size_t n = mesh.vertices.size();
  facet_first_.assign(n + 1, 0);
  for (std::uint32_t f = 0; f < count; ++f) ++facet_first_[ascending(corners(f))[0] + 1];
  for (std::size_t v = 0; v < n; ++v) facet_first_[v + 1] += facet_first_[v];
  facet_.resize(count);
  std::vector<std::uint32_t> next(facet_first_.begin(), facet_first_.end() - 1);
  for (std::uint32_t f = 0; f < count; ++f) facet_[next[ascending(corners(f))[0]]++] = f;
  twin.assign(count, kNoIndex);
  for (std::size_t v = 0; v < n; ++v) {
    const auto first = facet_.begin() + facet_first_[v],
               last = facet_.begin() + facet_first_[v + 1];
    std::sort(first, last, [&](std::uint32_t f, std::uint32_t g) {
      const Facet a = ascending(corners(f)), b = ascending(corners(g));
      return a != b ? a < b : f < g;
    });
    for (auto i = first; i != last;) {
      const Facet key = ascending(corners(*i));
      auto j = i + 1;
      while (j != last && ascending(corners(*j)) == key) ++j;
      if (j - i == 2 && even(corners(i[0])) != even(corners(i[1]))) {
        twin[i[0]] = i[1];
        twin[i[1]] = i[0];
      } else if (j - i > 1) {
        bad_facets.push_back(key);
      }
      i = j;
    }
  }
}

std::uint32_t VerifyContext3::find_facet(Facet f) const {
  f = ascending(f);
  if (f[2] >= mesh.vertices.size()) return kNoIndex;
  const auto first = facet_.begin() + facet_first_[f[0]],
             last = facet_.begin() + facet_first_[f[0] + 1];
  const auto it = std::lower_bound(first, last, f, [&](std::uint32_t g, const Facet& key) {
    return ascending(corners(g)) < key;
  });
  return it != last && ascending(corners(*it)) == f ? *it : kNoIndex;
}

void VerifyContext3::list_neighbors() {
  const std::size_t n = mesh.vertices.size();
  neighbor_first.assign(n + 1, 0);
  for (const Cell& c : cells)
    for (const std::uint32_t v : c) neighbor_first[v + 1] += 3;
  for (std::size_t v = 0; v < n; ++v) neighbor_first[v + 1] += neighbor_first[v];
  neighbor.resize(neighbor_first[n]);
  std::vector<std::uint32_t> next(neighbor_first.begin(), neighbor_first.end() - 1);
  for (const Cell& c : cells) {
    for (const std::uint32_t v : c)
      for (const std::uint32_t w : c)
        if (v != w) neighbor[next[v]++] = w;
  }
  std::uint32_t kept = 0;  // each once
  for (std::size_t v = 0; v < n; ++v) {
    const auto first = neighbor.begin() + neighbor_first[v],
               last = neighbor.begin() + neighbor_first[v + 1];
    std::sort(first, last);
    neighbor_first[v] = kept;
    for (auto it = first; it != last; ++it)
      if (it == first || *it != *(it - 1)) neighbor[kept++] = *it;
  }
  neighbor_first[n] = kept;
  neighbor.resize(kept);
}

bool VerifyContext3::has_edge(std::uint32_t a, std::uint32_t b) const {
  if (a >= mesh.vertices.size()) return false;
  return std::binary_search(neighbor.begin() + neighbor_first[a],
                            neighbor.begin() + neighbor_first[a + 1], b);
}

void VerifyContext3::match_vertices() {
  const std::size_t n = complex.vertices.size();
  mesh_vertex.assign(n, kNoIndex);
  vertex_wanted.assign(n, 0);
  by_number =
      mesh.input_vertices > 0 && n <= mesh.vertices.size() &&
      (n == mesh.input_vertices || n == std::size_t{mesh.input_vertices} + mesh.box_vertices);
  const auto less = [](const Point3& p, const Point3& q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  std::vector<std::uint32_t> order;
  if (!by_number) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
      if (usable_point(mesh.vertices[v])) order.push_back(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
      if (less(p, q) || less(q, p)) return less(p, q);
      return used[a] != used[b] ? used[a] > used[b] : a < b;
    });
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point3& p = complex.vertices[i];
    if (!usable_point(p)) continue;
    vertex_wanted[i] = 1;
    if (by_number) {
      if (mesh.vertices[i] == p) mesh_vertex[i] = i;
      continue;
    }
    const auto it = std::lower_bound(
        order.begin(), order.end(), p,
        [&](std::uint32_t v, const Point3& q) { return less(mesh.vertices[v], q); });
    if (it != order.end() && !less(p, mesh.vertices[*it])) mesh_vertex[i] = *it;
  }
  // A segment that repeats another is left out.
  std::vector<std::uint32_t> segments;
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) segments.push_back(s);
  const auto ends = [&](std::uint32_t s) {
    const auto& e = complex.segments[s];
    return std::array<std::uint32_t, 2>{std::min(e[0], e[1]), std::max(e[0], e[1])};
  };
  std::sort(segments.begin(), segments.end(), [&](std::uint32_t s, std::uint32_t t) {
    return ends(s) != ends(t) ? ends(s) < ends(t) : s < t;
  });
  segment_wanted.assign(complex.segments.size(), 1);
  for (std::size_t k = 1; k < segments.size(); ++k)
    if (ends(segments[k]) == ends(segments[k - 1])) segment_wanted[segments[k]] = 0;
}

/// Of a closed domain, a vertex on no segment and in no face that no cell has: it is outside, where
/// it lies in no cell. (What the cells should cover is for other checks to say.)
void VerifyContext3::leave_out_vertices_outside() {
  std::vector<std::uint8_t> alone(complex.vertices.size(), 1);
  for (const auto& s : complex.segments) {
    for (const std::uint32_t v : s) {
      if (v < alone.size()) alone[v] = 0;
    }
  }
  for (const Face& face : complex.faces) {
    for (const auto& loop : face.loops) {
      for (const std::uint32_t v : loop) {
        if (v < alone.size()) alone[v] = 0;
      }
    }
    for (const std::uint32_t v : face.vertices) {
      if (v < alone.size()) alone[v] = 0;
    }
  }
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    if (!alone[i] || !vertex_wanted[i]) continue;
    if (mesh_vertex[i] != kNoIndex && used[mesh_vertex[i]]) continue;
    const Point3& p = complex.vertices[i];
    const auto holds = [&](const Cell& c) {
      for (int k = 0; k < 4; ++k) {
        // p in the place of the corner k.
        const Point3* q[4] = {&point(c[0]), &point(c[1]), &point(c[2]), &point(c[3])};
        q[k] = &p;
        if (orient3d(*q[0], *q[1], *q[2], *q[3]) == Sign::kNegative) return false;
      }
      return true;
    };
    if (std::none_of(cells.begin(), cells.end(), holds)) vertex_wanted[i] = 0;
  }
}

void VerifyContext3::measure() {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double largest = 0;
  for (const Point3& p : complex.vertices) {
    if (!usable_point(p)) continue;
    const double at[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
      largest = std::max(largest, std::fabs(at[i]));
    }
  }
  if (!(low[0] <= high[0])) return;
  const double dx = high[0] - low[0], dy = high[1] - low[1], dz = high[2] - low[2];
  diameter = std::sqrt(dx * dx + dy * dy + dz * dz);
  rounding = 0x1p-49 * largest;
}

void VerifyContext3::leave_out_what_is_outside() {
  std::vector<std::uint32_t> unused;
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    const std::uint32_t v = mesh_vertex[i];
    if (vertex_wanted[i] && v != kNoIndex && !used[v]) unused.push_back(i);
  }
  if (unused.empty() || cells.empty()) return;
  std::vector<Box3> boxes;
  for (const Cell& c : cells) {
    Box3 box = Box3::of(point(c[0]), point(c[1]), point(c[2]));
    box.extend(Box3::of(point(c[3])));
    boxes.push_back(box);
  }
  const BoxTree3 tree(std::move(boxes));
  for (const std::uint32_t i : unused) {
    const Point3& p = complex.vertices[i];
    bool inside = false;
    tree.query([&](const Box3& box) { return box.meets(Box3::of(p)); },
               [&](std::uint32_t c) {
                 const Cell& v = cells[c];
                 inside = orient3d(point(v[1]), point(v[3]), point(v[2]), p) != Sign::kNegative &&
                          orient3d(point(v[0]), point(v[2]), point(v[3]), p) != Sign::kNegative &&
                          orient3d(point(v[0]), point(v[3]), point(v[1]), p) != Sign::kNegative &&
                          orient3d(point(v[0]), point(v[1]), point(v[2]), p) != Sign::kNegative;
                 return !inside;
               });
    if (!inside) vertex_wanted[i] = 0;
  }
  const auto is_outside = [&](std::uint32_t v) {
    return v < vertex_wanted.size() && mesh_vertex[v] != kNoIndex && !vertex_wanted[v];
  };
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
    for (const std::uint32_t v : complex.segments[s]) {
      if (is_outside(v)) segment_wanted[s] = 0;
    }
  }
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    for (const auto& loop : complex.faces[f].loops) {
      if (std::any_of(loop.begin(), loop.end(), is_outside)) face_wanted[f] = 0;
    }
  }
}

}  // namespace circumball
