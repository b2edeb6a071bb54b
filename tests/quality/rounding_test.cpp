#include <gtest/gtest.h>

#include "circumball/refine.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/complexes.h"

namespace circumball {
namespace {

using testing::finish;
using testing::options_of;
using testing::Random;

/// Triangles with corners on a lattice of 1e-3, a million away from the origin: a unit in the last
/// place of a coordinate is a ten millionth of a side, and most midpoints are off their segments.
Complex far_away(std::uint64_t seed) {
  Random random(seed);
  for (;;) {
    Complex c;
    for (int i = 0; i < 3; ++i) {
      c.vertices.push_back({1e6 + random.below(10) * 1e-3, 1e6 + random.below(10) * 1e-3, 0});
    }
    c.segments = {{0, 1}, {1, 2}, {2, 0}};
    bool valid = true;
    for (const Defect& d : check(c)) valid = valid && d.warning;
    if (valid && smallest_angle_degrees(c) > 25) return c;
  }
}

TEST(Rounding, OfVerticesOnSegmentsIsNoViolationHoweverFarAway) {
  std::size_t vertices = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Options options = options_of("ruppert");
    options.domain = seed % 2 ? Domain::kClosed : Domain::kHull;
    options.size = "2e-4";
    const auto run = finish(far_away(seed), options);
    ASSERT_EQ(run->status(), Status::kComplete) << seed;
    vertices += run->mesh().vertices.size();
    VerifyOptions promised = promised_checks(*run);
    for (const Check& check : verify(run->mesh(), run->complex(), promised)) {
      EXPECT_TRUE(check.ok || check.name == "nearest-neighbor") << seed << " " << check.detail;
    }
  }
  EXPECT_GT(vertices, 10000u);
}

TEST(Rounding, LeavesTheBoundOnFeatureSizesThatIsAttained) {
  Complex c;  // the lower bound is attained at vertex 1, but for rounding
  c.vertices = {
      {1000000.007, 1000000.009, 0}, {1000000.009, 1000000.001, 0}, {1000000.006, 1000000.007, 0}};
  c.segments = {{1, 2}, {2, 0}, {0, 1}};
  Options options = options_of("feature-size");
  options.domain = Domain::kHull;
  const auto run = finish(c, options);
  VerifyOptions lower;
  lower.checks = {"nearest-neighbor-lower"};
  const Check check = verify(run->mesh(), run->complex(), lower).at(0);
  EXPECT_TRUE(check.ok) << check.detail;
  ASSERT_TRUE(check.observed);
  EXPECT_LT(*check.observed, 0.5);
}

TEST(Rounding, DoesNotExcuseAVertexThatIsOff) {
  const auto run = finish(far_away(1), options_of("ruppert"));
  Mesh mesh = run->mesh();
  ASSERT_GT(mesh.vertices.size(), 3u);
  VerifyOptions options;
  options.checks = {"input-segments"};
  ASSERT_TRUE(verify(mesh, run->complex(), options).at(0).ok);
  for (std::uint32_t v = 3; v < mesh.vertices.size(); ++v) {
    if (mesh.vertex_features[v].kind != FeatureKind::kSegment) continue;
    mesh.vertices[v].x += 1e-7;
    mesh.vertices[v].y += 2e-7;
    break;
  }
  EXPECT_FALSE(verify(mesh, run->complex(), options).at(0).ok);
}

}  // namespace
}  // namespace circumball
