#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "feature_size/face_pieces.h"
#include "feature_size/vectors.h"
#include "quality/boundary_facets.h"
#include "quality/context3.h"

namespace circumball {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Facet = VerifyContext3::Facet;

Edge edge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Those that stand an odd number of times in a list: a chain modulo 2.
std::vector<Edge> odd_ones(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> odd;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    if ((j - i) % 2 == 1) odd.push_back(edges[i]);
    i = j;
  }
  return odd;
}

double area_of(const Point3& a, const Point3& b, const Point3& c) {
  return 0.5 * std::sqrt(cross2(b - a, c - a));
}

struct FaceProblem {
  std::string why;  // empty if there is none
  std::vector<std::uint32_t> at;
};

/// Conformity is counted, not measured: on each side of a face, those of its facets that do not
/// belong to a flat cell there (four vertices on the face) must have the chains of its bounding
/// loops as their boundary modulo 2. Then they cover every place of the face an odd number of
/// times, and no other; and if their areas add up to the face's, once.
class FaceFinder {
 public:
  explicit FaceFinder(const VerifyContext3& context) : context_(context), chains_(context) {
    const Complex& complex = context.complex;
    for (std::uint32_t s = 0; s < complex.segments.size(); ++s)
      if (context.segment_wanted[s])
        segment_.emplace(edge(complex.segments[s][0], complex.segments[s][1]), s);
    listed_.resize(complex.faces.size());
    for (const MeshFacet& f : context.mesh.facets) {
      if (f.face >= complex.faces.size()) continue;
      Facet facet = {f.a, f.b, f.c};
      std::sort(facet.begin(), facet.end());
      listed_[f.face].push_back(facet);
    }
    if (!context.mesh.facets.empty()) return;
    labeled_ = false;
    std::vector<Box3> boxes;
    for (std::uint32_t v = 0; v < context.used.size(); ++v) {
      if (!context.used[v]) continue;
      vertex_.push_back(v);
      boxes.push_back(Box3::of(context.point(v)));
    }
    tree_ = BoxTree3(std::move(boxes));
    on_face_.assign(context.used.size(), 0);
  }

  bool labeled() const { return labeled_; }
  std::size_t facets() const { return facets_; }

  FaceProblem look(std::uint32_t face) {
    const FacePieces pieces = face_pieces(context_.complex, face);
    if (pieces.triangles.empty()) return {"it has no area, or an index out of range", {}};
    find_plane(pieces);
    FaceProblem problem;
    const std::vector<Edge> boundary = boundary_of(face, pieces, &problem);
    if (!problem.why.empty()) return problem;
    double area = 0;
    for (const auto& t : pieces.triangles) area += area_of(t[0], t[1], t[2]);

    std::vector<Facet> facets = labeled_ ? listed_[face] : facets_near(pieces);
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    if (facets.empty()) return {"no facet lies in it", {}};
    std::vector<Edge> sides[2];
    double areas[2] = {0, 0};
    bool ends[2] = {true, true};  // on this side is nothing but layers of the face
    for (const Facet& f : facets) {
      bool in_tiling[2] = {true, true};
      problem = place(face, f, in_tiling, ends);
      if (!problem.why.empty()) return problem;
      const double a = area_of(context_.point(f[0]), context_.point(f[1]), context_.point(f[2]));
      for (int side = 0; side < 2; ++side) {
        if (!in_tiling[side]) continue;
        areas[side] += a;
        for (const Edge& e : {edge(f[0], f[1]), edge(f[1], f[2]), edge(f[0], f[2])})
          sides[side].push_back(e);
      }
    }
    for (int side = 0; side < 2; ++side) {
      // On the convex hull, layers of two faces may meet along what rounding made of a segment.
      if (ends[side] && !ends[1 - side]) continue;
      const std::vector<Edge> odd = odd_ones(std::move(sides[side]));
      std::vector<Edge> wrong;
      std::set_symmetric_difference(odd.begin(), odd.end(), boundary.begin(), boundary.end(),
                                    std::back_inserter(wrong));
      if (!wrong.empty()) return {"its facets have a gap", {wrong[0][0], wrong[0][1]}};
      if (!(std::fabs(areas[side] - area) <= tolerance(area)))
        return {
            "its facets have an area of " + value_text(areas[side]) + ", not " + value_text(area),
            {}};
    }
    facets_ += facets.size();
    return {};
  }

 private:
  double off_plane(const Point3& p) const { return std::fabs(dot(p - origin_, normal_)); }
  double tolerance(double area) const {
    return kAreaTolerance * area +
           4 * length_ * (labeled_ ? context_.rounding : context_.on_segment());
  }

  void find_plane(const FacePieces& pieces) {
    double largest = 0;
    for (const auto& t : pieces.triangles) {
      const Point3 n = cross(t[1] - t[0], t[2] - t[0]);
      const double size = std::sqrt(dot(n, n));
      if (!(size > largest)) continue;
      largest = size;
      origin_ = t[0];
      normal_ = {n.x / size, n.y / size, n.z / size};
    }
  }

  /// The mesh edges of the sides of the loops that bound a face.
  std::vector<Edge> boundary_of(std::uint32_t face, const FacePieces& pieces,
                                FaceProblem* problem) {
    std::vector<Edge> edges;
    length_ = 0;
    for (const std::uint32_t l : pieces.bounds) {
      const auto& loop = context_.complex.faces[face].loops[l];
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::uint32_t a = loop[k], b = loop[(k + 1) % loop.size()];
        if (a == b) continue;
        const Point3 d = context_.complex.vertices[b] - context_.complex.vertices[a];
        length_ += std::sqrt(dot(d, d));
        const auto segment = segment_.find(edge(a, b));
        const std::uint32_t p = context_.mesh_vertex[a], q = context_.mesh_vertex[b];
        if (p == kNoIndex || q == kNoIndex) {
          *problem = {"a corner of it is not in the mesh", {}};
          return {};
        }
        const Chain chain =
            segment != segment_.end() ? chains_.find(segment->second) : chains_.between(p, q);
        if (chain.vertices.empty()) {
          *problem = {"its side between " + vertices_text({p, q}) +
                          " is not a union of edges: " + chain.problem,
                      chain.at};
          return {};
        }
        for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i)
          edges.push_back(edge(chain.vertices[i], chain.vertices[i + 1]));
      }
    }
    return odd_ones(std::move(edges));
  }

  bool near(const Point3& p, const FacePieces& pieces) const {
    const double reach = context_.on_segment();
    if (off_plane(p) > 2 * reach) return false;
    // In a triangle of it, or this far beyond a side.
    return std::any_of(pieces.triangles.begin(), pieces.triangles.end(), [&](const auto& t) {
      const Point3 n = cross(t[1] - t[0], t[2] - t[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 d = t[(k + 1) % 3] - t[k];
        const double beyond = dot(cross(d, p - t[k]), n);
        if (beyond < -reach * std::sqrt(dot(d, d)) * std::sqrt(dot(n, n))) return false;
      }
      return true;
    });
  }

  /// On somebody else's mesh: facets with all corners, and their middle, on the face.
  std::vector<Facet> facets_near(const FacePieces& pieces) {
    for (const std::uint32_t v : marked_) on_face_[v] = 0;
    marked_.clear();
    Box3 box = Box3::of(origin_);
    for (const auto& t : pieces.triangles) box.extend(Box3::of(t[0], t[1], t[2]));
    const double reach = context_.on_segment();
    box.extend(Box3::of({box.lo_x - reach, box.lo_y - reach, box.lo_z - reach},
                        {box.hi_x + reach, box.hi_y + reach, box.hi_z + reach}));
    tree_.query([&](const Box3& other) { return other.meets(box); },
                [&](std::uint32_t i) {
                  if (!near(context_.point(vertex_[i]), pieces)) return true;
                  on_face_[vertex_[i]] = 1;
                  marked_.push_back(vertex_[i]);
                  return true;
                });
    std::vector<Facet> facets;
    for (const std::uint32_t v : marked_) {
      context_.for_each_facet_from(v, [&](std::uint32_t f) {
        Facet c = context_.corners(f);
        if (!on_face_[c[0]] || !on_face_[c[1]] || !on_face_[c[2]]) return;
        const Point3 &p = context_.point(c[0]), &q = context_.point(c[1]),
                     &r = context_.point(c[2]);
        const Point3 middle = {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
        if (!near(middle, pieces)) return;
        std::sort(c.begin(), c.end());
        facets.push_back(c);
      });
    }
    return facets;
  }

  /// Whether a vertex belongs to the face: by its label if it has one, else by distance.
  bool belongs(std::uint32_t face, std::uint32_t v) const {
    if (!labeled_) return on_face_[v] != 0;
    if (v >= context_.mesh.vertex_features.size())
      return off_plane(context_.point(v)) <= 2 * context_.on_segment();
    const Feature& feature = context_.mesh.vertex_features[v];
    const Face& f = context_.complex.faces[face];
    const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t x) {
      return std::find(list.begin(), list.end(), x) != list.end();
    };
    if (feature.kind == FeatureKind::kFace) return feature.index == face;
    if (feature.kind == FeatureKind::kFree) return false;
    if (feature.kind == FeatureKind::kVertex) {
      if (has(f.vertices, feature.index)) return true;
      for (const auto& loop : f.loops)
        if (has(loop, feature.index)) return true;
    }
    const auto& segments = context_.complex.segments;
    if (feature.kind == FeatureKind::kSegment && feature.index < segments.size()) {
      const auto& ends = segments[feature.index];  // a side of a loop, listed or not
      for (const auto& loop : f.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
          if (edge(loop[k], loop[(k + 1) % loop.size()]) == edge(ends[0], ends[1])) return true;
    }
    return std::any_of(f.segments.begin(), f.segments.end(), [&](std::uint32_t s) {
      if (s >= segments.size()) return false;
      if (feature.kind == FeatureKind::kVertex)
        return segments[s][0] == feature.index || segments[s][1] == feature.index;
      return s == feature.index;
    });
  }

  /// On which sides of the face a facet counts: where its cell is not flat, or there is none.
  FaceProblem place(std::uint32_t face, const Facet& facet, bool* in_tiling, bool* ends) {
    const std::vector<std::uint32_t> worst(facet.begin(), facet.end());
    for (const std::uint32_t v : facet) {
      if (v >= context_.mesh.vertices.size())
        return {"a facet of it names a vertex that is not there", {}};
      if (!belongs(face, v) || off_plane(context_.point(v)) > 2 * context_.on_segment())
        return {"a facet of it leaves it", worst};
    }
    const std::uint32_t some = context_.find_facet(facet);
    if (some == kNoIndex) return {"a facet of it is not a facet of a cell", worst};
    for (const std::uint32_t f : {some, context_.twin[some]}) {
      if (f == kNoIndex) continue;
      // Seen from outside of the cell the corners are counter-clockwise.
      const Facet c = context_.corners(f);
      const Point3 out = cross(context_.point(c[1]) - context_.point(c[0]),
                               context_.point(c[2]) - context_.point(c[0]));
      const int side = dot(out, normal_) > 0 ? 0 : 1;
      (belongs(face, context_.apex(f)) ? in_tiling : ends)[side] = false;
    }
    return {};
  }

  const VerifyContext3& context_;
  const ChainFinder<VerifyContext3> chains_;
  std::map<Edge, std::uint32_t> segment_;
  std::vector<std::vector<Facet>> listed_;
  bool labeled_ = true;
  std::size_t facets_ = 0;
  std::vector<std::uint32_t> vertex_;
  BoxTree3 tree_;
  std::vector<std::uint8_t> on_face_;
  std::vector<std::uint32_t> marked_;
  Point3 origin_, normal_;  // of the present face
  double length_ = 0;       // of its boundary
};

}  // namespace

Check check_input_faces(const VerifyContext3& context) {
  Check check;
  check.name = "input-faces";
  check.bound = 0;
  FaceFinder finder(context);
  std::size_t missing = 0, looked_at = 0;
  const std::size_t faces = context.complex.faces.size();
  for (std::uint32_t f = 0; f < faces && !context.cells.empty(); ++f) {
    if (!context.face_wanted[f]) continue;  // outside of a closed domain
    ++looked_at;
    const FaceProblem problem = finder.look(f);
    if (problem.why.empty() || missing++ > 0) continue;
    check.worst = problem.at;
    check.detail = "input face " + std::to_string(f) + " is not a union of facets: " + problem.why;
    if (!problem.at.empty()) check.detail += " (vertices " + vertices_text(problem.at) + ")";
  }
  // Also of faces outside of a closed domain, which need not be there.
  for (const MeshFacet& f : context.mesh.facets) {
    const std::size_t n = context.mesh.vertices.size();
    const bool in_range = f.a < n && f.b < n && f.c < n;
    if (in_range && context.find_facet({f.a, f.b, f.c}) != kNoIndex) continue;
    if (missing++ > 0) continue;
    check.worst = {f.a, f.b, f.c};
    check.detail = "the facet " + vertices_text(check.worst) + " that is listed for input face " +
                   std::to_string(f.face) + " is not a facet of a cell";
  }
  check.ok = missing == 0;
  check.observed = static_cast<double>(missing);
  if (!check.ok) {
    if (missing > 1) check.detail += " (" + std::to_string(missing) + " such)";
    return check;
  }
  if (context.closed()) {
    // What is closed ends at input faces: where it does not, something is torn out.
    const std::size_t off = boundary_facets_off_faces(context, &check.worst);
    if (off > 0) {
      check.ok = false;
      check.observed = static_cast<double>(off);
      check.detail = count_text(off, "facet") +
                     " on the boundary of the closed mesh in no input face, the first is " +
                     vertices_text(check.worst);
      return check;
    }
  }
  if (context.cells.empty()) {
    check.detail = "there are no cells, and so no facets to look at";
    return check;
  }
  check.detail = count_text(looked_at, "input face") + ", each tiled on both sides, by " +
                 count_text(finder.facets(), "facet") + " in all";
  if (looked_at < faces)
    check.detail += "; " + std::to_string(faces - looked_at) + " outside the domain";
  if (!finder.labeled() && faces > 0)
    check.detail += "; without labels: vertices count as on them within 1e-9 of the diameter";
  return check;
}

}  // namespace circumball
