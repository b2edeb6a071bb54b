#include "circumball/verify.h"

#include <algorithm>

#include "quality/context.h"

namespace circumball {
namespace {

struct Entry {
  const char* name;
  Check (*run)(const VerifyContext&);
  bool (*applies)(const VerifyOptions&);  // where no checks are named
};

bool always(const VerifyOptions&) { return true; }
bool asked_only(const VerifyOptions&) { return false; }
bool has_tau(const VerifyOptions& o) { return o.tau.has_value(); }
bool has_size(const VerifyOptions& o) { return o.size.has_value(); }
bool conforming(const VerifyOptions& o) { return o.domain != "hull"; }  // `hull` adds no vertices

constexpr Entry kChecks[] = {
    {"topology", check_topology, always},
    {"delaunay", check_delaunay, always},
    {"input-vertices", check_input_vertices, always},
    {"input-segments", check_input_segments, conforming},
    {"area", check_area, always},
    {"radius-edge", check_radius_edge, has_tau},
    {"min-angle", check_min_angle, asked_only},
    {"size", check_size, has_size},
    {"nearest-neighbor", check_nearest_neighbor, asked_only},
    {"nearest-neighbor-lower", check_nearest_neighbor_lower, asked_only},
    {"seditious", check_seditious, asked_only},
    {"collar", check_collar, asked_only},
};

}  // namespace

std::vector<Check> verify(const Mesh& mesh, const Complex& complex, const VerifyOptions& options) {
  const VerifyContext context(mesh, complex, options);
  std::vector<Check> checks;
  for (const Entry& entry : kChecks) {
    const auto named = std::find(options.checks.begin(), options.checks.end(), entry.name);
    const bool wanted =
        options.checks.empty() ? entry.applies(options) : named != options.checks.end();
    // A bound that nobody gave cannot be checked, named or not.
    const bool needs_tau =
        entry.run == check_radius_edge || entry.run == check_collar || entry.run == check_seditious;
    if (!wanted || (needs_tau && !options.tau) || (entry.run == check_size && !options.size))
      continue;
    checks.push_back(entry.run(context));
  }
  return checks;
}

}  // namespace circumball
