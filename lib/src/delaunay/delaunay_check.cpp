#include "delaunay/delaunay_check.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "circumball/predicates.h"

namespace circumball {
namespace {

using Triangle = Delaunay2::Triangle;
constexpr VertexId kGhost = Delaunay2::kGhost;

std::string text(VertexId v) { return v == kGhost ? "ghost" : std::to_string(v.value); }

std::string text(const Triangle& t) {
  return "(" + text(t.v[0]) + ", " + text(t.v[1]) + ", " + text(t.v[2]) + ")";
}

/// The numbered post-conditions of is_valid, one function each.
class Check {
 public:
  Check(const Delaunay2& d, std::string* why) : d_(d), why_(why) {}

  bool all() {
    return counts() && adjacency() && corners() && links() && order() && delaunay() && hull();
  }

 private:
  bool fail(const std::string& sentence) {
    if (why_) *why_ = sentence;
    return false;
  }

  bool counts() {
    for (std::uint32_t v = 0; v < d_.vertex_count(); ++v) inserted_ += d_.inserted(VertexId(v));
    const std::uint32_t expected = inserted_ < 2 ? 0 : 2 * inserted_ - 2;
    if (d_.slot_count() != expected)
      return fail("there are " + std::to_string(d_.slot_count()) + " triangles, not " +
                  std::to_string(expected));
    const bool low = inserted_ < 3 ? d_.dimension() == static_cast<int>(inserted_) - 1
                                   : d_.dimension() == 1 || d_.dimension() == 2;
    return low || fail("dimension " + std::to_string(d_.dimension()) + " with " +
                       std::to_string(inserted_) + " vertices");
  }

  bool adjacency() {
    for (TriangleId t = 0; t < d_.slot_count(); ++t)
      for (HalfEdge h = 4 * t; h < 4 * t + 3; ++h) {
        const HalfEdge o = d_.twin(h);
        if ((o & 3) == 3 || !d_.alive(o >> 2) || d_.twin(o) != h || o == h)
          return fail("half-edge " + std::to_string(h) + " has no proper twin");
        if (d_.origin(o) != d_.target(h) || d_.target(o) != d_.origin(h))
          return fail("twins join different vertices at " + text(d_.triangle(t)));
        if (d_.tag(o) != d_.tag(h)) return fail("twins differ in tag at " + text(d_.triangle(t)));
      }
    return true;
  }

  bool corners() {
    for (TriangleId t = 0; t < d_.slot_count(); ++t) {
      const Triangle& at = d_.triangle(t);
      for (int i = 0; i < 3; ++i) {
        const VertexId v = at.v[i];
        if (v == at.v[(i + 1) % 3]) return fail("a vertex twice in " + text(at));
        if (v != kGhost && (v.value >= d_.vertex_count() || !d_.inserted(v)))
          return fail("a vertex that is not inserted in " + text(at));
      }
    }
    for (std::uint32_t v = 0; v < d_.vertex_count() && inserted_ > 1; ++v) {
      if (!d_.inserted(VertexId(v))) continue;
      const TriangleId t = d_.triangle_of(VertexId(v));
      if (t == kNone || !has(d_.triangle(t), VertexId(v)))
        return fail("triangle_of(" + std::to_string(v) + ") is not at the vertex");
    }
    return true;
  }

  bool links() {
    std::vector<std::uint32_t> degree(d_.vertex_count(), 0);
    std::uint32_t ghosts = 0;
    for (TriangleId t = 0; t < d_.slot_count(); ++t)
      for (const VertexId v : d_.triangle(t).v) ++(v == kGhost ? ghosts : degree[v.value]);
    for (std::uint32_t v = 0; v < d_.vertex_count(); ++v) {
      std::uint32_t around = 0;
      d_.for_each_outgoing(VertexId(v), [&](HalfEdge) { return ++around <= degree[v]; });
      if (around != degree[v])
        return fail("the triangles at vertex " + std::to_string(v) + " are not one cycle");
    }
    if (d_.dimension() < 1) return true;
    const TriangleId first = d_.some_ghost();
    if (first == kNone || !d_.is_ghost(first)) return fail("some_ghost() is no ghost");
    std::uint32_t around = 0;
    TriangleId t = first;
    do {
      t = d_.twin(Delaunay2::next(outer_edge(t))) >> 2;
    } while (++around <= ghosts && t != first);
    return around == ghosts || fail("the ghosts are not one cycle");
  }

  bool order() {
    for (TriangleId t = 0; t < d_.slot_count(); ++t) {
      const Triangle& at = d_.triangle(t);
      if (Delaunay2::is_ghost(at)) continue;
      if (d_.dimension() < 2) return fail("a triangle in dimension 1: " + text(at));
      if (orient2d(d_.point(at.v[0]), d_.point(at.v[1]), d_.point(at.v[2])) != Sign::kPositive)
        return fail("not counter-clockwise: " + text(at));
    }
    if (d_.dimension() != 1) return true;
    const HalfEdge h = outer_edge(d_.some_ghost());
    for (std::uint32_t v = 0; v < d_.vertex_count(); ++v) {
      if (!d_.inserted(VertexId(v))) continue;
      if (orient2d(d_.point(d_.origin(h)), d_.point(d_.target(h)), d_.point(VertexId(v))) !=
          Sign::kZero)
        return fail("vertex " + std::to_string(v) + " is off the line in dimension 1");
      // Of two neighbors one comes before v, and one after.
      int earlier = 0, later = 0;
      d_.for_each_neighbor(VertexId(v), [&](VertexId u) {
        ++(before(d_.point(u), d_.point(VertexId(v))) ? earlier : later);
        return true;
      });
      if (earlier > 1 || later > 1) return fail("the chain turns at vertex " + std::to_string(v));
    }
    return true;
  }

  bool delaunay() {
    for (TriangleId t = 0; t < d_.slot_count(); ++t) {
      const Triangle& at = d_.triangle(t);
      if (Delaunay2::is_ghost(at)) continue;
      for (HalfEdge h = 4 * t; h < 4 * t + 3; ++h) {
        const VertexId p = d_.apex(d_.twin(h));
        if (p != kGhost && inside(at, p)) return fail(text(p) + " is in the disk of " + text(at));
      }
    }
    return true;
  }

  bool hull() {
    if (d_.dimension() < 2) return true;
    for (TriangleId t = 0; t < d_.slot_count(); ++t) {
      if (!d_.is_ghost(t)) continue;
      const HalfEdge ab = outer_edge(t), bc = outer_edge(d_.twin(Delaunay2::next(ab)) >> 2);
      const Point2 &a = d_.point(d_.origin(ab)), &b = d_.point(d_.target(ab));
      const Point2& c = d_.point(d_.target(bc));
      const Sign turn = orient2d(a, b, c);
      if (turn == Sign::kPositive || (turn == Sign::kZero && before(a, b) != before(b, c)))
        return fail("the hull is not convex at vertex " + text(d_.target(ab)));
    }
    return true;
  }

  static bool has(const Triangle& t, VertexId v) {
    return t.v[0] == v || t.v[1] == v || t.v[2] == v;
  }
  static bool before(const Point2& a, const Point2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  }
  HalfEdge outer_edge(TriangleId ghost) const {
    HalfEdge h = 4 * ghost;
    while (d_.apex(h) != kGhost) ++h;
    return h;
  }
  /// With ties: the incircle determinant, developed by the lift of the highest of the four
  /// vertices.
  bool inside(const Triangle& t, VertexId p) const {
    const Point2 &a = d_.point(t.v[0]), &b = d_.point(t.v[1]), &c = d_.point(t.v[2]);
    const Point2& q = d_.point(p);
    const Sign in = incircle(a, b, c, q);
    if (in != Sign::kZero) return in == Sign::kPositive;
    const VertexId top = std::max({t.v[0], t.v[1], t.v[2], p});
    if (top == t.v[0]) return orient2d(b, c, q) == Sign::kPositive;
    if (top == t.v[1]) return orient2d(c, a, q) == Sign::kPositive;
    if (top == t.v[2]) return orient2d(a, b, q) == Sign::kPositive;
    return false;
  }

  const Delaunay2& d_;
  std::string* why_;
  std::uint32_t inserted_ = 0;
};

}  // namespace

bool is_valid(const Delaunay2& triangulation, std::string* why) {
  return Check(triangulation, why).all();
}

}  // namespace circumball
