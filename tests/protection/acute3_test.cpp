#include "protection/acute3.h"

#include <gtest/gtest.h>

#include <cmath>

#include "complex/face_plane.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::Builder3;
using testing::cylinder;
using testing::Placement;
using testing::polar;
using testing::Random;
using testing::random_complex3;
using testing::Rotation;
using testing::SolidBuilder;

struct Asked {
  explicit Asked(const Complex& complex) : incidence(complex), acute(complex, incidence) {}
  Incidence3 incidence;
  Acute3 acute;
};

constexpr double kAngles[] = {1, 30, 60, 89, 89.9999, 90, 90.0001, 91, 120, 179};

TEST(Acute3, SegmentWithTwoFacesIsAcuteBelowNinetyDegrees) {
  Random random(1);
  for (const double angle : kAngles) {
    for (int turned = 0; turned < 4; ++turned) {
      const Rotation turn(&random);
      Builder3 b;
      b.place({turned == 3 ? 1000.0 : 0, 0, 0}, turned ? &turn : nullptr);
      const auto low = b.vertex({0, 0, 0}), high = b.vertex({0, 0, 2});
      for (const double at : {0.0, angle}) {
        b.face({low, b.vertex(cylinder(1, at, 0)), b.vertex(cylinder(1, at, 2)), high});
      }
      const Complex complex = b.complex();
      const Asked asked(complex);
      for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
        const bool axis = complex.segments[s] == std::array<std::uint32_t, 2>{low, high} ||
                          complex.segments[s] == std::array<std::uint32_t, 2>{high, low};
        EXPECT_EQ(asked.acute.segment(s), axis && angle < 90) << angle << ", " << turned;
      }
      for (std::uint32_t v = 0; v < complex.vertices.size(); ++v) {
        EXPECT_EQ(asked.acute.vertex(v), angle < 90 && (v == low || v == high)) << angle;
      }
      EXPECT_EQ(asked.acute.any(), angle < 90);
    }
  }
}

/// Sides of one face at a segment inside of it are opposite; a third face stands on it.
TEST(Acute3, BothSidesOfAFaceCountAtASegmentInside) {
  for (const double angle : {89.0, 90.0, 91.0}) {
    Builder3 b;
    const auto p = b.vertex({-1, -1, 0}), q = b.vertex({1, -1, 0}), r = b.vertex({1, 1, 0}),
               s = b.vertex({-1, 1, 0});
    const auto u = b.vertex({-0.5, 0, 0}), v = b.vertex({0.5, 0, 0});
    Face floor = b.face({p, q, r, s});
    const std::uint32_t inside = b.segment(u, v);
    floor.segments.push_back(inside);
    b.replace_last_face(floor);
    const Point2 up = polar(0, 0, 1, angle);
    b.face({u, v, b.vertex({0.5, up.x, up.y}), b.vertex({-0.5, up.x, up.y})});
    const Complex complex = b.complex();
    const Asked asked(complex);
    EXPECT_EQ(asked.acute.segment(inside), angle != 90) << angle;
  }
}

TEST(Acute3, VertexWithTwoSegmentsIsAcuteBelowNinetyDegrees) {
  Random random(2);
  for (const double angle : kAngles) {
    const Rotation turn(&random);
    Builder3 b;
    b.place({0, 0, 0}, &turn);
    const auto hub = b.vertex({0, 0, 0});
    for (const double at : {0.0, angle}) b.segment(hub, b.vertex(cylinder(1 + at, at, 0)));
    const Complex complex = b.complex();
    const Asked asked(complex);
    EXPECT_EQ(asked.acute.vertex(hub), angle < 90) << angle;
    EXPECT_FALSE(asked.acute.segment(0) || asked.acute.segment(1));
    EXPECT_FALSE(asked.acute.vertex(hub + 1) || asked.acute.vertex(hub + 2));
  }
}

/// A segment from a vertex inside of a face, and from a corner of it, over it or not.
TEST(Acute3, VertexWithASegmentAndAFaceIsAcuteUnlessItIsPerpendicularOrTurnedAway) {
  for (const double angle : {5.0, 89.0, 90.0}) {
    const Point2 up = polar(0, 0, 1, angle);
    Builder3 b;
    const auto p = b.vertex({-1, -1, 0}), q = b.vertex({1, -1, 0}), r = b.vertex({1, 1, 0}),
               s = b.vertex({-1, 1, 0});
    Face floor = b.face({p, q, r, s});
    const auto middle = b.vertex({0, 0, 0});
    floor.vertices.push_back(middle);
    b.replace_last_face(floor);
    b.segment(middle, b.vertex({0.3 * up.x, 0, 0.3 * up.y}));
    b.segment(p, b.vertex({-1 - up.x, -1 - up.x, up.y}));  // away from the face
    b.segment(q, b.vertex({1 - 0.1 * up.x, -1 + 0.1 * up.x, 0.2 * up.y}));
    const Complex complex = b.complex();
    const Asked asked(complex);
    EXPECT_EQ(asked.acute.vertex(middle), angle < 90) << angle;
    EXPECT_FALSE(asked.acute.vertex(p)) << angle;
    EXPECT_EQ(asked.acute.vertex(q), angle < 90) << angle;
    EXPECT_FALSE(asked.acute.vertex(r) || asked.acute.vertex(s));
  }
}

TEST(Acute3, NothingIsAcuteInTurnedSolidsWithRightAndObtuseAngles) {
  Random random(3);
  for (const testing::Solid& solid : testing::solids()) {
    for (int k = 0; k < 6; ++k) {
      const Rotation turn(&random);
      const double scale = k % 3 == 0 ? 1 : k % 3 == 1 ? 1e-6 : 1e6;
      SolidBuilder b({scale, &turn, k < 3 ? Point3{0, 0, 0} : Point3{1e3 * scale, 0, 0}});
      solid.build(&b);
      EXPECT_FALSE(Asked(b.complex()).acute.any()) << solid.name << ", " << k;
    }
  }
}

/// Directions in a face at a vertex of it, by degrees: those that stay in the face for a while.
std::vector<Point3> directions(const Complex& complex, std::uint32_t f, std::uint32_t v) {
  const FacePlane plane(complex, f);
  const Point2 at = plane.to_plane(complex.vertices[v]);
  std::vector<Point3> list;
  for (int k = 0; k < 720; ++k) {
    const Point2 d = polar(0, 0, 1, 0.5 * k + 0.1);
    if (!plane.contains({at.x + 1e-5 * d.x, at.y + 1e-5 * d.y})) continue;
    list.push_back(
        testing::sum(testing::scaled(d.x, plane.first()), testing::scaled(d.y, plane.second())));
  }
  return list;
}

Point3 direction(const Complex& complex, std::uint32_t from, std::uint32_t to) {
  const Point3 &p = complex.vertices[from], &q = complex.vertices[to];
  return testing::scaled(1 / testing::distance(p, q), testing::sum(q, testing::scaled(-1, p)));
}

double largest_cosine(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  double most = -1;
  for (const Point3& p : a) {
    for (const Point3& q : b) most = std::max(most, p.x * q.x + p.y * q.y + p.z * q.z);
  }
  return most;
}

/// The same by sampling: all pairs of segments and faces at a vertex, neither of which holds the
/// other, which share no segment at it.
double largest_cosine_at(const Complex& complex, const Incidence3& incidence, std::uint32_t v) {
  struct Feature3 {
    std::uint32_t segment, face;
    std::vector<Point3> directions;
  };
  std::vector<Feature3> features;
  for (const std::uint32_t s : incidence.segments_of_vertex(v)) {
    const auto& ends = complex.segments[s];
    features.push_back({s, kNoIndex, {direction(complex, v, ends[0] == v ? ends[1] : ends[0])}});
  }
  for (const std::uint32_t f : incidence.faces_of_vertex(v)) {
    features.push_back({kNoIndex, f, directions(complex, f, v)});
  }
  const auto meet_there_alone = [&](const Feature3& a, const Feature3& b) {
    if (a.face == kNoIndex && b.face == kNoIndex) return true;
    if (a.face == kNoIndex) return !incidence.face_has_segment(b.face, a.segment);
    for (const std::uint32_t s : incidence.segments_of_vertex(v)) {
      if (incidence.face_has_segment(a.face, s) && incidence.face_has_segment(b.face, s)) {
        return false;
      }
    }
    return true;
  };
  double most = -1;
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (std::size_t j = i + 1; j < features.size(); ++j) {
      if (!meet_there_alone(features[i], features[j])) continue;
      most = std::max(most, largest_cosine(features[i].directions, features[j].directions));
    }
  }
  return most;
}

TEST(Acute3, AgreesWithSampledDirectionsOnRandomComplexes) {
  int acute = 0, other = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Complex complex = random_complex3(seed, 20);
    const Asked asked(complex);
    std::vector<bool> at_segment(complex.vertices.size(), false);
    for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
      if (!asked.acute.segment(s)) continue;
      for (const std::uint32_t v : complex.segments[s]) {
        at_segment[v] = true;
        EXPECT_TRUE(asked.acute.vertex(v));
      }
    }
    for (std::uint32_t v = 0; v < complex.vertices.size(); ++v) {
      if (at_segment[v]) continue;
      const double cosine = largest_cosine_at(complex, asked.incidence, v);
      if (std::fabs(cosine) < 0.01) continue;  // half a degree apart, between two samples
      EXPECT_EQ(asked.acute.vertex(v), cosine > 0) << "seed " << seed << ", vertex " << v;
      ++(cosine > 0 ? acute : other);
    }
  }
  EXPECT_GT(acute, 100);
  EXPECT_GT(other, 100);
}

}  // namespace
}  // namespace circumball
