#include <algorithm>
#include <limits>

#include "io/formats.h"

// Gmsh's MSH format, ASCII, versions 4.1 and 2.2 (Gmsh Reference Manual, "Gmsh mesh file formats").
namespace circumball::io {
namespace {

/// Types of elements in Gmsh.
constexpr int kLine = 1, kTriangle = 2;

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

/// Subsegments by marker, or where there are none by input segment (numbered from 1; 0: none that
/// is known).
std::vector<Group> curves(const Mesh& mesh) {
  if (!mesh.edge_markers.empty())
    return group_by(
        mesh.edges.size(), [&](std::size_t i) { return static_cast<double>(mesh.edge_markers[i]); },
        "marker");
  return group_by(
      mesh.edges.size(),
      [&](std::size_t i) {
        const std::uint32_t s = mesh.edges[i].segment;
        return s == kNoIndex ? 0.0 : static_cast<double>(s) + 1;
      },
      "segment");
}

std::vector<Group> surfaces(const Mesh& mesh) {
  return group_by(
      mesh.cell_count(),
      [&](std::size_t i) {
        const double label = mesh.cell_regions.empty() ? 0 : mesh.cell_regions[i];
        return label == label ? label : 0;  // NaN has no place in an order
      },
      "region");
}

std::string ends(const Mesh& mesh, std::size_t edge) {
  return " " + std::to_string(std::size_t{mesh.edges[edge].a} + 1) + " " +
         std::to_string(std::size_t{mesh.edges[edge].b} + 1) + "\n";
}

std::string corners(const Mesh& mesh, std::size_t cell) {
  std::string out;
  for (int k = 0; k < 3; ++k) out += " " + std::to_string(std::size_t{mesh.cell(cell)[k]} + 1);
  return out + "\n";
}

std::string point(const Point3& p) {
  return format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z);
}

/// Bounding box of an entity as "minX minY minZ maxX maxY maxZ".
template <class Members, class Vertices>
std::string box(const Mesh& mesh, const Members& members, Vertices vertices_of) {
  Point3 low, high;
  bool any = false;
  for (const std::size_t i : members)
    for (const std::uint32_t v : vertices_of(i)) {
      const Point3& p = mesh.vertices[v];
      low = any ? Point3{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)} : p;
      high = any ? Point3{std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)} : p;
      any = true;
    }
  return point(low) + " " + point(high);
}

std::string names(const std::vector<Group>& lines, const std::vector<Group>& cells) {
  std::string out = "$PhysicalNames\n" + std::to_string(lines.size() + cells.size()) + "\n";
  for (const Group& g : lines) out += "1 " + std::to_string(g.tag) + " \"" + g.name + "\"\n";
  for (const Group& g : cells) out += "2 " + std::to_string(g.tag) + " \"" + g.name + "\"\n";
  return out + "$EndPhysicalNames\n";
}

std::string version_2(const Mesh& mesh, const std::vector<Group>& lines,
                      const std::vector<Group>& cells) {
  std::string out = "$Nodes\n" + std::to_string(mesh.vertices.size()) + "\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    out += std::to_string(i + 1) + " " + point(mesh.vertices[i]) + "\n";
  out += "$EndNodes\n$Elements\n" + std::to_string(mesh.edges.size() + mesh.cell_count()) + "\n";
  std::size_t number = 0;
  const auto head = [&](int type, const Group& g) {  // two tags: physical and elementary entity
    const std::string tag = " " + std::to_string(g.tag);
    return std::to_string(++number) + " " + std::to_string(type) + " 2" + tag + tag;
  };
  for (const Group& g : lines)
    for (const std::size_t i : g.members) out += head(kLine, g) + ends(mesh, i);
  for (const Group& g : cells)
    for (const std::size_t i : g.members) out += head(kTriangle, g) + corners(mesh, i);
  return out + "$EndElements\n";
}

std::string version_4(const Mesh& mesh, const std::vector<Group>& lines,
                      const std::vector<Group>& cells) {
  std::string out =
      "$Entities\n0 " + std::to_string(lines.size()) + " " + std::to_string(cells.size()) + " 0\n";
  for (const Group& g : lines)
    out += std::to_string(g.tag) + " " +
           box(mesh, g.members,
               [&](std::size_t i) {
                 return std::array<std::uint32_t, 2>{mesh.edges[i].a, mesh.edges[i].b};
               }) +
           " 1 " + std::to_string(g.tag) + " 0\n";
  for (const Group& g : cells)
    out += std::to_string(g.tag) + " " +
           box(mesh, g.members,
               [&](std::size_t i) {
                 return std::array<std::uint32_t, 3>{mesh.cell(i)[0], mesh.cell(i)[1],
                                                     mesh.cell(i)[2]};
               }) +
           " 1 " + std::to_string(g.tag) + " 0\n";
  const std::string n = std::to_string(mesh.vertices.size());
  // All nodes belong to one entity: the first surface, or the first curve where there is none.
  const bool surface = !cells.empty();
  const std::int64_t owner = surface ? cells[0].tag : lines.empty() ? 1 : lines[0].tag;
  out += "$EndEntities\n$Nodes\n1 " + n + " 1 " + n + "\n" + (surface ? "2 " : "1 ") +
         std::to_string(owner) + " 0 " + n + "\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) out += std::to_string(i + 1) + "\n";
  for (const Point3& p : mesh.vertices) out += point(p) + "\n";
  const std::string count = std::to_string(mesh.edges.size() + mesh.cell_count());
  out += "$EndNodes\n$Elements\n" + std::to_string(lines.size() + cells.size()) + " " + count +
         " 1 " + count + "\n";
  std::size_t number = 0;
  const auto block = [&](const char* dimension, int type, const Group& g) {
    return dimension + std::to_string(g.tag) + " " + std::to_string(type) + " " +
           std::to_string(g.members.size()) + "\n";
  };
  for (const Group& g : lines) {
    out += block("1 ", kLine, g);
    for (const std::size_t i : g.members) out += std::to_string(++number) + ends(mesh, i);
  }
  for (const Group& g : cells) {
    out += block("2 ", kTriangle, g);
    for (const std::size_t i : g.members) out += std::to_string(++number) + corners(mesh, i);
  }
  return out + "$EndElements\n";
}

}  // namespace

std::string write_msh(const Mesh& mesh, bool old) {
  const std::vector<Group> lines = curves(mesh), cells = surfaces(mesh);
  return std::string("$MeshFormat\n") + (old ? "2.2" : "4.1") + " 0 8\n$EndMeshFormat\n" +
         names(lines, cells) +
         (old ? version_2(mesh, lines, cells) : version_4(mesh, lines, cells));
}

}  // namespace circumball::io
