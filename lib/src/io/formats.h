#ifndef CIRCUMBALL_IO_FORMATS_H_
#define CIRCUMBALL_IO_FORMATS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "circumball/io.h"

/// What the readers and writers share, and the list of them: one format a file.
namespace circumball::io {

/// Bytes of a file that is read at all. Everything in a complex is numbered with 32 bits.
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
/// How many defects of a file are listed before the rest is left out.
constexpr std::size_t kMaxDefects = 200;
/// How deep JSON, SVG groups or geometry collections may nest.
constexpr std::size_t kMaxDepth = 128;

/// Adds a defect that stops the reading (at most kMaxDefects are kept). Returns false, for `return
/// fail(…)`.
bool fail(ReadResult& result, const char* name, std::string message);
/// The same for a place in a text file: "line 12: message".
bool fail_at(ReadResult& result, std::size_t line, const char* name, const std::string& message);
void warn(ReadResult& result, const char* name, std::string message);

/// A vertex number counted from 0 as it is kept in a complex: one that no index can hold is
/// kNoIndex, which is as far out of range. `check` tells of both.
inline std::uint32_t kept_index(std::int64_t number) {
  return number < 0 || number > std::int64_t{kNoIndex} ? kNoIndex
                                                       : static_cast<std::uint32_t>(number);
}

/// "name.poly" -> "name"; what follows the last point after the last slash is dropped.
std::string stem(const std::string& name);
/// ".poly", in lower case; empty if there is none.
std::string extension_of(const std::string& name);
/// `token` in quotes for a message: cut after 32 bytes, and without unprintable bytes.
std::string in_quotes(std::string_view token);

/// Whether the exact predicates decide about `p`: coordinates zero or of magnitude 1e-45 to 1e55.
bool in_exact_range(const Point3& p);
/// Makes every tetrahedron of a mesh of space positive (orient3d): programs differ in this.
void orient_cells(Mesh* mesh);

// Readers. Each fills `result` (format, complex, mesh, defects).
void read_triangle(std::string_view bytes, const std::string& name, const Sibling& sibling,
                   ReadResult& result);
/// Whether numbers at the beginning of a file are TetGen's (space), not Triangle's (plane).
bool is_tetgen(std::string_view bytes, const std::string& name, const Sibling& sibling);
void read_tetgen(std::string_view bytes, const std::string& name, const Sibling& sibling,
                 ReadResult& result);
void read_json(std::string_view bytes, ReadResult& result);  ///< the project's own, and GeoJSON
void read_obj(std::string_view bytes, const ReadOptions& options, ReadResult& result);
void read_off(std::string_view bytes, const ReadOptions& options, ReadResult& result);
void read_ply(std::string_view bytes, const ReadOptions& options, ReadResult& result);
/// Whether the bytes have the length that the count of a binary STL file says, or more.
bool is_binary_stl(std::string_view bytes);
void read_stl(std::string_view bytes, const ReadOptions& options, ReadResult& result);
void read_svg(std::string_view bytes, ReadResult& result);

/// The lines of a .node file, or of the first section of a .poly file, numbered from 1. `more`:
/// empty, or text that follows the marker of each.
std::string write_nodes(int dimension, const std::vector<Point3>& vertices,
                        int attributes_per_vertex, const std::vector<double>& attributes,
                        const std::vector<std::int32_t>& markers,
                        const std::vector<std::string>& more = {});

// Writers of meshes. Markers of faces are the complex's.
std::vector<OutputFile> write_triangle_mesh(const Mesh& mesh, const Complex& complex);
std::vector<OutputFile> write_tetgen_mesh(const Mesh& mesh, const Complex& complex);
std::string write_json_mesh(const Mesh& mesh, const Complex& complex);
std::string write_vtu(const Mesh& mesh, const Complex& complex);
std::string write_vtk(const Mesh& mesh, const Complex& complex);
std::string write_msh(const Mesh& mesh, const Complex& complex, bool version_2);
std::string write_medit(const Mesh& mesh, const Complex& complex);
std::string write_svg_mesh(const Mesh& mesh);
// Of a mesh of space its surface: the facets on input faces, or the hull where there are none.
std::string write_obj_mesh(const Mesh& mesh);
std::string write_off_mesh(const Mesh& mesh);
std::string write_ply_mesh(const Mesh& mesh);
std::string write_stl_mesh(const Mesh& mesh);

// Writers of complexes. Where the format cannot hold it, they return nothing and set the error.
std::string write_triangle_node(const Complex& complex);
std::string write_triangle_poly(const Complex& complex);
std::string write_tetgen_poly(const Complex& complex);
std::string write_tetgen_smesh(const Complex& complex, std::string* error);
std::string write_json_complex(const Complex& complex);
std::string write_svg_complex(const Complex& complex);
std::string write_obj_complex(const Complex& complex, std::string* error);
std::string write_off_complex(const Complex& complex, std::string* error);
std::string write_ply_complex(const Complex& complex, std::string* error);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_FORMATS_H_
