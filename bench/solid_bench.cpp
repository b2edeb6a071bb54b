// Ruppert's algorithm in space beside TetGen's `-pq`, in one process, on solids without acute
// angles: the same radius-edge threshold, volume bounds of TetGen tuned to equal numbers of
// vertices.
//
//   solid_bench [cells] [repeats] [solid]
//
// cells: the largest mesh, 1000000 by default; solid: of those alone whose name holds this. Prints
// medians.
#define TETLIBRARY
#include <tetgen.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "circumball/io.h"
#include "circumball/refine.h"
#include "support/solids3.h"

namespace {

using namespace circumball;

constexpr double kTau = 2.1;

struct Measured {
  double seconds = 0;
  std::size_t vertices = 0, inserted = 0, cells = 0;
  double rate() const { return static_cast<double>(inserted) / seconds / 1000; }
};

template <class F>
double seconds_of(F f) {
  const std::clock_t start = std::clock();  // of the processor: nothing here waits
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Solid {
  std::string name;
  Complex complex;
  std::vector<Point3> holes;  // seeds that TetGen needs
};

Measured ours(const Complex& complex, double circumradius, double tau = kTau) {
  Options options;
  options.algorithm = "ruppert";
  options.tau = tau;
  options.limits.max_vertices = 0;
  char size[32];
  std::snprintf(size, sizeof size, "%.17g", circumradius);
  options.size = size;
  std::vector<Defect> defects;
  std::string error;
  Measured result;
  result.seconds = seconds_of([&] {
    const auto run = Run::create(complex, options, nullptr, &defects, &error);
    if (!run) return;
    run->advance();
    const Mesh mesh = run->mesh();
    result.vertices = mesh.vertices.size();
    result.cells = mesh.cell_count();
  });
  result.inserted = result.vertices - complex.vertices.size();
  return result;
}

void describe(const Solid& solid, tetgenio* in) {
  const Complex& c = solid.complex;
  in->numberofpoints = static_cast<int>(c.vertices.size());
  in->pointlist = new REAL[3 * c.vertices.size()];
  for (std::size_t i = 0; i < c.vertices.size(); ++i) {
    in->pointlist[3 * i] = c.vertices[i].x;
    in->pointlist[3 * i + 1] = c.vertices[i].y;
    in->pointlist[3 * i + 2] = c.vertices[i].z;
  }
  in->numberoffacets = static_cast<int>(c.faces.size());
  in->facetlist = new tetgenio::facet[c.faces.size()];
  for (std::size_t f = 0; f < c.faces.size(); ++f) {
    tetgenio::facet& facet = in->facetlist[f];
    tetgenio::init(&facet);
    const auto& loops = c.faces[f].loops;
    facet.numberofpolygons = static_cast<int>(loops.size());
    facet.polygonlist = new tetgenio::polygon[loops.size()];
    for (std::size_t i = 0; i < loops.size(); ++i) {
      tetgenio::polygon& polygon = facet.polygonlist[i];
      tetgenio::init(&polygon);
      polygon.numberofvertices = static_cast<int>(loops[i].size());
      polygon.vertexlist = new int[loops[i].size()];
      std::copy(loops[i].begin(), loops[i].end(), polygon.vertexlist);
    }
  }
  if (!solid.holes.empty()) {
    in->numberofholes = static_cast<int>(solid.holes.size());
    in->holelist = new REAL[3 * solid.holes.size()];
    for (std::size_t i = 0; i < solid.holes.size(); ++i) {
      in->holelist[3 * i] = solid.holes[i].x;
      in->holelist[3 * i + 1] = solid.holes[i].y;
      in->holelist[3 * i + 2] = solid.holes[i].z;
    }
  }
}

/// TetGen with a bound on volumes; `optimize`: with its last step, that flips and smooths, as it
/// does unless told not to.
Measured tetgen(const Solid& solid, double volume, bool optimize) {
  char switches[96];
  std::snprintf(switches, sizeof switches, "pq%.17ga%.17g%sQ", kTau, volume, optimize ? "" : "O0");
  tetgenio in, out;
  describe(solid, &in);
  Measured result;
  result.seconds = seconds_of([&] {
    try {
      tetrahedralize(switches, &in, &out);
    } catch (...) {  // how it ends on an error
    }
  });
  result.vertices = static_cast<std::size_t>(out.numberofpoints);
  result.cells = static_cast<std::size_t>(out.numberoftetrahedra);
  result.inserted = result.vertices - solid.complex.vertices.size();
  return result;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The circumradius with which we make about as many cells as asked.
double tune_ours(const Complex& complex, double cells, double guess) {
  for (int i = 0; i < 6; ++i) {
    const double ratio = static_cast<double>(ours(complex, guess).cells) / cells;
    if (std::fabs(ratio - 1) < 0.1) break;
    guess *= std::cbrt(ratio);
  }
  return guess;
}

/// The volume bound with which TetGen makes as many vertices as we did.
double tune_tetgen(const Solid& solid, std::size_t vertices, double guess) {
  for (int i = 0; i < 8; ++i) {
    const auto got = static_cast<double>(tetgen(solid, guess, true).vertices);
    const double ratio = got / static_cast<double>(vertices);
    if (std::fabs(ratio - 1) < 0.02) break;
    guess *= ratio;
  }
  return guess;
}

std::vector<Solid> solids() {
  std::vector<Solid> list;
  const auto add = [&](const std::string& name, const std::vector<Point3>& holes, auto build) {
    testing::SolidBuilder b{testing::Placement()};
    build(&b);
    list.push_back({name, b.complex(), holes});
  };
  using Builder = testing::SolidBuilder;
  add("cube", {}, [](Builder* b) { b->box({0, 0, 0}, {1, 1, 1}); });
  add("box with a cavity", {{1.4, 1.5, 1.6}}, [](Builder* b) {
    b->box({0, 0, 0}, {3, 3, 3});
    b->box({1, 1, 1}, {1.7, 2, 2.2});
  });
  add("L", {}, [](Builder* b) { b->prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1); });
  add("lattice of boxes", {}, [](Builder* b) { b->lattice(4, 4, 4); });
  add("hexagonal prism", {}, [](Builder* b) { b->regular_prism(6, 1.5); });
  std::ifstream file("examples/truncated-octahedron.off", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto result = read(bytes, "truncated-octahedron.off");
  if (result.ok()) list.push_back({"truncated octahedron", result.complex, {}});
  return list;
}

double extent(const Complex& c) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Point3& p : c.vertices) {
    low = std::min({low, p.x, p.y, p.z});
    high = std::max({high, p.x, p.y, p.z});
  }
  return high - low;
}

}  // namespace

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 1e6;
  const int repeats = argc > 2 ? std::max(1, std::atoi(argv[2])) : 3;
  std::printf("%-21s %8s %8s %8s %9s %9s %7s %9s %7s\n", "", "vertices", "cells", "TetGen's", "k/s",
              "TetGen's", "ratio", "no flips", "ratio");
  const std::string wanted = argc > 3 ? argv[3] : "";
  for (const Solid& solid : solids()) {
    if (solid.name.find(wanted) == std::string::npos) continue;
    double size = extent(solid.complex) / 10;
    for (double cells = 1e4; cells <= 1.01 * most; cells *= 10) {
      size = tune_ours(solid.complex, cells, size);
      const std::size_t vertices = ours(solid.complex, size).vertices;
      const double volume = tune_tetgen(solid, vertices, 0.5 * size * size * size);
      std::vector<double> our_rates, peer_rates, plain_rates;
      Measured we, peer;
      for (int i = 0; i < repeats; ++i) {
        we = ours(solid.complex, size);
        our_rates.push_back(we.rate());
        peer = tetgen(solid, volume, true);
        peer_rates.push_back(peer.rate());
        plain_rates.push_back(tetgen(solid, volume, false).rate());
      }
      const double rate = median(our_rates), peers = median(peer_rates),
                   plain = median(plain_rates);
      std::printf("%-21s %8zu %8zu %8zu %9.1f %9.1f %7.2f %9.1f %7.2f\n", solid.name.c_str(),
                  we.vertices, we.cells, peer.vertices, rate, peers, rate / peers, plain,
                  rate / plain);
      std::fflush(stdout);
      size /= std::cbrt(10.0);
    }
  }
  return 0;
}
