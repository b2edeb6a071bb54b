#include <cstdio>

#include <fmt/format.h>

#include "circumball/verify.h"
#include "command.h"
#include "files.h"
#include "messages.h"

namespace circumball::cli {

namespace {

bool named_ok(const std::vector<Check>& checks, const char* name) {
  for (const Check& check : checks) {
    if (check.name == name && check.ok) return true;
  }
  return false;
}

}  // namespace

int verify_command(const VerifyArguments& arguments) {
  VerifyOptions options;
  options.tau = arguments.tau;
  options.sizing = arguments.size;
  std::string error;
  if (!read_sizing(&options.sizing, &error)) {
    print_error(error);
    return kUsage;
  }
  const ReadResult input = read_input(arguments.input, arguments.reading);
  // Of a .node file the mesh is in the .ele beside it.
  std::string mesh_file = arguments.mesh;
  const std::string node = ".node";
  if (mesh_file.size() > node.size() &&
      mesh_file.compare(mesh_file.size() - node.size(), node.size(), node) == 0) {
    mesh_file.replace(mesh_file.size() - node.size(), node.size(), ".ele");
  }
  const ReadResult mesh = read_input(mesh_file);
  const bool bad_input = print_defects(input.defects, input.complex.dimension);
  const bool bad_mesh = print_defects(mesh.defects, mesh.complex.dimension);
  if (bad_input || bad_mesh || print_defects(check(input.complex), input.complex.dimension))
    return kInvalidInput;
  if (!mesh.mesh) {
    print_error(fmt::format("'{}' ({}) holds no mesh", mesh_file, mesh.format));
    return kInvalidInput;
  }
  if (mesh.mesh->dimension != input.complex.dimension) {
    print_error("the mesh and the complex differ in dimension");
    return kInvalidInput;
  }
  // What the mesh was meant to cover is not written in it: it is what encloses, the hull, or a box,
  // whichever its area is that of. All other checks are the same for the three.
  std::vector<Check> checks;
  for (const char* domain : {"closed", "hull", "box"}) {
    options.domain = domain;
    const bool boxed = options.domain == "box";
    std::vector<Check> attempt =
        verify(*mesh.mesh, boxed ? with_box(input.complex, 3) : input.complex, options);
    const bool covers = named_ok(attempt, "area");
    if (checks.empty() || covers) checks = std::move(attempt);
    if (covers) break;
  }
  std::fputs(table(checks).c_str(), stdout);
  return all_ok(checks) ? kDone : kCheckFailed;
}

}  // namespace circumball::cli
