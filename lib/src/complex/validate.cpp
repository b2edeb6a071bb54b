#include <algorithm>

#include "complex/validate_defects.h"

namespace circumball {

std::vector<Defect> check(const Complex& complex, std::size_t max_defects) {
  const std::size_t max = max_defects;
  std::vector<Defect> defects = check_numbers(complex, max);
  check_vertices(complex, max, &defects);
  check_seed_coordinates(complex, max, &defects);

  std::vector<Point2> seeds;
  if (complex.dimension == 2) {
    for (const Point3& p : complex.holes) seeds.push_back(xy(p));
    for (const Region& r : complex.regions) seeds.push_back(xy(r.at));
  }
  // In space the view is of the projection, in which nothing may be concluded: only its own
  // segments' ends are used.
  const PlanarView view(complex.dimension == 2 ? complex : Complex{}, seeds);
  check_segments(complex, view, max, &defects);
  if (complex.dimension != 2) return defects;

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
