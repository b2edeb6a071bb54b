#ifndef CIRCUMBALL_IO_SVG_PATH_H_
#define CIRCUMBALL_IO_SVG_PATH_H_

#include <string_view>

#include "io/svg_geometry.h"

namespace circumball::io {

/// Draws path data (the attribute d of SVG 1.1, section 8.3). Returns how many bytes were
/// understood: all of them, or the place of the error.
std::size_t draw_path(std::string_view data, const Affine& map, OutlineSink& sink);
/// Draws the points "x,y x,y …" of a polyline or polygon; the same.
std::size_t draw_points(std::string_view points, bool closed, const Affine& map, OutlineSink& sink);
/// Draws an ellipse as four arcs, from its rightmost point (before the map).
void draw_ellipse(const Point2& center, double rx, double ry, const Affine& map, OutlineSink& sink);
/// Draws a rectangle, with corners rounded by quarters of an ellipse where rx and ry are positive.
void draw_rectangle(const Point2& corner, double width, double height, double rx, double ry,
                    const Affine& map, OutlineSink& sink);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_SVG_PATH_H_
