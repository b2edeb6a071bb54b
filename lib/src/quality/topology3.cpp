#include <algorithm>
#include <numeric>

#include "quality/context3.h"

namespace circumball {
namespace {

/// How the cells at the vertices are connected: V - E + F of the link of each vertex, and its
/// parts. The link of a vertex inside a mesh is a sphere (one part, 2), on the boundary a disk (one
/// part, 1).
struct Links {
  std::size_t pinched = 0;  // boundary vertices with another link: the mesh touches itself there
  std::uint32_t bad = kNoIndex;  // an inner vertex with another link
  std::size_t bad_count = 0;
};

Links find_links(const VerifyContext3& context) {
  const std::size_t n = context.mesh.vertices.size(), m = context.cells.size();
  // Corner 4 c + i is that of cell c at its vertex i; cells that share a facet join three corners.
  std::vector<std::uint32_t> part(4 * m);
  std::iota(part.begin(), part.end(), 0u);
  const auto root = [&](std::uint32_t corner) {
    while (part[corner] != corner) corner = part[corner] = part[part[corner]];
    return corner;
  };
  std::vector<std::int64_t> twice_euler(n, 0);
  std::vector<std::uint8_t> boundary(n, 0);
  for (std::size_t v = 0; v < n; ++v)
    twice_euler[v] =
        2 * static_cast<std::int64_t>(context.neighbor_first[v + 1] - context.neighbor_first[v]);
  for (const auto& c : context.cells)
    for (const std::uint32_t v : c) twice_euler[v] += 2;
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    const std::uint32_t t = context.twin[f];
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (i == f % 4) continue;
      const std::uint32_t v = context.cells[f / 4][i];
      twice_euler[v] -= t == kNoIndex ? 2 : 1;  // a facet of two cells is met twice
      if (t == kNoIndex) boundary[v] = 1;
      if (t == kNoIndex || t < f) continue;
      const auto& other = context.cells[t / 4];
      const auto j =
          static_cast<std::uint32_t>(std::find(other.begin(), other.end(), v) - other.begin());
      part[root(f - f % 4 + i)] = root(t - t % 4 + j);
    }
  }
  std::vector<std::uint32_t> parts(n, 0);
  for (std::uint32_t corner = 0; corner < part.size(); ++corner)
    if (root(corner) == corner) ++parts[context.cells[corner / 4][corner % 4]];
  Links links;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (!context.used[v]) continue;
    if (parts[v] == 1 && twice_euler[v] == (boundary[v] ? 2 : 4)) continue;
    if (boundary[v]) {
      ++links.pinched;
    } else {
      if (links.bad == kNoIndex) links.bad = v;
      ++links.bad_count;
    }
  }
  return links;
}

}  // namespace

Check check_topology(const VerifyContext3& context) {
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
  const auto list = [](const VerifyContext3::Cell& c) {
    return std::vector<std::uint32_t>(c.begin(), c.end());
  };

  if (mesh.dimension != 3 || mesh.cells.size() % 4 != 0)
    fail(1, {}, "the mesh is not one of tetrahedra in space");
  if (mesh.dimension == 3 && context.cells.size() < mesh.cell_count()) {
    std::uint32_t bad = 0;
    while (bad < context.cell_number.size() && context.cell_number[bad] == bad) ++bad;
    const std::uint32_t* c = mesh.cell(bad);
    fail(mesh.cell_count() - context.cells.size(), {c[0], c[1], c[2], c[3]},
         "cell " + std::to_string(bad) + " (" + vertices_text({c[0], c[1], c[2], c[3]}) +
             ") names a vertex twice, or one that is not there or not finite");
  }
  const auto inverted = std::count(context.positive.begin(), context.positive.end(), 0);
  if (inverted > 0) {
    const auto first = static_cast<std::size_t>(
        std::find(context.positive.begin(), context.positive.end(), 0) - context.positive.begin());
    fail(static_cast<std::size_t>(inverted), list(context.cells[first]),
         count_text(static_cast<std::size_t>(inverted), "cell") + " inverted or flat, first cell " +
             std::to_string(context.cell_number[first]) + " (" +
             vertices_text(list(context.cells[first])) + ")");
  }
  std::vector<VerifyContext3::Cell> sorted = context.cells;
  for (auto& c : sorted) std::sort(c.begin(), c.end());
  std::sort(sorted.begin(), sorted.end());
  std::size_t duplicates = 0;
  std::vector<std::uint32_t> duplicate;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] != sorted[i - 1]) continue;
    if (duplicates++ == 0) duplicate = list(sorted[i]);
  }
  if (duplicates > 0)
    fail(duplicates, duplicate,
         count_text(duplicates, "cell") + " repeated, first that of vertices " +
             vertices_text(duplicate));
  if (!context.bad_facets.empty()) {
    const auto& f = context.bad_facets.front();
    fail(context.bad_facets.size(), {f[0], f[1], f[2]},
         count_text(context.bad_facets.size(), "facet") +
             " with more than two cells, or two on one side, first that of " +
             vertices_text({f[0], f[1], f[2]}));
  }
  const Links links = find_links(context);
  if (links.bad != kNoIndex)
    fail(links.bad_count, {links.bad},
         "the cells at vertex " + std::to_string(links.bad) + " do not surround it as a sphere (" +
             std::to_string(links.bad_count) + " such)");

  check.ok = problems == 0;
  check.bound = 0;
  check.observed = static_cast<double>(problems);
  if (check.ok) {
    const auto vertices = static_cast<std::int64_t>(
        std::count(context.used.begin(), context.used.end(), std::uint8_t{1}));
    const auto boundary =
        static_cast<std::size_t>(std::count(context.twin.begin(), context.twin.end(), kNoIndex));
    const auto edges = static_cast<std::int64_t>(context.neighbor.size() / 2);
    const auto facets = static_cast<std::int64_t>((context.twin.size() + boundary) / 2);
    const auto cells = static_cast<std::int64_t>(context.cells.size());
    check.detail = count_text(context.cells.size(), "cell") +
                   ", all positively oriented, each facet between at most two (" +
                   std::to_string(boundary) +
                   " on the boundary), each inner vertex's link a sphere; Euler characteristic " +
                   std::to_string(vertices - edges + facets - cells);
    if (links.pinched > 0)
      check.detail += "; the boundary touches itself at " + std::to_string(links.pinched) +
                      (links.pinched == 1 ? " vertex" : " vertices");
  }
  return check;
}

}  // namespace circumball
