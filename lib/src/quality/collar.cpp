#include <cmath>

#include "complex/box_tree.h"
#include "quality/context.h"
#include "quality/protected_vertices.h"
#include "quality/triangle_measure.h"

namespace circumball {
/// Theorem 5.7: the circumcenter of any triangle with RE(t) > tau lies in the diametral disk of a
/// collar simplex. Collar simplices are read off the mesh: its subsegments at protected vertices.
Check check_collar(const VerifyContext& context) {
  Check check;
  check.name = "collar";
  const Mesh& mesh = context.mesh;
  const double tau = context.options.tau.value_or(0);
  const std::vector<double> protection = protection_distances(context);
  std::vector<MeshEdge> collar;
  std::vector<Box2> boxes;
  for (const MeshEdge& e : mesh.edges) {
    if (protection[e.a] == 0 && protection[e.b] == 0) continue;
    const Point2 a = context.point(e.a), b = context.point(e.b);
    const double dx = 0.5 * (b.x - a.x), dy = 0.5 * (b.y - a.y);
    const double r = std::sqrt(dx * dx + dy * dy) * (1 + kRoundedPosition);
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
                 covered = px * qx + py * qy > -kRoundedPosition * length2;
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
