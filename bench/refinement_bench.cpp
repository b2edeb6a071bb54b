// Ruppert's algorithm on the unit square beside CGAL's Delaunay_mesher_2, in one process: the same
// smallest angle (20.7 degrees), size bounds tuned to equal numbers of vertices; and what recording
// a trace costs.
//
//   refinement_bench [repeats]        prints medians and ratios
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "circumball/refine.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_2<Triangulation, Criteria>;

struct Measured {
  double seconds = 0;
  std::size_t vertices = 0;
};

template <class F>
double seconds_of(F f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Measured ours(double circumradius, circumball::TraceSink* sink) {
  circumball::Complex square;
  square.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  circumball::Options options;
  options.algorithm = "ruppert";
  char size[32];
  std::snprintf(size, sizeof size, "%.17g", circumradius);
  options.size = size;
  Measured result;
  std::vector<circumball::Defect> defects;
  std::string error;
  std::unique_ptr<circumball::Run> run;
  result.seconds = seconds_of([&] {
    run = circumball::Run::create(square, options, sink, &defects, &error);
    run->advance();
  });
  result.vertices = run->progress().vertices;
  return result;
}

Measured cgal(double edge) {
  Triangulation cdt;
  const auto a = cdt.insert({0, 0}), b = cdt.insert({1, 0}), c = cdt.insert({1, 1}),
             d = cdt.insert({0, 1});
  cdt.insert_constraint(a, b);
  cdt.insert_constraint(b, c);
  cdt.insert_constraint(c, d);
  cdt.insert_constraint(d, a);
  Measured result;
  result.seconds = seconds_of([&] {
    Mesher mesher(cdt);
    mesher.set_criteria(Criteria(0.125, edge));  // sin^2 of 20.7 degrees
    mesher.refine_mesh();
  });
  result.vertices = cdt.number_of_vertices();
  return result;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The edge bound with which CGAL makes as many vertices as asked, within 1 percent.
double tune(std::size_t vertices, double guess) {
  for (int i = 0; i < 12; ++i) {
    const double got = static_cast<double>(cgal(guess).vertices);
    const double factor = std::sqrt(got / static_cast<double>(vertices));
    if (std::fabs(factor - 1) < 0.005) break;
    guess *= factor;
  }
  return guess;
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
  std::printf("%10s %10s %14s %14s %8s %12s\n", "vertices", "CGAL's", "ours, k/s", "CGAL, k/s",
              "ratio", "recording");
  // Circumradii that are no power of two of the side: the meshes are no lattices.
  for (const double h : {0.0257, 0.0081, 0.00257, 0.00128}) {
    const std::size_t vertices = ours(h, nullptr).vertices;
    const double edge = tune(vertices, 1.6 * h);
    std::vector<double> our_times, cgal_times, recording_times;
    std::size_t cgal_vertices = 0;
    for (int i = 0; i < repeats; ++i) {
      our_times.push_back(ours(h, nullptr).seconds);
      const Measured peer = cgal(edge);
      cgal_times.push_back(peer.seconds);
      cgal_vertices = peer.vertices;
      circumball::Trace trace;
      recording_times.push_back(ours(h, &trace).seconds);
    }
    const double n = static_cast<double>(vertices) / 1000;
    const double our_rate = n / median(our_times);
    const double cgal_rate = static_cast<double>(cgal_vertices) / 1000 / median(cgal_times);
    std::printf("%10zu %10zu %14.0f %14.0f %8.2f %12.2f\n", vertices, cgal_vertices, our_rate,
                cgal_rate, our_rate / cgal_rate, median(recording_times) / median(our_times));
  }
}
