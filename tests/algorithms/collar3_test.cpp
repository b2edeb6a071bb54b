#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "delaunay/tetrahedron_shape.h"
#include "feature_size/feature_table.h"
#include "feature_size/vectors.h"
#include "support/acute.h"
#include "support/examples.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::example;
using testing::finish;
using testing::Random;
using testing::random_complex3;
using testing::Rotation;

Options collar() {
  Options options = testing::options_of("collar");
  options.limits.max_vertices = 100000;
  return options;
}

/// It ended, it conforms, and Theorem 6.11 holds of what is left above tau.
void expect_kept_promises(const Run& run, const std::string& what) {
  EXPECT_EQ(run.status(), Status::kComplete) << what;
  std::size_t others = 0;
  for (const Unresolved& u : run.unresolved(100000)) {
    others += u.simplex.size() != 4 || u.reason != "protected";
  }
  EXPECT_EQ(others, 0u) << what;
  for (const Check& check : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(check.ok) << what << ", " << check.name << ": " << check.detail;
  }
}

/// Books, fans, spikes, plates and more, at angles from 1 degree; by all settings in turn.
TEST(CollarInSpace, EndsConformsAndKeepsTheorem611OnRandomAcuteComplexes) {
  for (std::uint64_t seed = 1; seed <= testing::cases(40); ++seed) {
    Options options = collar();
    options.domain = Domain::kBox;
    options.parameters["protect"] = seed % 5 ? "acute" : "all";
    const double least[] = {1, 3, 8, 15, 30, 60};
    const auto run = finish(random_complex3(seed, least[seed % 6], 2), options);
    ASSERT_TRUE(run) << seed;
    expect_kept_promises(*run, "seed " + std::to_string(seed));
  }
}

/// Pages at 3 and 9 degrees: ears at corners of their collars are encroached by vertices beside a
/// side that they do not share with the collar.
TEST(CollarInSpace, LinesUpAtTheCornersOfItsCollars) {
  Options options = collar();
  options.domain = Domain::kBox;
  const auto run = finish(random_complex3(288, 3, 2), options);
  ASSERT_TRUE(run);
  expect_kept_promises(*run, "pages");
}

TEST(CollarInSpace, KeepsItsPromisesAtOtherHeightsAndSizes) {
  const char* const settings[][3] = {{"0.75", "0.66", "acute"},
                                     {"0.52", "0.95", "all"},
                                     {"0.6", "0.3", "acute"},
                                     {"0.55", "0.9", "all"}};
  for (const auto& [height, factor, protect] : settings) {
    for (const char* name : {"schoenhardt.json", "dangling.json"}) {
      Options options = collar();
      options.parameters = {{"height", height}, {"size-factor", factor}, {"protect", protect}};
      const auto run = finish(example(name), options);
      ASSERT_TRUE(run) << name << height;
      expect_kept_promises(*run, std::string(name) + " at height " + height);
    }
  }
}

TEST(CollarInSpace, RefusesHeightsAtWhichCollarsWouldCross) {
  Options options = collar();
  options.parameters = {{"height", "0.7"}, {"size-factor", "0.8"}};
  std::vector<Defect> defects;
  std::string error;
  EXPECT_FALSE(Run::create(example("pyramid.json"), options, nullptr, &defects, &error));
  EXPECT_NE(error.find("below 1/2"), std::string::npos) << error;
}

TEST(CollarInSpace, IsRuppertsAlgorithmWhereNothingIsAcute) {
  Random random(7);
  for (const testing::Solid& solid : testing::solids()) {
    const Rotation turn(&random);
    testing::SolidBuilder builder({1, &turn, {0, 0, 0}});
    solid.build(&builder);
    Options options = collar();
    options.tau = 2.2;
    const auto protected_run = finish(builder.complex(), options);
    options.algorithm = "ruppert";
    const auto run = finish(builder.complex(), options);
    ASSERT_TRUE(run && protected_run) << solid.name;
    EXPECT_EQ(fingerprint(run->mesh()), fingerprint(protected_run->mesh())) << solid.name;
  }
}

TEST(CollarInSpace, MeshesThePyramidAndSchoenhardtsPrism) {
  for (const char* name : {"pyramid.json", "schoenhardt.json"}) {
    const auto run = finish(example(name), collar());
    ASSERT_TRUE(run) << name;
    EXPECT_EQ(run->domain(), Domain::kClosed) << name;
    expect_kept_promises(*run, name);
  }
}

/// The pyramid after steps 2b and 2c: as many vertices as an independent implementation has.
TEST(CollarInSpace, DrawsTheCollarsOfThePyramidBySizesOfAlgorithm41) {
  Options options = collar();
  options.parameters["protect"] = "all";
  options.parameters["sizes"] = "estimate";
  const auto run = finish(example("pyramid.json"), options);
  ASSERT_TRUE(run);
  ASSERT_GE(run->steps().size(), 3u);
  EXPECT_EQ(run->steps()[1].vertices, 271u);
  EXPECT_EQ(run->steps()[2].vertices, 751u);
}

TEST(CollarInSpace, ConformsWhereverTheComplexStands) {
  const Complex pyramid = example("pyramid.json");
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    const Rotation turn(&random);
    const double scale = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 1e-6 : 1e6;
    const double away = seed == 3 ? 1e5 : 0;
    Complex complex = pyramid;
    for (Point3& p : complex.vertices) {
      const Point3 q = turn({scale * p.x, scale * p.y, scale * p.z});
      p = {q.x + away, q.y - away, q.z + 0.3 * away};
    }
    const auto run = finish(complex, collar());
    ASSERT_TRUE(run) << seed;
    expect_kept_promises(*run, "placement " + std::to_string(seed));
  }
}

/// What protects a complex, at some moment of its run.
struct Moment {
  Moment(const Complex& complex, const Options& options, const std::string& step) {
    Trace trace;
    trace.dimension = 3;
    run = finish(complex, options, &trace);
    if (!run) return;
    const auto& names = run->step_names();
    const auto wanted = std::find(names.begin(), names.end(), step) - names.begin();
    Replay replay(trace);
    for (const Event& e : trace.events) {
      replay.forward();
      if (e.kind == EventKind::kStepEnded && e.step == wanted) break;
    }
    elements = replay.protection();
    triangles = replay.face_triangles();
    vertices = replay.vertices();
    for (const ProtectingElement& p : elements) {
      if (p.kind == ProtectingKind::kProtectedSubsegment) on_segments.insert({p.a, p.b});
    }
  }
  double dot(std::uint32_t at, std::uint32_t a, std::uint32_t b) const {
    const Point3 &o = vertices.at(at), &p = vertices.at(a), &q = vertices.at(b);
    return (p.x - o.x) * (q.x - o.x) + (p.y - o.y) * (q.y - o.y) + (p.z - o.z) * (q.z - o.z);
  }
  /// The smallest cosine between elements of one face that share a vertex.
  double largest_cosine(bool arcs) const {
    std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> at;  // of face and vertex
    double most = -1;
    for (const ProtectingElement& p : elements) {
      if (p.kind != ProtectingKind::kCollarSegment &&
          !(arcs && p.kind == ProtectingKind::kCollarArc))
        continue;
      for (const auto& [v, other] : {std::pair{p.a, p.b}, std::pair{p.b, p.a}}) {
        auto& others = at[{p.carrier, v}];
        for (const std::uint32_t u : others) {
          most = std::max(most, dot(v, u, other) / std::sqrt(dot(v, u, u) * dot(v, other, other)));
        }
        others.push_back(other);
      }
    }
    return most;
  }
  bool in_ball(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
    return dot(v, a, b) < -1e-9 * dot(a, b, b);
  }

  std::unique_ptr<Run> run;
  std::vector<ProtectingElement> elements;
  std::vector<std::uint32_t> triangles;
  std::map<std::uint32_t, Point3> vertices;
  std::set<std::array<std::uint32_t, 2>> on_segments;
};

std::vector<Complex> some_acute_complexes() {
  std::vector<Complex> list{example("pyramid.json"), example("schoenhardt.json"),
                            example("two-non-convex.json")};
  for (std::uint64_t seed = 1; seed <= 12; ++seed) list.push_back(random_complex3(seed, 5, 1));
  return list;
}

TEST(CollarInSpace, PiecesOfProtectedSegmentsDifferByAFactorOfTwoFromTheirNeighbors) {
  for (const Complex& complex : some_acute_complexes()) {
    const Moment m(complex, collar(), "2b");
    ASSERT_TRUE(m.run);
    std::map<std::array<std::uint32_t, 2>, double> length2;  // of segment and end: of the other one
    for (const ProtectingElement& p : m.elements) {
      if (p.a < complex.vertices.size() || p.b < complex.vertices.size()) continue;
      const double here = m.dot(p.a, p.b, p.b);
      for (const std::uint32_t v : {p.a, p.b}) {
        const auto [other, first] = length2.try_emplace({p.carrier, v}, here);
        if (first) continue;
        EXPECT_LE(std::max(here, other->second), 4.0001 * std::min(here, other->second));
      }
    }
  }
}

/// Lemma 6.5 III, IV. `between`: triangles at input vertices are left out, whose third side is an
/// arc that step 3a may have to split yet.
struct CollarBalls {
  std::size_t triangles = 0, holding = 0, reaching = 0;

  CollarBalls(const Complex& complex, const Moment& m, bool between) {
    const FeatureTable<Point3> table(complex, {});
    std::map<std::uint32_t, std::vector<std::uint32_t>> segments_at;  // protected; by mesh vertex
    for (const ProtectingElement& p : m.elements) {
      if (p.kind != ProtectingKind::kProtectedSubsegment) continue;
      for (const std::uint32_t v : {p.a, p.b}) segments_at[v].push_back(p.carrier);
    }
    for (std::size_t i = 0; i + 4 < m.triangles.size(); i += 5) {
      const std::uint32_t* v = &m.triangles[i];
      const std::uint32_t face = v[4] / 4;
      if (v[4] % 4 == 2) continue;  // outside of its face
      if (std::any_of(v, v + 3, [&](auto u) { return !m.vertices.count(u); })) continue;  // ghosts
      std::set<std::uint32_t> at;  // the protected segments of the face that it touches
      bool tip = false;
      for (std::size_t k = 0; k < 3; ++k) {
        tip = tip || v[k] < complex.vertices.size();
        const auto found = segments_at.find(v[k]);
        if (found == segments_at.end()) continue;
        for (const std::uint32_t s : found->second) {
          const auto& in = table.face_segments.at(face);
          // Between two protected pieces: not at the tip where an ordinary segment goes on.
          if (std::count(found->second.begin(), found->second.end(), s) == 2 &&
              std::binary_search(in.begin(), in.end(), s))
            at.insert(s);
        }
      }
      if (at.size() != 1 || (between && tip)) continue;
      const Point3 &a = m.vertices.at(v[0]), &b = m.vertices.at(v[1]), &c = m.vertices.at(v[2]);
      const TriangleBall ball = triangle_ball(a, b, c);  // about its corner
      if (!std::isfinite(ball.radius2)) continue;
      ++triangles;
      bool holds = false, reaches = false;
      for (const auto& [u, p] : m.vertices) {
        if (u != v[0] && u != v[1] && u != v[2])
          holds = holds || ball.power(p) < -1e-9 * ball.radius2;
      }
      const auto& own = complex.segments[*at.begin()];
      for (const auto& item : table.features) {
        const auto points = table.points_of(item);
        const bool touches = std::any_of(points.begin(), points.end(), [&](std::uint32_t u) {
          return u == own[0] || u == own[1];
        });
        if (touches || table.contains(item, *at.begin())) continue;
        reaches = reaches || table.distance2(along(ball.corner, 1, ball.center), item) <
                                 (1 - 1e-9) * ball.radius2;
      }
      holding += holds;
      reaching += reaches;
    }
  }
};

TEST(CollarInSpace, Lemma65HoldsForTheBallsOfTrianglesBesideSegments) {
  std::size_t triangles = 0;
  for (const Complex& complex : some_acute_complexes()) {
    const CollarBalls after_2c(complex, Moment(complex, collar(), "2c"), true);
    EXPECT_EQ(after_2c.holding, 0u) << "III";
    EXPECT_EQ(after_2c.reaching, 0u) << "IV";
    const CollarBalls at_end(complex, Moment(complex, collar(), "3"), false);
    EXPECT_EQ(at_end.reaching, 0u) << "IV, when it ends";
    triangles += after_2c.triangles;
  }
  EXPECT_GT(triangles, 300u);
}

TEST(CollarInSpace, H1HoldsAfterStep2bAndTheCheckTellsTheBOfH2) {
  for (const Complex& complex : some_acute_complexes()) {
    const Moment m(complex, collar(), "2b");
    ASSERT_TRUE(m.run);
    const FeatureTable<Point3> table(m.run->complex(), {});
    for (const auto& [v, p] : m.vertices) {
      double least = HUGE_VAL;  // distance from the segments and input vertices
      for (const auto& item : table.edges) least = std::min(least, table.distance2(p, item));
      EXPECT_LT(least, 1e-24) << "H1: vertex " << v;
    }
    VerifyOptions options = promised_checks(*m.run);
    options.checks = {"protection"};
    const Check check = verify(m.run->mesh(), m.run->complex(), options).at(0);
    const auto at = check.detail.find(", b, is ");
    if (at == std::string::npos) continue;  // nothing is protected
    EXPECT_GT(std::stod(check.detail.substr(at + 8)), 0.1) << "H2: " << check.detail;
  }
}

TEST(CollarInSpace, Lemma65HoldsAfterStep2cButForArcs) {
  std::size_t elements = 0;
  for (const Complex& complex : some_acute_complexes()) {
    const Moment m(complex, collar(), "2c");
    ASSERT_TRUE(m.run);
    EXPECT_LT(m.largest_cosine(false), 1e-9) << "I";
    for (const ProtectingElement& p : m.elements) {
      if (p.kind == ProtectingKind::kCollarArc) continue;
      ++elements;
      for (const auto& [v, at] : m.vertices) {
        EXPECT_FALSE(v != p.a && v != p.b && m.in_ball(v, p.a, p.b))
            << "II: " << v << " in the ball of " << name(p.kind) << " " << p.a << ", " << p.b;
      }
    }
  }
  EXPECT_GT(elements, 300u);
}

TEST(CollarInSpace, Lemma69HoldsWhenItEnds) {
  for (const Complex& complex : some_acute_complexes()) {
    const Moment m(complex, collar(), "3");
    ASSERT_TRUE(m.run);
    EXPECT_LT(m.largest_cosine(true), 1e-9) << "II";
    for (const ProtectingElement& p : m.elements) {
      for (const auto& [v, at] : m.vertices) {
        EXPECT_FALSE(v != p.a && v != p.b && m.in_ball(v, p.a, p.b))
            << "I: " << v << " in the ball of " << name(p.kind) << " " << p.a << ", " << p.b;
      }
    }
  }
}

TEST(CollarInSpace, ItsCheckSeesLongSubsegmentsAndUnequalEnds) {
  const auto run = finish(example("pyramid.json"), collar());
  ASSERT_TRUE(run);
  VerifyOptions options = promised_checks(*run);
  options.checks = {"protection"};
  const auto failure = [&](const Mesh& mesh) {
    const Check check = verify(mesh, run->complex(), options).at(0);
    return check.ok ? "" : check.detail.substr(check.detail.find("(thesis, "), 12);
  };
  Mesh mesh = run->mesh();
  EXPECT_EQ(failure(mesh), "");
  options.size_factor = 0.7;
  EXPECT_EQ(failure(mesh), "(thesis, H2)");
  options.size_factor = 0.8;
  const MeshEdge end = mesh.edges.at(0);  // moved along its segment, by a thousandth
  const std::uint32_t tip = std::max(end.a, end.b), corner = std::min(end.a, end.b);
  ASSERT_EQ(mesh.vertex_features[tip].kind, FeatureKind::kSegment);
  ASSERT_EQ(mesh.vertex_features[corner].kind, FeatureKind::kVertex);
  mesh.vertices[tip] = testing::between(mesh.vertices[corner], mesh.vertices[tip], 0.999);
  EXPECT_EQ(failure(mesh), "(thesis, H3)");
}

TEST(CollarInSpace, IsTheSameWithATraceThatReplaysToItsMesh) {
  const Complex complex = example("pyramid.json");
  Trace trace;
  trace.dimension = 3;
  const auto run = finish(complex, collar(), &trace);
  const auto silent = finish(complex, collar());
  ASSERT_TRUE(run && silent);
  EXPECT_EQ(fingerprint(run->mesh()), fingerprint(silent->mesh()));
  Replay replay(trace);
  replay.seek(trace.events.size());
  const auto cells = replay.cells();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < cells.size(); i += 5) inside += cells[i + 4] != 2;
  EXPECT_EQ(inside, run->mesh().cell_count());
  replay.seek(0);
  EXPECT_TRUE(replay.cells().empty());
  for (const Event& e : trace.events) EXPECT_FALSE(describe(e, trace.steps).empty());
}

/// Two tetrahedra share an edge; their hull has vertices of segments on it, rounded inwards, and
/// places that are no input face.
TEST(CollarInSpace, CoversFacesOnAHullThatIsNoUnionOfFaces) {
  const Complex complex = read(R"({"circumball": 1, "dimension": 3, "segments": [], "vertices":
      [[0, 0, 0], [0, 0, 1], [1, 0, 0.5], [1, 0.3, 0.4], [-1, 0, 0.5], [-1, 0.25, 0.4]], "faces": [
      {"loops": [[0, 1, 2]]}, {"loops": [[0, 1, 3]]}, {"loops": [[0, 2, 3]]}, {"loops": [[1, 2, 3]]},
      {"loops": [[0, 1, 4]]}, {"loops": [[0, 1, 5]]}, {"loops": [[0, 4, 5]]}, {"loops": [[1, 4, 5]]}
      ]})",
                               "edge.json")
                              .complex;
  Options options = collar();
  options.domain = Domain::kHull;
  const auto run = finish(complex, options);
  ASSERT_TRUE(run);
  for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run)))
    EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
}

TEST(CollarInSpace, StopsAtALimitWithWhatItHas) {
  Options options = collar();
  options.parameters["protect"] = "all";
  for (const std::uint64_t limit : {20, 45, 70, 91}) {
    options.limits.max_vertices = limit;
    const auto run = finish(example("pyramid.json"), options);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->limit(), Reason::kLimitVertices) << limit;
    for (const Check& check : verify(run->mesh(), run->complex(), promised_checks(*run))) {
      if (check.name != "delaunay") continue;
      EXPECT_TRUE(check.ok) << limit << ": " << check.detail;
    }
  }
}

}  // namespace
}  // namespace circumball
