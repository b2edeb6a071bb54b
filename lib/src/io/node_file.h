#ifndef CIRCUMBALL_IO_NODE_FILE_H_
#define CIRCUMBALL_IO_NODE_FILE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"
#include "io/lines.h"

/// What the files of Triangle and of TetGen have in common: numbered vertices, counts before lists,
/// markers, seeds.
namespace circumball::io {

/// One file of the family: its lines, and what to call it in a message ("" for the file that was
/// asked for).
class NodeParser {
 public:
  NodeParser(std::string_view bytes, std::string file, ReadResult& result)
      : lines_(bytes), file_(std::move(file)), result_(result) {}

  Lines& lines() { return lines_; }
  ReadResult& result() { return result_; }

  bool fail_here(const char* name, const std::string& message);

  /// A vertex number that is not there: in a complex it is kept for `check` to tell of, and a
  /// warning names the line of the first; in a mesh it is a defect.
  void no_such_vertex(bool of_mesh, const std::string& message);

  /// The next word as a vertex number; one that does not fit in 64 bits is the nearest that does.
  bool vertex_number(const std::string& what, std::int64_t* value);

  /// The next word as an integer; `missing` where the line has ended (nothing: that is a defect).
  bool integer(const std::string& what, std::optional<std::int64_t> missing, std::int64_t* value);

  bool number(const std::string& what, std::optional<double> missing, double* value);

  /// The next word as the count of things that take at least `bytes_each` bytes in the lines that
  /// follow.
  bool count(const std::string& what, std::optional<std::int64_t> missing, std::size_t bytes_each,
             std::size_t* value);

  /// The number of boundary markers of a list: none or one, none where it is missing.
  bool has_markers(bool* markers);

  /// Goes to line `i` of `n` that list `what`.
  bool next(const std::string& what, std::size_t i, std::size_t n);

  /// A marker: an integer, of which 32 bits are kept; 0 where it is missing.
  bool marker(std::int32_t* value);

  /// Two coordinates, or three.
  bool point(int dimension, Point3* value);

 private:
  Lines lines_;
  std::string file_;
  ReadResult& result_;
  bool warned_ = false;
};

/// Number of the first vertex in the files of a family: 0 or 1.
struct Base {
  std::int64_t first = 1;
};

/// The first line of a .node or .poly file.
struct NodeHeader {
  std::size_t vertices = 0, attributes = 0;
  bool markers = false;
};

/// Reads the header, of which the line has been reached.
bool read_node_header(NodeParser& p, int dimension, NodeHeader* header);

/// Reads the vertices, and into `features` (if not nullptr) the features of a mesh's vertices,
/// which follow the marker in files of our own: one for each vertex, or fewer if they are not
/// there.
bool read_vertices(NodeParser& p, int dimension, const NodeHeader& header, Base* base,
                   Complex* complex, std::vector<Feature>* features = nullptr);

/// Reads the vertices of the .node file beside a file that has none.
bool read_sibling_node(const std::string& name, const Sibling& sibling, int dimension,
                       NodeParser& asking, Base* base, ReadResult& result,
                       std::vector<Feature>* features = nullptr);

/// A vertex number of the file as an index. Reading goes on after one that is out of range.
bool vertex_index(NodeParser& p, const std::string& what, const Base& base, std::size_t vertices,
                  bool of_mesh, std::uint32_t* index);

/// The number of an input feature that an edge or a facet lies on, as our own files have it in a
/// column after the marker: from 1; 0 none (false in `on_feature`), -1 one that is not numbered.
bool feature_number(NodeParser& p, const std::string& what, bool marked, std::uint32_t* feature,
                    bool* on_feature);

/// Holes and regions; either section may be missing at the end of the file.
bool read_seeds(NodeParser& p, int dimension, Complex* complex);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_NODE_FILE_H_
