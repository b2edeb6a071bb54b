#include <cstdio>

#include <fmt/format.h>

#include "circumball/registry.h"
#include "command.h"
#include "parameters.h"

namespace circumball::cli {

int list_command(bool json) {
  if (json) {
    std::printf("%s\n", registry_json().c_str());
    return kDone;
  }
  std::string text;
  for (const AlgorithmInfo& algorithm : registry()) {
    text += fmt::format("{}  {} ({}D; {})\n", algorithm.id, algorithm.title, algorithm.dimension,
                        algorithm.thesis);
    text += fmt::format("  action            {}\n", algorithm.action);
    text += fmt::format("  priority          {}\n", algorithm.priority);
    text += fmt::format("  unacceptability   {}\n", algorithm.unacceptability);
    text += fmt::format("  safety            {}\n", algorithm.safety);
    text += fmt::format("  guarantee         {}\n", algorithm.guarantee);
    text += fmt::format("  checks            {}\n", fmt::join(algorithm.checks, ", "));
    for (const ParameterInfo& parameter : algorithm.parameters) {
      const std::string range = parameter.max.empty()
                                    ? parameter.min
                                    : fmt::format("{} to {}", parameter.min, parameter.max);
      text += fmt::format(
          has_own_option(parameter.name) ? "  --{} {}  ({})  {}\n" : "  --set {}={}  ({})  {}\n",
          parameter.name, parameter.default_value, range, parameter.help);
    }
    text += '\n';
  }
  std::fputs(text.c_str(), stdout);
  return kDone;
}

}  // namespace circumball::cli
