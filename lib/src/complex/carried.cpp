#include "complex/carried.h"

#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// Attributes of a vertex on a segment: those of the segment's ends, interpolated.
void interpolate(const Complex& complex, std::uint32_t segment, const Point3& p, double* out) {
  const auto& ends = complex.segments[segment];
  const Point3 &a = complex.vertices[ends[0]], &b = complex.vertices[ends[1]];
  const double whole = distance(a, b);
  const double s = whole > 0 ? distance(a, p) / whole : 0;
  const auto n = static_cast<std::size_t>(complex.attributes_per_vertex);
  for (std::size_t k = 0; k < n; ++k) {
    const double u = complex.vertex_attributes[ends[0] * n + k];
    const double v = complex.vertex_attributes[ends[1] * n + k];
    out[k] = u + s * (v - u);
  }
}

}  // namespace

void carry_attributes(const Complex& complex, Mesh* mesh) {
  const auto n = static_cast<std::uint32_t>(mesh->vertices.size());
  const bool segment_markers = !complex.segment_markers.empty();
  const bool face_markers = !complex.face_markers.empty();
  if (!complex.vertex_markers.empty() || segment_markers || face_markers) {
    mesh->vertex_markers.assign(n, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Feature& f = mesh->vertex_features[i];
      if (f.kind == FeatureKind::kVertex && !complex.vertex_markers.empty()) {
        mesh->vertex_markers[i] = complex.vertex_markers[f.index];
      } else if (f.kind == FeatureKind::kSegment && segment_markers) {
        mesh->vertex_markers[i] = complex.segment_markers[f.index];
      } else if (f.kind == FeatureKind::kFace && face_markers) {
        mesh->vertex_markers[i] = complex.face_markers[f.index];
      }
    }
  }
  if (complex.attributes_per_vertex > 0) {
    const auto k = static_cast<std::size_t>(complex.attributes_per_vertex);
    mesh->attributes_per_vertex = complex.attributes_per_vertex;
    mesh->vertex_attributes = complex.vertex_attributes;
    mesh->vertex_attributes.resize(n * k, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Feature& f = mesh->vertex_features[i];
      if (f.kind != FeatureKind::kSegment) continue;
      interpolate(complex, f.index, mesh->vertices[i], &mesh->vertex_attributes[i * k]);
    }
  }
}

}  // namespace circumball
