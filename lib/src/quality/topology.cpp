#include <algorithm>

#include "quality/context.h"

namespace circumball {
namespace {

bool upward(const Point2& from, const Point2& to) {
  return to.y > from.y || (to.y == from.y && to.x > from.x);
}

/// How the cells at the vertices are connected.
struct Links {
  std::size_t pinched = 0;  // vertices with several fans: the mesh touches itself there
  std::uint32_t bad =
      kNoIndex;  // a vertex with a full turn of cells and more, or that is wound around twice
  std::size_t bad_count = 0;
};

Links find_links(const VerifyContext& context) {
  // A corner is named by its half-edge (the one opposite to it). Turning counter-clockwise at v
  // crosses the half-edge that ends at v, whose twin starts there.
  const auto next_corner = [](std::uint32_t h, std::uint32_t k) {
    return h - h % 3 + (h % 3 + k) % 3;
  };
  const std::uint32_t corners = static_cast<std::uint32_t>(3 * context.cells.size());
  const std::size_t n = context.mesh.vertices.size();
  std::vector<std::uint8_t> seen(corners, 0);
  std::vector<std::uint32_t> paths(n, 0), cycles(n, 0);
  std::vector<std::uint8_t> wound(n, 0);
  for (std::uint32_t c = 0; c < corners; ++c) {  // paths start where nothing lies clockwise
    if (context.twin[next_corner(c, 2)] != kNoIndex) continue;
    ++paths[context.apex(c)];
    for (std::uint32_t at = c; !seen[at];) {
      seen[at] = 1;
      const std::uint32_t across = context.twin[next_corner(at, 1)];
      if (across == kNoIndex) break;
      at = next_corner(across, 1);
    }
  }
  for (std::uint32_t c = 0; c < corners; ++c) {
    if (seen[c]) continue;
    const std::uint32_t v = context.apex(c);
    const Point2 center = context.point(v);
    int turns = 0;
    for (std::uint32_t at = c; !seen[at];) {
      seen[at] = 1;
      // the spoke from the first to the second edge of the cell: it rises once in every full turn
      if (!upward(center, context.point(context.origin(at))) &&
          upward(center, context.point(context.target(at))))
        ++turns;
      at = next_corner(context.twin[next_corner(at, 1)], 1);
    }
    ++cycles[v];
    if (turns != 1) wound[v] = 1;
  }
  Links links;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (wound[v] || cycles[v] > 1 || (cycles[v] == 1 && paths[v] > 0)) {
      if (links.bad == kNoIndex) links.bad = v;
      ++links.bad_count;
    } else if (paths[v] > 1) {
      ++links.pinched;
    }
  }
  return links;
}

}  // namespace

Check check_topology(const VerifyContext& context) {
  Check check;
  check.name = "topology";
  const Mesh& mesh = context.mesh;
  std::size_t problems = 0;
  const auto fail = [&](std::size_t count, std::vector<std::uint32_t> worst, std::string sentence) {
    if (problems == 0) {
      check.worst = std::move(worst);
      check.detail = std::move(sentence);
    }
    problems += count;
  };

  if (mesh.dimension != 2 || mesh.cells.size() % 3 != 0)
    fail(1, {}, "the mesh is not one of triangles in the plane");
  if (context.cells.size() < mesh.cell_count() && mesh.dimension == 2) {
    std::uint32_t bad = 0;
    while (bad < context.cell_number.size() && context.cell_number[bad] == bad) ++bad;
    const std::uint32_t* c = mesh.cell(bad);
    fail(mesh.cell_count() - context.cells.size(), {c[0], c[1], c[2]},
         "cell " + std::to_string(bad) + " (" + vertices_text({c[0], c[1], c[2]}) +
             ") names a vertex twice, or one that is not there or not finite");
  }
  std::size_t inverted = 0;
  std::uint32_t first_inverted = kNoIndex;
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    if (context.positive[i]) continue;
    if (inverted++ == 0) first_inverted = i;
  }
  if (inverted > 0) {
    const auto& c = context.cells[first_inverted];
    fail(inverted, {c[0], c[1], c[2]},
         count_text(inverted, "cell") + " clockwise or flat, first cell " +
             std::to_string(context.cell_number[first_inverted]) + " (" +
             vertices_text({c[0], c[1], c[2]}) + ")");
  }
  std::vector<VerifyContext::Cell> sorted = context.cells;
  for (auto& c : sorted) std::sort(c.begin(), c.end());
  std::sort(sorted.begin(), sorted.end());
  std::size_t duplicates = 0;
  std::vector<std::uint32_t> duplicate;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] != sorted[i - 1]) continue;
    if (duplicates++ == 0) duplicate.assign(sorted[i].begin(), sorted[i].end());
  }
  if (duplicates > 0)
    fail(duplicates, duplicate,
         count_text(duplicates, "cell") + " repeated, first that of vertices " +
             vertices_text(duplicate));
  if (!context.bad_edges.empty()) {
    const auto& e = context.bad_edges.front();
    fail(context.bad_edges.size(), {e[0], e[1]},
         count_text(context.bad_edges.size(), "edge") +
             " with more than two cells, or two on one side, first that from " +
             vertices_text({e[0], e[1]}));
  }
  const Links links = find_links(context);
  if (links.bad != kNoIndex)
    fail(links.bad_count, {links.bad},
         "the cells at vertex " + std::to_string(links.bad) +
             " do not go around it exactly once (" + std::to_string(links.bad_count) + " such)");

  std::size_t vertices = 0, boundary = 0;
  for (const std::uint8_t u : context.used) vertices += u;
  for (const std::uint32_t t : context.twin) boundary += t == kNoIndex;
  check.ok = problems == 0;
  check.bound = 0;
  check.observed = static_cast<double>(problems);
  if (check.ok) {
    const std::int64_t euler = static_cast<std::int64_t>(vertices) -
                               static_cast<std::int64_t>(context.edge_count) +
                               static_cast<std::int64_t>(context.cells.size());
    check.detail = count_text(context.cells.size(), "cell") +
                   ", all counter-clockwise, each edge between at most two (" +
                   std::to_string(boundary) +
                   " on the boundary), each vertex's link a cycle or paths; Euler characteristic " +
                   std::to_string(euler);
    if (links.pinched > 0)
      check.detail += "; the boundary touches itself at " + std::to_string(links.pinched) +
                      (links.pinched == 1 ? " vertex" : " vertices");
  }
  return check;
}

}  // namespace circumball
