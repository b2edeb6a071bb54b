#include <algorithm>
#include <functional>
#include <limits>

#include "io/formats.h"
#include "io/mesh_parts.h"

// Gmsh's MSH format, ASCII, versions 4.1 and 2.2 (Gmsh Reference Manual, "Gmsh mesh file formats").
namespace circumball::io {
namespace {

/// Types of elements in Gmsh.
constexpr int kLine = 1, kTriangle = 2, kTetrahedron = 4;

/// One physical group: its tag, its name, and its elements.
struct Group {
  std::int64_t tag = 0;
  std::string name;
  std::vector<std::size_t> members;
};

/// Sorts elements into groups by a key, in the order of the keys. A key is the tag where all are
/// positive integers.
template <class Key>
std::vector<Group> group_by(std::size_t count, Key key, const std::string& what) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return key(i) != key(j) ? key(i) < key(j) : i < j;
  });
  std::vector<Group> groups;
  bool tags = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = key(order[i]);
    if (i == 0 || k != key(order[i - 1])) {
      tags = tags && k >= 1 && k <= std::numeric_limits<std::int32_t>::max() &&
             k == static_cast<double>(static_cast<std::int64_t>(k));
      groups.push_back(
          {tags ? static_cast<std::int64_t>(k) : 0, what + " " + format_double(k), {}});
    }
    groups.back().members.push_back(order[i]);
  }
  if (!tags)
    for (std::size_t i = 0; i < groups.size(); ++i)
      groups[i].tag = static_cast<std::int64_t>(i) + 1;
  return groups;
}

/// The elements of one dimension: lines, then triangles, then tetrahedra.
struct Layer {
  int dimension, type;
  std::vector<Group> groups;
  std::function<std::vector<std::uint32_t>(std::size_t)> vertices;  ///< of element i
};

/// Elements by marker, or where there are no markers by input feature (numbered from 1; 0: none
/// that is known).
template <class Marker, class Feature>
std::vector<Group> by_marker_or(const std::string& what, std::size_t count, bool marked,
                                Marker marker, Feature feature) {
  if (marked)
    return group_by(
        count, [&](std::size_t i) { return static_cast<double>(marker(i)); }, "marker");
  return group_by(
      count,
      [&](std::size_t i) {
        const std::uint32_t f = feature(i);
        return f == kNoIndex ? 0.0 : static_cast<double>(f) + 1;
      },
      what);
}

std::vector<Layer> layers_of(const Mesh& mesh, const Complex& complex) {
  std::vector<Layer> out;
  out.push_back({1, kLine,
                 by_marker_or(
                     "segment", mesh.edges.size(), !mesh.edge_markers.empty(),
                     [&](std::size_t i) { return mesh.edge_markers[i]; },
                     [&](std::size_t i) { return mesh.edges[i].segment; }),
                 [&](std::size_t i) {
                   return std::vector<std::uint32_t>{mesh.edges[i].a, mesh.edges[i].b};
                 }});
  if (mesh.dimension == 3)
    out.push_back({2, kTriangle,
                   by_marker_or(
                       "face", mesh.facets.size(), !complex.face_markers.empty(),
                       [&](std::size_t i) { return facet_marker(mesh.facets[i], complex); },
                       [&](std::size_t i) { return mesh.facets[i].face; }),
                   [&](std::size_t i) {
                     const MeshFacet& f = mesh.facets[i];
                     return std::vector<std::uint32_t>{f.a, f.b, f.c};
                   }});
  const auto region = [&](std::size_t i) {
    const double label = mesh.cell_regions.empty() ? 0 : mesh.cell_regions[i];
    return label == label ? label : 0;  // NaN has no place in an order
  };
  out.push_back({mesh.dimension, mesh.dimension == 2 ? kTriangle : kTetrahedron,
                 group_by(mesh.cell_count(), region, "region"), [&](std::size_t i) {
                   const auto c = right_handed(mesh, i);
                   return std::vector<std::uint32_t>(c.begin(), c.begin() + mesh.dimension + 1);
                 }});
  return out;
}

std::string numbers(const std::vector<std::uint32_t>& vertices) {
  std::string out;
  for (const std::uint32_t v : vertices) out += " " + std::to_string(std::size_t{v} + 1);
  return out + "\n";
}

/// Bounding box of an entity as "minX minY minZ maxX maxY maxZ".
std::string box(const Mesh& mesh, const Layer& layer, const Group& group) {
  Point3 low, high;
  bool any = false;
  for (const std::size_t i : group.members)
    for (const std::uint32_t v : layer.vertices(i)) {
      const Point3& p = mesh.vertices[v];
      low = any ? Point3{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)} : p;
      high = any ? Point3{std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)} : p;
      any = true;
    }
  return coordinates(low) + " " + coordinates(high);
}

std::size_t element_count(const std::vector<Layer>& layers) {
  std::size_t count = 0;
  for (const Layer& layer : layers)
    for (const Group& g : layer.groups) count += g.members.size();
  return count;
}

std::string names(const std::vector<Layer>& layers) {
  std::size_t count = 0;
  std::string out;
  for (const Layer& layer : layers)
    for (const Group& g : layer.groups) {
      ++count;
      out +=
          std::to_string(layer.dimension) + " " + std::to_string(g.tag) + " \"" + g.name + "\"\n";
    }
  return "$PhysicalNames\n" + std::to_string(count) + "\n" + out + "$EndPhysicalNames\n";
}

std::string version_2(const Mesh& mesh, const std::vector<Layer>& layers) {
  std::string out = "$Nodes\n" + std::to_string(mesh.vertices.size()) + "\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    out += std::to_string(i + 1) + " " + coordinates(mesh.vertices[i]) + "\n";
  out += "$EndNodes\n$Elements\n" + std::to_string(element_count(layers)) + "\n";
  std::size_t number = 0;
  for (const Layer& layer : layers)
    for (const Group& g : layer.groups)
      for (const std::size_t i : g.members) {
        const std::string tag = " " + std::to_string(g.tag);
        // Two tags: physical and elementary entity.
        out += std::to_string(++number) + " " + std::to_string(layer.type) + " 2" + tag + tag +
               numbers(layer.vertices(i));
      }
  return out + "$EndElements\n";
}

std::string version_4(const Mesh& mesh, const std::vector<Layer>& layers) {
  std::size_t entities[4] = {0, 0, 0, 0};
  for (const Layer& layer : layers) entities[layer.dimension] = layer.groups.size();
  std::string out = "$Entities\n0 " + std::to_string(entities[1]) + " " +
                    std::to_string(entities[2]) + " " + std::to_string(entities[3]) + "\n";
  // All nodes belong to one entity: the first of the highest dimension that has any.
  std::string owner = "1 1";
  for (const Layer& layer : layers) {
    for (const Group& g : layer.groups)
      out += std::to_string(g.tag) + " " + box(mesh, layer, g) + " 1 " + std::to_string(g.tag) +
             " 0\n";
    if (!layer.groups.empty())
      owner = std::to_string(layer.dimension) + " " + std::to_string(layer.groups[0].tag);
  }
  const std::string n = std::to_string(mesh.vertices.size());
  out += "$EndEntities\n$Nodes\n1 " + n + " 1 " + n + "\n" + owner + " 0 " + n + "\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) out += std::to_string(i + 1) + "\n";
  for (const Point3& p : mesh.vertices) out += coordinates(p) + "\n";
  const std::string count = std::to_string(element_count(layers));
  out += "$EndNodes\n$Elements\n" + std::to_string(entities[1] + entities[2] + entities[3]) + " " +
         count + " 1 " + count + "\n";
  std::size_t number = 0;
  for (const Layer& layer : layers)
    for (const Group& g : layer.groups) {
      out += std::to_string(layer.dimension) + " " + std::to_string(g.tag) + " " +
             std::to_string(layer.type) + " " + std::to_string(g.members.size()) + "\n";
      for (const std::size_t i : g.members)
        out += std::to_string(++number) + numbers(layer.vertices(i));
    }
  return out + "$EndElements\n";
}

}  // namespace

std::string write_msh(const Mesh& mesh, const Complex& complex, bool old) {
  const std::vector<Layer> layers = layers_of(mesh, complex);
  return std::string("$MeshFormat\n") + (old ? "2.2" : "4.1") + " 0 8\n$EndMeshFormat\n" +
         names(layers) + (old ? version_2(mesh, layers) : version_4(mesh, layers));
}

}  // namespace circumball::io
