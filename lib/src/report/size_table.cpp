#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "circumball/report.h"

namespace circumball {
namespace {

double distance(const Point3& a, const Point3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// N(q0): distance to the nearest other vertex. A nearest neighbor is a Delaunay neighbor.
std::vector<double> nearest_neighbors(const Mesh& mesh) {
  std::vector<double> nearest(mesh.vertices.size(), HUGE_VAL);
  const auto note = [&](std::uint32_t a, std::uint32_t b) {
    const double d = distance(mesh.vertices[a], mesh.vertices[b]);
    nearest[a] = std::min(nearest[a], d);
    nearest[b] = std::min(nearest[b], d);
  };
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const std::uint32_t* v = mesh.cell(c);
    for (int i = 0; i <= mesh.dimension; ++i) {
      for (int j = 0; j < i; ++j) note(v[i], v[j]);
    }
  }
  for (const MeshEdge& e : mesh.edges) note(e.a, e.b);
  return nearest;
}

}  // namespace

std::string size_table(const Run& run, const Mesh& mesh) {
  // The upper bounds on lengths, which are lower bounds on feature sizes, hold at the end only.
  const bool complete = run.status() == Status::kComplete;
  std::string text;
  if (mesh.dimension == 3) {
    text = "segment,a,b,length,fs1_at_least,lfs_at_least\n";
    for (const MeshEdge& e : mesh.edges) {
      const double length = distance(mesh.vertices[e.a], mesh.vertices[e.b]);
      text += std::to_string(e.segment) + "," + std::to_string(e.a) + "," + std::to_string(e.b) +
              "," + number(length) + ",";
      text += complete ? number(length / std::sqrt(2.0)) + "," + number(0.6 * length) : ",";
      text += "\n";
    }
    return text;
  }
  text = "vertex,nearest,lfs_at_least,lfs_at_most\n";
  const std::vector<double> nearest = nearest_neighbors(mesh);
  for (std::uint32_t v = 0; v < mesh.input_vertices; ++v) {
    if (std::isinf(nearest[v])) continue;  // the only vertex
    text += std::to_string(v) + "," + number(nearest[v]) + "," +
            (complete ? number(nearest[v] / std::sqrt(2.0)) : "") + "," + number(2 * nearest[v]) +
            "\n";
  }
  return text;
}

}  // namespace circumball
