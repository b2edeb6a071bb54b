#include <algorithm>

#include "complex/validate_defects.h"
#include "complex/validate_space.h"

namespace circumball {

std::vector<Defect> check(const Complex& complex, std::size_t max_defects) {
  const std::size_t max = max_defects;
  std::vector<Defect> defects = check_numbers(complex, max);
  check_vertices(complex, max, &defects);
  check_seed_coordinates(complex, max, &defects);

  if (complex.dimension == 3) {
    const SpaceView view(complex);
    check_segments(complex, view.duplicate_segments, max, &defects);
    SpaceMeetings meetings;
    const std::vector<FaceSurface> surfaces = check_faces(complex, view, max, &meetings, &defects);
    check_contacts(complex, view, surfaces, max, &meetings, &defects);
    check_near_contacts(complex, view, surfaces, meetings, max, &defects);
    // With a boundary that is broken, "outside" would be said of seeds that are where they should
    // be.
    if (std::all_of(defects.begin(), defects.end(), [](const Defect& d) { return d.warning; }))
      check_seeds_in_space(complex, view, surfaces, max, &defects);
    return defects;
  }
  std::vector<Point2> seeds;
  for (const Point3& p : complex.holes) seeds.push_back(xy(p));
  for (const Region& r : complex.regions) seeds.push_back(xy(r.at));
  const PlanarView view(complex, seeds);
  check_segments(complex, view.duplicate_segments, max, &defects);

  const SweepResult swept = sweep(view);
  check_crossings(view, swept, max, &defects);
  const bool planar =
      std::none_of(swept.suspect.begin(), swept.suspect.end(), [](auto s) { return s != 0; });
  const bool whole =
      view.segments.size() + view.duplicate_segments.size() == complex.segments.size();
  // With a boundary that is broken, "outside" would be said of seeds that are where they should be.
  if (planar && whole) check_seed_places(complex, view, swept, max, &defects);
  return defects;
}

}  // namespace circumball
