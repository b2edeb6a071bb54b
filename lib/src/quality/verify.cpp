#include "circumball/verify.h"

#include <algorithm>

#include "quality/context.h"
#include "quality/context3.h"

namespace circumball {
namespace {

template <class Context>
struct Entry {
  const char* name;
  Check (*run)(const Context&);
  bool (*applies)(const VerifyOptions&);  // where no checks are named
  bool (*possible)(
      const VerifyOptions&);  // a bound that nobody gave cannot be checked, named or not
};

bool always(const VerifyOptions&) { return true; }
bool asked_only(const VerifyOptions&) { return false; }
bool has_tau(const VerifyOptions& o) { return o.tau.has_value(); }
bool has_size(const VerifyOptions& o) { return o.size.has_value(); }
bool has_sizing(const VerifyOptions& o) { return !o.sizing.empty(); }
bool has_function(const VerifyOptions& o) { return !o.size && !o.sizing.empty(); }
bool conforming(const VerifyOptions& o) { return o.domain != "hull"; }  // `hull` adds no vertices

constexpr Entry<VerifyContext> kChecks[] = {
    {"topology", check_topology, always, always},
    {"delaunay", check_delaunay, always, always},
    {"input-vertices", check_input_vertices, always, always},
    {"input-segments", check_input_segments, conforming, always},
    {"area", check_area, always, always},
    {"radius-edge", check_radius_edge, has_tau, has_tau},
    {"min-angle", check_min_angle, asked_only, always},
    {"size", check_size, has_size, has_size},
    {"sizing", check_sizing, has_function, has_sizing},
    {"sizing-lower", check_sizing_lower, asked_only, has_sizing},
    {"nearest-neighbor", check_nearest_neighbor, asked_only, always},
    {"nearest-neighbor-lower", check_nearest_neighbor_lower, asked_only, always},
    {"seditious", check_seditious, asked_only, has_tau},
    {"collar", check_collar, asked_only, has_tau},
    {"intestine", check_intestine, asked_only, has_tau},
    {"max-angle", check_max_angle, asked_only, has_tau},
    {"grading", check_grading, asked_only, always},
};

constexpr Entry<VerifyContext3> kChecks3[] = {
    {"topology", check_topology, always, always},
    {"delaunay", check_delaunay, always, always},
    {"input-vertices", check_input_vertices, always, always},
    {"input-segments", check_input_segments, conforming, always},
    {"input-faces", check_input_faces, conforming, always},
    {"volume", check_volume, always, always},
    {"radius-edge", check_radius_edge, has_tau, has_tau},
    {"collar", check_collar, asked_only, has_tau},
    {"protection", check_protection, asked_only, always},
    {"intestine", check_intestine, asked_only, has_tau},
    {"delaunay-outside", check_delaunay_outside, asked_only, always},
    {"segment-lower", check_segment_lower, asked_only, always},
    {"segment-upper", check_segment_upper, asked_only, always},
};

template <class Context, std::size_t n>
std::vector<Check> run_checks(const Entry<Context> (&entries)[n], const Mesh& mesh,
                              const Complex& complex, const VerifyOptions& options) {
  const Context context(mesh, complex, options);
  std::vector<Check> checks;
  for (const Entry<Context>& entry : entries) {
    const auto named = std::find(options.checks.begin(), options.checks.end(), entry.name);
    const bool wanted =
        options.checks.empty() ? entry.applies(options) : named != options.checks.end();
    if (!wanted || !entry.possible(options)) continue;
    checks.push_back(entry.run(context));
  }
  return checks;
}

}  // namespace

std::vector<Check> verify(const Mesh& mesh, const Complex& complex, const VerifyOptions& options) {
  return complex.dimension == 3 ? run_checks(kChecks3, mesh, complex, options)
                                : run_checks(kChecks, mesh, complex, options);
}

}  // namespace circumball
