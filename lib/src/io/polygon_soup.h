#ifndef CIRCUMBALL_IO_POLYGON_SOUP_H_
#define CIRCUMBALL_IO_POLYGON_SOUP_H_

#include <cstdint>
#include <vector>

#include "circumball/io.h"

namespace circumball::io {

/// Polygons over a list of vertices, as OBJ and OFF files hold them.
struct PolygonSoup {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> ends{0};  ///< polygon i has the corners [ends[i], ends[i + 1])
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< lines that are drawn beside the polygons

  /// Vertex numbers that are not there, in sentences that name the line: of corners (at most
  /// kMaxDefects), and the first of lines. Their indices are kept, out of range.
  std::vector<std::string> missing_corners, missing_ends;

  std::size_t polygon_count() const { return ends.size() - 1; }
  void end_polygon() { ends.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Makes one vertex of those that are at most `tolerance` apart (0: that have equal bits, but that
/// -0 is 0): each becomes the first before it that is near enough. Corners that follow their own
/// vertex and polygons with fewer than three corners left are dropped, with a warning. O(n log n)
/// where no ball of that radius holds many vertices that stay.
void weld(double tolerance, PolygonSoup* soup, ReadResult& result);

/// Makes a complex, and where it can a mesh, of a soup. In the plane z = 0: triangles are the cells
/// of a mesh, whose boundary is the complex where no lines are drawn; other polygons give their
/// sides as segments. In space every polygon is a face, but that coplanar triangles are merged if
/// all are triangles (see ReadOptions); sides of faces are segments. Indices out of range are a
/// defect in the cells of a mesh, and elsewhere left for `check` to tell of; a warning names the
/// line of the first.
void take_soup(PolygonSoup&& soup, const ReadOptions& options, ReadResult& result);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_POLYGON_SOUP_H_
