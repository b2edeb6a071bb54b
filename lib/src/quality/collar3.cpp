#include <algorithm>
#include <cmath>
#include <vector>

#include "complex/box_tree.h"
#include "feature_size/vectors.h"
#include "quality/acute_features.h"
#include "quality/context3.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {
namespace {

/// Vertices on arcs and in sloping faces are rounded, and balls are compared with a slack when they
/// are made: the same here, relative to squared lengths.
constexpr double kRoundedPower = 1e-9;

/// The smallest ball of an edge or of a triangle.
struct Ball {
  Point3 center;
  double radius2 = 0;
};

Ball ball_of(const Point3& a, const Point3& b) {
  const Point3 d = b - a;
  return {{a.x + 0.5 * d.x, a.y + 0.5 * d.y, a.z + 0.5 * d.z}, 0.25 * dot(d, d)};
}

Ball ball_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u = b - a, v = c - a, n = cross(u, v);
  const double uu = dot(u, u), vv = dot(v, v), t = 0.5 / dot(n, n);
  const Point3 vn = cross(v, n), nu = cross(n, u);
  const Point3 o = {(uu * vn.x + vv * nu.x) * t, (uu * vn.y + vv * nu.y) * t,
                    (uu * vn.z + vv * nu.z) * t};
  return {{a.x + o.x, a.y + o.y, a.z + o.z}, dot(o, o)};
}

struct Vector2fold {
  Twofold x, y, z;
};
Twofold negative(const Twofold& a) { return {-a.high, -a.low}; }
Vector2fold cross(const Vector2fold& a, const Vector2fold& b) {
  const auto minor = [](const Twofold& p, const Twofold& q, const Twofold& r, const Twofold& t) {
    return p * t + negative(q * r);
  };
  return {minor(a.y, a.z, b.y, b.z), minor(a.z, a.x, b.z, b.x), minor(a.x, a.y, b.x, b.y)};
}
Twofold dot(const Vector2fold& a, const Vector2fold& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// In twice the digits: flat tetrahedra are normal, as rectangles beside segments are cocircular.
Point3 circumcenter(const Point3& o, const Point3& p, const Point3& q, const Point3& r) {
  const auto from_o = [&](const Point3& v) -> Vector2fold {
    return {Twofold{v.x} + Twofold{-o.x}, Twofold{v.y} + Twofold{-o.y},
            Twofold{v.z} + Twofold{-o.z}};
  };
  const Vector2fold a = from_o(p), b = from_o(q), c = from_o(r);
  const Vector2fold bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Twofold a2 = dot(a, a), b2 = dot(b, b), c2 = dot(c, c);
  const double t = 0.5 / dot(a, bc).high;
  return {o.x + (a2 * bc.x + b2 * ca.x + c2 * ab.x).high * t,
          o.y + (a2 * bc.y + b2 * ca.y + c2 * ab.y).high * t,
          o.z + (a2 * bc.z + b2 * ca.z + c2 * ab.z).high * t};
}

/// The boundary of a mesh of the convex hull: the theorem is about domains that end at faces, and a
/// hull need not.
std::vector<std::uint32_t> hull_facets(const VerifyContext3& context) {
  std::vector<std::uint32_t> border;
  if (context.options.domain != "hull") return border;
  for (std::uint32_t f = 0; f < context.twin.size(); ++f)
    if (context.twin[f] == kNoIndex) border.push_back(f);
  return border;
}

/// Whether p is on the outer side of a facet of the hull, or on it but for rounding.
bool is_beyond(const VerifyContext3& context, const std::vector<std::uint32_t>& border,
               const Point3& p) {
  if (!border.empty() && !std::isfinite(dot(p, p))) return true;  // of a cell without volume
  return std::any_of(border.begin(), border.end(), [&](std::uint32_t f) {
    const auto v = context.corners(f);
    const Point3& a = context.point(v[0]);
    const Point3 n = cross(context.point(v[1]) - a, context.point(v[2]) - a);
    return dot(n, p - a) >= -2 * context.rounding * std::sqrt(dot(n, n));
  });
}

}  // namespace

/// Theorem 6.11: the circumcenter of any tetrahedron with RE(t) > tau lies in the ball of a collar
/// simplex. Collar simplices are read off the mesh: its subsegments on protected segments and at
/// protected vertices, and its facets in faces that touch these.
Check check_collar(const VerifyContext3& context) {
  Check check;
  check.name = "collar";
  const Mesh& mesh = context.mesh;
  const double tau = context.options.tau.value_or(0);
  const ProtectedFeatures features = protected_features(context, RightAngles::kProtected);
  const auto is_protected = [&](const std::vector<bool>& list, std::uint32_t i) {
    return i < list.size() ? list[i] : context.options.protect_all;  // beyond: of the box
  };
  const auto on_protected = [&](std::uint32_t v) {
    if (v >= mesh.vertex_features.size()) return false;
    const Feature& f = mesh.vertex_features[v];
    if (f.kind == FeatureKind::kVertex) return is_protected(features.vertices, f.index);
    return f.kind == FeatureKind::kSegment && is_protected(features.segments, f.index);
  };
  const auto is_protected_vertex = [&](std::uint32_t v) {
    return on_protected(v) && mesh.vertex_features[v].kind == FeatureKind::kVertex;
  };
  const auto usable = [&](std::uint32_t v) { return v < context.used.size() && context.used[v]; };
  std::vector<Ball> balls;
  std::vector<Box3> boxes;
  const auto add = [&](const Ball& ball) {
    const double r = std::sqrt(ball.radius2) * (1 + kRoundedPower);
    const Point3& c = ball.center;
    balls.push_back(ball);
    boxes.push_back(Box3::of({c.x - r, c.y - r, c.z - r}, {c.x + r, c.y + r, c.z + r}));
  };
  for (const MeshEdge& e : mesh.edges) {
    if (!usable(e.a) || !usable(e.b)) continue;
    if (is_protected(features.segments, e.segment) || is_protected_vertex(e.a) ||
        is_protected_vertex(e.b))
      add(ball_of(context.point(e.a), context.point(e.b)));
  }
  for (const MeshFacet& f : mesh.facets) {
    if (!usable(f.a) || !usable(f.b) || !usable(f.c)) continue;
    if (!on_protected(f.a) && !on_protected(f.b) && !on_protected(f.c)) continue;
    if (context.is_between_layers(f)) continue;
    add(ball_of(context.point(f.a), context.point(f.b), context.point(f.c)));
  }
  const BoxTree3 tree(std::move(boxes));
  std::size_t allowed = 0, bad = 0, outside = 0;
  const std::vector<std::uint32_t> border = hull_facets(context);
  for (const auto& cell : context.cells) {
    const Point3 &a = context.point(cell[0]), &b = context.point(cell[1]),
                 &c = context.point(cell[2]), &d = context.point(cell[3]);
    const TetrahedronMeasure m = measure_tetrahedron(a, b, c, d);
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    const Point3 center = circumcenter(a, b, c, d);
    bool covered = false;
    tree.query([&](const Box3& box) { return box.meets(Box3::of(center)); },
               [&](std::uint32_t i) {
                 const Point3 q = center - balls[i].center;
                 covered = dot(q, q) <= balls[i].radius2 * (1 + kRoundedPower);
                 return !covered;
               });
    if (covered) {
      ++allowed;
    } else if (is_beyond(context, border, center)) {
      ++outside;
    } else if (bad++ == 0) {
      check.worst = {cell[0], cell[1], cell[2], cell[3]};
    }
  }
  check.ok = bad == 0;
  check.bound = 0;
  check.observed = static_cast<double>(bad);
  check.detail = count_text(allowed, "cell") +
                 " above tau with its circumcenter in the ball of one of " +
                 std::to_string(balls.size()) + " collar simplices (thesis, Theorem 6.11)";
  if (outside > 0) {
    check.detail += "; " + count_text(outside, "other cell") +
                    " with it outside of the convex hull, or without volume";
  }
  if (bad > 0) {
    check.detail =
        count_text(bad, "cell") +
        " above tau with its circumcenter in no ball of a collar simplex, the first is " +
        vertices_text(check.worst);
  }
  return check;
}

}  // namespace circumball
