#include <algorithm>

#include "complex/validate_defects.h"

namespace circumball {

void check_segments(const Complex& complex,
                    const std::vector<std::array<std::uint32_t, 2>>& duplicates, std::size_t max,
                    std::vector<Defect>* defects) {
  const std::size_t n = complex.vertices.size();
  DefectList zero("zero-length-segment", false, max);
  for (std::uint32_t i = 0; i < complex.segments.size(); ++i) {
    const auto& s = complex.segments[i];
    const std::string name = "segment " + std::to_string(i);
    if (s[0] >= n || s[1] >= n) continue;  // told by check_numbers
    const Point3 &a = complex.vertices[s[0]], &b = complex.vertices[s[1]];
    const bool same = a.x == b.x && a.y == b.y && (complex.dimension == 2 || a.z == b.z);
    if (s[0] == s[1] || same)
      zero.add({{FeatureKind::kSegment, i}}, {a},
               name + " has both ends at " + point_text(a, complex.dimension) + ": remove it");
  }
  zero.append_to(defects);

  DefectList duplicate("duplicate-segments", true, max);
  for (const auto& pair : duplicates) {
    const auto& s = complex.segments[pair[1]];
    const Point3 &a = complex.vertices[s[0]], &b = complex.vertices[s[1]];
    duplicate.add({{FeatureKind::kSegment, pair[1]}, {FeatureKind::kSegment, pair[0]}}, {a, b},
                  "segments " + std::to_string(pair[1]) + " and " + std::to_string(pair[0]) +
                      " both join " + point_text(a, complex.dimension) + " and " +
                      point_text(b, complex.dimension) + ": the second is ignored; remove it");
  }
  duplicate.append_to(defects, true);
}

}  // namespace circumball
