#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "circumball/registry.h"
#include "circumball/report.h"

namespace circumball {

namespace {

// Safety refuses for good because of the input: a protected simplex or the border of the domain is
// in the way. Refusals that a limit caused (edge length, precision, and what froze because of them)
// excuse nothing.
bool rightly_refused(const Unresolved& simplex, Status status) {
  if (simplex.reason == name(Reason::kProtected)) return true;
  if (simplex.reason == name(Reason::kSeditious)) return true;
  if (simplex.reason == name(Reason::kOutsideDomain)) return true;
  return simplex.reason == name(Reason::kFrozen) && status == Status::kComplete;
}

// The bound of --size where it is a number.
std::optional<double> constant_size(const std::string& text) {
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0') return std::nullopt;
  return value;
}

}  // namespace

VerifyOptions promised_checks(const Run& run) {
  VerifyOptions result;
  const int dimension = run.complex().dimension;
  const AlgorithmInfo* algorithm = find_algorithm(run.options().algorithm, dimension);
  if (algorithm) result.checks = algorithm->checks;
  const auto drop = [&](const char* check) {
    const auto end = std::remove(result.checks.begin(), result.checks.end(), check);
    result.checks.erase(end, result.checks.end());
  };
  result.size = constant_size(run.options().size);
  result.sizing = run.options().size;
  drop(result.size ? "sizing" : "size");  // one of the two says it
  if (run.options().algorithm == "fem-size" && run.steps().size() > 1) {
    result.divisions = static_cast<std::uint32_t>(run.steps()[1].inserted);  // step 1
  }
  result.tau = run.tau();
  if (!(run.tau() > 0)) {
    result.tau.reset();
    drop("radius-edge");
  }
  result.domain = name(run.domain());
  const auto& parameters = run.options().parameters;
  const auto protect = parameters.find("protect");
  result.protect_all = protect != parameters.end() && protect->second == "all";
  const auto factor = parameters.find("size-factor");
  if (factor != parameters.end()) {
    result.size_factor = std::strtod(factor->second.c_str(), nullptr);
    // Algorithm 4.1 and halves leave end segments of up to 5/6 lfs (Theorem 4.2).
    const auto sizes = parameters.find("sizes");
    if (sizes != parameters.end() && sizes->second == "estimate") {
      result.size_factor = std::max(*result.size_factor, 5.0 / 6);
    }
  }
  // Theorems 6.14 and 6.15 hold without exception, but for a hull, whose own facets are no faces.
  const bool no_exception =
      dimension == 3 && std::count(result.checks.begin(), result.checks.end(), "intestine") > 0;
  const bool hull = run.domain() == Domain::kHull;
  for (const Unresolved& unresolved : run.unresolved(static_cast<std::size_t>(-1))) {
    if (unresolved.simplex.size() != static_cast<std::size_t>(dimension) + 1) continue;
    if (!rightly_refused(unresolved, run.status())) continue;
    const bool beyond_hull = hull && unresolved.reason == name(Reason::kOutsideDomain);
    std::vector<std::uint32_t> simplex = unresolved.simplex;
    std::sort(simplex.begin(), simplex.end());
    if (beyond_hull) result.beyond_hull.push_back(simplex);
    if (beyond_hull || !no_exception) result.excused.push_back(std::move(simplex));
  }
  std::sort(result.beyond_hull.begin(), result.beyond_hull.end());
  std::sort(result.excused.begin(), result.excused.end());
  return result;
}

}  // namespace circumball
