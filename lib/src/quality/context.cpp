#include "quality/context.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "circumball/predicates.h"

namespace circumball {

VerifyContext::VerifyContext(const Mesh& m, const Complex& c, const VerifyOptions& o)
    : mesh(m), complex(c), options(o), view(c, [&] {
        std::vector<Point2> seeds;  // holes first, as PlanarArrangement::inside expects
        for (const Point3& p : c.holes) seeds.push_back(xy(p));
        return seeds;
      }()) {
  read_cells();
  pair_edges();
  match_vertices();
  arrange();
  for (const auto& cell : options.excused) {
    if (cell.size() != 3) continue;
    Cell sorted = {cell[0], cell[1], cell[2]};
    std::sort(sorted.begin(), sorted.end());
    excused_.push_back(sorted);
  }
  std::sort(excused_.begin(), excused_.end());
}

bool VerifyContext::excused(const Cell& cell) const {
  if (excused_.empty()) return false;
  Cell sorted = cell;
  std::sort(sorted.begin(), sorted.end());
  return std::binary_search(excused_.begin(), excused_.end(), sorted);
}

void VerifyContext::read_cells() {
  const std::size_t n = mesh.vertices.size();
  used.assign(n, 0);
  const auto fine = [&](std::uint32_t v) {
    return v < n && usable(mesh.vertices[v].x) && usable(mesh.vertices[v].y);
  };
  if (mesh.dimension != 2) return;
  cells.reserve(mesh.cell_count());
  for (std::uint32_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* c = mesh.cell(i);
    if (!fine(c[0]) || !fine(c[1]) || !fine(c[2])) continue;
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    cells.push_back({c[0], c[1], c[2]});
    cell_number.push_back(i);
    positive.push_back(orient2d(point(c[0]), point(c[1]), point(c[2])) == Sign::kPositive);
    for (int k = 0; k < 3; ++k) used[c[k]] = 1;
  }
}

void VerifyContext::pair_edges() {
  const std::uint32_t halves = static_cast<std::uint32_t>(3 * cells.size());
  const std::size_t n = mesh.vertices.size();
  edge_first.assign(n + 1, 0);
  for (std::uint32_t h = 0; h < halves; ++h) ++edge_first[std::min(origin(h), target(h)) + 1];
  for (std::size_t v = 0; v < n; ++v) edge_first[v + 1] += edge_first[v];
  edge_half.resize(halves);
  std::vector<std::uint32_t> next(edge_first.begin(), edge_first.end() - 1);
  for (std::uint32_t h = 0; h < halves; ++h) edge_half[next[std::min(origin(h), target(h))]++] = h;
  twin.assign(halves, kNoIndex);
  neighbor_first.assign(n + 1, 0);
  const auto high = [&](std::uint32_t h) { return std::max(origin(h), target(h)); };
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t v = 0; v < n; ++v) {
    const auto first = edge_half.begin() + edge_first[v],
               last = edge_half.begin() + edge_first[v + 1];
    std::sort(first, last, [&](std::uint32_t g, std::uint32_t h) {
      return high(g) != high(h) ? high(g) < high(h) : g < h;
    });
    for (auto i = first; i != last;) {
      auto j = i + 1;
      while (j != last && high(*j) == high(*i)) ++j;
      edges.push_back({v, high(*i)});
      if (j - i == 2 && origin(i[0]) != origin(i[1])) {
        twin[i[0]] = i[1];
        twin[i[1]] = i[0];
      } else if (j - i > 1) {
        bad_edges.push_back({v, high(*i)});
      }
      i = j;
    }
  }
  edge_count = edges.size();
  for (const auto& e : edges) ++neighbor_first[e[0] + 1], ++neighbor_first[e[1] + 1];
  for (std::size_t v = 0; v < n; ++v) neighbor_first[v + 1] += neighbor_first[v];
  neighbor.resize(2 * edges.size());
  next.assign(neighbor_first.begin(), neighbor_first.end() - 1);
  for (const auto& e : edges) {
    neighbor[next[e[0]]++] = e[1];
    neighbor[next[e[1]]++] = e[0];
  }
  for (std::size_t v = 0; v < n; ++v)
    std::sort(neighbor.begin() + neighbor_first[v], neighbor.begin() + neighbor_first[v + 1]);
}

std::uint32_t VerifyContext::find_edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t low = std::min(a, b), top = std::max(a, b);
  if (top >= mesh.vertices.size()) return kNoIndex;
  const auto first = edge_half.begin() + edge_first[low],
             last = edge_half.begin() + edge_first[low + 1];
  const auto it = std::lower_bound(first, last, top, [&](std::uint32_t h, std::uint32_t value) {
    return std::max(origin(h), target(h)) < value;
  });
  return it != last && std::max(origin(*it), target(*it)) == top ? *it : kNoIndex;
}

void VerifyContext::match_vertices() {
  const std::size_t n = complex.vertices.size();
  mesh_vertex.assign(n, kNoIndex);
  by_number =
      mesh.input_vertices > 0 && n <= mesh.vertices.size() &&
      (n == mesh.input_vertices || n == std::size_t{mesh.input_vertices} + mesh.box_vertices);
  if (by_number) {
    for (std::uint32_t i = 0; i < n; ++i) {
      if (xy(mesh.vertices[i]) == xy(complex.vertices[i])) mesh_vertex[i] = i;
    }
  } else {
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
      if (usable(mesh.vertices[v].x) && usable(mesh.vertices[v].y)) order.push_back(v);
    const auto less = [](const Point3& p, const Point3& q) {
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
      if (less(p, q) || less(q, p)) return less(p, q);
      return used[a] != used[b] ? used[a] > used[b] : a < b;
    });
    for (std::uint32_t i = 0; i < n; ++i) {
      const Point3& p = complex.vertices[i];
      if (!usable(p.x) || !usable(p.y)) continue;
      const auto it = std::lower_bound(
          order.begin(), order.end(), p,
          [&](std::uint32_t v, const Point3& q) { return less(mesh.vertices[v], q); });
      if (it != order.end() && !less(p, mesh.vertices[*it])) mesh_vertex[i] = *it;
    }
  }
  measure();
}

void VerifyContext::measure() {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, largest = 0;
  for (std::size_t k = 0; k < view.points.size(); ++k) {
    if (view.vertex[k] == kNoIndex) continue;  // a seed
    const double at[2] = {view.points[k].x, view.points[k].y};
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
      largest = std::max(largest, std::fabs(at[i]));
    }
  }
  if (!(low[0] <= high[0])) return;
  const double dx = high[0] - low[0], dy = high[1] - low[1];
  diameter = std::sqrt(dx * dx + dy * dy);
  rounding = 0x1p-49 * largest;
  boundary_length = 2 * (dx + dy);  // of the hull
  for (const auto& segment : view.segments) {
    const Point2 &p = view.points[segment.lo], &q = view.points[segment.hi];
    boundary_length += std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
  }
}

void VerifyContext::arrange() {
  swept = sweep(view);
  vertex_wanted.assign(complex.vertices.size(), 1);
  segment_wanted.assign(complex.segments.size(), 1);
  if (std::any_of(swept.suspect.begin(), swept.suspect.end(), [](auto s) { return s != 0; }))
    return;
  arrangement = std::make_unique<PlanarArrangement>(view, swept);
  inside = arrangement->inside(complex, view);
  if (!closed()) return;
  segment_wanted.assign(complex.segments.size(), 0);
  std::vector<std::uint8_t> point_wanted(view.points.size(), 0);
  for (std::uint32_t s = 0; s < view.segments.size(); ++s) {
    if (!inside[arrangement->left_face(2 * s)] && !inside[arrangement->left_face(2 * s + 1)])
      continue;
    const auto& segment = view.segments[s];
    segment_wanted[segment.segment] = 1;
    point_wanted[segment.lo] = point_wanted[segment.hi] = 1;
  }
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    const std::uint32_t p = view.point_of_vertex[i];
    if (p == kNoIndex) continue;
    const std::uint32_t face = arrangement->face_of_point(p);
    vertex_wanted[i] = face == kNoIndex ? point_wanted[p] : static_cast<std::uint8_t>(inside[face]);
  }
}

std::string vertices_text(const std::vector<std::uint32_t>& vertices) {
  std::string text;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i > 0) text += i + 1 == vertices.size() ? " and " : ", ";
    text += std::to_string(vertices[i]);
  }
  return text;
}

std::string count_text(std::size_t n, const char* thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

std::string value_text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

}  // namespace circumball
