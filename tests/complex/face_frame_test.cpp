#include <gtest/gtest.h>

#include <cmath>

#include "circumball/complex.h"

namespace circumball {
namespace {

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Complex triangle(const Point3& a, const Point3& b, const Point3& c) {
  Complex complex;
  complex.dimension = 3;
  complex.vertices = {a, b, c};
  complex.faces.push_back({{{0, 1, 2}}, {}, {}, {}});
  return complex;
}

TEST(FaceFrame, IsOrthonormalRightHandedAndHoldsTheFace) {
  const Complex sloping = triangle({1, 2, 3}, {4, -1, 5}, {0.5, 7, -2});
  const auto frame = face_frame(sloping, 0);
  ASSERT_TRUE(frame.has_value());
  const Point3 axes[3] = {frame->first, frame->second, frame->normal};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(dot(axes[i], axes[j]), i == j ? 1 : 0, 1e-15);
  }
  // Counter-clockwise about the normal, as its corners are listed.
  Point2 p[3];
  for (int k = 0; k < 3; ++k) {
    const Point3 d = minus(sloping.vertices[k], frame->origin);
    EXPECT_NEAR(dot(d, frame->normal), 0, 1e-14);
    p[k] = {dot(d, frame->first), dot(d, frame->second)};
  }
  const double twice =
      (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  EXPECT_GT(twice, 0);
}

TEST(FaceFrame, OfAFaceParallelToACoordinatePlaneHasItsAxes) {
  const auto frame = face_frame(triangle({1, 1, 5}, {2, 1, 5}, {1, 3, 5}), 0);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->first, (Point3{1, 0, 0}));
  EXPECT_EQ(frame->second, (Point3{0, 1, 0}));
  EXPECT_EQ(frame->normal, (Point3{0, 0, 1}));
}

TEST(FaceFrame, IsNoneWithoutAreaOrWithIndicesOutOfRange) {
  EXPECT_FALSE(face_frame(triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), 0).has_value());
  Complex wrong = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(face_frame(wrong, 1).has_value());
  wrong.faces[0].loops[0][2] = 9;
  EXPECT_FALSE(face_frame(wrong, 0).has_value());
  wrong = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  wrong.dimension = 2;
  EXPECT_FALSE(face_frame(wrong, 0).has_value());
}

}  // namespace
}  // namespace circumball
