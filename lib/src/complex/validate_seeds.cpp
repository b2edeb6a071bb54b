#include <cmath>

#include "complex/planar_arrangement.h"
#include "complex/validate_defects.h"

namespace circumball {

void check_seed_coordinates(const Complex& complex, std::size_t max, std::vector<Defect>* defects) {
  DefectList magnitude("magnitude", false, max);
  const auto look = [&](const Point3& p, const std::string& name) {
    const bool space = complex.dimension == 3;
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || (space && !std::isfinite(p.z)))
      return;  // told by check_numbers
    if (!usable(p.x) || !usable(p.y) || (space && !usable(p.z)))
      magnitude.add(
          {}, {p},
          name + " is at " + point_text(p, complex.dimension) +
              ": scale the input so that every coordinate is 0 or of magnitude 1e-45 to 1e55");
  };
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    look(complex.holes[i], "hole seed " + std::to_string(i));
  for (std::size_t i = 0; i < complex.regions.size(); ++i)
    look(complex.regions[i].at, "region seed " + std::to_string(i));
  magnitude.append_to(defects);
}

void check_seed_places(const Complex& complex, const PlanarView& view, const SweepResult& swept,
                       std::size_t max, std::vector<Defect>* defects) {
  if (complex.holes.empty() && complex.regions.empty()) return;
  const PlanarArrangement arrangement(view, swept);
  DefectList hole("hole-outside", true, max), region("region-outside", true, max);
  const std::size_t holes = complex.holes.size();
  for (std::size_t i = 0; i < view.point_of_seed.size(); ++i) {
    const std::uint32_t point = view.point_of_seed[i];
    if (point == kNoIndex) continue;
    const bool is_hole = i < holes;
    const std::string name =
        is_hole ? "hole seed " + std::to_string(i) : "region seed " + std::to_string(i - holes);
    const Point3 at = xyz(view.points[point]);
    DefectList& list = is_hole ? hole : region;
    const std::string effect = is_hole ? "it removes nothing" : "it labels nothing";
    const std::uint32_t face = arrangement.face_of_point(point);
    if (face == PlanarArrangement::kUnbounded) {
      list.add({}, {at},
               name + " at " + point_text(at) + " lies outside everything that segments enclose: " +
                   effect + "; move it inside a closed boundary");
    } else if (face == kNoIndex) {
      const std::uint32_t through = swept.through[point];
      std::vector<Feature> on;
      if (through != kNoIndex)
        on.push_back({FeatureKind::kSegment, view.segments[through].segment});
      else
        on.push_back({FeatureKind::kVertex, view.vertex[point]});
      list.add(on, {at},
               name + " at " + point_text(at) + " lies on " +
                   (through != kNoIndex ? "segment " : "vertex ") + std::to_string(on[0].index) +
                   ", between the parts that it might mean: " + effect + "; move it off");
    }
  }
  hole.append_to(defects);
  region.append_to(defects);
}

}  // namespace circumball
