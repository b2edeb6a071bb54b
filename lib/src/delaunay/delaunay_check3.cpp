#include <algorithm>
#include <array>
#include <vector>

#include "circumball/predicates.h"
#include "delaunay/delaunay_check.h"

namespace circumball {
namespace {

using Cell = Delaunay3::Cell;
constexpr VertexId kGhost = Delaunay3::kGhost;

std::string text(VertexId v) { return v == kGhost ? "ghost" : std::to_string(v.value); }

std::string text(const Cell& c) {
  return "(" + text(c.v[0]) + ", " + text(c.v[1]) + ", " + text(c.v[2]) + ", " + text(c.v[3]) + ")";
}

/// The numbered post-conditions of is_valid, one function each.
class Check3 {
 public:
  Check3(const Delaunay3& d, std::string* why) : d_(d), why_(why) {}

  bool all() {
    if (!counts()) return false;
    if (d_.dimension() < 2) return chain();
    return corners() && adjacency() && links() && order() && delaunay() && hull();
  }

 private:
  bool fail(const std::string& sentence) {
    if (why_) *why_ = sentence;
    return false;
  }
  const Point3& at(VertexId v) const { return d_.point(v); }

  bool counts() {
    for (std::uint32_t v = 0; v < d_.vertex_count(); ++v)
      if (d_.inserted(VertexId(v))) inserted_.push_back(VertexId(v));
    for (CellSlot c = 0; c < d_.slot_count(); ++c)
      if (d_.alive(c)) cells_.push_back(c);
    const int n = static_cast<int>(std::min<std::size_t>(inserted_.size(), 5)), k = d_.dimension();
    if (k > n - 1 || k > 3 || k < std::min(n - 1, 1))
      return fail("dimension " + std::to_string(k) + " with " + std::to_string(inserted_.size()) +
                  " vertices");
    return k >= 2 || cells_.empty() || fail("there are cells below dimension 2");
  }

  /// Collinear: three points are if they are in each coordinate plane.
  static bool collinear(const Point3& a, const Point3& b, const Point3& c) {
    return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::kZero &&
           orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::kZero &&
           orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == Sign::kZero;
  }

  bool chain() {
    std::vector<VertexId> sorted = inserted_, neighbors;
    std::sort(sorted.begin(), sorted.end(), [this](VertexId a, VertexId b) {
      const Point3 &p = at(a), &q = at(b);
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (!collinear(at(sorted.front()), at(sorted.back()), at(sorted[i])))
        return fail("vertex " + text(sorted[i]) + " is off the line in dimension 1");
      d_.neighbors(sorted[i], &neighbors);
      std::vector<VertexId> expected;
      if (i > 0) expected.push_back(sorted[i - 1]);
      if (i + 1 < sorted.size()) expected.push_back(sorted[i + 1]);
      if (neighbors != expected) return fail("the chain is wrong at vertex " + text(sorted[i]));
    }
    return true;
  }

  bool corners() {
    for (const CellSlot c : cells_) {
      const Cell cell = d_.cell(c);
      if (d_.dimension() == 2 && !Delaunay3::is_ghost(cell))
        return fail("a cell that is no ghost in dimension 2: " + text(cell));
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j)
          if (cell.v[i] == cell.v[j]) return fail("a vertex twice in " + text(cell));
        if (i == 3 && cell.v[i] == kGhost) continue;
        if (cell.v[i].value >= d_.vertex_count() || !d_.inserted(cell.v[i]))
          return fail("a vertex that is not inserted in " + text(cell));
      }
    }
    for (const VertexId v : inserted_) {
      const CellSlot c = d_.cell_of(v);
      if (c == kNone || !d_.alive(c) || !has(d_.cell(c), v))
        return fail("cell_of(" + text(v) + ") is not at the vertex");
    }
    const CellSlot ghost = d_.some_ghost();
    return (ghost != kNone && d_.alive(ghost) && d_.is_ghost(ghost)) ||
           fail("some_ghost() is no ghost");
  }

  bool adjacency() {
    for (const CellSlot c : cells_)
      for (CellFacet f = 4 * c; f < 4 * c + 4; ++f) {
        const CellFacet o = d_.twin(f);
        if (!d_.alive(o >> 2) || d_.twin(o) != f || o >> 2 == c)
          return fail("facet " + std::to_string(f) + " has no proper twin");
        // The same corners the other way round.
        int same = 0;
        for (int turn = 0; turn < 3; ++turn) {
          bool equal = true;
          for (int i = 0; i < 3; ++i)
            equal = equal && d_.facet_corner(f, i) == d_.facet_corner(o, (turn + 3 - i) % 3);
          same += equal;
        }
        if (same != 1) return fail("twins do not fit at " + text(d_.cell(c)));
      }
    return true;
  }

  /// The link of every vertex is a connected surface of Euler characteristic 2, a sphere: so the
  /// cells form a manifold. In dimension 2 kGhost is two points of the link of an inner vertex.
  bool links() {
    std::vector<std::uint32_t> count(d_.vertex_count(), 0);
    for (const CellSlot c : cells_)
      for (const VertexId v : d_.cell(c).v)
        if (v != kGhost) ++count[v.value];
    std::vector<CellSlot> star;
    std::vector<VertexId> around;
    for (const VertexId v : inserted_) {
      d_.cells_at(v, &star);
      if (star.size() != count[v.value])
        return fail("the cells at vertex " + text(v) + " do not hang together");
      d_.neighbors(v, &around);
      bool at_hull = false, at_rim = false;
      for (const CellSlot c : star) {
        const Cell cell = d_.cell(c);
        at_hull = at_hull || Delaunay3::is_ghost(cell);
        for (int i = 0; i < 3; ++i)
          at_rim = at_rim || (cell.v[i] != v && cell.n[i] >> 2 == cell.n[3] >> 2);
      }
      const std::size_t ghosts = d_.dimension() == 2 ? (at_rim ? 1 : 2) : at_hull ? 1 : 0;
      if (2 * (around.size() + ghosts) != star.size() + 4)
        return fail("the link of vertex " + text(v) + " is no sphere");
    }
    return true;
  }

  bool order() {
    for (const CellSlot c : cells_) {
      const Cell cell = d_.cell(c);
      if (!Delaunay3::is_ghost(cell)) {
        if (orient3d(at(cell.v[0]), at(cell.v[1]), at(cell.v[2]), at(cell.v[3])) != Sign::kPositive)
          return fail("not positively oriented: " + text(cell));
      } else if (collinear(at(cell.v[0]), at(cell.v[1]), at(cell.v[2]))) {
        return fail("collinear corners: " + text(cell));
      }
    }
    if (d_.dimension() == 3) return true;
    const Cell first = d_.cell(cells_.front());
    for (const VertexId v : inserted_)
      if (orient3d(at(first.v[0]), at(first.v[1]), at(first.v[2]), at(v)) != Sign::kZero)
        return fail("vertex " + text(v) + " is off the plane in dimension 2");
    return true;
  }

  bool delaunay() {
    for (const CellSlot c : cells_) {
      if (d_.is_ghost(c)) continue;
      const Cell cell = d_.cell(c);
      for (int i = 0; i < 4; ++i) {
        const VertexId p = d_.apex(cell.n[i]);
        if (p == kGhost) continue;
        const Corner corners[5] = {corner(cell.v[0]), corner(cell.v[1]), corner(cell.v[2]),
                                   corner(cell.v[3]), corner(p)};
        if (inside(corners)) return fail(text(p) + " is in the ball of " + text(cell));
      }
    }
    return true;
  }

  /// The hull is convex at every edge. Where it is flat, its triangles are on either side of the
  /// edge, and locally Delaunay.
  bool hull() {
    for (const CellSlot c : cells_) {
      const Cell cell = d_.cell(c);
      if (!Delaunay3::is_ghost(cell)) continue;
      const Point3 &p = at(cell.v[0]), &q = at(cell.v[1]), &r = at(cell.v[2]);
      for (int i = 0; i < 3; ++i) {
        const VertexId s = d_.apex(cell.n[i]);
        const bool rim = d_.dimension() == 2 && s == cell.v[i];
        const Sign side = orient3d(p, q, r, at(s));
        if (side == Sign::kPositive) return fail("the hull is not convex at " + text(cell));
        if (side == Sign::kNegative || rim) continue;
        const VertexId a = cell.v[(i + 1) % 3], b = cell.v[(i + 2) % 3];
        const Point3 off = off_plane(p, q, r);
        const Sign left = orient3d(at(a), at(b), at(cell.v[i]), off);
        const Sign right = orient3d(at(a), at(b), at(s), off);
        if (static_cast<int>(left) + static_cast<int>(right) != 0)
          return fail("the hull turns back at " + text(cell));
        Corner corners[5] = {
            corner(cell.v[0]), corner(cell.v[1]), corner(cell.v[2]), {&off, 0}, corner(s)};
        if (orient3d(p, q, r, off) == Sign::kNegative) std::swap(corners[0], corners[1]);
        if (inside(corners)) return fail(text(s) + " is in the disk of " + text(cell));
      }
    }
    if (d_.dimension() == 3) return true;
    // In dimension 2 the rim must be convex, too: it sees no vertex outside.
    for (const CellSlot c : cells_) {
      const Cell cell = d_.cell(c);
      const Point3 off = off_plane(at(cell.v[0]), at(cell.v[1]), at(cell.v[2]));
      for (int i = 0; i < 3; ++i) {
        if (cell.n[i] >> 2 != cell.n[3] >> 2) continue;
        const VertexId a = cell.v[(i + 1) % 3], b = cell.v[(i + 2) % 3];
        const Sign in = orient3d(at(a), at(b), at(cell.v[i]), off);
        for (const VertexId v : inserted_) {
          const Sign side = orient3d(at(a), at(b), at(v), off);
          if (side != Sign::kZero && side != in)
            return fail("the planar hull is not convex at " + text(a) + ", " + text(b));
        }
      }
    }
    return true;
  }

  struct Corner {
    const Point3* p;
    std::uint32_t number;
  };
  Corner corner(VertexId v) const { return {&d_.point(v), v.value}; }

  static bool has(const Cell& c, VertexId v) {
    return c.v[0] == v || c.v[1] == v || c.v[2] == v || c.v[3] == v;
  }
  static Point3 off_plane(const Point3& a, const Point3& b, const Point3& c) {
    Point3 off{0, 0, 0};
    for (const Point3& next : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
      if (orient3d(a, b, c, off) != Sign::kZero) break;
      off = next;
    }
    return off;
  }
  /// With ties: the insphere determinant is linear in the lifts, and that of the highest number
  /// whose coefficient does not vanish decides. The coefficient of a corner is the orientation with
  /// the fifth point in its place, that of the fifth point is negative. Corners of the same number
  /// as others must have no coefficient.
  static bool inside(const Corner (&c)[5]) {
    const Sign in = insphere(*c[0].p, *c[1].p, *c[2].p, *c[3].p, *c[4].p);
    if (in != Sign::kZero) return in == Sign::kPositive;
    std::array<int, 5> order{0, 1, 2, 3, 4};
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return c[i].number != c[j].number ? c[i].number > c[j].number : i < j;
    });
    for (const int i : order) {
      if (i == 4) return false;
      const Point3* p[4] = {c[0].p, c[1].p, c[2].p, c[3].p};
      p[i] = c[4].p;
      const Sign side = orient3d(*p[0], *p[1], *p[2], *p[3]);
      if (side != Sign::kZero) return side == Sign::kPositive;
    }
    return false;
  }

  const Delaunay3& d_;
  std::string* why_;
  std::vector<VertexId> inserted_;
  std::vector<CellSlot> cells_;
};

}  // namespace

bool is_valid(const Delaunay3& triangulation, std::string* why) {
  return Check3(triangulation, why).all();
}

}  // namespace circumball
