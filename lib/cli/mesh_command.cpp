#include <algorithm>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "circumball/io.h"
#include "circumball/registry.h"
#include "circumball/report.h"
#include "command.h"
#include "files.h"
#include "interrupt.h"
#include "messages.h"
#include "parameters.h"
#include "progress.h"

namespace circumball::cli {

namespace {

// Often enough for Ctrl-C and the progress line to feel immediate.
constexpr double kSliceSeconds = 0.1;

int usage(const std::string& error) {
  print_error(error);
  return kUsage;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Everything that can be known to be wrong before the input is read.
bool parse_outputs(const MeshArguments& arguments, std::vector<Destination>* destinations,
                   std::string* error) {
  int to_stdout = arguments.report == "-" ? 1 : 0;
  to_stdout += arguments.trace == "-" ? 1 : 0;
  for (const std::string& output : arguments.outputs) {
    Destination destination;
    if (!parse_destination(output, arguments.format, &destination, error)) return false;
    to_stdout += output == "-" ? 1 : 0;
    destinations->push_back(destination);
  }
  if (to_stdout > 1) *error = "only one thing can go to standard output";
  return to_stdout <= 1;
}

/// The table of sizes, which only `feature-size` makes.
constexpr char kSizeTable[] = ".csv";

bool known_extensions(const std::vector<Destination>& destinations, int dimension,
                      const std::string& algorithm, std::string* error) {
  std::vector<std::string> known = mesh_extensions(dimension);
  if (algorithm == "feature-size") known.push_back(kSizeTable);
  for (const Destination& destination : destinations) {
    if (std::count(known.begin(), known.end(), destination.extension)) continue;
    *error = fmt::format("a mesh of dimension {} cannot be written as '{}'; known: {}", dimension,
                         destination.extension, fmt::join(known, " "));
    return false;
  }
  return true;
}

// Names, ranges and choices of the algorithm and its parameters.
bool complete_options(const MeshArguments& arguments, const Complex& complex, Options* options,
                      std::string* error) {
  if (options->algorithm.empty()) options->algorithm = default_algorithm(complex);
  const AlgorithmInfo* algorithm = find_algorithm(options->algorithm, complex.dimension);
  if (!algorithm) {
    *error =
        fmt::format("there is no algorithm '{}' for dimension {}; 'circumball list' names them",
                    options->algorithm, complex.dimension);
    return false;
  }
  return parse_settings(arguments.settings, *algorithm, &options->parameters, error);
}

void advance_to_the_end(Run* run, ProgressLine* line) {
  catch_interrupts();
  while (run->advance(0, kSliceSeconds) == Status::kRunning) {
    if (interrupted()) run->cancel();
    line->show(run->progress());
  }
}

/// Dihedral angles; before and after the step that removes slivers, where there is one.
std::string dihedral_table(const Run& run, const Mesh& mesh) {
  const auto removal = run.sliver_removal(0);
  const DihedralHistogram now = dihedral_histogram(mesh, removal ? removal->degrees : 0);
  if (!removal) return fmt::format("dihedral angles {:.4g} to {:.4g} degrees\n", now.min, now.max);
  const DihedralHistogram& before = removal->before;
  std::string text = fmt::format("{:>24}  {:>10}  {:>10}\n", "dihedral angles", "before", "after");
  const auto row = [&](const std::string& name, const auto& a, const auto& b) {
    text += fmt::format("{:>24}  {:>10.4}  {:>10.4}\n", name, a, b);
  };
  row("smallest", before.min, now.min);
  row("largest", before.max, now.max);
  const auto count = [&](const std::string& name, std::uint64_t a, std::uint64_t b) {
    text += fmt::format("{:>24}  {:>10}  {:>10}\n", name, a, b);
  };
  for (std::size_t k = 0; k < now.counts.size(); ++k) {
    count(fmt::format("{} to {} degrees", 10 * k, 10 * k + 10), before.counts[k], now.counts[k]);
  }
  count(fmt::format("cells below {:.4g}", removal->degrees), before.slivers, now.slivers);
  return text;
}

std::string summary(const Run& run, const Mesh& mesh) {
  std::string text;
  for (const StepReport& step : run.steps()) {
    text += fmt::format("step {}: {}: {} inserted, {} refused, {} vertices\n", step.name,
                        step.title, step.inserted, step.refused, step.vertices);
  }
  text += fmt::format("{} {}: {} vertices, {} cells", run.options().algorithm, name(run.status()),
                      mesh.vertices.size(), mesh.cell_count());
  if (run.status() == Status::kLimit) text += fmt::format(" (limit: {})", limit_name(run));
  if (mesh.dimension == 2 && mesh.cell_count() > 0) {
    const Quality quality = measure(mesh);
    text +=
        fmt::format(", angles {:.4g} to {:.4g} degrees, shortest edge {:.4g}",
                    quality.min_angle_degrees, quality.max_angle_degrees, quality.shortest_edge);
  }
  if (mesh.dimension == 3 && mesh.cell_count() > 0) text += "\n" + dihedral_table(run, mesh);
  if (!text.empty() && text.back() == '\n') text.pop_back();
  if (!run.domain_known())
    text += "\nthe domain is not known yet: the mesh is all of the convex hull, without regions";
  const std::size_t unresolved = run.unresolved(static_cast<std::size_t>(-1)).size();
  if (unresolved) text += fmt::format("\nunresolved: {}", unresolved);
  text += fmt::format("\nfingerprint {}, {:.3g} s\n", fingerprint(mesh), run.progress().seconds);
  return text;
}

bool write_meshes(const MeshArguments& arguments, const std::vector<Destination>& destinations,
                  const Run& run, const Mesh& mesh, std::string* error) {
  WriteOptions options;
  options.msh_version = arguments.msh_version;
  for (const Destination& destination : destinations) {
    if (destination.extension == kSizeTable) {
      if (!write_file(destination.path, size_table(run, mesh), error)) return false;
      continue;
    }
    const std::vector<OutputFile> files =
        write_mesh(mesh, run.complex(), destination.extension, options, error);
    if (files.empty() || !write_files(destination, files, error)) return false;
  }
  return true;
}

int exit_code(const Run& run, const std::vector<Check>& checks) {
  if (!all_ok(checks)) return kCheckFailed;
  if (run.status() == Status::kCancelled) return kInterrupted;
  return run.status() == Status::kLimit ? kLimitReached : kDone;
}

}  // namespace

int mesh_command(const MeshArguments& arguments) {
  std::string error;
  std::vector<Destination> destinations;
  if (!parse_outputs(arguments, &destinations, &error)) return usage(error);
  Options options = arguments.options;
  if (!read_sizing(&options.size, &error)) return usage(error);

  const ReadResult input = read_input(arguments.input, arguments.reading);
  if (print_defects(input.defects, input.complex.dimension)) return kInvalidInput;
  if (!complete_options(arguments, input.complex, &options, &error)) return usage(error);
  if (!known_extensions(destinations, input.complex.dimension, options.algorithm, &error)) {
    return usage(error);
  }

  Trace trace;
  std::vector<Defect> defects;
  const std::unique_ptr<Run> run = Run::create(
      input.complex, options, arguments.trace.empty() ? nullptr : &trace, &defects, &error);
  if (print_defects(defects, input.complex.dimension) || (!run && error.empty()))
    return kInvalidInput;
  if (!run) return usage(error);
  {
    ProgressLine line(arguments.progress && !arguments.quiet);
    advance_to_the_end(run.get(), &line);
  }

  const Mesh mesh = run->mesh();
  std::vector<Check> checks;
  if (arguments.verify) checks = verify(mesh, run->complex(), promised_checks(*run));
  if (!write_meshes(arguments, destinations, *run, arguments.compact ? compact(mesh) : mesh,
                    &error)) {
    return usage(error);
  }
  if (!arguments.trace.empty()) {
    trace.dimension = mesh.dimension;
    if (trace.steps.empty()) trace.steps = run->step_names();
    const bool readable = ends_with(arguments.trace, ".jsonl");
    if (!write_file(arguments.trace, readable ? to_jsonl(trace) : to_bytes(trace), &error)) {
      return usage(error);
    }
  }
  if (!arguments.report.empty()) {
    const std::string report = report_json(*run, input.complex, mesh, checks) + "\n";
    if (!write_file(arguments.report, report, &error)) return usage(error);
  }
  if (!arguments.quiet) {
    const bool stdout_is_taken =
        arguments.report == "-" || arguments.trace == "-" ||
        std::count(arguments.outputs.begin(), arguments.outputs.end(), "-") > 0;
    std::FILE* out = stdout_is_taken ? stderr : stdout;
    std::fputs(summary(*run, mesh).c_str(), out);
    if (arguments.verify) std::fputs(table(checks).c_str(), out);
  }
  return exit_code(*run, checks);
}

}  // namespace circumball::cli
