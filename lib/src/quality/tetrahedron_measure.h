#ifndef CIRCUMBALL_QUALITY_TETRAHEDRON_MEASURE_H_
#define CIRCUMBALL_QUALITY_TETRAHEDRON_MEASURE_H_

#include "circumball/types.h"

namespace circumball {

/// A sum of two doubles that do not overlap: about 100 bits. Products and sums of a few such
/// numbers are off by a few 2^-100 of the largest term (Dekker 1971).
struct Twofold {
  double high = 0, low = 0;
};
Twofold operator+(const Twofold& a, const Twofold& b);
Twofold operator*(const Twofold& a, const Twofold& b);

/// Lengths of a tetrahedron, with a bound on what rounding did to them.
struct TetrahedronMeasure {
  double circumradius = 0;  ///< infinite for a flat tetrahedron
  double shortest = 0, longest = 0;
  double radius_edge = 0;  ///< thesis, Definition 2.1.2
  Twofold six_volume;      ///< positive where orient3d is
  /// Bound on the relative error of circumradius and radius_edge, and of any other evaluation that
  /// takes care where differences cancel. Below 1e-10.
  double error = 0;
};
TetrahedronMeasure measure_tetrahedron(const Point3& a, const Point3& b, const Point3& c,
                                       const Point3& d);

/// Smallest and largest dihedral angle in degrees, some ulp accurate; reported only.
struct DihedralRange {
  double min, max;
};
DihedralRange dihedrals_degrees(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_TETRAHEDRON_MEASURE_H_
