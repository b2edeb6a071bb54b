#include "circumball/registry.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "algorithms/registry3.h"

namespace circumball {
namespace {

std::vector<AlgorithmInfo> make_registry() {
  const ParameterInfo tau{
      "tau", "1.4145", "0.6", "1000",
      "radius-edge threshold: circumradius over shortest edge; above sqrt 2 the end is proved. The "
      "default is that of a smallest angle of 20.7 degrees"};
  const ParameterInfo min_angle{
      "min-angle", "20.7", "0.1", "56",
      "the same threshold as the smallest angle in degrees: tau = 1 / (2 sin(angle))"};
  const ParameterInfo size{"size", "0", "0", "1e55",
                           "upper bound on the circumradius of every triangle; 0: none"};
  const ParameterInfo box{"box-scale", "3", "1.5", "1000",
                          "side of the box of the domain `box`, in sizes of the input"};

  const ParameterInfo steiner{
      "steiner", "circumcenter", "circumcenter|off-center", "",
      "where triangles with too large a radius-edge ratio are split: at the circumcenter, or "
      "nearer "
      "to the shortest edge, so that the new triangle over it is just good enough (Üngör 2004)"};

  AlgorithmInfo delaunay;
  delaunay.id = "delaunay";
  delaunay.title = "Delaunay triangulation";
  delaunay.thesis = "Step 0 (Definition 2.1.1)";
  delaunay.action = "Insert the next input vertex.";
  delaunay.priority = "Along a space-filling curve: any order gives the same triangulation.";
  delaunay.unacceptability = "A triangle is unacceptable if its circumdisk holds an input vertex.";
  delaunay.safety = "It is safe to insert any vertex.";
  delaunay.parameters = {box};
  delaunay.guarantee =
      "The circumdisk of every triangle is empty; exactly, whatever the input. Segments are not "
      "enforced.";
  delaunay.checks = {"topology", "delaunay", "input-vertices"};
  delaunay.default_domain = "hull";

  AlgorithmInfo ruppert;
  ruppert.id = "ruppert";
  ruppert.title = "Ruppert's algorithm";
  ruppert.thesis = "Algorithm 2.3";
  ruppert.action =
      "If a triangle's circumcenter encroaches upon a segment, the encroached segment is added to "
      "the queue. Otherwise, when a simplex is processed, its circumcenter is inserted.";
  ruppert.priority = "Segments are processed before triangles.";
  ruppert.unacceptability =
      "A segment is unacceptable if it has a nonempty diametral disk. A triangle $t$ is "
      "unacceptable if $\\mathrm{RE}(t) > \\tau$.";
  ruppert.safety = "It is safe to split any simplex.";
  ruppert.parameters = {tau, min_angle, size, steiner, box};
  ruppert.guarantee =
      "For input angles of at least $60^\\circ$ and $\\tau > \\sqrt 2$ it ends; the mesh conforms "
      "to the input, $\\mathrm{RE}(t) \\le \\tau$ for every triangle, it is graded to the local "
      "feature size, and $N(q_0) \\le \\sqrt 2\\,\\mathrm{lfs}(q_0)$ for every input vertex "
      "(Theorems 2.2 and 2.3).";
  ruppert.checks = {"topology", "delaunay",    "input-vertices",   "input-segments",
                    "area",     "radius-edge", "nearest-neighbor", "size",
                    "sizing",   "grading"};
  ruppert.default_domain = "closed";

  AlgorithmInfo feature_size;
  feature_size.id = "feature-size";
  feature_size.title = "Feature size estimate";
  feature_size.thesis = "Algorithm 3.2";
  feature_size.action = "Insert the circumcenter of a segment.";
  feature_size.priority = "Segments may be processed in any order.";
  feature_size.unacceptability =
      "A segment $s$ is unacceptable if a vertex inside its diametral disk is a 1-feature size "
      "witness for $s$; or if an endpoint has a Delaunay neighbor inside the disk and $s$ is more "
      "than twice the length of the shortest segment in $\\mathrm{Spind}(s)$.";
  feature_size.safety = "It is safe to split any simplex.";
  feature_size.parameters = {box};
  feature_size.guarantee =
      "It ends for every complex, whatever its angles. At every input vertex $\\frac12 "
      "\\mathrm{lfs}(q_0) \\le N(q_0) \\le \\sqrt 2\\,\\mathrm{lfs}(q_0)$ (Theorems 3.2 and 3.3).";
  feature_size.checks = {"topology", "delaunay", "input-vertices", "nearest-neighbor",
                         "nearest-neighbor-lower"};
  feature_size.default_domain = "hull";

  AlgorithmInfo collar = ruppert;
  collar.id = "collar";
  collar.title = "Refinement with collars";
  collar.thesis = "Algorithm 5.2";
  collar.action =
      "Insert the circumcenter of a simplex. A triangle's circumcenter that encroaches upon a "
      "segment yields to it.";
  collar.priority = "Encroached segments are given higher priority than poor quality triangles.";
  collar.unacceptability =
      "Any segment with a nonempty diametral disk is unacceptable. Any triangle $t$ with "
      "$\\mathrm{RE}(t) > \\tau$ is unacceptable.";
  collar.safety =
      "Collar simplices (the end segments at acute input angles, made equal first) are not safe to "
      "split; a circumcenter in the diametral disk of one is refused.";
  collar.parameters.push_back(
      {"protection", "0.45", "0.01", "0.49",
       "distance of the collar from its input vertex, in N(q0); below 1/2"});
  collar.parameters.push_back(
      {"protect", "acute", "acute|all", "", "which input vertices are protected"});
  collar.guarantee =
      "It ends for every complex and $\\tau > \\sqrt 2$; the mesh conforms and is graded to the "
      "local feature size, and the circumcenter of every triangle with $\\mathrm{RE}(t) > \\tau$ "
      "lies in the diametral disk of a collar simplex (Theorems 5.6 and 5.7).";
  collar.checks = {"topology", "delaunay",    "input-vertices", "input-segments", "area",
                   "collar",   "radius-edge", "size",           "sizing",         "grading"};

  AlgorithmInfo intestine = collar;
  intestine.id = "intestine";
  intestine.title = "Refinement with intestines";
  intestine.thesis = "Algorithm 5.3";
  intestine.action =
      "Insert the circumcenter of a triangle. Insert the midpoint of a segment or arc. A "
      "triangle's circumcenter that encroaches upon a segment or arc yields to it.";
  intestine.priority =
      "Encroached segments and arcs are given higher priority than poor quality triangles.";
  intestine.unacceptability =
      "Any segment or arc with a nonempty diametral disk is unacceptable. Any triangle $t$ outside "
      "of the protecting disks with $\\mathrm{RE}(t) > \\tau$ is unacceptable.";
  intestine.safety =
      "All simplices and arcs outside of the disks are safe to split; inside, a fan of triangles "
      "joins the input vertex to the arcs of its circle.";
  intestine.guarantee =
      "It ends for every complex and $\\tau > \\sqrt 2$; the mesh conforms and is graded to the "
      "local feature size, triangles with $\\mathrm{RE}(t) > \\tau$ remain only in the disks about "
      "acute input vertices, and no angle is larger than $180^\\circ - 2\\kappa$ (Theorems 5.10 "
      "and 5.11).";
  intestine.checks = {"topology",  "delaunay",  "input-vertices", "input-segments", "area",
                      "intestine", "max-angle", "size",           "sizing",         "grading"};

  AlgorithmInfo terminator = ruppert;
  terminator.id = "terminator";
  terminator.title = "Terminator";
  terminator.thesis = "not in the thesis: Shewchuk 2000, 2002";
  terminator.action =
      "An end segment at an acute angle is split on the concentric shell about its input vertex, "
      "of radius $2^k$, nearest to its middle; any other segment at its midpoint. If a triangle's "
      "circumcenter encroaches upon a segment, the encroached segment is added to the queue. "
      "Otherwise its circumcenter is inserted.";
  terminator.safety =
      "A triangle with $\\mathrm{RE}(t) > \\tau$ is not safe to split if its shortest edge is "
      "seditious: its ends lie in two input segments that meet at less than $60^\\circ$, equally "
      "far "
      "from where they meet.";
  terminator.guarantee =
      "Wherever it ends the mesh conforms to the input, and every triangle with $\\mathrm{RE}(t) > "
      "\\tau$ has a seditious shortest edge. It ends for every complex up to $26.45^\\circ$, or "
      "$\\tau "
      "\\ge 1.123$ (Miller, Pav and Walkington 2003 prove it where segments are cut to equal "
      "shells first; "
      "tested here).";
  terminator.checks = {"topology",  "delaunay",    "input-vertices", "input-segments", "area",
                       "seditious", "radius-edge", "size",           "sizing",         "grading"};

  AlgorithmInfo chew;
  chew.id = "chew";
  chew.title = "Chew's first algorithm";
  chew.thesis = "Algorithm 7.2";
  chew.action = "Insert the circumcenter of a triangle.";
  chew.priority =
      "Triangles are prioritized by circumradius, larger circumradii are processed first.";
  chew.unacceptability = "A triangle $t$ is unacceptable if $R_t > h$.";
  chew.safety = "It is safe to split any simplex.";
  chew.parameters = {{"size", "0", "0", "1e55",
                      "h: segments are divided to between h and sqrt 3 h, triangles split while "
                      "their circumradius "
                      "exceeds h; 0: half the smallest distance between input vertices"},
                     box};
  chew.guarantee =
      "It always ends. Where input vertices are at least $h$ apart, segments divide into pieces "
      "between $h$ and $\\sqrt 3\\,h$, and these are Delaunay edges, every angle is at least "
      "$30^\\circ$ and every circumradius at most $h$.";
  chew.checks = {"topology", "delaunay", "input-vertices", "input-segments",
                 "area",     "size",     "min-angle"};
  chew.default_domain = "closed";

  AlgorithmInfo fem_size;
  fem_size.id = "fem-size";
  fem_size.title = "Simple refinement for FEM";
  fem_size.thesis = "Algorithm 7.1";
  fem_size.action =
      "Insert the circumcenter of a simplex unless the simplex is a triangle and the circumcenter "
      "encroaches upon a segment. In this case, queue the encroached segment for splitting.";
  fem_size.priority = "Segments are processed before triangles.";
  fem_size.unacceptability =
      "A segment $s$ is unacceptable if its diametral disk is non-empty. A triangle $t$ is "
      "unacceptable if $\\inf_{x \\in t} h(x) < R_t$.";
  fem_size.safety =
      "It is safe to split any simplex. (Acutely adjacent input segments were split at equal "
      "lengths modulo powers of two first.)";
  fem_size.parameters = {
      {"size", "0", "0", "1e55",
       "the sizing function h: a number, an expression in x and y such as 0.02 + 0.3*x^2, or a "
       "grid; 0: a tenth of the input's diameter"},
      box};
  fem_size.guarantee =
      "It ends for every complex and every $h$ that is bounded away from 0; the mesh conforms to "
      "the input, and $R_t \\le \\inf_{x \\in t} h(x)$ for every triangle $t$ (Theorem 7.13). "
      "Angles are not bounded, but mostly good.";
  fem_size.checks = {"topology", "delaunay", "input-vertices", "input-segments", "area",
                     "size",     "sizing",   "sizing-lower",   "grading"};
  fem_size.default_domain = "closed";

  std::vector<AlgorithmInfo> all = {delaunay, ruppert,   chew,       feature_size,
                                    collar,   intestine, terminator, fem_size};
  for (AlgorithmInfo& info : algorithms_in_space()) all.push_back(std::move(info));
  return all;
}

/// Numbers as numbers, all else as text.
nlohmann::ordered_json value_of(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return number;
  return text;
}

}  // namespace

const std::vector<AlgorithmInfo>& registry() {
  static const std::vector<AlgorithmInfo> algorithms = make_registry();
  return algorithms;
}

const AlgorithmInfo* find_algorithm(const std::string& id, int dimension) {
  for (const AlgorithmInfo& info : registry()) {
    if (info.id == id && info.dimension == dimension) return &info;
  }
  return nullptr;
}

std::string default_algorithm(const Complex& complex) {
  // Below 60 degrees nothing is proved of Ruppert's algorithm; a protection comes first where there
  // is one.
  const char* protection = "collar";
  if (complex.dimension == 3) return protection;  // which is Ruppert's where nothing is acute
  if ((smallest_angle_degrees(complex) >= 60 ||
       find_algorithm(protection, complex.dimension) == nullptr)) {
    return "ruppert";
  }
  return protection;
}

std::string registry_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const AlgorithmInfo& a : registry()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const ParameterInfo& p : a.parameters) {
      parameters.push_back({{"name", p.name},
                            {"default", value_of(p.default_value)},
                            {"min", value_of(p.min)},
                            {"max", value_of(p.max)},
                            {"help", p.help}});
    }
    list.push_back({{"id", a.id},
                    {"title", a.title},
                    {"dimension", a.dimension},
                    {"thesis", a.thesis},
                    {"rules",
                     {{"action", a.action},
                      {"priority", a.priority},
                      {"unacceptability", a.unacceptability},
                      {"safety", a.safety}}},
                    {"parameters", parameters},
                    {"guarantee", a.guarantee},
                    {"checks", a.checks}});
  }
  return list.dump(2);
}

}  // namespace circumball
