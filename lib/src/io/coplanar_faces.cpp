#include "io/coplanar_faces.h"

#include <algorithm>

#include "circumball/predicates.h"
#include "io/formats.h"
#include "io/segment_table.h"

namespace circumball::io {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Half-edge 3 t + k runs from corner k of triangle t to the next one.
std::uint32_t next_in_triangle(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

/// A point in the coordinate plane that leaves out `axis`.
Point2 along(const Point3& p, int axis) {
  if (axis == 0) return {p.y, p.z};
  return axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

/// Triangles by their half-edges, and the half-edges by the sides that they are.
struct HalfEdges {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> sorted;  ///< by side; those of one side stand together

  std::uint32_t origin(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
  std::uint32_t target(std::uint32_t h) const { return origin(next_in_triangle(h)); }
  std::uint32_t apex(std::uint32_t h) const {
    return origin(next_in_triangle(next_in_triangle(h)));
  }
  std::array<std::uint32_t, 2> side(std::uint32_t h) const {
    return {std::min(origin(h), target(h)), std::max(origin(h), target(h))};
  }

  void sort() {
    sorted.resize(3 * triangles.size());
    for (std::uint32_t h = 0; h < sorted.size(); ++h) sorted[h] = h;
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t g, std::uint32_t h) {
      const auto a = side(g), b = side(h);
      return a != b ? a < b : g < h;
    });
  }

  /// Calls f(first, last) for the half-edges of each side.
  template <class F>
  void for_each_side(F f) const {
    for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
      for (j = i; j < sorted.size() && side(sorted[j]) == side(sorted[i]);) ++j;
      f(sorted.data() + i, sorted.data() + j);
    }
  }
};

/// How a triangle or a loop turns (1 left, -1 right) when it is seen along an axis.
struct View {
  int axis = -1;  ///< none: the corners are collinear, or not within the reach of the predicates
  int turn = 0;
};

class Merger {
 public:
  Merger(const std::vector<Triangle>& triangles, Complex* complex)
      : complex_(*complex), table_(complex), used_(complex->vertices.size(), 0) {
    all_.triangles = triangles;
  }

  void run() {
    all_.sort();
    for (const Triangle& t : all_.triangles) views_.push_back(view(t));
    for (const auto& members : groups()) add_face(members);
  }

 private:
  const Point3& at(std::uint32_t v) const { return complex_.vertices[v]; }

  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const {
    return static_cast<int>(orient2d(along(at(a), axis), along(at(b), axis), along(at(c), axis)));
  }

  View view(const Triangle& t) const {
    View view;
    for (const std::uint32_t v : t)
      if (!in_exact_range(at(v))) return view;
    for (int axis = 0; axis < 3; ++axis)
      if (const int way = turn(t[0], t[1], t[2], axis); way != 0) return {axis, way};
    return view;
  }

  /// Whether the triangles of two half-edges of one side are parts of one plane and do not overlap.
  bool flat(std::uint32_t g, std::uint32_t h) const {
    const int axis = views_[g / 3].axis;
    if (axis < 0 || views_[h / 3].axis < 0) return false;
    const Triangle& t = all_.triangles[g / 3];
    const std::uint32_t a = all_.origin(g), b = all_.target(g), d = all_.apex(h);
    return orient3d(at(t[0]), at(t[1]), at(t[2]), at(d)) == Sign::kZero &&
           turn(a, b, all_.apex(g), axis) * turn(a, b, d, axis) < 0;
  }

  std::uint32_t root(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }

  /// The triangles of each face, in order.
  std::vector<std::vector<std::uint32_t>> groups() {
    const auto count = static_cast<std::uint32_t>(all_.triangles.size());
    parent_.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) parent_[t] = t;
    all_.for_each_side([&](const std::uint32_t* first, const std::uint32_t* last) {
      if (last != first + 2 || !flat(first[0], first[1])) return;
      const std::uint32_t a = root(first[0] / 3), b = root(first[1] / 3);
      parent_[std::max(a, b)] = std::min(a, b);
    });
    std::vector<std::vector<std::uint32_t>> groups;
    std::vector<std::uint32_t> place(count);
    for (std::uint32_t t = 0; t < count; ++t) {
      const std::uint32_t r = root(t);  // the smallest of its group: met first
      if (r == t) {
        place[t] = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      groups[place[r]].push_back(t);
    }
    return groups;
  }

  void add_face(const std::vector<std::uint32_t>& members) {
    Face face;
    const Triangle& first = all_.triangles[members[0]];
    if (members.size() == 1) {
      face.loops.push_back({first.begin(), first.end()});
    } else {
      // All lie in one plane: along an axis where the first is seen as a triangle, all are.
      const View plane = views_[members[0]];
      HalfEdges part;
      for (const std::uint32_t member : members) {
        Triangle t = all_.triangles[member];
        if (turn(t[0], t[1], t[2], plane.axis) != plane.turn) std::swap(t[1], t[2]);
        part.triangles.push_back(t);
      }
      part.sort();
      collect_loops(part, mates(part, &face), plane, &face);
      collect_vertices(part, &face);
    }
    table_.add_sides(face);
    complex_.faces.push_back(std::move(face));
  }

  /// The other half-edge of each side that the face has on both sides of it. Where a third triangle
  /// has the side as well, it is a segment in the face.
  std::vector<std::uint32_t> mates(const HalfEdges& part, Face* face) {
    std::vector<std::uint32_t> mate(3 * part.triangles.size(), kNoIndex);
    part.for_each_side([&](const std::uint32_t* first, const std::uint32_t* last) {
      if (last != first + 2 || part.origin(first[0]) == part.origin(first[1])) return;
      mate[first[0]] = first[1];
      mate[first[1]] = first[0];
      const auto side = part.side(first[0]);
      const auto range =
          std::equal_range(all_.sorted.begin(), all_.sorted.end(), Key{side},
                           [&](const auto& x, const auto& y) { return key(x) < key(y); });
      if (range.second - range.first > 2) face->segments.push_back(table_.number(side[0], side[1]));
    });
    return mate;
  }

  struct Key {
    std::array<std::uint32_t, 2> side;
  };
  std::array<std::uint32_t, 2> key(std::uint32_t h) const { return all_.side(h); }
  static std::array<std::uint32_t, 2> key(const Key& k) { return k.side; }

  /// Follows the border of the face with its inside on the left. Where it comes back to a vertex it
  /// is cut into two loops.
  void collect_loops(const HalfEdges& part, const std::vector<std::uint32_t>& mate,
                     const View& plane, Face* face) {
    std::vector<char> done(mate.size(), 0);
    std::vector<std::vector<std::uint32_t>> holes;
    for (std::uint32_t start = 0; start < mate.size(); ++start) {
      if (mate[start] != kNoIndex || done[start]) continue;
      std::vector<std::uint32_t> path;
      std::uint32_t h = start;
      do {
        done[h] = 1;
        const std::uint32_t v = part.origin(h);
        if (used_[v]) {
          const auto again = std::find(path.begin(), path.end(), v);
          add_loop({again, path.end()}, plane, face, &holes);
          for (auto it = again; it != path.end(); ++it) used_[*it] = 0;
          path.erase(again, path.end());
        }
        path.push_back(v);
        used_[v] = 1;
        h = next_in_triangle(h);
        while (mate[h] != kNoIndex) h = next_in_triangle(mate[h]);
      } while (h != start);
      for (const std::uint32_t v : path) used_[v] = 0;
      add_loop(std::move(path), plane, face, &holes);
    }
    for (auto& hole : holes) {
      face->holes.push_back(point_inside(hole, plane.axis));
      face->loops.push_back(std::move(hole));
    }
  }

  /// Where a loop begins in the coordinate plane: its vertex with the least coordinates.
  std::size_t corner_of(const std::vector<std::uint32_t>& loop, int axis) const {
    std::size_t least = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const Point2 p = along(at(loop[i]), axis), q = along(at(loop[least]), axis);
      if (p.x != q.x ? p.x < q.x : p.y < q.y) least = i;
    }
    return least;
  }

  void add_loop(std::vector<std::uint32_t>&& loop, const View& plane, Face* face,
                std::vector<std::vector<std::uint32_t>>* holes) {
    if (loop.size() < 3) return;
    const std::size_t n = loop.size(), i = corner_of(loop, plane.axis);
    const bool outer =
        turn(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], plane.axis) == plane.turn;
    (outer ? face->loops : *holes).push_back(std::move(loop));
  }

  /// A point inside of a simple loop: near a corner v with neighbors a and b, the middle between v
  /// and the vertex in triangle avb that is farthest from ab; the center of avb if there is none.
  Point3 point_inside(const std::vector<std::uint32_t>& loop, int axis) const {
    const std::size_t n = loop.size(), i = corner_of(loop, axis);
    const std::uint32_t a = loop[(i + n - 1) % n], v = loop[i], b = loop[(i + 1) % n];
    const int way = turn(a, v, b, axis);
    const Point2 pa = along(at(a), axis), pb = along(at(b), axis);
    const auto distance = [&](std::uint32_t q) {
      const Point2 p = along(at(q), axis);
      const double d = (pb.x - pa.x) * (p.y - pa.y) - (pb.y - pa.y) * (p.x - pa.x);
      return d < 0 ? -d : d;
    };
    std::uint32_t nearest = kNoIndex;
    for (const std::uint32_t q : loop)
      if (q != a && q != v && q != b && turn(a, v, q, axis) * way >= 0 &&
          turn(v, b, q, axis) * way >= 0 && turn(b, a, q, axis) * way >= 0 &&
          (nearest == kNoIndex || distance(q) > distance(nearest)))
        nearest = q;
    const Point3 &p = at(v), &q = at(nearest == kNoIndex ? a : nearest), &r = at(b);
    if (nearest != kNoIndex) return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    return {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
  }

  void collect_vertices(const HalfEdges& part, Face* face) {
    std::vector<std::uint32_t> marked;
    const auto mark = [&](std::uint32_t v) {
      if (used_[v]) return false;
      used_[v] = 1;
      marked.push_back(v);
      return true;
    };
    for (const auto& loop : face->loops)
      for (const std::uint32_t v : loop) mark(v);
    for (const std::uint32_t s : face->segments)
      for (const std::uint32_t v : complex_.segments[s]) mark(v);
    for (const Triangle& t : part.triangles)
      for (const std::uint32_t v : t)
        if (mark(v)) face->vertices.push_back(v);
    for (const std::uint32_t v : marked) used_[v] = 0;
  }

  Complex& complex_;
  SegmentTable table_;
  HalfEdges all_;
  std::vector<View> views_;
  std::vector<std::uint32_t> parent_;
  std::vector<char> used_;  ///< marks of vertices; all 0 between uses
};

}  // namespace

void add_merged_faces(const std::vector<Triangle>& triangles, Complex* complex) {
  Merger(triangles, complex).run();
}

}  // namespace circumball::io
