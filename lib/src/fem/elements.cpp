#include "fem/elements.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "predicates/elementary.h"

namespace circumball {
namespace fem {

Point2 Element::gradient(const std::array<double, 3>& values) const {
  // The gradient of a barycentric coordinate is its opposite edge, turned inward, by twice the
  // area; they sum up to zero, so that differences of values are enough.
  const double u = values[1] - values[0], v = values[2] - values[0];
  return {-(u * edge[1].y + v * edge[2].y) / (2 * area),
          (u * edge[1].x + v * edge[2].x) / (2 * area)};
}

Element element(const Point2& a, const Point2& b, const Point2& c) {
  Element e;
  e.corner = {a, b, c};
  e.edge = {Point2{c.x - b.x, c.y - b.y}, Point2{a.x - c.x, a.y - c.y},
            Point2{b.x - a.x, b.y - a.y}};
  // From the two shorter edges: the least is lost in their difference.
  const auto square = [](const Point2& p) { return p.x * p.x + p.y * p.y; };
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (square(e.edge[k]) > square(e.edge[longest])) longest = k;
  }
  const Point2 &p = e.edge[(longest + 1) % 3], &q = e.edge[(longest + 2) % 3];
  e.area = 0.5 * (p.x * q.y - p.y * q.x);
  return e;
}

Element element(const Mesh& mesh, std::size_t cell) {
  const std::uint32_t* v = mesh.cell(cell);
  return element(xy(mesh.vertices[v[0]]), xy(mesh.vertices[v[1]]), xy(mesh.vertices[v[2]]));
}

std::string unusable(const Mesh& mesh) {
  if (mesh.dimension != 2) return "linear elements are for meshes of the plane";
  if (mesh.cells.empty()) return "the mesh has no triangles";
  if (mesh.cells.size() % 3 != 0) return "the list of cells ends within a triangle";
  for (const std::uint32_t v : mesh.cells) {
    if (v >= mesh.vertices.size()) {
      return "a cell has the vertex " + std::to_string(v) + ", but there are only " +
             std::to_string(mesh.vertices.size());
    }
  }
  for (const Point3& p : mesh.vertices) {
    // Their squares and the areas must be finite, too.
    if (!(std::fabs(p.x) <= 1e100 && std::fabs(p.y) <= 1e100)) {
      return "a vertex of the mesh is not finite, or beyond 1e100";
    }
  }
  return "";
}

std::vector<std::array<std::uint32_t, 2>> boundary_edges(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges, boundary;
  edges.reserve(mesh.cells.size());
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.cell(i)[k], b = mesh.cell(i)[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) boundary.push_back(edges[i]);
    i = next;
  }
  return boundary;
}

CellError cell_error(const Element& element, const std::array<double, 3>& values,
                     const PlaneFunction& u, QuadratureBudget* budget) {
  const Point2 g = element.gradient(values);
  const auto f = [&](const Barycentric& at) {
    const PlaneFunction::Derivatives d = u.derivatives(element.at(at));
    const double e = d.value - (at[0] * values[0] + at[1] * values[1] + at[2] * values[2]);
    const double x = d.x - g.x, y = d.y - g.y;
    return std::array<double, 5>{e * e, x * x + y * y, d.value * d.value, d.x * d.x + d.y * d.y,
                                 d.xx * d.xx + 2 * (d.xy * d.xy) + d.yy * d.yy};
  };
  // What rounding of the values leaves is not divided further.
  double size = 0, longest = 0;
  for (int k = 0; k < 3; ++k) {
    size = std::max(size, std::fabs(values[k]));
    longest = std::max(longest, std::sqrt(element.edge[k].x * element.edge[k].x +
                                          element.edge[k].y * element.edge[k].y));
  }
  const double noise = 1e-14 * size, slope = noise * longest / (2 * element.area);
  const Integral<5> mean = average<5>(f, 2, {noise * noise, slope * slope, 0, 0, 0}, budget);
  const double area = element.area;
  return {mean.value[0] * area, mean.value[1] * area, mean.value[2] * area,
          mean.value[3] * area, mean.value[4] * area, mean.settled};
}

void measure_error(const Mesh& mesh, const PlaneFunction& u, ErrorField* field) {
  field->size = mesh_size(mesh);
  const std::size_t cells = mesh.cell_count();
  field->cell_l2.assign(cells, 0);
  field->cell_h1.assign(cells, 0);
  QuadratureBudget budget;
  CellError sum;
  for (std::size_t i = 0; i < cells; ++i) {
    const Element t = element(mesh, i);
    if (!(t.area > 0)) continue;
    const std::uint32_t* v = mesh.cell(i);
    const CellError cell =
        cell_error(t, {field->nodal[v[0]], field->nodal[v[1]], field->nodal[v[2]]}, u, &budget);
    if (!std::isfinite(cell.l2 + cell.h1)) {
      const Point2 middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
      field->error = "u or its gradient is not finite near " + place(middle) +
                     ": choose a function that is defined on the whole mesh";
      return;
    }
    field->cell_l2[i] = std::sqrt(cell.l2);
    field->cell_h1[i] = std::sqrt(cell.h1);
    sum.l2 += cell.l2;
    sum.h1 += cell.h1;
    sum.u_l2 += cell.u_l2;
    sum.u_h1 += cell.u_h1;
    sum.u_h2 += cell.u_h2;
    if (!cell.settled) ++field->unsettled_cells;
  }
  field->l2 = std::sqrt(sum.l2);
  field->h1 = std::sqrt(sum.h1);
  field->u = {std::sqrt(sum.u_l2), std::sqrt(sum.u_h1), std::sqrt(sum.u_h2)};
  field->points = budget.spent;
  if (field->size.flat_cells > 0) {
    field->warning = std::to_string(field->size.flat_cells) +
                     " triangles have no area in double precision and were left out.";
  } else if (100 * field->unsettled_cells > field->size.cells) {
    field->warning = "The quadrature did not settle on " + std::to_string(field->unsettled_cells) +
                     " triangles: u varies within them too much to measure its error well.";
  }
}

std::string place(const Point2& p) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.6g, %.6g)", p.x, p.y);
  return text;
}

}  // namespace fem

MeshSize mesh_size(const Mesh& mesh) {
  MeshSize size;
  if (!fem::unusable(mesh).empty()) return size;
  const double degrees = 180 / elementary::kPi;
  std::vector<char> used(mesh.vertices.size(), 0);
  size.cells = mesh.cell_count();
  size.min_angle_degrees = 180;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const fem::Element t = fem::element(mesh, i);
    double product = 1;
    for (int k = 0; k < 3; ++k) {
      used[mesh.cell(i)[k]] = 1;
      const Point2 &p = t.edge[(k + 1) % 3], &q = t.edge[(k + 2) % 3];
      const double length = std::sqrt(t.edge[k].x * t.edge[k].x + t.edge[k].y * t.edge[k].y);
      size.h = std::max(size.h, length);
      product *= length;
      const double angle =
          elementary::atan2(2 * std::max(t.area, 0.0), -(p.x * q.x + p.y * q.y)) * degrees;
      size.min_angle_degrees = std::min(size.min_angle_degrees, angle);
      size.max_angle_degrees = std::max(size.max_angle_degrees, angle);
    }
    if (t.area > 0) {
      size.area += t.area;
      size.max_circumradius = std::max(size.max_circumradius, product / (4 * t.area));
    } else {
      ++size.flat_cells;
    }
  }
  size.vertices = static_cast<std::uint64_t>(std::count(used.begin(), used.end(), 1));
  return size;
}

}  // namespace circumball
