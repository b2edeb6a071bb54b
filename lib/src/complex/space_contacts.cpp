#include "complex/space_contacts.h"

#include <algorithm>

#include "circumball/predicates.h"

namespace circumball {

int SpaceContacts::turn(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if (a == b || b == c || c == a) return 0;
  const auto drop = [&](std::uint32_t v) {
    const Point3& p = points_[v];
    return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  };
  return static_cast<int>(orient2d(drop(a), drop(b), drop(c)));
}

int SpaceContacts::faithful_axis(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  for (int axis = 2; axis >= 0; --axis)
    if (turn(axis, a, b, c) != 0) return axis;
  return -1;
}

int SpaceContacts::volume(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                          std::uint32_t d) const {
  if (a == b || a == c || a == d || b == c || b == d || c == d) return 0;
  return static_cast<int>(orient3d(points_[a], points_[b], points_[c], points_[d]));
}

int SpaceContacts::side(const Triangle& t, std::uint32_t d) const {
  return volume(t[0], t[1], t[2], d);
}

bool SpaceContacts::before(std::uint32_t a, std::uint32_t b) const {
  const Point3 &p = points_[a], &q = points_[b];
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

bool SpaceContacts::collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return faithful_axis(a, b, c) < 0;
}

bool SpaceContacts::on_segment(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
  if (v == a || v == b) return false;
  if (before(b, a)) std::swap(a, b);
  return before(a, v) && before(v, b) && collinear(a, b, v);
}

bool SpaceContacts::in_triangle(std::uint32_t v, const Triangle& t) const {
  if (v == t[0] || v == t[1] || v == t[2] || side(t, v) != 0) return false;
  const int axis = faithful_axis(t[0], t[1], t[2]);
  if (axis < 0) return false;
  const int s = turn(axis, t[0], t[1], v);
  return s != 0 && turn(axis, t[1], t[2], v) == s && turn(axis, t[2], t[0], v) == s;
}

SpaceContacts::Meeting SpaceContacts::segments(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                               std::uint32_t d) const {
  const bool share = a == c || a == d || b == c || b == d;
  if (!share && volume(a, b, c, d) != 0) return Meeting::kNone;
  // All four in a plane, onto which some projection is one to one, unless all are collinear.
  int axis = faithful_axis(a, b, c);
  if (axis < 0) axis = faithful_axis(a, b, d);
  if (axis < 0) {
    if (before(b, a)) std::swap(a, b);
    if (before(d, c)) std::swap(c, d);
    const std::uint32_t low = before(a, c) ? c : a, high = before(b, d) ? b : d;
    return before(low, high) ? Meeting::kOverlap : Meeting::kNone;
  }
  if (share) return Meeting::kNone;
  return turn(axis, a, b, c) * turn(axis, a, b, d) < 0 &&
                 turn(axis, c, d, a) * turn(axis, c, d, b) < 0
             ? Meeting::kCross
             : Meeting::kNone;
}

SpaceContacts::Meeting SpaceContacts::segment_triangle(std::uint32_t a, std::uint32_t b,
                                                       const Triangle& t) const {
  const int sa = side(t, a), sb = side(t, b);
  if (sa != 0 || sb != 0) {
    if (sa * sb >= 0) return Meeting::kNone;
    const int s = volume(a, b, t[0], t[1]);
    return s != 0 && volume(a, b, t[1], t[2]) == s && volume(a, b, t[2], t[0]) == s
               ? Meeting::kCross
               : Meeting::kNone;
  }
  // Coplanar: convex sets are apart exactly if a line along an edge of one of them separates them.
  const int axis = faithful_axis(t[0], t[1], t[2]);
  if (axis < 0) return Meeting::kNone;
  const int inside = turn(axis, t[0], t[1], t[2]);
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t u = t[i], v = t[(i + 1) % 3];
    if (turn(axis, u, v, a) * inside <= 0 && turn(axis, u, v, b) * inside <= 0)
      return Meeting::kNone;
  }
  const int t0 = turn(axis, a, b, t[0]), t1 = turn(axis, a, b, t[1]), t2 = turn(axis, a, b, t[2]);
  if ((t0 >= 0 && t1 >= 0 && t2 >= 0) || (t0 <= 0 && t1 <= 0 && t2 <= 0)) return Meeting::kNone;
  return Meeting::kOverlap;
}

SpaceContacts::Meeting SpaceContacts::triangles(const Triangle& t, const Triangle& u) const {
  int of_t[3], of_u[3];
  for (int i = 0; i < 3; ++i) of_t[i] = side(u, t[i]);
  const auto crosses = [](const int* s) {
    return std::min({s[0], s[1], s[2]}) < 0 && std::max({s[0], s[1], s[2]}) > 0;
  };
  if (of_t[0] == 0 && of_t[1] == 0 && of_t[2] == 0) {
    const int axis = faithful_axis(t[0], t[1], t[2]);
    if (axis < 0) return Meeting::kNone;
    const auto separated = [&](const Triangle& v, const Triangle& w) {
      const int inside = turn(axis, v[0], v[1], v[2]);
      for (int i = 0; i < 3; ++i) {
        bool beyond = true;
        for (int j = 0; j < 3 && beyond; ++j)
          beyond = turn(axis, v[i], v[(i + 1) % 3], w[j]) * inside <= 0;
        if (beyond) return true;
      }
      return false;
    };
    return separated(t, u) || separated(u, t) ? Meeting::kNone : Meeting::kOverlap;
  }
  if (!crosses(of_t)) return Meeting::kNone;
  for (int i = 0; i < 3; ++i) of_u[i] = side(t, u[i]);
  if (!crosses(of_u)) return Meeting::kNone;
  // Each triangle cuts the line of both planes in an interval that ends on the two edges at its
  // apex, the vertex beyond which the other two are not. The orientation of an edge of one and an
  // edge of the other compares their ends on the line (Guigue and Devillers, Fast and robust
  // triangle-triangle overlap test using orientation predicates, 2003): intervals are apart exactly
  // if no two of the four comparisons differ in sign.
  const auto apex = [](const int* s) {
    for (int i = 0; i < 3; ++i)
      if (s[i] != 0 && s[i] * s[(i + 1) % 3] <= 0 && s[i] * s[(i + 2) % 3] <= 0) return i;
    return 0;
  };
  const int i = apex(of_t), j = apex(of_u);
  bool less = false, more = false;
  for (int k = 1; k < 3; ++k)
    for (int l = 1; l < 3; ++l) {
      const int s = volume(t[i], t[(i + k) % 3], u[j], u[(j + l) % 3]);
      less = less || s < 0;
      more = more || s > 0;
    }
  return less && more ? Meeting::kCross : Meeting::kNone;
}

}  // namespace circumball
