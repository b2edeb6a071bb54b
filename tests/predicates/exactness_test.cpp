// A million nearly degenerate inputs: every sign is that of exact integer arithmetic.

#include <gtest/gtest.h>

#include <cstring>

#include "circumball/predicates.h"
#include "predicates/reference.h"
#include "predicates/support.h"

namespace circumball::testing {
namespace {

constexpr int kInputs = 125000;  // for each of eight predicates

/// Runs `check` on inputs of which every fourth is mixed in magnitude, every fourth a small
/// lattice, and the others come from `degenerate`, perturbed by a few doubles; all rescaled, up to
/// the edges of the range. Counts what the exact signs were: a family that never meets a zero or
/// one of the signs would test little.
template <class Degenerate, class Check>
void run(std::uint64_t seed, Degenerate degenerate, Check check) {
  Random random(seed);
  int seen[3] = {};
  for (int i = 0; i < kInputs && !::testing::Test::HasFailure(); ++i) {
    Points points;
    if (i % 4 == 0) {
      points = mixed_points(random);
    } else {
      if (i % 4 == 1) {
        const Point3 offset = random_offset(random);
        for (Point3& p : points) p = lattice_point(random) + offset;
      } else {
        points = degenerate(random);
      }
      rescale(points, random);
      perturb(points, random);
    }
    const Sign s = check(points);
    ++seen[static_cast<int>(s) + 1];
  }
  for (const int count : seen) EXPECT_GT(count, kInputs / 50);
}

/// "(x, y, z) ..." in hexadecimal, to reproduce a failure.
std::string print(const Points& points) {
  std::string s;
  char buffer[128];
  for (const Point3& p : points) {
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a} ", p.x, p.y, p.z);
    s += buffer;
  }
  return s;
}

/// Points of a line, or of a plane, through random points.
Points on_line(Random& random) {
  const Point3 offset = random_offset(random);
  const Point3 a = random_point(random) + offset, b = random_point(random) + offset;
  Points points = {a, b};
  for (int i = 2; i < 5; ++i) points[i] = a + random.uniform() * (b - a);
  return points;
}

Points on_plane(Random& random) {
  const Point3 offset = random_offset(random);
  const bool integers = random.below(2) == 0;
  const auto point = [&] { return integers ? lattice_point(random) : random_point(random); };
  const auto factor = [&] { return integers ? random.between(-3, 3) : random.uniform(); };
  const Point3 a = point() + offset, b = point() + offset, c = point() + offset;
  Points points = {a, b, c};
  for (int i = 3; i < 5; ++i) {
    const double s = factor(), t = factor();
    points[i] = a + s * (b - a) + t * (c - a);
  }
  return points;
}

Points on_circle(Random& random) {
  const Point3 center = random_offset(random);
  const double radius = 1 + random.uniform() / 2;
  Points points;
  for (Point3& p : points) p = circle_point(center, radius, random);
  if (random.below(2) == 0) {  // exactly, before rounding the offset
    for (Point3& p : points) {
      do {
        p = integer_sphere_point(random);
      } while (p.z != 0);
      p = p + Point3{center.x, center.y, 0};
    }
  }
  return points;
}

Points on_sphere(Random& random) {
  const Point3 center = random_offset(random);
  const double radius = 1 + random.uniform() / 2;
  const bool integers = random.below(2) == 0;
  Points points;
  for (Point3& p : points) {
    p = integers ? integer_sphere_point(random) + center : sphere_point(center, radius, random);
  }
  return points;
}

/// The first two are opposite on a sphere that holds the others.
Points on_diametral_sphere(Random& random) {
  const Point3 center = random_offset(random);
  Points points = on_sphere(random);
  if (random.below(2) == 0) {
    points[0] = integer_sphere_point(random);
    points[1] = -1.0 * points[0];
    for (int i = 2; i < 5; ++i) points[i] = integer_sphere_point(random);
  } else {
    points[0] = sphere_point({}, 1, random);
    points[1] = -1.0 * points[0];
    for (int i = 2; i < 5; ++i) points[i] = sphere_point({}, 1, random);
  }
  for (Point3& p : points) p = p + center;
  return points;
}

/// The same in the plane.
Points on_diametral_circle(Random& random) {
  const Point3 center = random_offset(random);
  Points points = on_circle(random);
  points[0] = points[0] - center;
  points[1] = -1.0 * points[0] + center;
  points[0] = points[0] + center;
  return points;
}

/// The first three are on a great circle of a sphere that holds the others.
Points on_great_circle(Random& random) {
  const Point3 center = random_offset(random);
  Points points;
  if (random.below(2) == 0) {
    const int axis = random.below(3);
    for (int i = 0; i < 5; ++i) {
      do {
        points[i] = integer_sphere_point(random);
      } while (i < 3 && coordinate(points[i], axis) != 0);
    }
  } else {
    const Point3 u = sphere_point({}, 1, random);
    Point3 v = sphere_point({}, 1, random);
    v = v - (u.x * v.x + u.y * v.y + u.z * v.z) * u;
    v = 1 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z) * v;
    for (int i = 0; i < 5; ++i) {
      const Point3 c = circle_point({}, 1, random);
      points[i] = i < 3 ? c.x * u + c.y * v : sphere_point({}, 1, random);
    }
  }
  for (Point3& p : points) p = p + center;
  return points;
}

/// |ab| = |cd|: two chords that a rotation, a reflection or a translation takes to each other.
Points equal_chords(Random& random) {
  const Point3 center = random_offset(random);
  const Point3 d = random.below(2) == 0 ? lattice_point(random) : random_point(random);
  const Point3 turned = random.below(2) == 0 ? Point3{-d.y, d.x, 0} : Point3{d.x, -d.y, 0};
  const Point3 a = random_point(random) + center, c = random_point(random) + center;
  return {a, a + d, c, c + turned, a};
}

TEST(Exactness, Orient2dHasTheSignOfItsDeterminant) {
  run(1, on_line, [](const Points& p) {
    const Sign s = exact_orient2d(p[0], p[1], p[2]);
    EXPECT_EQ(orient2d(xy(p[0]), xy(p[1]), xy(p[2])), s) << print(p);
    return s;
  });
}

TEST(Exactness, Orient3dHasTheSignOfItsDeterminant) {
  run(2, on_plane, [](const Points& p) {
    const Sign s = exact_orient3d(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), s) << print(p);
    return s;
  });
}

TEST(Exactness, IncircleHasTheSignOfItsDeterminant) {
  run(3, on_circle, [](const Points& p) {
    const Sign s = exact_incircle(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(incircle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])), s) << print(p);
    return s;
  });
}

TEST(Exactness, InsphereHasTheSignOfItsDeterminant) {
  run(4, on_sphere, [](const Points& p) {
    const Sign s = exact_insphere(p[0], p[1], p[2], p[3], p[4]);
    EXPECT_EQ(insphere(p[0], p[1], p[2], p[3], p[4]), s) << print(p);
    return s;
  });
}

TEST(Exactness, DiametralBallOfSegmentInThePlaneIsThalesCircle) {
  run(5, on_diametral_circle, [](const Points& p) {
    const Point3 a = xyz(xy(p[0])), b = xyz(xy(p[1])), c = xyz(xy(p[2]));
    const Sign s = exact_segment_ball(a, b, c);
    EXPECT_EQ(in_diametral_ball(xy(a), xy(b), xy(c)), s) << print(p);
    return s;
  });
}

TEST(Exactness, DiametralBallOfSegmentInSpaceIsThalesSphere) {
  run(6, on_diametral_sphere, [](const Points& p) {
    const Sign s = exact_segment_ball(p[0], p[1], p[2]);
    EXPECT_EQ(in_diametral_ball(p[0], p[1], p[2]), s) << print(p);
    return s;
  });
}

TEST(Exactness, DiametralBallOfTriangleHasItsCircumcenter) {
  run(7, on_great_circle, [](const Points& p) {
    const Sign s = exact_triangle_ball(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(in_diametral_ball(p[0], p[1], p[2], p[3]), s) << print(p);
    return s;
  });
}

TEST(Exactness, CompareDistanceComparesSquares) {
  run(8, equal_chords, [](const Points& p) {
    const Sign s = exact_compare_distance(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(compare_distance(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])), s) << print(p);
    return s;
  });
}

}  // namespace
}  // namespace circumball::testing
