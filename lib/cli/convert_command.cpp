#include <algorithm>

#include <fmt/format.h>

#include "circumball/io.h"
#include "command.h"
#include "files.h"
#include "messages.h"

namespace circumball::cli {

int convert_command(const ConvertArguments& arguments) {
  std::string error;
  Destination destination;
  if (!parse_destination(arguments.output, arguments.format, &destination, &error)) {
    print_error(error);
    return kUsage;
  }
  const ReadResult input = read_input(arguments.input, arguments.reading);
  if (print_defects(input.defects, input.complex.dimension)) return kInvalidInput;
  // Crossings may be written; what refers to nothing may not. Then all that is wrong is told.
  if (!check_numbers(input.complex, 1).empty()) {
    print_defects(check(input.complex), input.complex.dimension);
    return kInvalidInput;
  }

  std::vector<OutputFile> files;
  const std::vector<std::string> known = mesh_extensions(input.complex.dimension);
  const bool as_mesh = input.mesh && std::count(known.begin(), known.end(), destination.extension);
  if (as_mesh) {
    WriteOptions options;
    options.msh_version = arguments.msh_version;
    files = write_mesh(*input.mesh, input.complex, destination.extension, options, &error);
  } else {
    files = write_complex(input.complex, destination.extension, &error);
  }
  if (files.empty()) {
    print_error(error);
    return kUsage;
  }
  if (!write_files(destination, files, &error)) {
    print_error(error);
    return kUsage;
  }
  return kDone;
}

}  // namespace circumball::cli
