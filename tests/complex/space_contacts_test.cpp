#include "complex/space_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/complexes.h"
#include "support/interiors.h"

namespace circumball {
namespace {

using testing::Random;
using Meeting = SpaceContacts::Meeting;
using testing::interiors_meet;
using testing::Simplex;

/// Points of a small lattice: every coincidence, collinearity and coplanarity comes up.
std::vector<Point3> lattice_points(Random* random, int count, std::uint32_t side) {
  std::vector<Point3> points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const Point3 p{static_cast<double>(random->below(side)),
                   static_cast<double>(random->below(side)),
                   static_cast<double>(random->below(side))};
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

TEST(SpaceContacts, AgreeWithExactLinearProgramsOnLatticePoints) {
  Random random(3);
  int met[4] = {};
  for (int run = 0; run < 6000; ++run) {
    const auto points = lattice_points(&random, 6, run % 2 == 0 ? 3 : 4);
    const SpaceContacts contacts(points);
    // Simplices that share numbers now and then.
    const auto pick = [&](std::size_t n) {
      Simplex s;
      while (s.size() < n) {
        const std::uint32_t v = random.below(6);
        if (std::find(s.begin(), s.end(), v) == s.end()) s.push_back(v);
      }
      return s;
    };
    const Simplex v = pick(1), a = pick(2), b = pick(2), t = pick(3), u = pick(3);
    EXPECT_EQ(contacts.on_segment(v[0], a[0], a[1]),
              v[0] != a[0] && v[0] != a[1] && interiors_meet(points, v, a));
    const Meeting ab = contacts.segments(a[0], a[1], b[0], b[1]);
    EXPECT_EQ(ab != Meeting::kNone, interiors_meet(points, a, b));
    met[0] += ab == Meeting::kCross;
    if (contacts.collinear(t[0], t[1], t[2]) || contacts.collinear(u[0], u[1], u[2])) continue;
    const SpaceContacts::Triangle tt{t[0], t[1], t[2]}, uu{u[0], u[1], u[2]};
    EXPECT_EQ(contacts.in_triangle(v[0], tt), interiors_meet(points, v, t));
    const Meeting at = contacts.segment_triangle(a[0], a[1], tt);
    EXPECT_EQ(at != Meeting::kNone, interiors_meet(points, a, t));
    met[1] += at == Meeting::kCross;
    const Meeting tu = contacts.triangles(tt, uu);
    EXPECT_EQ(tu != Meeting::kNone, interiors_meet(points, t, u));
    met[2] += tu == Meeting::kCross;
    met[3] += tu == Meeting::kOverlap;
  }
  for (const int count : met) EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace circumball
