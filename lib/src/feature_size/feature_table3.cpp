#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "complex/planar_sweep.h"
#include "feature_size/face_pieces.h"
#include "feature_size/feature_table.h"

namespace circumball {

using Table = FeatureTable<Point3>;

namespace {

bool usable_point(const Point3& p) { return usable(p.x) && usable(p.y) && usable(p.z); }

void sort_unique(std::vector<std::uint32_t>* v) {
  std::sort(v->begin(), v->end());
  v->erase(std::unique(v->begin(), v->end()), v->end());
}

bool has(const std::vector<std::uint32_t>& sorted, std::uint32_t x) {
  return std::binary_search(sorted.begin(), sorted.end(), x);
}

/// The segments of a complex that can be used, without those that repeat one: `first_of` is the
/// number of the first segment with the same ends, or kNoIndex.
std::vector<std::uint32_t> first_of_segments(const Complex& complex) {
  const auto usable_vertex = [&](std::uint32_t v) {
    return v < complex.vertices.size() && usable_point(complex.vertices[v]);
  };
  const auto ends = [&](std::uint32_t s) {
    const auto& e = complex.segments[s];
    return std::pair{std::min(e[0], e[1]), std::max(e[0], e[1])};
  };
  std::vector<std::uint32_t> order, first_of(complex.segments.size(), kNoIndex);
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
    const auto& e = complex.segments[s];
    if (usable_vertex(e[0]) && usable_vertex(e[1]) &&
        complex.vertices[e[0]] != complex.vertices[e[1]])
      order.push_back(s);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
    return ends(s) != ends(t) ? ends(s) < ends(t) : s < t;
  });
  std::uint32_t first = kNoIndex;
  for (const std::uint32_t s : order) {
    if (first == kNoIndex || ends(first) != ends(s)) first = s;
    first_of[s] = first;
  }
  return first_of;
}

/// The vertices of a face: of its loops, of its segments, and those alone in it. Empty if one of
/// them cannot be used.
std::vector<std::uint32_t> vertices_of(const Complex& complex, const Face& face) {
  std::vector<std::uint32_t> all = face.vertices;
  for (const auto& loop : face.loops) all.insert(all.end(), loop.begin(), loop.end());
  for (const std::uint32_t s : face.segments) {
    if (s >= complex.segments.size()) return {};
    all.insert(all.end(), complex.segments[s].begin(), complex.segments[s].end());
  }
  for (const std::uint32_t v : all)
    if (v >= complex.vertices.size() || !usable_point(complex.vertices[v])) return {};
  sort_unique(&all);
  return all;
}

}  // namespace

Table::FeatureTable(const Complex& complex, const FeatureSizes3::Filter& filter) {
  std::vector<Box3> boxes;
  for (std::uint32_t v = 0; v < complex.vertices.size(); ++v) {
    const Point3& p = complex.vertices[v];
    const Feature vertex{FeatureKind::kVertex, v};
    if (!usable_point(p) || (filter && !filter(vertex))) continue;
    vertices.push_back({{p, p, p}, 1, vertex, v, v});
    boxes.push_back(Box3::of(p));
  }
  vertex_tree = BoxTree3(boxes);
  edges = vertices;
  first_of = first_of_segments(complex);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_ends;
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
    const Feature segment{FeatureKind::kSegment, s};
    if (first_of[s] != s || (filter && !filter(segment))) continue;
    const auto& e = complex.segments[s];
    const Point3 &p = complex.vertices[e[0]], &q = complex.vertices[e[1]];
    edges.push_back({{p, q, q}, 2, segment, e[0], e[1]});
    by_ends[std::minmax(e[0], e[1])] = s;
    boxes.push_back(Box3::of(p, q));
  }
  edge_tree = BoxTree3(boxes);
  features = edges;
  face_vertices.resize(complex.faces.size());
  face_segments.resize(complex.faces.size());
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    const Feature face{FeatureKind::kFace, f};
    if (filter && !filter(face)) continue;
    std::vector<std::uint32_t> of_face = vertices_of(complex, complex.faces[f]);
    if (of_face.empty()) continue;
    for (const auto& corner : face_pieces(complex, f).triangles) {
      if (!(cross2(corner[1] - corner[0], corner[2] - corner[0]) > 0)) continue;
      features.push_back({corner, 3, face, kNoIndex, kNoIndex});
      boxes.push_back(Box3::of(corner[0], corner[1], corner[2]));
    }
    face_vertices[f] = std::move(of_face);
    for (const std::uint32_t s : complex.faces[f].segments)
      if (first_of[s] != kNoIndex) face_segments[f].push_back(first_of[s]);
    for (const auto& loop : complex.faces[f].loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto side = by_ends.find(std::minmax(loop[k], loop[(k + 1) % loop.size()]));
        if (side != by_ends.end()) face_segments[f].push_back(side->second);
      }
    }
    sort_unique(&face_segments[f]);
  }
  feature_tree = BoxTree3(std::move(boxes));
}

bool Table::face_has(std::uint32_t face, std::uint32_t vertex) const {
  return has(face_vertices[face], vertex);
}

bool Table::disjoint(const Item& f, const Item& g) const {
  const bool face_f = f.corners == 3, face_g = g.corners == 3;
  if (!face_f && !face_g) return f.a != g.a && f.a != g.b && f.b != g.a && f.b != g.b;
  if (!face_f) return !face_has(g.feature.index, f.a) && !face_has(g.feature.index, f.b);
  if (!face_g) return !face_has(f.feature.index, g.a) && !face_has(f.feature.index, g.b);
  const std::vector<std::uint32_t>*few = &face_vertices[f.feature.index],
        *many = &face_vertices[g.feature.index];
  if (many->size() < few->size()) std::swap(few, many);
  return std::none_of(few->begin(), few->end(), [&](std::uint32_t v) { return has(*many, v); });
}

bool Table::contains(const Item& f, std::uint32_t segment) const {
  if (segment >= first_of.size() || first_of[segment] == kNoIndex) return false;
  if (f.corners == 3) return has(face_segments[f.feature.index], first_of[segment]);
  return f.feature == Feature{FeatureKind::kSegment, first_of[segment]};
}

std::vector<std::uint32_t> Table::points_of(const Item& f) const {
  if (f.corners == 3) return face_vertices[f.feature.index];
  if (f.a == f.b) return {f.a};
  return {std::min(f.a, f.b), std::max(f.a, f.b)};
}

namespace {

/// Where on a segment x is nearest: 0 at a, 1 at b.
double nearest_on_segment(const Point3& x, const Point3& a, const Point3& b) {
  const Point3 d = b - a;
  const double along = dot(x - a, d), length2 = dot(d, d);
  return along <= 0 ? 0 : along >= length2 ? 1 : along / length2;
}

double segment_distance2(const Point3& x, const Point3& a, const Point3& b) {
  const Point3 u = x - a, d = b - a;
  const double along = dot(u, d), length2 = dot(d, d);
  if (along <= 0) return dot(u, u);
  if (along >= length2) return dot(x - b, x - b);
  return cross2(u, d) / length2;
}

/// The side (0: from corner 0 to 1, …) of a triangle on which x is nearest, or -1 if its projection
/// lies inside. Signs of the cross products with the normal tell on which side of each edge's plane
/// x lies; of the sides that it lies beyond, the nearest one is it (both where the region is a
/// corner's).
int nearest_side(const Point3& x, const std::array<Point3, 3>& c, const Point3& normal) {
  int side = -1;
  double least = 0;
  for (int k = 0; k < 3; ++k) {
    const Point3 &p = c[static_cast<std::size_t>(k)], &q = c[static_cast<std::size_t>((k + 1) % 3)];
    if (dot(cross(q - p, x - p), normal) >= 0) continue;
    const double d2 = segment_distance2(x, p, q);
    if (side >= 0 && !(d2 < least)) continue;
    side = k;
    least = d2;
  }
  return side;
}

Point3 normal_of(const std::array<Point3, 3>& c) { return cross(c[1] - c[0], c[2] - c[0]); }

}  // namespace

double Table::distance2(const Point3& x, const Item& item) const {
  const auto& c = item.corner;
  if (item.corners == 1) return dot(x - c[0], x - c[0]);
  if (item.corners == 2) return segment_distance2(x, c[0], c[1]);
  const Point3 normal = normal_of(c);
  const int side = nearest_side(x, c, normal);
  if (side >= 0)
    return segment_distance2(x, c[static_cast<std::size_t>(side)],
                             c[static_cast<std::size_t>((side + 1) % 3)]);
  const double height = dot(x - c[0], normal) / std::sqrt(dot(normal, normal));
  return height * height;
}

Point3 Table::nearest_point(const Point3& x, const Item& item) const {
  const auto& c = item.corner;
  const auto on_segment = [&](const Point3& a, const Point3& b) {
    const double t = nearest_on_segment(x, a, b);
    return t <= 0 ? a : t >= 1 ? b : along(a, t, b - a);
  };
  if (item.corners == 1) return c[0];
  if (item.corners == 2) return on_segment(c[0], c[1]);
  const Point3 normal = normal_of(c);
  const int side = nearest_side(x, c, normal);
  if (side >= 0)
    return on_segment(c[static_cast<std::size_t>(side)],
                      c[static_cast<std::size_t>((side + 1) % 3)]);
  return along(x, -dot(x - c[0], normal) / dot(normal, normal), normal);
}

Approach Table::approach(const Piece<Point3>& piece, const Item& item) const {
  const Point3& a = piece.a;
  const Point3 d = piece.b - a;
  const double length2 = dot(d, d);
  Approach best{0, distance2(a, item)};
  const auto take = [&](double t) {
    const double d2 = distance2(piece.at(t), item);
    if (d2 < best.distance2) best = {t, d2};
  };
  const auto consider = [&](double t) {
    if (t > 0 && t < 1) take(t);  // false where it is not a number
  };
  // Distance is least at an end of the piece, or where a corner of the item is projected, or a
  // side of it is nearest to the line of the piece, or the plane of the triangle is met.
  take(1);
  const auto& c = item.corner;
  for (int k = 0; k < item.corners; ++k)
    consider(dot(c[static_cast<std::size_t>(k)] - a, d) / length2);
  const int sides = item.corners == 1 ? 0 : item.corners == 2 ? 1 : 3;
  for (int k = 0; k < sides; ++k) {
    const Point3& p = c[static_cast<std::size_t>(k)];
    const Point3 e = c[static_cast<std::size_t>((k + 1) % 3)] - p;
    const Point3 across = cross(d, e);
    consider(dot(cross(p - a, e), across) / dot(across, across));
  }
  if (item.corners == 3) {
    const Point3 normal = normal_of(c);
    consider(dot(c[0] - a, normal) / dot(d, normal));
  }
  return best;
}

}  // namespace circumball
