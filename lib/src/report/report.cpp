#include "circumball/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "circumball/registry.h"

namespace circumball {

namespace {

using Json = nlohmann::ordered_json;  // keys stay in the order of the manual

Json number_or_null(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

// A parameter is a number where its text is one.
Json parameter_value(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return text;
  return value;
}

Json parameters(const Run& run) {
  Json result = Json::object();
  const Options& options = run.options();
  if (run.tau() > 0) result["tau"] = run.tau();
  if (!options.size.empty()) result["size"] = parameter_value(options.size);
  result["domain"] = name(run.domain());
  result["max-vertices"] = options.limits.max_vertices;
  if (options.limits.min_edge > 0) result["min-edge"] = options.limits.min_edge;
  if (options.limits.max_seconds > 0) result["max-seconds"] = options.limits.max_seconds;
  for (const auto& [key, value] : options.parameters) result[key] = parameter_value(value);
  return result;
}

Json measures(const Mesh& mesh) {
  const Quality quality = measure(mesh);
  const bool any = mesh.cell_count() > 0;
  const auto value = [&](double v, int dimension = 0) {  // 0: of either
    const bool has = any && (dimension == 0 || dimension == mesh.dimension);
    return number_or_null(has ? std::optional(v) : std::nullopt);
  };
  Json result;
  result["vertices"] = mesh.vertices.size();
  result["cells"] = mesh.cell_count();
  result["min_angle_degrees"] = value(quality.min_angle_degrees, 2);
  result["max_angle_degrees"] = value(quality.max_angle_degrees, 2);
  result["max_radius_edge"] = value(quality.max_radius_edge);
  result["min_dihedral_degrees"] = value(quality.min_dihedral_degrees, 3);
  result["max_dihedral_degrees"] = value(quality.max_dihedral_degrees, 3);
  result["shortest_edge"] = value(quality.shortest_edge);
  if (any && mesh.dimension == 3) result["dihedrals"] = dihedral_histogram(mesh).counts;
  return result;
}

Json histogram_json(const DihedralHistogram& histogram) {
  return {{"slivers", histogram.slivers},
          {"min_dihedral_degrees", histogram.min},
          {"max_dihedral_degrees", histogram.max},
          {"dihedrals", histogram.counts}};
}

Json unresolved_json(const Unresolved& simplex) {
  return {{"simplex", simplex.simplex},
          {"rule", simplex.rule},
          {"reason", simplex.reason},
          {"near", simplex.near}};
}

/// Before and after the step that removes slivers.
Json slivers_json(const SliverRemoval& removal, const Mesh& mesh, std::size_t max) {
  const DihedralHistogram after = dihedral_histogram(mesh, removal.degrees);
  Json result;
  result["bound"] = removal.degrees;
  result["before"] = histogram_json(removal.before);
  result["after"] = histogram_json(after);
  result["removed"] = removal.before.slivers - std::min(removal.before.slivers, after.slivers);
  result["kept"] = after.slivers;
  Json& reasons = result["reasons"] = Json::object();
  Json& cells = result["cells"] = Json::array();
  for (const Unresolved& sliver : removal.kept) {
    Json& count = reasons[sliver.reason];
    count = count.is_null() ? 1 : count.get<int>() + 1;
    if (cells.size() < max) cells.push_back(unresolved_json(sliver));
  }
  return result;
}

Json check_json(const Check& check, const ReportOptions& options) {
  Json result;
  result["name"] = check.name;
  result["ok"] = check.ok;
  result["detail"] = check.detail;
  result["bound"] = number_or_null(check.bound);
  result["observed"] = number_or_null(check.observed);
  if (options.worst_offenders) result["worst"] = check.worst;
  return result;
}

}  // namespace

const char* name(Status status) {
  switch (status) {
    case Status::kRunning:
      return "running";
    case Status::kComplete:
      return "complete";
    case Status::kLimit:
      return "limit";
    case Status::kCancelled:
      return "cancelled";
  }
  return "";
}

const char* name(Domain domain) {
  switch (domain) {
    case Domain::kDefault:
      return "default";
    case Domain::kHull:
      return "hull";
    case Domain::kBox:
      return "box";
    case Domain::kClosed:
      return "closed";
  }
  return "";
}

std::string limit_name(const Run& run) {
  switch (run.limit()) {
    case Reason::kLimitVertices:
      return "vertices";
    case Reason::kLimitMinEdge:
      return "min-edge";
    case Reason::kLimitSeconds:
      return "seconds";
    case Reason::kLimitPrecision:
      return "precision";
    case Reason::kLimitMemory:
      return "memory";
    default:
      return name(run.limit());
  }
}

std::string report_json(const Run& run, const Complex& input, const Mesh& mesh,
                        const std::vector<Check>& checks, const ReportOptions& options) {
  Json report;
  report["schema"] = 1;
  report["version"] = version();
  report["algorithm"] = run.options().algorithm;
  report["dimension"] = mesh.dimension;
  report["parameters"] = parameters(run);
  report["input"] = {{"vertices", input.vertices.size()},
                     {"segments", input.segments.size()},
                     {"faces", input.faces.size()},
                     {"smallest_angle_degrees", smallest_angle_degrees(input)}};
  report["status"] = name(run.status());
  if (run.status() == Status::kLimit) report["limit"] = limit_name(run);
  if (!run.domain_known()) report["domain_known"] = false;
  Json& steps = report["steps"] = Json::array();
  for (const StepReport& step : run.steps()) {
    steps.push_back({{"name", step.name},
                     {"title", step.title},
                     {"vertices", step.vertices},
                     {"inserted", step.inserted},
                     {"refused", step.refused},
                     {"seconds", step.seconds}});
  }
  report["mesh"] = measures(mesh);
  Json& unresolved = report["unresolved"] = Json::array();
  const std::vector<Unresolved> remaining = run.unresolved(static_cast<std::size_t>(-1));
  for (std::size_t i = 0; i < std::min(remaining.size(), options.max_unresolved); ++i)
    unresolved.push_back(unresolved_json(remaining[i]));
  report["unresolved_total"] = remaining.size();
  if (const auto removal = run.sliver_removal(~std::size_t{0})) {
    report["slivers"] = slivers_json(*removal, mesh, options.max_unresolved);
  }
  Json& results = report["checks"] = Json::array();
  for (const Check& check : checks) results.push_back(check_json(check, options));
  report["fingerprint"] = fingerprint(mesh);
  report["seconds"] = run.progress().seconds;
  report["peak_bytes"] = run.peak_bytes();
  // Names in a hostile input may hold any bytes: those that are not UTF-8 are replaced, never
  // thrown at.
  return report.dump(options.indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace circumball
