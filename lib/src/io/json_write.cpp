#include <cmath>

#include "io/formats.h"

// The project's own JSON: docs/formats.md. Written by hand, so that it reads well and streams.
namespace circumball::io {
namespace {

std::string json_number(double value) {
  return std::isfinite(value) ? format_double(value) : "null";
}

std::string json_point(const Point3& p, int dimension) {
  std::string out = "[" + json_number(p.x) + ", " + json_number(p.y);
  if (dimension == 3) out += ", " + json_number(p.z);
  return out + "]";
}

/// An array with a few elements a line. `element(i)` is text.
template <class Element>
std::string json_array(std::size_t count, const std::string& indent, Element element) {
  if (count == 0) return "[]";
  std::string out = "[";
  std::size_t line = out.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = element(i);
    if (i == 0 || out.size() - line + text.size() > 96) {
      out += "\n" + indent + "  ";
      line = out.size();
    } else {
      out += " ";
    }
    out += text;
    if (i + 1 < count) out += ",";
  }
  return out + "\n" + indent + "]";
}

std::string json_numbers(const std::vector<std::uint32_t>& numbers) {
  std::string out = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    out += (i ? ", " : "") + std::to_string(numbers[i]);
  return out + "]";
}

std::string signed_index(std::uint32_t index) {
  return index == kNoIndex ? "-1" : std::to_string(index);
}

std::string json_face(const Face& face) {
  std::string out = "{\"loops\": [";
  for (std::size_t i = 0; i < face.loops.size(); ++i)
    out += (i ? ", " : "") + json_numbers(face.loops[i]);
  out += "]";
  if (!face.holes.empty()) {
    out += ", \"holes\": [";
    for (std::size_t i = 0; i < face.holes.size(); ++i)
      out += (i ? ", " : "") + json_point(face.holes[i], 3);
    out += "]";
  }
  if (!face.segments.empty()) out += ", \"segments\": " + json_numbers(face.segments);
  if (!face.vertices.empty()) out += ", \"vertices\": " + json_numbers(face.vertices);
  return out + "}";
}

std::string json_markers(const std::vector<std::int32_t>& markers) {
  return json_array(markers.size(), "    ",
                    [&](std::size_t i) { return std::to_string(markers[i]); });
}

/// Everything but the mesh and the closing brace.
std::string head(const Complex& complex, const std::vector<Point3>& vertices,
                 const std::vector<std::int32_t>& vertex_markers) {
  std::string out =
      "{\n  \"circumball\": 1,\n  \"dimension\": " + std::to_string(complex.dimension) +
      ",\n  \"vertices\": " + json_array(vertices.size(), "  ", [&](std::size_t i) {
        return json_point(vertices[i], complex.dimension);
      });
  if (!complex.segments.empty())
    out += ",\n  \"segments\": " + json_array(complex.segments.size(), "  ", [&](std::size_t i) {
             return "[" + std::to_string(complex.segments[i][0]) + ", " +
                    std::to_string(complex.segments[i][1]) + "]";
           });
  if (!complex.faces.empty())
    out += ",\n  \"faces\": " + json_array(complex.faces.size(), "  ", [&](std::size_t i) {
             return json_face(complex.faces[i]);
           });
  // That "holes" is there, if only empty, says that holes are told by seeds and not by parity.
  if (!complex.holes.empty() || complex.hole_rule == HoleRule::kSeeds)
    out += ",\n  \"holes\": " + json_array(complex.holes.size(), "  ", [&](std::size_t i) {
             return json_point(complex.holes[i], complex.dimension);
           });
  if (!complex.regions.empty())
    out += ",\n  \"regions\": " + json_array(complex.regions.size(), "  ", [&](std::size_t i) {
             const Region& r = complex.regions[i];
             return "{\"at\": " + json_point(r.at, complex.dimension) +
                    ", \"label\": " + json_number(r.label) +
                    (r.max > 0 ? ", \"max\": " + json_number(r.max) : "") + "}";
           });
  std::string markers;
  const auto add_markers = [&](const char* key, const std::vector<std::int32_t>& values) {
    if (values.empty()) return;
    markers +=
        std::string(markers.empty() ? "" : ",") + "\n    \"" + key + "\": " + json_markers(values);
  };
  add_markers("vertices", vertex_markers);
  add_markers("segments", complex.segment_markers);
  add_markers("faces", complex.face_markers);
  if (!markers.empty()) out += ",\n  \"markers\": {" + markers + "\n  }";
  return out;
}

}  // namespace

std::string write_json_complex(const Complex& complex) {
  return head(complex, complex.vertices, complex.vertex_markers) + "\n}\n";
}

std::string write_json_mesh(const Mesh& mesh, const Complex& complex) {
  const auto corners = static_cast<std::size_t>(mesh.dimension) + 1;
  std::string out = head(complex, mesh.vertices, mesh.vertex_markers);
  out += ",\n  \"mesh\": {\n    \"cells\": " +
         json_array(mesh.cell_count(), "    ", [&](std::size_t i) {
           std::string cell = "[";
           for (std::size_t k = 0; k < corners; ++k)
             cell += (k ? ", " : "") + std::to_string(mesh.cell(i)[k]);
           return cell + "]";
         });
  if (!mesh.cell_regions.empty())
    out += ",\n    \"cellRegions\": " +
           json_array(mesh.cell_regions.size(), "    ",
                      [&](std::size_t i) { return json_number(mesh.cell_regions[i]); });
  if (!mesh.vertex_features.empty())
    out += ",\n    \"vertexFeatures\": " +
           json_array(mesh.vertex_features.size(), "    ", [&](std::size_t i) {
             const Feature& f = mesh.vertex_features[i];
             // A corner of the box is a vertex of no number: so the reader knows where the input
             // ends.
             const bool of_box =
                 i >= mesh.input_vertices && i - mesh.input_vertices < mesh.box_vertices;
             return "[" + std::to_string(static_cast<int>(f.kind)) + ", " +
                    (of_box ? "-1" : signed_index(f.index)) + "]";
           });
  if (!mesh.edges.empty())
    out += ",\n    \"edges\": " + json_array(mesh.edges.size(), "    ", [&](std::size_t i) {
             const MeshEdge& e = mesh.edges[i];
             return "[" + std::to_string(e.a) + ", " + std::to_string(e.b) + ", " +
                    signed_index(e.segment) + "]";
           });
  if (!mesh.facets.empty())
    out += ",\n    \"facets\": " + json_array(mesh.facets.size(), "    ", [&](std::size_t i) {
             const MeshFacet& f = mesh.facets[i];
             return "[" + std::to_string(f.a) + ", " + std::to_string(f.b) + ", " +
                    std::to_string(f.c) + ", " + signed_index(f.face) + "]";
           });
  return out + "\n  }\n}\n";
}

}  // namespace circumball::io
