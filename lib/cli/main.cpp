// The `circumball` command: arguments in, exit code out. What each verb does is in its own file.
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "circumball/predicates.h"
#include "circumball/report.h"
#include "command.h"
#include "messages.h"

namespace circumball::cli {

namespace {

// CLI11's own Range and NonNegativeNumber let "nan" pass.
const CLI::Validator kPositive(
    [](std::string& text) {
      double value = 0;
      const bool ok = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
      return ok ? std::string() : "'" + text + "' is not a positive number";
    },
    "NUMBER");
const CLI::Validator kNotNegative(
    [](std::string& text) {
      double value = 0;
      const bool ok = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0;
      return ok ? std::string() : "'" + text + "' is not a number of at least 0";
    },
    "NUMBER");

void add_reading_options(CLI::App* verb, ReadOptions* reading) {
  verb->add_option(
          "--weld", reading->weld,
          "Surfaces (STL, OFF, OBJ, PLY): vertices at most this far apart are one; 0: equal "
          "ones (default for STL)")
      ->check(kNotNegative);
  verb->add_flag("!--no-merge", reading->merge_coplanar,
                 "Surfaces of triangles: make no face of coplanar neighbors");
}

void add_mesh_options(CLI::App* verb, MeshArguments* mesh) {
  Options& options = mesh->options;
  verb->add_option("INPUT", mesh->input, "The complex: a file of any format that is read")
      ->required();
  add_reading_options(verb, &mesh->reading);
  verb->add_option("--tau", options.tau, "Radius-edge threshold")->check(kPositive);
  verb->add_option("--min-angle", options.min_angle_degrees,
                   "Smallest angle in degrees, in the plane (default 20.7); tau = 1 / (2 sin)")
      ->check(kPositive)
      ->excludes("--tau");
  verb->add_option("--size", options.size,
                   "Upper bound on the circumradius: a number, an expression in x and y, or @FILE "
                   "with either or with a sampled grid");
  const auto set_domain = [&options](const std::string& name) {
    options.domain = name == "hull"  ? Domain::kHull
                     : name == "box" ? Domain::kBox
                                     : Domain::kClosed;
  };
  verb->add_option_function<std::string>("--domain", set_domain, "What is meshed")
      ->check(CLI::IsMember({"hull", "box", "closed"}));
  verb->add_option("--max-vertices", options.limits.max_vertices,
                   "Stop at this many vertices (0: no limit)")
      ->check(kNotNegative)
      ->capture_default_str();
  verb->add_option("--min-edge", options.limits.min_edge, "Make no edge shorter than this")
      ->check(kNotNegative);
  verb->add_option("--max-seconds", options.limits.max_seconds, "Stop after this time")
      ->check(kNotNegative);
  verb->add_option("--set", mesh->settings, "NAME=VALUE: a parameter of the algorithm; see 'list'")
      ->allow_extra_args(false);
  verb->add_option("-o,--output", mesh->outputs,
                   "Write the mesh, in the format of the extension; again for more; '-': to "
                   "standard output")
      ->allow_extra_args(false);
  verb->add_option("--format", mesh->format, "Format of '-o -': an extension");
  verb->add_option("--msh", mesh->msh_version, "Version of .msh files")
      ->check(CLI::IsMember({"4.1", "2.2"}))
      ->capture_default_str();
  verb->add_option("--trace", mesh->trace, "Write the event trace; .jsonl for a readable one");
  verb->add_option("--report", mesh->report, "Write the report as JSON ('-': to standard output)");
  verb->add_flag("--verify", mesh->verify, "Run every check that the algorithm promises");
  verb->add_flag("--compact", mesh->compact, "Drop vertices that no cell uses, and renumber");
  verb->add_flag("--quiet", mesh->quiet, "Say nothing but errors");
  verb->add_flag("!--no-progress", mesh->progress, "No progress line");
}

int run(int argc, char** argv) {
  CLI::App app("Delaunay refinement that you can watch, and trust.", "circumball");
  app.set_version_flag("--version", std::string("circumball ") + version());
  app.require_subcommand(1);
  std::function<int()> action;

  MeshArguments mesh;
  CLI::App* mesh_verb = app.add_subcommand("mesh", "Refine a complex");
  mesh_verb->add_option("--algorithm", mesh.options.algorithm,
                        "An id that 'circumball list' prints; default: chosen by the input");
  add_mesh_options(mesh_verb, &mesh);
  mesh_verb->callback([&] { action = [&] { return mesh_command(mesh); }; });

  MeshArguments sizes;
  sizes.options.algorithm = "feature-size";
  CLI::App* sizes_verb =
      app.add_subcommand("sizes", "Feature sizes: shorthand for mesh --algorithm feature-size");
  add_mesh_options(sizes_verb, &sizes);
  sizes_verb->callback([&] { action = [&] { return mesh_command(sizes); }; });

  VerifyArguments verify;
  CLI::App* verify_verb =
      app.add_subcommand("verify", "Check a mesh, whoever made it, against its complex");
  verify_verb->add_option("MESH", verify.mesh, "The mesh")->required();
  verify_verb->add_option("--input", verify.input, "The complex")->required();
  verify_verb->add_option("--tau", verify.tau, "Radius-edge bound to check")->check(kPositive);
  verify_verb->add_option("--size", verify.size,
                          "Bound on the circumradius to check, as 'mesh' takes it");
  add_reading_options(verify_verb, &verify.reading);
  verify_verb->callback([&] { action = [&] { return verify_command(verify); }; });

  CheckArguments checked;
  CLI::App* check_verb =
      app.add_subcommand("check", "What is in a complex, and what is wrong with it");
  check_verb->add_option("INPUT", checked.input, "The complex")->required();
  add_reading_options(check_verb, &checked.reading);
  check_verb->callback([&] { action = [&] { return check_command(checked); }; });

  bool json = false;
  CLI::App* list_verb =
      app.add_subcommand("list", "The algorithms: rules, parameters, guarantee, thesis reference");
  list_verb->add_flag("--json", json, "As JSON");
  list_verb->callback([&] { action = [&] { return list_command(json); }; });

  ConvertArguments convert;
  CLI::App* convert_verb = app.add_subcommand("convert", "Between formats");
  convert_verb->add_option("INPUT", convert.input, "A complex or a mesh")->required();
  convert_verb->add_option("OUTPUT", convert.output, "The file to write; '-': standard output")
      ->required();
  convert_verb->add_option("--format", convert.format, "Format of standard output: an extension");
  convert_verb->add_option("--msh", convert.msh_version, "Version of .msh files")
      ->check(CLI::IsMember({"4.1", "2.2"}));
  add_reading_options(convert_verb, &convert.reading);
  convert_verb->callback([&] { action = [&] { return convert_command(convert); }; });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? kDone : kUsage;  // --help and --version end here, with 0
  }
  if (const char* wrong = predicate_self_test(); wrong[0] != '\0') {
    print_error(wrong);
    return kCheckFailed;
  }
  return action();
}

}  // namespace

}  // namespace circumball::cli

int main(int argc, char** argv) {
  using namespace circumball::cli;
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
    return kLimitReached;
  } catch (const std::exception& error) {
    print_error(error.what());
    return kInvalidInput;
  }
}
