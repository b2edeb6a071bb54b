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
                     [&](const MeshEdge& e) { return e.a < n && e.b < n; }) &&
         std::all_of(mesh.facets.begin(), mesh.facets.end(),
                     [&](const MeshFacet& f) { return f.a < n && f.b < n && f.c < n; });
}

/// The same of a complex.
bool indices_in_range(const Complex& complex) {
  const std::size_t n = complex.vertices.size(), m = complex.segments.size();
  const auto vertex = [&](std::uint32_t v) { return v < n; };
  return std::all_of(complex.segments.begin(), complex.segments.end(),
                     [&](const auto& s) { return s[0] < n && s[1] < n; }) &&
         std::all_of(complex.faces.begin(), complex.faces.end(), [&](const Face& face) {
           return std::all_of(face.loops.begin(), face.loops.end(),
                              [&](const auto& loop) {
                                return std::all_of(loop.begin(), loop.end(), vertex);
                              }) &&
                  std::all_of(face.vertices.begin(), face.vertices.end(), vertex) &&
                  std::all_of(face.segments.begin(), face.segments.end(),
                              [&](std::uint32_t s) { return s < m; });
         });
}

/// One file, unless there is nothing to write: then the writer has said why.
std::vector<OutputFile> in_one(const std::string& extension, std::string&& bytes,
                               const std::string& error) {
  if (!error.empty()) return {};
  return {{extension, std::move(bytes)}};
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
  if (extension == ".vtu") return {{extension, io::write_vtu(mesh, complex)}};
  if (extension == ".vtk") return {{extension, io::write_vtk(mesh, complex)}};
  if (extension == ".mesh") return {{extension, io::write_medit(mesh, complex)}};
  if (extension == ".obj") return {{extension, io::write_obj_mesh(mesh)}};
  if (extension == ".off") return {{extension, io::write_off_mesh(mesh)}};
  if (extension == ".ply") return {{extension, io::write_ply_mesh(mesh)}};
  if (extension == ".stl") return {{extension, io::write_stl_mesh(mesh)}};
  if (extension == ".svg" && mesh.dimension == 2) return {{extension, io::write_svg_mesh(mesh)}};
  if (extension == ".node" || extension == ".ele")
    return mesh.dimension == 2 ? io::write_triangle_mesh(mesh, complex)
                               : io::write_tetgen_mesh(mesh, complex);
  if (extension == ".msh") {
    if (options.msh_version == "4.1" || options.msh_version == "2.2")
      return {{extension, io::write_msh(mesh, complex, options.msh_version == "2.2")}};
    *error = "there is no writer for version " + options.msh_version + " of .msh: use 4.1 or 2.2";
    return {};
  }
  *error = "a mesh of dimension " + std::to_string(mesh.dimension) + " cannot be written as " +
           io::in_quotes(extension) + ": use one of " + list(mesh_extensions(mesh.dimension));
  return {};
}

std::vector<OutputFile> write_complex(const Complex& complex, const std::string& extension,
                                      std::string* error) {
  error->clear();
  if (!indices_in_range(complex)) {
    *error = "the complex refers to vertices that it does not have";
    return {};
  }
  if (extension == ".json") return {{extension, io::write_json_complex(complex)}};
  if (complex.dimension == 2) {
    if (extension == ".poly") return {{extension, io::write_triangle_poly(complex)}};
    if (extension == ".node") return {{extension, io::write_triangle_node(complex)}};
    if (extension == ".svg") return {{extension, io::write_svg_complex(complex)}};
  } else {
    if (extension == ".poly") return {{extension, io::write_tetgen_poly(complex)}};
    if (extension == ".node")
      return {{extension, io::write_nodes(3, complex.vertices, complex.attributes_per_vertex,
                                          complex.vertex_attributes, complex.vertex_markers)}};
    if (extension == ".smesh")
      return in_one(extension, io::write_tetgen_smesh(complex, error), *error);
    if (extension == ".off")
      return in_one(extension, io::write_off_complex(complex, error), *error);
    if (extension == ".ply")
      return in_one(extension, io::write_ply_complex(complex, error), *error);
  }
  if (extension == ".obj") return in_one(extension, io::write_obj_complex(complex, error), *error);
  *error = "a complex of dimension " + std::to_string(complex.dimension) +
           " cannot be written as " + io::in_quotes(extension) + ": use one of " +
           (complex.dimension == 2 ? ".json, .poly, .node, .obj, .svg"
                                   : ".json, .poly, .smesh, .node, .off, .obj, .ply");
  return {};
}

std::vector<std::string> mesh_extensions(int dimension) {
  std::vector<std::string> out = {".node", ".ele", ".vtu", ".vtk", ".msh", ".mesh",
                                  ".json", ".obj", ".off", ".ply", ".stl"};
  if (dimension == 2) out.push_back(".svg");
  return out;
}

}  // namespace circumball
