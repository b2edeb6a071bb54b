#include <algorithm>

#include "io/formats.h"

namespace circumball {
namespace {

std::string list(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

/// Whether every index of a mesh is one of its vertices: what the writers take for granted.
bool indices_in_range(const Mesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  return std::all_of(mesh.cells.begin(), mesh.cells.end(),
                     [&](std::uint32_t v) { return v < n; }) &&
         std::all_of(mesh.edges.begin(), mesh.edges.end(),
                     [&](const MeshEdge& e) { return e.a < n && e.b < n; });
}

}  // namespace

std::vector<OutputFile> write_mesh(const Mesh& mesh, const Complex& complex,
                                   const std::string& extension, const WriteOptions& options,
                                   std::string* error) {
  error->clear();
  if (!indices_in_range(mesh)) {
    *error = "the mesh refers to vertices that it does not have";
    return {};
  }
  if (extension == ".json") return {{extension, io::write_json_mesh(mesh, complex)}};
  if (extension == ".vtu") return {{extension, io::write_vtu(mesh)}};
  if (mesh.dimension == 2) {
    if (extension == ".node" || extension == ".ele") return io::write_triangle_mesh(mesh, complex);
    if (extension == ".svg") return {{extension, io::write_svg_mesh(mesh)}};
    if (extension == ".obj") return {{extension, io::write_obj_mesh(mesh)}};
    if (extension == ".off") return {{extension, io::write_off(mesh)}};
    if (extension == ".msh") {
      if (options.msh_version == "4.1" || options.msh_version == "2.2")
        return {{extension, io::write_msh(mesh, options.msh_version == "2.2")}};
      *error = "there is no writer for version " + options.msh_version + " of .msh: use 4.1 or 2.2";
      return {};
    }
  }
  *error = "a mesh of dimension " + std::to_string(mesh.dimension) + " cannot be written as " +
           io::in_quotes(extension) + ": use one of " + list(mesh_extensions(mesh.dimension));
  return {};
}

std::vector<OutputFile> write_complex(const Complex& complex, const std::string& extension,
                                      std::string* error) {
  error->clear();
  const std::size_t n = complex.vertices.size();
  if (std::any_of(complex.segments.begin(), complex.segments.end(),
                  [&](const auto& s) { return s[0] >= n || s[1] >= n; })) {
    *error = "the complex refers to vertices that it does not have";
    return {};
  }
  if (extension == ".json") return {{extension, io::write_json_complex(complex)}};
  if (complex.dimension == 2) {
    if (extension == ".poly") return {{extension, io::write_triangle_poly(complex)}};
    if (extension == ".node") return {{extension, io::write_triangle_node(complex)}};
    if (extension == ".obj") return {{extension, io::write_obj_complex(complex)}};
    if (extension == ".svg") return {{extension, io::write_svg_complex(complex)}};
  }
  *error = "a complex of dimension " + std::to_string(complex.dimension) +
           " cannot be written as " + io::in_quotes(extension) + ": use one of " +
           (complex.dimension == 2 ? ".json, .poly, .node, .obj, .svg" : ".json");
  return {};
}

std::vector<std::string> mesh_extensions(int dimension) {
  if (dimension == 2) return {".node", ".ele", ".vtu", ".msh", ".svg", ".json", ".obj", ".off"};
  return {".vtu", ".json"};
}

}  // namespace circumball
