#ifndef CIRCUMBALL_CLI_PARAMETERS_H_
#define CIRCUMBALL_CLI_PARAMETERS_H_

#include <map>
#include <string>
#include <vector>

#include "circumball/registry.h"

namespace circumball::cli {

/// Whether a parameter of the registry has an option of its own (--tau, --min-angle, --size).
bool has_own_option(const std::string& name);

/// Parses "NAME=VALUE" texts against the parameters that the registry lists for an algorithm: the
/// name must be one of them, the value one of its choices or within its range. Fails with a
/// sentence in `error`.
bool parse_settings(const std::vector<std::string>& settings, const AlgorithmInfo& algorithm,
                    std::map<std::string, std::string>* parameters, std::string* error);

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_PARAMETERS_H_
