#ifndef CIRCUMBALL_CLI_COMMAND_H_
#define CIRCUMBALL_CLI_COMMAND_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "circumball/io.h"
#include "circumball/refine.h"

/// The verbs of the command: one file each. They parse nothing and return the exit code.
namespace circumball::cli {

/// Exit codes of the manual; scripts rely on them.
enum ExitCode : int {
  kDone = 0,
  kCheckFailed = 1,
  kUsage = 2,
  kInvalidInput = 3,
  kLimitReached = 4,
  kInterrupted = 5,
};

struct MeshArguments {
  std::string input;
  ReadOptions reading;
  Options options;
  std::vector<std::string> settings;  ///< NAME=VALUE of --set
  std::vector<std::string> outputs;
  std::string format;  ///< extension for `-o -`
  std::string msh_version = "4.1";
  std::string trace, report;  ///< file names; empty: none
  bool verify = false, compact = false, quiet = false, progress = true;
};
int mesh_command(const MeshArguments& arguments);

struct VerifyArguments {
  std::string mesh, input;
  ReadOptions reading;  ///< of the input
  std::optional<double> tau;
  std::string size;  ///< sizing function; "@FILE": in a file; empty: none
};
int verify_command(const VerifyArguments& arguments);

struct CheckArguments {
  std::string input;
  ReadOptions reading;
};
int check_command(const CheckArguments& arguments);

int list_command(bool json);

struct ConvertArguments {
  std::string input, output, format;
  ReadOptions reading;
  std::string msh_version = "4.1";
};
int convert_command(const ConvertArguments& arguments);

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_COMMAND_H_
