#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "circumball/report.h"
#include "circumball/trace.h"
#include "circumball/verify.h"
#include "support/acute.h"
#include "support/solids3.h"

namespace circumball {
namespace {

using testing::finish;
using testing::Placement;
using testing::Random;
using testing::Rotation;
using testing::SolidBuilder;

Options removing(const std::string& algorithm, const std::string& degrees, double size = 0) {
  Options options = testing::options_of(algorithm);
  options.parameters["slivers"] = "remove";
  options.parameters["dihedral"] = degrees;
  options.limits.max_vertices = 20000;
  if (size > 0) options.size = std::to_string(size);
  return options;
}

Complex turned_prism() {
  Random random(3);
  const Rotation turn(&random);
  SolidBuilder b({1, &turn, {0.3, 2, -1}});
  b.regular_prism(6, 1.5);
  return b.complex();
}

void expect_kept_promises(const Run& run) {
  EXPECT_EQ(run.status(), Status::kComplete);
  for (const Check& check : verify(run.mesh(), run.complex(), promised_checks(run))) {
    EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
  }
}

/// Smallest angle between two planes of facets, by their normals.
double least_dihedral(const Mesh& mesh, const std::uint32_t* v) {
  double least = 180;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const int k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2, l = 6 - i - j - k;
      const Point3 &p = mesh.vertices[v[i]], &q = mesh.vertices[v[j]];
      const double e[3] = {q.x - p.x, q.y - p.y, q.z - p.z};
      const double ee = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
      double side[2][3], length[2];
      for (int s = 0; s < 2; ++s) {  // perpendicular to the edge, in either facet
        const Point3& r = mesh.vertices[v[s == 0 ? k : l]];
        const double w[3] = {r.x - p.x, r.y - p.y, r.z - p.z};
        const double t = (w[0] * e[0] + w[1] * e[1] + w[2] * e[2]) / ee;
        for (int x = 0; x < 3; ++x) side[s][x] = w[x] - t * e[x];
        length[s] =
            std::sqrt(side[s][0] * side[s][0] + side[s][1] * side[s][1] + side[s][2] * side[s][2]);
      }
      const double cosine =
          (side[0][0] * side[1][0] + side[0][1] * side[1][1] + side[0][2] * side[1][2]) /
          (length[0] * length[1]);
      least = std::min(least, std::acos(std::max(-1.0, std::min(1.0, cosine))) * 180 / M_PI);
    }
  }
  return least;
}

TEST(DihedralHistogram, CountsTheAnglesOfEveryCell) {
  const auto run = finish(turned_prism(), [] {
    Options options = testing::options_of("ruppert");
    options.size = "0.4";
    return options;
  }());
  ASSERT_TRUE(run);
  const Mesh mesh = run->mesh();
  const DihedralHistogram histogram = dihedral_histogram(mesh, 15);
  std::uint64_t angles = 0, slivers = 0;
  double least = 180;
  for (const std::uint64_t count : histogram.counts) angles += count;
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const double angle = least_dihedral(mesh, mesh.cell(i));
    slivers += angle < 15;
    least = std::min(least, angle);
  }
  EXPECT_EQ(angles, 6 * mesh.cell_count());
  EXPECT_EQ(histogram.slivers, slivers);
  EXPECT_NEAR(histogram.min, least, 1e-5);
  const Quality quality = measure(mesh);
  EXPECT_NEAR(histogram.min, quality.min_dihedral_degrees, 1e-9);
  EXPECT_NEAR(histogram.max, quality.max_dihedral_degrees, 1e-9);
}

TEST(Slivers, AreFewerAndEverythingPromisedHoldsStill) {
  const Complex prism = turned_prism();
  const auto run = finish(prism, removing("ruppert", "10", 0.13));
  ASSERT_TRUE(run);
  expect_kept_promises(*run);
  EXPECT_TRUE(run->unresolved().empty());
  const auto removal = run->sliver_removal();
  ASSERT_TRUE(removal);
  const DihedralHistogram after = dihedral_histogram(run->mesh(), 10);
  EXPECT_GT(removal->before.slivers, 50u);
  EXPECT_LT(after.slivers, removal->before.slivers / 10);
  EXPECT_EQ(removal->kept.size(), after.slivers);
  for (const Unresolved& sliver : removal->kept) {
    EXPECT_EQ(sliver.rule, "sliver");
    EXPECT_TRUE(sliver.reason == "no-room" || sliver.reason == "not-improved") << sliver.reason;
  }
}

/// Between two plates there is no room but in the plates.
TEST(Slivers, NextToFacesGiveWayToPointsOfTheFaces) {
  Random random(11);
  const Rotation turn(&random);
  SolidBuilder b({1, &turn, {5, 0.1, -2}});
  b.box({0, 0, 0}, {3, 3, 3});
  b.builder().face(b.square(0.5, 2.5, 1.4));
  b.builder().face(b.square(0.4, 2.4, 1.5));
  const auto run = finish(b.complex(), removing("ruppert", "10"));
  ASSERT_TRUE(run);
  expect_kept_promises(*run);
  ASSERT_TRUE(run->sliver_removal());
  const Mesh mesh = run->mesh();
  const std::uint64_t before = run->sliver_removal()->before.slivers;
  EXPECT_GT(before, 40u);
  EXPECT_LT(dihedral_histogram(mesh, 10).slivers, before / 5);
  std::size_t in_faces = 0;
  for (std::size_t v = mesh.vertices.size() - run->steps().back().inserted;
       v < mesh.vertices.size(); ++v) {
    in_faces += mesh.vertex_features[v].kind == FeatureKind::kFace;
  }
  EXPECT_GT(in_faces, 0u);
}

/// The argument for its end.
TEST(Slivers, BecomeFewerWithEveryVertex) {
  Trace trace;
  std::vector<Defect> defects;
  std::string error;
  const auto run =
      Run::create(turned_prism(), removing("ruppert", "12", 0.2), &trace, &defects, &error);
  ASSERT_TRUE(run) << error;
  run->advance();
  const Mesh mesh = run->mesh();
  const auto step = static_cast<std::uint8_t>(run->step_names().size() - 1);
  ASSERT_EQ(run->step_names().back(), "slivers");
  std::size_t inserted = 0, at = 0;
  for (const Event& e : trace.events) {
    if (e.kind != EventKind::kInserted && e.kind != EventKind::kRelabeled &&
        e.kind != EventKind::kFaceChanged) {
      continue;
    }
    const std::uint32_t* simplex = trace.simplices.data() + at;
    at += 5 * std::size_t{e.other[0] + e.other[1]};
    if (e.kind != EventKind::kInserted || e.step != step) continue;
    ++inserted;
    EXPECT_EQ(e.reason, Reason::kPicked);
    int balance = 0;
    for (std::uint32_t k = 0; k < e.other[0] + e.other[1]; ++k) {
      const bool is_inside = simplex[5 * k + 4] == 1;
      const bool is_sliver = is_inside && least_dihedral(mesh, simplex + 5 * k) < 12;
      balance += is_sliver ? (k < e.other[0] ? 1 : -1) : 0;
    }
    EXPECT_GT(balance, 0) << "vertex " << e.subject;
  }
  EXPECT_GT(inserted, 10u);
}

TEST(Slivers, AtSharpAnglesLeaveTheCollarsAlone) {
  Random random(5);
  testing::Builder3 b;
  testing::add_book(&b, &random, 25);
  const auto run = finish(b.complex(), removing("collar", "10"));
  ASSERT_TRUE(run);
  expect_kept_promises(*run);
  ASSERT_TRUE(run->sliver_removal());
  EXPECT_LT(dihedral_histogram(run->mesh(), 10).slivers, run->sliver_removal()->before.slivers);
}

Complex plates() {
  testing::Builder3 b;
  const std::uint32_t p = b.vertex({0, 0, -1}), q = b.vertex({0, 0, 1});
  b.face({p, b.vertex({2, 0, -1}), b.vertex({1, 0, 0}), b.vertex({2, 0, 1}), q});
  b.face({p, b.vertex({1.5, 0.8, -1}), b.vertex({1.5, 0.8, 1}), q});
  return b.complex();
}

/// Where a point near the surface would be good, cells inside of it would be those that die.
TEST(Slivers, OfIntestinesLeaveSpheresAndTubesAlone) {
  std::size_t removed = 0;
  for (const char* algorithm : {"intestine-structured", "intestine"}) {
    for (const char* protect : {"acute", "all"}) {
      Options options = removing(algorithm, "10");
      options.domain = Domain::kBox;
      options.parameters["protect"] = protect;
      const auto run = finish(plates(), options);
      ASSERT_TRUE(run);
      expect_kept_promises(*run);
      removed += run->steps().back().inserted;
    }
  }
  EXPECT_GT(removed, 20u);
}

TEST(Slivers, AreKeptUnlessAskedFor) {
  Options plain = testing::options_of("ruppert");
  plain.size = "0.4";
  Options kept = plain;
  kept.parameters["slivers"] = "keep";
  kept.parameters["dihedral"] = "20";
  const auto run = finish(turned_prism(), plain), same = finish(turned_prism(), kept);
  ASSERT_TRUE(run && same);
  EXPECT_EQ(fingerprint(run->mesh()), fingerprint(same->mesh()));
  EXPECT_FALSE(run->sliver_removal());
  EXPECT_FALSE(nlohmann::json::parse(report_json(*run, turned_prism(), run->mesh(), {}))
                   .contains("slivers"));
}

TEST(Slivers, RespectTheShortestEdgeAllowed) {
  Options options = removing("ruppert", "15", 0.4);
  const auto free = finish(turned_prism(), options);
  ASSERT_TRUE(free);
  const double shortest = measure(free->mesh()).shortest_edge;
  options.limits.min_edge = 1.05 * shortest;
  const auto run = finish(turned_prism(), options);
  ASSERT_TRUE(run);
  const auto slivers_began = run->sliver_removal();
  if (run->limit() == Reason::kNone) {
    ASSERT_TRUE(slivers_began);
    EXPECT_GE(measure(run->mesh()).shortest_edge, 1.05 * shortest);
  }
}

TEST(Slivers, AreInTheReport) {
  const Complex prism = turned_prism();
  const auto run = finish(prism, removing("ruppert", "10", 0.4));
  ASSERT_TRUE(run);
  const Mesh mesh = run->mesh();
  const auto report = nlohmann::json::parse(report_json(*run, prism, mesh, {}));
  const auto& slivers = report["slivers"];
  EXPECT_EQ(slivers["bound"], 10.0);
  EXPECT_EQ(slivers["before"]["dihedrals"].size(), 18u);
  EXPECT_EQ(slivers["after"]["dihedrals"], report["mesh"]["dihedrals"]);
  EXPECT_EQ(slivers["after"]["slivers"], slivers["kept"]);
  EXPECT_EQ(slivers["removed"].get<int>() + slivers["kept"].get<int>(),
            slivers["before"]["slivers"].get<int>());
  std::size_t reasons = 0;
  for (const auto& count : slivers["reasons"]) reasons += count.get<std::size_t>();
  EXPECT_EQ(reasons, slivers["kept"].get<std::size_t>());
}

}  // namespace
}  // namespace circumball
