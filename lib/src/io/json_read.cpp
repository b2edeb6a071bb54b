#include <algorithm>
#include <cstdint>

#include "io/geojson.h"
#include "io/json_value.h"
#include "io/segment_table.h"

// The project's own JSON: docs/formats.md.
namespace circumball::io {
namespace {

/// Highest number of the format that this reader knows.
constexpr std::int64_t kVersion = 1;

/// Reads an array of tuples of indices with `read_index(value, &index)`. After a tuple with a
/// defect reading goes on, so that all of them are told.
template <std::size_t N, class ReadIndex, class Add>
bool read_tuples(const JsonValue& list, const char* wanted, ReadIndex read_index, Add add) {
  bool ok = true;
  const bool is_array = list.for_each([&](const JsonValue& tuple, std::size_t) {
    std::array<std::uint32_t, N> indices{};
    bool good = tuple.is_array_of(N) || tuple.wrong_type(wanted);
    if (good)
      tuple.for_each([&](const JsonValue& v, std::size_t k) {
        good = read_index(v, &indices[k]) && good;
        return true;
      });
    if (good) add(indices);
    ok = ok && good;
    return true;
  });
  return is_array && ok;
}

/// Indices of a complex may be out of range: `check` tells of them, and of all else with them.
bool read_indices(const JsonValue& list, std::vector<std::uint32_t>* out) {
  return list.for_each([&](const JsonValue& v, std::size_t) {
    std::uint32_t index = 0;
    if (!v.any_index(&index)) return false;
    out->push_back(index);
    return true;
  });
}

bool read_points(const JsonValue& list, int dimension, std::vector<Point3>* out) {
  if (list.json().is_array()) out->reserve(list.json().size());
  return list.for_each([&](const JsonValue& v, std::size_t) {
    Point3 p;
    if (!v.point(dimension, &p)) return false;
    out->push_back(p);
    return true;
  });
}

bool read_face(const JsonValue& value, Complex* complex) {
  Face face;
  if (!value.json().is_object()) return value.wrong_type("an object with loops");
  if (const Json* loops = value.find("loops")) {
    const bool ok = value.member(*loops, "loops").for_each([&](const JsonValue& v, std::size_t) {
      face.loops.emplace_back();
      return read_indices(v, &face.loops.back());
    });
    if (!ok) return false;
  }
  if (const Json* holes = value.find("holes"))
    if (!read_points(value.member(*holes, "holes"), 3, &face.holes)) return false;
  if (const Json* segments = value.find("segments"))
    if (!read_indices(value.member(*segments, "segments"), &face.segments)) return false;
  if (const Json* vertices = value.find("vertices"))
    if (!read_indices(value.member(*vertices, "vertices"), &face.vertices)) return false;
  complex->faces.push_back(std::move(face));
  return true;
}

bool read_region(const JsonValue& value, Complex* complex) {
  Region region;
  const Json* at = value.find("at");
  if (!at) return value.wrong_type("an object with \"at\"");
  if (!value.member(*at, "at").point(complex->dimension, &region.at)) return false;
  if (const Json* label = value.find("label"))
    if (!value.member(*label, "label").number(&region.label)) return false;
  if (const Json* max = value.find("max"))
    if (!value.member(*max, "max").number(&region.max)) return false;
  complex->regions.push_back(region);
  return true;
}

bool read_markers(const JsonValue& markers, const char* key, std::size_t count,
                  std::vector<std::int32_t>* out) {
  const Json* json = markers.find(key);
  if (!json || json->empty()) return true;
  const JsonValue list = markers.member(*json, key);
  if (!json->is_array()) return list.wrong_type("an array");
  if (json->size() != count)
    return list.fail("wrong-length", "has " + std::to_string(json->size()) + " markers for " +
                                         std::to_string(count) + " " + key +
                                         ": give one for each, or none");
  return list.for_each([&](const JsonValue& v, std::size_t) {
    out->push_back(0);
    return v.marker(&out->back());
  });
}

/// A feature or segment number; -1 and 2^32 - 1 stand for none.
bool read_feature_index(const JsonValue& value, std::uint32_t* index) {
  std::int64_t wide = 0;
  if (!value.integer(&wide)) return false;
  if (wide < -1 || wide > static_cast<std::int64_t>(kNoIndex))
    return value.fail("index-out-of-range",
                      std::to_string(wide) + " cannot be the number of a feature: use -1 for none");
  *index = wide < 0 ? kNoIndex : static_cast<std::uint32_t>(wide);
  return true;
}

bool read_vertex_features(const JsonValue& list, Mesh* mesh) {
  if (list.json().is_array() && list.json().size() != mesh->vertices.size())
    return list.fail("wrong-length", "has " + std::to_string(list.json().size()) + " entries for " +
                                         std::to_string(mesh->vertices.size()) +
                                         " vertices: give one for each, or none");
  return list.for_each([&](const JsonValue& pair, std::size_t) {
    if (!pair.is_array_of(2)) return pair.wrong_type("[kind, index]");
    Feature feature;
    const bool ok = pair.for_each([&](const JsonValue& v, std::size_t k) {
      if (k == 1) return read_feature_index(v, &feature.index);
      std::uint32_t kind = 0;
      if (!v.index(4, "kinds (vertex, segment, face, free)", &kind)) return false;
      feature.kind = static_cast<FeatureKind>(kind);
      return true;
    });
    mesh->vertex_features.push_back(feature);
    return ok;
  });
}

/// "edges" ([a, b, segment]) or "facets" ([a, b, c, face]): N vertices, then the feature.
template <std::size_t N, class Add>
bool read_labeled(const JsonValue& list, std::size_t vertices, const char* wanted, Add add) {
  return list.for_each([&](const JsonValue& tuple, std::size_t) {
    if (!tuple.is_array_of(N + 1)) return tuple.wrong_type(wanted);
    std::array<std::uint32_t, N + 1> numbers{};
    const bool ok = tuple.for_each([&](const JsonValue& v, std::size_t k) {
      return k == N ? read_feature_index(v, &numbers[k])
                    : v.index(vertices, "vertices", &numbers[k]);
    });
    if (ok) add(numbers);
    return ok;
  });
}

/// The vertices of the input come first, and know their own number; those of the box follow, and
/// have none.
void count_input_vertices(Mesh* mesh) {
  std::vector<Feature>& features = mesh->vertex_features;
  std::uint32_t v = 0;
  for (; v < features.size() && features[v] == Feature{FeatureKind::kVertex, v}; ++v)
    ++mesh->input_vertices;
  for (; v < features.size() && features[v] == Feature{FeatureKind::kVertex, kNoIndex}; ++v) {
    ++mesh->box_vertices;
    features[v].index = v;
  }
}

/// Of the vertices of a mesh those of the input are the complex, where it is known which they are.
void drop_steiner_vertices(const Mesh& mesh, Complex* complex) {
  std::size_t used = 0;  // vertices that the features of the complex need
  const auto use = [&](std::uint32_t v) {
    if (v < complex->vertices.size()) used = std::max(used, std::size_t{v} + 1);
  };
  for (const auto& s : complex->segments) use(s[0]), use(s[1]);
  for (const Face& face : complex->faces) {
    for (const auto& loop : face.loops)
      for (const std::uint32_t v : loop) use(v);
    for (const std::uint32_t v : face.vertices) use(v);
  }
  std::size_t kept = mesh.input_vertices;
  if (kept < used) kept += mesh.box_vertices;
  if (mesh.input_vertices == 0 || kept < used) return;
  complex->vertices.resize(kept);
  if (!complex->vertex_markers.empty()) complex->vertex_markers.resize(kept);
}

bool read_mesh(const JsonValue& value, ReadResult& result) {
  Mesh mesh;
  Complex& complex = result.complex;
  mesh.dimension = complex.dimension;
  mesh.vertices = complex.vertices;
  mesh.vertex_markers = complex.vertex_markers;
  const Json* cells = value.find("cells");
  if (!cells) return value.wrong_type("an object with \"cells\"");
  const JsonValue cell_list = value.member(*cells, "cells");
  const auto add = [&](const auto& v) { mesh.cells.insert(mesh.cells.end(), v.begin(), v.end()); };
  const auto vertex = [&](const JsonValue& v, std::uint32_t* index) {
    return v.index(mesh.vertices.size(), "vertices", index);
  };
  if (!(mesh.dimension == 2 ? read_tuples<3>(cell_list, "[a, b, c]", vertex, add)
                            : read_tuples<4>(cell_list, "[a, b, c, d]", vertex, add)))
    return false;
  if (const Json* regions = value.find("cellRegions"); regions && !regions->empty()) {
    const JsonValue list = value.member(*regions, "cellRegions");
    if (regions->is_array() && regions->size() != mesh.cell_count())
      return list.fail("wrong-length", "has " + std::to_string(regions->size()) + " labels for " +
                                           std::to_string(mesh.cell_count()) +
                                           " cells: give one for each, or none");
    const bool ok = list.for_each([&](const JsonValue& v, std::size_t) {
      mesh.cell_regions.push_back(0);
      return v.number(&mesh.cell_regions.back());
    });
    if (!ok) return false;
  }
  if (const Json* features = value.find("vertexFeatures"); features && !features->empty())
    if (!read_vertex_features(value.member(*features, "vertexFeatures"), &mesh)) return false;
  if (const Json* edges = value.find("edges"))
    if (!read_labeled<2>(value.member(*edges, "edges"), mesh.vertices.size(), "[a, b, segment]",
                         [&](const auto& n) {
                           mesh.edges.push_back({n[0], n[1], n[2]});
                         }))
      return false;
  if (const Json* facets = value.find("facets"))
    if (!read_labeled<3>(value.member(*facets, "facets"), mesh.vertices.size(), "[a, b, c, face]",
                         [&](const auto& n) {
                           mesh.facets.push_back({n[0], n[1], n[2], n[3]});
                         }))
      return false;
  // Subsegments have the marker of their segment, 0 where that is not known.
  if (!complex.segment_markers.empty())
    for (const MeshEdge& e : mesh.edges)
      mesh.edge_markers.push_back(
          e.segment < complex.segment_markers.size() ? complex.segment_markers[e.segment] : 0);
  count_input_vertices(&mesh);
  result.mesh = std::move(mesh);
  return true;
}

bool segments_of_faces_exist(const Complex& complex) {
  for (const Face& face : complex.faces)
    for (const std::uint32_t s : face.segments)
      if (s >= complex.segments.size()) return false;
  return true;
}

void read_own(const JsonValue& document, ReadResult& result) {
  result.format = "json";
  Complex& complex = result.complex;
  std::int64_t version = 0, dimension = 0;
  if (!document.member(*document.find("circumball"), "circumball").integer(&version)) return;
  if (version < 1 || version > kVersion) {
    document.member(*document.find("circumball"), "circumball")
        .fail("unsupported", "format " + std::to_string(version) + " is newer than this program, " +
                                 "which knows 1 to " + std::to_string(kVersion) + ": update it");
    return;
  }
  const Json* dimension_json = document.find("dimension");
  if (!dimension_json) {
    document.fail("type", "\"dimension\" is missing: add 2 or 3");
    return;
  }
  const JsonValue dimension_value = document.member(*dimension_json, "dimension");
  if (!dimension_value.integer(&dimension)) return;
  if (dimension != 2 && dimension != 3) {
    dimension_value.fail("unsupported",
                         "is " + std::to_string(dimension) + ": it should be 2 or 3");
    return;
  }
  complex.dimension = static_cast<int>(dimension);
  const Json* vertices = document.find("vertices");
  if (!vertices) {
    document.fail("type", "\"vertices\" is missing: add an array of points");
    return;
  }
  if (!read_points(document.member(*vertices, "vertices"), complex.dimension, &complex.vertices))
    return;
  bool ok = true;
  if (const Json* segments = document.find("segments"))
    ok = read_tuples<2>(
        document.member(*segments, "segments"), "[a, b]",
        [](const JsonValue& v, std::uint32_t* index) { return v.any_index(index); },
        [&](const std::array<std::uint32_t, 2>& s) { complex.segments.push_back(s); });
  if (const Json* faces = document.find("faces"); faces && ok)
    ok = document.member(*faces, "faces").for_each([&](const JsonValue& v, std::size_t) {
      return read_face(v, &complex);
    });
  const Json* holes = document.find("holes");
  const Json* regions = document.find("regions");
  complex.hole_rule = holes || regions ? HoleRule::kSeeds : HoleRule::kParity;
  if (holes)
    ok = read_points(document.member(*holes, "holes"), complex.dimension, &complex.holes) && ok;
  if (regions)
    ok = document.member(*regions, "regions").for_each([&](const JsonValue& v, std::size_t) {
      return read_region(v, &complex);
    }) && ok;
  if (!ok) return;
  if (const Json* markers = document.find("markers")) {
    const JsonValue m = document.member(*markers, "markers");
    if (!markers->is_object()) {
      m.wrong_type("an object");
      return;
    }
    if (!read_markers(m, "vertices", complex.vertices.size(), &complex.vertex_markers) ||
        !read_markers(m, "segments", complex.segments.size(), &complex.segment_markers) ||
        !read_markers(m, "faces", complex.faces.size(), &complex.face_markers))
      return;
  }
  // Where a face refers to a segment that is not listed nothing is added: `check` shall tell of it.
  if (segments_of_faces_exist(complex)) complex = with_sides(complex);
  if (const Json* mesh = document.find("mesh")) {
    if (!read_mesh(document.member(*mesh, "mesh"), result)) return;
    drop_steiner_vertices(*result.mesh, &complex);
  }
}

}  // namespace

void read_json(std::string_view bytes, ReadResult& result) {
  Json json;
  if (!parse_json(bytes, &json, result)) return;
  const JsonValue document(json, "", result);
  if (document.find("circumball"))
    read_own(document, result);
  else if (document.find("type"))
    read_geojson(document, result);
  else
    document.fail("unknown-format",
                  "it has neither \"circumball\" (the project's own JSON) nor \"type\" (GeoJSON): "
                  "add \"circumball\": 1");
}

}  // namespace circumball::io
