#include "io/formats.h"

namespace circumball {

std::vector<OutputFile> write_mesh(const Mesh& mesh, const Complex& complex,
                                   const std::string& extension, const WriteOptions& options,
                                   std::string* error) {
  (void)options;
  error->clear();
  if (extension == ".json") return {{extension, io::write_json_mesh(mesh, complex)}};
  if (mesh.dimension == 2 && (extension == ".node" || extension == ".ele"))
    return io::write_triangle_mesh(mesh, complex);
  *error = "cannot write a mesh as \"" + extension + "\"";
  return {};
}

std::vector<OutputFile> write_complex(const Complex& complex, const std::string& extension,
                                      std::string* error) {
  error->clear();
  if (extension == ".json") return {{extension, io::write_json_complex(complex)}};
  if (extension == ".poly") return {{extension, io::write_triangle_poly(complex)}};
  if (extension == ".node") return {{extension, io::write_triangle_node(complex)}};
  *error = "cannot write a complex as \"" + extension + "\"";
  return {};
}

std::vector<std::string> mesh_extensions(int dimension) {
  if (dimension == 2) return {".node", ".ele", ".json"};
  return {".json"};
}

}  // namespace circumball
