#include <cmath>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "quality/context.h"
#include "quality/triangle_measure.h"

namespace circumball {
namespace {

/// Circumcenters are rounded: inside a disk means inside by this, relative to its diameter.
constexpr double kSlack = 1e-10;

/// Vertices of the complex at which two segments meet at less than 90 degrees. Exact.
std::vector<bool> acute_corners(const Complex& complex) {
  std::vector<std::vector<Point2>> ends(complex.vertices.size());
  for (const auto& s : complex.segments) {
    if (s[0] >= ends.size() || s[1] >= ends.size()) continue;
    ends[s[0]].push_back(xy(complex.vertices[s[1]]));
    ends[s[1]].push_back(xy(complex.vertices[s[0]]));
  }
  std::vector<bool> acute(ends.size(), false);
  for (std::size_t v = 0; v < ends.size(); ++v) {
    const Point2 p = xy(complex.vertices[v]);
    for (std::size_t i = 1; i < ends[v].size() && !acute[v]; ++i) {
      for (std::size_t j = 0; j < i && !acute[v]; ++j) {
        acute[v] = ends[v][i] != ends[v][j] &&
                   in_diametral_ball(ends[v][i], ends[v][j], p) == Sign::kNegative;
      }
    }
  }
  return acute;
}

}  // namespace

/// Theorem 5.7: the circumcenter of any triangle with RE(t) > tau lies in the diametral disk of a
/// collar simplex. Collar simplices are read off the mesh: its subsegments at acute input angles
/// (every subsegment at an input vertex, where all are protected: then this asks for less).
Check check_collar(const VerifyContext& context) {
  Check check;
  check.name = "collar";
  const Mesh& mesh = context.mesh;
  const double tau = context.options.tau.value_or(0);
  std::vector<bool> acute = acute_corners(context.complex);
  if (context.options.protect_all) acute.assign(acute.size(), true);
  std::vector<bool> protects(mesh.vertices.size(), false);
  for (std::size_t i = 0; i < acute.size(); ++i) {
    if (acute[i] && context.mesh_vertex[i] != kNoIndex) protects[context.mesh_vertex[i]] = true;
  }
  std::vector<MeshEdge> collar;
  std::vector<Box2> boxes;
  for (const MeshEdge& e : mesh.edges) {
    if (!protects[e.a] && !protects[e.b]) continue;
    const Point2 a = context.point(e.a), b = context.point(e.b);
    const double dx = 0.5 * (b.x - a.x), dy = 0.5 * (b.y - a.y);
    const double r = std::sqrt(dx * dx + dy * dy) * (1 + kSlack);
    const Point2 c{a.x + dx, a.y + dy};
    collar.push_back(e);
    boxes.push_back({c.x - r, c.y - r, c.x + r, c.y + r});
  }
  const BoxTree tree(std::move(boxes));
  std::size_t allowed = 0, bad = 0;
  for (const auto& cell : context.cells) {
    const Point2 a = context.point(cell[0]), b = context.point(cell[1]), c = context.point(cell[2]);
    const TriangleMeasure m = measure_triangle(a, b, c);
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    const double u2 = ux * ux + uy * uy, v2 = vx * vx + vy * vy;
    const Point2 center{a.x + (u2 * vy - v2 * uy) / (2 * m.cross),
                        a.y + (v2 * ux - u2 * vx) / (2 * m.cross)};
    bool covered = false;
    tree.query([&](const Box2& box) { return box.meets(Box2::of(center)); },
               [&](std::uint32_t i) {
                 const Point2 p = context.point(collar[i].a), q = context.point(collar[i].b);
                 const double px = center.x - p.x, py = center.y - p.y;
                 const double qx = q.x - center.x, qy = q.y - center.y;
                 const double length2 = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
                 covered = px * qx + py * qy > -kSlack * length2;
                 return !covered;
               });
    if (covered) {
      ++allowed;
    } else if (bad++ == 0) {
      check.worst = {cell[0], cell[1], cell[2]};
    }
  }
  check.ok = bad == 0;
  check.bound = 0;
  check.observed = static_cast<double>(bad);
  check.detail = count_text(allowed, "cell") +
                 " above tau with its circumcenter in the diametral disk of one of " +
                 std::to_string(collar.size()) + " collar simplices" + " (thesis, Theorem 5.7)";
  if (bad > 0) {
    check.detail = count_text(bad, "cell") +
                   " above tau with its circumcenter in no such disk, the first is " +
                   vertices_text(check.worst);
  }
  return check;
}

}  // namespace circumball
