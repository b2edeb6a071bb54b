#ifndef CIRCUMBALL_IO_H_
#define CIRCUMBALL_IO_H_

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"

/// Reading complexes and meshes, writing meshes and complexes. Bytes in, bytes out: no file system.
namespace circumball {

/// Gives the bytes of a file beside the one that is read (".poly" without vertices wants its
/// ".node"), or nothing.
using Sibling = std::function<std::optional<std::string>(const std::string& name)>;

struct ReadResult {
  std::string
      format;  ///< "triangle-poly", "triangle-node", "triangle-ele", "obj", "svg", "json", …
  Complex complex;
  std::optional<Mesh> mesh;     ///< where the file holds one (.ele, JSON)
  std::vector<Defect> defects;  ///< why it cannot be read ("syntax", "truncated", "too-large",
                                ///< "unknown-format", …), and warnings; names the line
  bool ok() const {
    for (const Defect& d : defects)
      if (!d.warning) return false;
    return true;
  }
};

/// How surfaces of space (STL, OFF, OBJ, PLY) are read.
struct ReadOptions {
  /// Vertices at most this far apart become one, the first of them; 0: vertices with equal bits.
  /// Not set: STL files by equal bits, the others as they are numbered.
  std::optional<double> weld;
  /// In a surface of triangles alone, neighbors that are exactly coplanar become one face.
  bool merge_coplanar = true;
};

/// Indices out of range and coordinates that are not finite stay in the complex, for `check` to
/// tell of with all else (see `check_numbers`); those of a mesh are defects here. Reads whatever it
/// is: formats are told by content; `name` (a file name) only settles ties and finds siblings.
/// Sizes in headers are checked against the bytes there are before memory is taken.
ReadResult read(std::string_view bytes, const std::string& name, const Sibling& sibling = nullptr,
                const ReadOptions& options = {});

struct OutputFile {
  std::string extension;  ///< ".node"
  std::string bytes;
};
struct WriteOptions {
  std::string msh_version = "4.1";
};
/// Writes a mesh in the format of an extension (".ele" or ".node" give the family). Empty and
/// `error` set if it can't.
std::vector<OutputFile> write_mesh(const Mesh& mesh, const Complex& complex,
                                   const std::string& extension, const WriteOptions& options,
                                   std::string* error);
/// Writes a complex: ".json", ".poly", ".node", ".obj", in the plane also ".svg", in space also
/// ".smesh", ".off" and ".ply" (as ".obj": faces of one loop each).
std::vector<OutputFile> write_complex(const Complex& complex, const std::string& extension,
                                      std::string* error);
/// Extensions that `write_mesh` knows, for a dimension.
std::vector<std::string> mesh_extensions(int dimension);

/// The shortest decimal that reads back as the same double.
std::string format_double(double value);

}  // namespace circumball

#endif  // CIRCUMBALL_IO_H_
