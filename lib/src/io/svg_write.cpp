#include <algorithm>
#include <map>

#include "io/formats.h"
#include "io/numbers.h"

// Figures in SVG 1.1: y is negated, since there it points down.
namespace circumball::io {
namespace {

/// Fills of the regions, in the order of their labels (again from the first after the last): Okabe
/// and Ito's colors, which color-blind readers can tell apart, in pale tints.
constexpr const char* kFills[] = {"#eaf4fb", "#fdf3dc", "#e3f3ec", "#fbeade", "#f6e8f0", "#fbf9dd"};

/// Three significant digits: enough for the width of a line.
std::string rough(double value) {
  if (!(value > 0)) return "0";
  const Decimal decimal = shortest_decimal(value);
  const std::string cut =
      "0." + decimal.digits.substr(0, 3) + "e" + std::to_string(decimal.exponent);
  return format_double(parse_double(cut).value_or(value));
}

std::string place(const Point3& p) { return format_double(p.x) + " " + format_double(0 - p.y); }

struct Frame {
  double width = 1;  ///< of the larger side
  std::string text;  ///< the opening tag
};

/// The opening tag, with a margin around the vertices.
Frame frame(const std::vector<Point3>& vertices) {
  Point3 low, high;
  bool any = false;
  for (const Point3& p : vertices) {
    if (!(p.x - p.x == 0 && p.y - p.y == 0)) continue;  // not finite
    low = any ? Point3{std::min(low.x, p.x), std::min(low.y, p.y), 0} : p;
    high = any ? Point3{std::max(high.x, p.x), std::max(high.y, p.y), 0} : p;
    any = true;
  }
  Frame f;
  const double dx = high.x - low.x, dy = high.y - low.y;
  if (std::max(dx, dy) > 0) f.width = std::max(dx, dy);
  const double margin = f.width / 32;
  f.text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + format_double(low.x - margin) +
           " " + format_double(0 - high.y - margin) + " " + format_double(dx + 2 * margin) + " " +
           format_double(dy + 2 * margin) + "\">\n";
  return f;
}

std::string stroke(const char* color, double width) {
  return std::string(" stroke=\"") + color + "\" stroke-width=\"" + rough(width) +
         "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
}

/// Path data of segments; one that starts where the last ended goes on with it. Loops come back to
/// their first point without Z, which would move ends that nearly meet onto it.
template <class Segment>
std::string lines(std::size_t count, const std::vector<Point3>& vertices, Segment segment) {
  std::string out;
  std::uint32_t here = kNoIndex;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = segment(i);
    if (a != here) out += (out.empty() ? "M" : "\nM") + place(vertices[a]);
    out += "L" + place(vertices[b]);
    here = b;
  }
  return out;
}

std::string path(const std::string& data, const std::string& attributes) {
  return data.empty() ? "" : "<path" + attributes + " d=\"" + data + "\"/>\n";
}

}  // namespace

std::string write_svg_complex(const Complex& complex) {
  const Frame f = frame(complex.vertices);
  std::vector<bool> used(complex.vertices.size(), false);
  for (const auto& s : complex.segments) used[s[0]] = used[s[1]] = true;
  std::string dots;  // a path of no length with round ends is a dot
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) dots += (dots.empty() ? "M" : "\nM") + place(complex.vertices[i]) + "h0";
  return f.text +
         path(lines(complex.segments.size(), complex.vertices,
                    [&](std::size_t i) {
                      return std::pair{complex.segments[i][0], complex.segments[i][1]};
                    }),
              " fill=\"none\"" + stroke("#16324f", f.width / 250)) +
         path(dots, " fill=\"none\"" + stroke("#16324f", f.width / 80)) + "</svg>\n";
}

std::string write_svg_mesh(const Mesh& mesh) {
  const Frame f = frame(mesh.vertices);
  std::map<double, std::string> regions;  // label -> its triangles
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    double label = mesh.cell_regions.empty() ? 0 : mesh.cell_regions[i];
    if (label != label) label = 0;  // NaN has no place in an order
    std::string& data = regions[label];
    data += (data.empty() ? "M" : "\nM") + place(mesh.vertices[v[0]]) + "L" +
            place(mesh.vertices[v[1]]) + "L" + place(mesh.vertices[v[2]]) + "Z";
  }
  std::string out = f.text;
  std::size_t color = 0;
  for (const auto& [label, data] : regions)
    out += path(data, std::string(" fill=\"") + kFills[color++ % std::size(kFills)] + "\"" +
                          stroke("#5b7a99", f.width / 1000));
  out += path(lines(mesh.edges.size(), mesh.vertices,
                    [&](std::size_t i) {
                      return std::pair{mesh.edges[i].a, mesh.edges[i].b};
                    }),
              " fill=\"none\"" + stroke("#16324f", f.width / 300));
  return out + "</svg>\n";
}

}  // namespace circumball::io
