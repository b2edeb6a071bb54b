#ifndef CIRCUMBALL_REGISTRY_H_
#define CIRCUMBALL_REGISTRY_H_

#include <string>
#include <vector>

#include "circumball/complex.h"

/// The one list of algorithms. The command's help, the page's panels and the docs read it.
namespace circumball {

struct ParameterInfo {
  std::string name;
  std::string default_value, min,
      max;  ///< as text; for a choice, min holds "a|b|c" and max is empty
  std::string help;
};

struct AlgorithmInfo {
  std::string id, title;
  int dimension = 2;
  std::string thesis;  ///< e.g. "Algorithm 2.3"
  std::string action, priority, unacceptability,
      safety;  ///< the four rules in words; mathematics between $…$
  std::vector<ParameterInfo> parameters;
  std::string guarantee;
  std::vector<std::string> checks;  ///< names of the checks that `verify` runs for it
  std::string default_domain;  ///< "hull", or "closed" ("closed" falls back to "box" where nothing
                               ///< is enclosed)
};

const std::vector<AlgorithmInfo>& registry();
/// Null if there is none.
const AlgorithmInfo* find_algorithm(const std::string& id, int dimension);
/// The default for a complex: `ruppert` in the plane where no input angle is below 60 degrees
/// (cli.md).
std::string default_algorithm(const Complex& complex);
/// The registry as JSON: what `circumball list --json` prints.
std::string registry_json();

}  // namespace circumball

#endif  // CIRCUMBALL_REGISTRY_H_
