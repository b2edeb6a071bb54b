#include "complex/export3.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "complex/carried.h"
#include "complex/matching_region.h"
#include "complex/solid_domain.h"
#include "delaunay/constructions.h"

namespace circumball {
namespace {

/// Whether some cell of the domain has the edge ab.
bool edge_is_in_domain(const Live3& live, VertexId a, VertexId b, std::vector<CellSlot>* cells) {
  const Delaunay3& dt = live.triangulation();
  dt.cells_at(dt.of_lesser_degree(a, b), cells);
  return std::any_of(cells->begin(), cells->end(), [&](CellSlot c) {
    if (!live.is_in_domain(c)) return false;
    int ends = 0;
    for (std::uint32_t i = 0; i < 4; ++i) ends += dt.corner(c, i) == a || dt.corner(c, i) == b;
    return ends == 2;
  });
}

/// Where the mesh does not conform yet: those triangles of the faces' own triangulations that are
/// facets.
void export_common_facets(const Live3& live, Mesh* mesh) {
  for (std::uint32_t f = 0; f < live.face_count(); ++f) {
    const FaceRefinement& face = live.face(f);
    face.triangulation().for_each_triangle([&](TriangleId t) {
      const Delaunay2::Triangle& triangle = face.triangulation().triangle(t);
      if (!live.is_inside(f, triangle)) return;
      const VertexId a = face.global(triangle.v[0]), b = face.global(triangle.v[1]),
                     c = face.global(triangle.v[2]);
      if (live.triangulation().find_facet(a, b, c) == kNone) return;
      mesh->facets.push_back({a.value, b.value, c.value, f});
    });
  }
}

/// All facets that lie in faces, of cells of the domain. `region`: what takes the place of some, or
/// null.
void export_facets(const Live3& live, const MatchingRegion* region, Mesh* mesh) {
  const Delaunay3& dt = live.triangulation();
  const FaceFacets facets(live);
  dt.for_each_cell([&](CellSlot c) {
    if (!live.is_in_domain(c) || (region && region->replaced[c])) return;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellFacet f = 4 * c + i, twin = dt.twin(f);
      if (facets.face(f) == kNone || (twin < f && live.is_in_domain(twin / 4))) continue;
      VertexId a = dt.facet_corner(f, 0), b = dt.facet_corner(f, 1), v = dt.facet_corner(f, 2);
      // Counter-clockwise about the normal of the face.
      const FacePlane& plane = live.face(facets.face(f)).plane();
      const Point2 p = plane.to_plane(dt.point(a)), q = plane.to_plane(dt.point(b)),
                   r = plane.to_plane(dt.point(v));
      if (shape_of(p, q, r).area4 < 0) std::swap(a, b);
      mesh->facets.push_back({a.value, b.value, v.value, facets.face(f)});
    }
  });
  if (region) {
    for (const MatchingRegion::Facet& f : region->facets) {
      const FacePlane& plane = live.face(f.face).plane();
      const Point2 p = plane.to_plane(dt.point(f.v[0])), q = plane.to_plane(dt.point(f.v[1])),
                   r = plane.to_plane(dt.point(f.v[2]));
      const bool left = shape_of(p, q, r).area4 > 0;
      mesh->facets.push_back(
          {f.v[0].value, f.v[left ? 1 : 2].value, f.v[left ? 2 : 1].value, f.face});
    }
  }
  std::sort(mesh->facets.begin(), mesh->facets.end(), [](const MeshFacet& f, const MeshFacet& g) {
    const auto key = [](const MeshFacet& h) { return std::array{h.face, h.a, h.b, h.c}; };
    return key(f) < key(g);
  });
}

}  // namespace

Mesh export_mesh(Live3* live, std::uint32_t input_vertices) {
  const Delaunay3& dt = live->triangulation();
  const Complex& complex = live->complex();
  Mesh mesh;
  mesh.dimension = 3;
  mesh.input_vertices = input_vertices;
  mesh.box_vertices = static_cast<std::uint32_t>(complex.vertices.size()) - input_vertices;
  const std::uint32_t n = dt.vertex_count();
  mesh.vertices.reserve(n);
  mesh.vertex_features.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.vertices.push_back(dt.point(VertexId(i)));
    mesh.vertex_features.push_back(live->feature(VertexId(i)));
  }
  const bool regions = live->classified() && !complex.regions.empty();
  const auto add_region = [&](std::uint32_t label) {
    if (!regions) return;
    mesh.cell_regions.push_back(label >= kFirstRegion ? complex.regions[label - kFirstRegion].label
                                                      : 0);
  };
  std::optional<MatchingRegion> region;
  if (needs_matching_region(*live)) {
    region.emplace(*live);
    if (!region->matches) region.reset();
  }
  if (dt.dimension() == 3) {
    dt.for_each_cell([&](CellSlot c) {
      if (!live->is_in_domain(c) || (region && region->replaced[c])) return;
      for (std::uint32_t i = 0; i < 4; ++i) mesh.cells.push_back(dt.corner(c, i).value);
      add_region(dt.label(c));
    });
  }
  if (region) {
    for (const MatchingRegion::Cell& cell : region->cells) {
      if (cell.label == kOutside) continue;
      for (const VertexId v : cell.v) mesh.cells.push_back(v.value);
      add_region(cell.label);
    }
  }
  if (live->classified()) {
    export_facets(*live, region ? &*region : nullptr, &mesh);
  } else {
    export_common_facets(*live, &mesh);
  }
  const bool segment_markers = !complex.segment_markers.empty();
  std::vector<CellSlot> scratch;
  for (std::uint32_t i = 0; i < live->subsegment_count(); ++i) {
    const Subsegment& u = live->subsegment(SubsegmentId(i));
    if (!u.alive || u.is_collar_element() || u.is_of_tube()) continue;
    const bool in_region =
        region && std::binary_search(region->inside_edges.begin(), region->inside_edges.end(),
                                     std::array{std::min(u.a, u.b), std::max(u.a, u.b)});
    if (live->classified() && !in_region && !edge_is_in_domain(*live, u.a, u.b, &scratch)) continue;
    mesh.edges.push_back({u.a.value, u.b.value, u.segment.value});
    if (!segment_markers) continue;
    mesh.edge_markers.push_back(u.segment.valid() ? complex.segment_markers[u.segment.value] : 0);
  }
  carry_attributes(complex, &mesh);
  return mesh;
}

}  // namespace circumball
