// What becomes of small angles: Ruppert's algorithm (stopped by a limit), the terminator, collars
// and intestines, each with circumcenters and with off-centers, on the same input and for the same
// smallest angle. Prints the tables of docs/comparison.md. Run it from the root of the repository.
//
//   compare [degrees]        the smallest angle asked for: 20.7 by default
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "circumball/io.h"
#include "circumball/refine.h"
#include "circumball/verify.h"
#include "delaunay/constructions.h"
#include "support/needles.h"

namespace {

using circumball::Complex;
using circumball::Mesh;
using circumball::Point2;

Complex example(const std::string& name) {
  std::ifstream file("examples/" + name, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto result = circumball::read(bytes, name);
  if (!result.ok()) std::fprintf(stderr, "examples/%s cannot be read\n", name.c_str());
  return result.complex;
}

/// What was left below the angle asked for.
struct Region {
  std::size_t triangles = 0;
  double area_share = 0;  ///< of the area of all triangles
  double reach = 0;  ///< the largest distance of a corner of one from the nearest input vertex,
                     ///< relative to the size of the input
};

Region region_below(const Mesh& mesh, double tau) {
  Region region;
  double area = 0, all = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (std::uint32_t i = 0; i < mesh.input_vertices; ++i) {
    low = std::min({low, mesh.vertices[i].x, mesh.vertices[i].y});
    high = std::max({high, mesh.vertices[i].x, mesh.vertices[i].y});
  }
  const auto from_input = [&](const Point2& p) {
    double nearest2 = HUGE_VAL;
    for (std::uint32_t i = 0; i < mesh.input_vertices; ++i) {
      nearest2 = std::min(nearest2, squared_distance(p, xy(mesh.vertices[i])));
    }
    return std::sqrt(nearest2);
  };
  for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
    const std::uint32_t* v = mesh.cell(i);
    const Point2 p[3] = {xy(mesh.vertices[v[0]]), xy(mesh.vertices[v[1]]), xy(mesh.vertices[v[2]])};
    const auto shape = circumball::shape_of(p[0], p[1], p[2]);
    all += shape.area();
    if (!shape.radius_edge_exceeds(tau)) continue;
    ++region.triangles;
    area += shape.area();
    for (const Point2& corner : p) region.reach = std::max(region.reach, from_input(corner));
  }
  region.area_share = area / all;
  region.reach /= high - low;
  return region;
}

void print_row(const Complex& complex, const char* algorithm, const char* steiner, double degrees) {
  circumball::Options options;
  options.algorithm = algorithm;
  options.min_angle_degrees = degrees;
  options.parameters["steiner"] = steiner;
  options.limits.max_vertices = 20000;
  std::vector<circumball::Defect> defects;
  std::string error;
  std::vector<double> times;
  std::unique_ptr<circumball::Run> run;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run = circumball::Run::create(complex, options, nullptr, &defects, &error);
    if (!run) return static_cast<void>(std::fprintf(stderr, "%s\n", error.c_str()));
    run->advance();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  const Mesh mesh = run->mesh();
  const circumball::Quality quality = circumball::measure(mesh);
  const Region region = region_below(mesh, run->tau());
  const double milliseconds = 1000 * times[times.size() / 2];
  if (run->status() != circumball::Status::kComplete) {  // nothing is promised of such a mesh
    std::printf("| %s | %s | %zu, stopped | | | | | | %.2f |\n", algorithm, steiner,
                mesh.vertices.size(), milliseconds);
    return;
  }
  std::printf("| %s | %s | %zu | %.2f | %.1f | %zu | %.3g | %.3g | %.2f |\n", algorithm, steiner,
              mesh.vertices.size(), quality.min_angle_degrees, quality.max_angle_degrees,
              region.triangles, 100 * region.area_share, region.reach, milliseconds);
}

}  // namespace

int main(int argc, char** argv) {
  const double degrees = argc > 1 ? std::atof(argv[1]) : 20.7;
  circumball::testing::Random random(1);
  const struct {
    const char* title;
    Complex complex;
  } inputs[] = {
      {"A fan, angles of 13 to 26 degrees (`examples/fan.json`)", example("fan.json")},
      {"The pinwheel at 2 pi / 7 (`examples/pinwheel.json`)", example("pinwheel.json")},
      {"A fan of 40 segments, 3 to 6 degrees apart", circumball::testing::fan(&random, 40, 3)},
      {"A star with 12 tips of 5 degrees", circumball::testing::star(12, 5)},
      {"A comb with 6 teeth of 1 degree", circumball::testing::comb(6, 1)},
      {"An airfoil, no acute angles (`examples/airfoil.poly`)", example("airfoil.poly")},
      {"A lake, no acute angles (`examples/lake.json`)", example("lake.json")},
  };
  std::printf("Smallest angle asked for: %g degrees; at most 20,000 vertices.\n", degrees);
  for (const auto& input : inputs) {
    std::printf(
        "\n**%s**; smallest input angle %.3g degrees\n\n| algorithm | Steiner points | vertices | "
        "smallest angle | largest angle | triangles below | their area, %% | their reach | ms |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        input.title, circumball::smallest_angle_degrees(input.complex));
    for (const char* algorithm : {"ruppert", "terminator", "collar", "intestine"}) {
      for (const char* steiner : {"circumcenter", "off-center"}) {
        print_row(input.complex, algorithm, steiner, degrees);
      }
    }
  }
}
