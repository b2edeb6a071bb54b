#include "parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace circumball::cli {

namespace {

bool parse_number(const std::string& text, double* value) {
  char* end = nullptr;
  *value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(*value);
}

// A choice lists "a|b|c" in `min`; otherwise `min` and `max` are numbers, or empty for no bound.
bool valid_value(const ParameterInfo& parameter, const std::string& value, std::string* error) {
  if (parameter.min.find('|') != std::string::npos) {
    const std::string choices = "|" + parameter.min + "|";
    if (value.find('|') == std::string::npos &&
        choices.find("|" + value + "|") != std::string::npos) {
      return true;
    }
    *error = fmt::format("{} is one of {}, not '{}'", parameter.name, parameter.min, value);
    return false;
  }
  double number = 0, bound = 0;
  if (!parse_number(value, &number)) {
    // An expression; what takes none, and what is wrong with it, `Run::create` says.
    if (parameter.name == "size") return true;
    *error = fmt::format("{} is a number, not '{}'", parameter.name, value);
    return false;
  }
  const bool below = parse_number(parameter.min, &bound) && number < bound;
  const bool above = parse_number(parameter.max, &bound) && number > bound;
  if (below || above) {
    *error = fmt::format("{} is between {} and {}, not {}", parameter.name, parameter.min,
                         parameter.max, value);
  }
  return !below && !above;
}

}  // namespace

bool has_own_option(const std::string& name) {
  return name == "tau" || name == "min-angle" || name == "size";
}

bool parse_settings(const std::vector<std::string>& settings, const AlgorithmInfo& algorithm,
                    std::map<std::string, std::string>* parameters, std::string* error) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      *error = fmt::format("--set takes NAME=VALUE, not '{}'", setting);
      return false;
    }
    const std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
    const auto parameter = std::find_if(algorithm.parameters.begin(), algorithm.parameters.end(),
                                        [&name](const ParameterInfo& p) { return p.name == name; });
    if (parameter == algorithm.parameters.end()) {
      *error =
          fmt::format("{} has no parameter '{}'; 'circumball list' names them", algorithm.id, name);
      return false;
    }
    if (!valid_value(*parameter, value, error)) return false;
    (*parameters)[name] = value;
  }
  return true;
}

}  // namespace circumball::cli
