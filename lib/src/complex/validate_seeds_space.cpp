#include <map>

#include "complex/face_shells.h"
#include "complex/space_contacts.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

using Triangle = SpaceContacts::Triangle;

std::vector<Triangle> triangles_of(const std::vector<FaceSurface>& surfaces) {
  std::vector<Triangle> all;
  for (const FaceSurface& s : surfaces)
    all.insert(all.end(), s.triangles.begin(), s.triangles.end());
  return all;
}

class SeedCheck {
 public:
  SeedCheck(const Complex& complex, const SpaceView& view, const std::vector<FaceSurface>& surfaces)
      : complex_(complex), shells_(complex, triangles_of(surfaces)), points_(complex.vertices) {
    for (std::uint32_t f = 0; f < surfaces.size(); ++f)
      face_of_.insert(face_of_.end(), surfaces[f].triangles.size(), f);
    points_.emplace_back();  // the seed
    std::vector<Box3> boxes;
    for (const std::uint32_t s : view.segments) {
      segment_of_.push_back(s);
      boxes.push_back(Box3::of(points_[complex.segments[s][0]], points_[complex.segments[s][1]]));
    }
    segments_ = BoxTree3(std::move(boxes));
  }

  /// The face, segment, or vertex of a face or segment that a point is on; kFree without.
  Feature on(const Point3& p) {
    points_[seed()] = p;
    const SpaceContacts contacts(points_);
    Feature found;
    const Box3 at = Box3::of(p);
    const auto enter = [&](const Box3& box) { return box.meets(at); };
    segments_.query(enter, [&](std::uint32_t i) {
      const auto& s = complex_.segments[segment_of_[i]];
      for (const std::uint32_t v : s)
        if (points_[v] == p) found = {FeatureKind::kVertex, v};
      if (found.kind == FeatureKind::kFree && contacts.on_segment(seed(), s[0], s[1]))
        found = {FeatureKind::kSegment, segment_of_[i]};
      return found.kind == FeatureKind::kFree;
    });
    if (found.kind != FeatureKind::kFree) return found;
    shells_.tree().query(enter, [&](std::uint32_t k) {
      const Triangle& t = shells_.triangles()[k];
      bool in = contacts.in_triangle(seed(), t);
      for (int i = 0; i < 3; ++i)
        in = in || points_[t[i]] == p || contacts.on_segment(seed(), t[i], t[(i + 1) % 3]);
      if (in) found = {FeatureKind::kFace, face_of_[k]};
      return !in;
    });
    return found;
  }

  /// Whether faces enclose a point that is on none of them. A ray that passes no edge decides for
  /// each connected part of the faces: the point is outside of it if the side that is met first and
  /// the side that is left last belong to one shell. Parts that share no edge enclose nothing
  /// together that none encloses alone (their intersection is finite: Alexander duality). True if
  /// rays do not decide.
  bool enclosed(const Point3& p) {
    if (!shells_.is_near(p)) return false;
    std::vector<FaceShells::Hit> hits;
    for (int attempt = 0; attempt < FaceShells::kAttempts; ++attempt) {
      bool inside = false;
      if (shells_.cast(p, attempt, &hits) && is_decided(hits, &inside)) return inside;
    }
    return true;
  }

 private:
  std::uint32_t seed() const { return static_cast<std::uint32_t>(complex_.vertices.size()); }

  bool is_decided(const std::vector<FaceShells::Hit>& hits, bool* inside) const {
    std::map<std::uint32_t, std::vector<FaceShells::Hit>> parts;  // by component
    for (const auto& hit : hits) parts[shells_.component(hit.triangle)].push_back(hit);
    for (const auto& [part, list] : parts) {
      if (!FaceShells::is_first(list) || !FaceShells::is_last(list)) return false;
      const FaceShells::Hit &first = list[0], &last = list.back();
      if (shells_.shell(first.triangle, first.front) != shells_.shell(last.triangle, !last.front))
        *inside = true;
    }
    return true;
  }

  const Complex& complex_;
  FaceShells shells_;
  std::vector<Point3> points_;
  std::vector<std::uint32_t> face_of_, segment_of_;
  BoxTree3 segments_;
};

std::string kind_text(FeatureKind kind) {
  return kind == FeatureKind::kVertex    ? "vertex "
         : kind == FeatureKind::kSegment ? "segment "
                                         : "face ";
}

}  // namespace

void check_seeds_in_space(const Complex& complex, const SpaceView& view,
                          const std::vector<FaceSurface>& surfaces, std::size_t max,
                          std::vector<Defect>* defects) {
  if (complex.holes.empty() && complex.regions.empty()) return;
  SeedCheck seeds(complex, view, surfaces);
  DefectList hole("hole-outside", true, max), region("region-outside", true, max);
  const auto look = [&](const Point3& p, const std::string& name, const std::string& effect,
                        DefectList* list) {
    if (!usable(p.x) || !usable(p.y) || !usable(p.z)) return;
    const Feature on = seeds.on(p);
    if (on.kind != FeatureKind::kFree)
      list->add({on}, {p},
                name + " at " + point_text(p, 3) + " lies on " + kind_text(on.kind) +
                    std::to_string(on.index) + ", between the parts that it might mean: " + effect +
                    "; move it off");
    else if (!seeds.enclosed(p))
      list->add({}, {p},
                name + " at " + point_text(p, 3) + " lies outside everything that faces enclose: " +
                    effect + "; move it inside a closed boundary");
  };
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    look(complex.holes[i], "hole seed " + std::to_string(i), "it removes nothing", &hole);
  for (std::size_t i = 0; i < complex.regions.size(); ++i)
    look(complex.regions[i].at, "region seed " + std::to_string(i), "it labels nothing", &region);
  hole.append_to(defects);
  region.append_to(defects);
}

}  // namespace circumball
