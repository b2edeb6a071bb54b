#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "circumball/io.h"
#include "circumball/report.h"
#include "circumball/verify.h"
#include "support/acute.h"
#include "support/examples.h"
#include "support/solids3.h"

/// Vertices of sloping faces, and whatever is far from the origin, are rounded. Nothing of what is
/// promised may depend on that (docs/algorithms.md, "Rounding").
namespace circumball {
namespace {

using testing::Random;
using testing::Rotation;

/// The complexes of space in the gallery, each once.
std::vector<std::string> examples() {
  std::set<std::string> files;
  for (const auto& entry : nlohmann::json::parse(testing::bytes_of_example("index.json"))) {
    if (entry.value("dimension", 2) == 3) files.insert(entry["file"].get<std::string>());
  }
  return {files.begin(), files.end()};
}

/// Rotations with rational matrices, as people turn things: by 3-4-5 and 5-12-13 triangles about
/// axes, and half a turn about (1, 2, 2).
Point3 turned(const Point3& p, int turn) {
  switch (turn) {
    case 1:
      return {(3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5, p.z};
    case 2: {
      const Point3 q = turned(p, 1);
      return {q.x, (12 * q.y - 5 * q.z) / 13, (5 * q.y + 12 * q.z) / 13};
    }
    case 3: {
      const double t = 2 * (p.x + 2 * p.y + 2 * p.z) / 9;
      return {t - p.x, 2 * t - p.y, 2 * t - p.z};
    }
    default:
      return p;
  }
}

struct Place {
  int turn = 0;
  double scale = 1;
  double away = 0;  // in sizes of the complex
};

Complex placed(Complex complex, const Place& place) {
  double size = 0;
  for (const Point3& p : complex.vertices) {
    for (const Point3& q : {p, complex.vertices[0]}) {
      size = std::max({size, std::fabs(p.x - q.x), std::fabs(p.y - q.y), std::fabs(p.z - q.z)});
    }
  }
  const double s = place.scale, d = place.away * size * s;
  const auto move = [&](Point3* p) {
    const Point3 q = turned(*p, place.turn);
    *p = {s * q.x + d, s * q.y - 0.7 * d, s * q.z + 0.4 * d};
  };
  for (Point3& p : complex.vertices) move(&p);
  for (Point3& p : complex.holes) move(&p);
  for (Region& r : complex.regions) {
    move(&r.at);
    r.max *= s * s * s;
  }
  for (Face& f : complex.faces) {
    for (Point3& p : f.holes) move(&p);
  }
  return complex;
}

/// Empty if it ended, conforms and keeps all that is promised; else what does not.
std::string what_fails(const Complex& complex, const char* algorithm) {
  for (const Defect& d : check(complex)) {
    if (!d.warning) return d.message;
  }
  Options options = testing::options_of(algorithm);
  options.limits.max_vertices = 60000;
  const auto run = testing::finish(complex, options);
  if (!run) return "no run";
  if (run->status() != Status::kComplete) return "stopped by " + limit_name(*run);
  for (const Unresolved& u : run->unresolved(100000)) {
    if (u.simplex.size() != 4 || u.reason != "protected") return u.rule + ", " + u.reason;
  }
  for (const Check& c : verify(run->mesh(), run->complex(), promised_checks(*run))) {
    if (!c.ok) return c.name + ": " + c.detail;
  }
  return {};
}

/// CIRCUMBALL_CASES=1000 asks for all of them.
TEST(RoundingInSpace, EveryExampleIsMeshedWhereverItStands) {
  std::vector<Place> places;
  for (const double away : {0.0, 1e3, 1e6}) {
    for (const double scale : {1.0, 1e-6, 1e6}) {
      for (int turn = 3; turn >= 0; --turn) places.push_back({turn, scale, away});
    }
  }
  const std::uint64_t count = std::min<std::uint64_t>(testing::cases(2), places.size());
  const bool all = count == places.size();
  std::size_t number = 0;
  for (const std::string& file : examples()) {
    const Complex example = read(testing::bytes_of_example(file), file).complex;
    if (!all && example.faces.size() > 20) continue;  // those that take long
    if (!all && (file == "near-plates.json" || file == "wedge.json" || file == "fan-of-faces.json"))
      continue;
    for (std::uint64_t k = 0; k < count; ++k) {
      const Place& place = places[all ? k : (7 * number++) % places.size()];
      const std::string why = what_fails(placed(example, place), "collar");
      EXPECT_TRUE(why.empty()) << file << ", turn " << place.turn << ", scale " << place.scale
                               << ", away " << place.away << ": " << why;
    }
  }
}

/// Regular polygons: all vertices on one circle but for their last bits, or for a little more.
TEST(RoundingInSpace, NearlyCocircularVerticesOfAFaceLeaveNoHoleAndNoWrongDiagonal) {
  const std::uint64_t step = testing::cases(1) > 1 ? 1 : 13;
  for (std::uint64_t sides = 3; sides <= 100; sides += step) {
    Random random(sides);
    const Rotation turn(&random);
    for (const double noise : {0.0, 1e-15, 1e-12}) {
      testing::SolidBuilder b({1, &turn, {0, 0, 0}});
      std::vector<std::uint32_t> ring;
      for (std::uint64_t k = 0; k < sides; ++k) {
        const double r = 1 + noise * (2 * random.unit() - 1);
        const Point2 p =
            testing::polar(0, 0, r, 360.0 * static_cast<double>(k) / static_cast<double>(sides));
        ring.push_back(b.vertex({p.x, p.y, 0}));
      }
      b.builder().face(ring);
      const std::string why = what_fails(b.complex(), sides > 3 ? "ruppert" : "collar");
      EXPECT_TRUE(why.empty()) << sides << " sides, noise " << noise << ": " << why;
    }
  }
}

/// Every square of the lattice is a tie in the face, and turned, one that rounding settles; spheres
/// through them and the lattice points above are others.
TEST(RoundingInSpace, LatticesInSlopingFacesAreTiledOnBothSides) {
  const std::uint64_t count = testing::cases(3);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed);
    const Rotation turn(&random);
    const int n = 3 + static_cast<int>(seed % 5);
    const double away = seed % 3 == 2 ? 1e5 : 0;
    testing::SolidBuilder b({1, &turn, {away, -away, away}});
    Face face = b.builder().face(b.square(0, n, 0));
    for (int i = 1; i < n; ++i) {
      for (int j = 1; j < n; ++j) face.vertices.push_back(b.vertex({1.0 * i, 1.0 * j, 0}));
    }
    b.builder().replace_last_face(face);
    if (seed % 2) {
      for (int i = 0; i < n; ++i) b.vertex({i + 0.5, 0.5 * n, 1});
    }
    const std::string why = what_fails(b.complex(), "ruppert");
    EXPECT_TRUE(why.empty()) << seed << ": " << why;
  }
}

}  // namespace
}  // namespace circumball
