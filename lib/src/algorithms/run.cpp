#include "circumball/refine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "algorithms/plan.h"
#include "algorithms/sweeps.h"
#include "circumball/registry.h"
#include "complex/export2.h"
#include "delaunay/constructions.h"
#include "predicates/elementary.h"
#include "refinement/stage.h"
#include "sizing/sizing.h"

namespace circumball {
namespace {

/// A finite number that is all of the text.
bool parse_number(const std::string& text, double* value) {
  char* end = nullptr;
  *value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(*value);
}

/// A sizing function that is not a plain number: it must be positive at the input vertices, at
/// least.
std::string settle_sizing(const Complex& complex, const std::string& text, Settings* settings) {
  auto sizing = std::make_shared<Sizing>();
  std::string error;
  if (!Sizing::parse(text, sizing.get(), &error)) return "size: " + error;
  for (const Point3& p : complex.vertices) {
    const double h = sizing->at(p.x, p.y, p.z);
    if (!(h > 0) || std::isinf(h)) {
      return "size: '" + text + "' is not positive and finite at the input vertex (" +
             std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
    }
  }
  settings->sizing = sizing;
  return "";
}

/// Of the bounding box of the vertices.
double diameter(const Complex& complex) {
  if (complex.vertices.empty()) return 0;
  Point3 low = complex.vertices[0], high = low;
  for (const Point3& p : complex.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
  }
  return distance(xy(low), xy(high));
}

/// Whether the box lies strictly around the input, in the range of coordinates.
bool box_fits(const Complex& complex, double scale) {
  const Complex boxed = with_box(complex, scale);
  const Point3 &low = *(boxed.vertices.end() - 4), &high = *(boxed.vertices.end() - 2);
  for (const Point3& p : complex.vertices) {
    if (!(low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y)) return false;
  }
  return low.x >= -1e55 && low.y >= -1e55 && high.x <= 1e55 && high.y <= 1e55;
}

/// Fills in the defaults and checks the ranges of the registry. An empty answer, or what is wrong.
std::string settle(const Complex& complex, Options* options, Settings* settings) {
  if (options->algorithm.empty()) options->algorithm = default_algorithm(complex);
  const AlgorithmInfo* info = find_algorithm(options->algorithm, complex.dimension);
  if (!info) {
    return "there is no algorithm '" + options->algorithm + "' for dimension " +
           std::to_string(complex.dimension) + "; `circumball list` names them";
  }
  // The options with names of their own are parameters of the registry like all others.
  auto& values = options->parameters;
  if (!options->size.empty()) values["size"] = options->size;
  for (const auto& [name, text] : values) {
    const auto known = std::find_if(info->parameters.begin(), info->parameters.end(),
                                    [&n = name](const ParameterInfo& p) { return p.name == n; });
    if (known == info->parameters.end()) {
      return "algorithm '" + info->id + "' has no parameter '" + name + "'";
    }
    double value, low, high;
    if (known->min.find('|') != std::string::npos) {  // a choice
      if (("|" + known->min + "|").find("|" + text + "|") != std::string::npos) continue;
      return "'" + name + "' must be one of " + known->min;
    }
    if (name == "size" && info->id != "chew" && !parse_number(text, &value)) {
      const std::string error = settle_sizing(complex, text, settings);
      if (!error.empty()) return error;
      continue;
    }
    if (!parse_number(text, &value)) return "'" + text + "' is not a number for '" + name + "'";
    if (parse_number(known->min, &low) && parse_number(known->max, &high) &&
        !(value >= low && value <= high)) {
      return "'" + name + "' is " + text + ", but must be between " + known->min + " and " +
             known->max;
    }
  }
  for (const ParameterInfo& p : info->parameters) {
    if (p.name != "tau" && p.name != "min-angle") values.emplace(p.name, p.default_value);
  }
  const auto number = [&](const char* name) {
    const auto found = values.find(name);
    double value = 0;
    if (found != values.end()) parse_number(found->second, &value);
    return value;
  };
  settings->algorithm = info->id;
  settings->size = number("size");
  if (values.count("protection")) settings->protection = number("protection");
  settings->off_centers = values.count("steiner") && values["steiner"] == "off-center";
  settings->protect_all = values.count("protect") && values["protect"] == "all";
  if (options->tau && !(*options->tau >= 0.6 && *options->tau <= 1000)) {
    return "tau must be between 0.6 and 1000";
  }
  if (options->min_angle_degrees &&
      !(*options->min_angle_degrees >= 0.1 && *options->min_angle_degrees <= 56)) {
    return "the smallest angle must be between 0.1 and 56 degrees";
  }
  if (!options->tau && values.count("tau")) options->tau = number("tau");
  if (!options->min_angle_degrees && values.count("min-angle")) {
    options->min_angle_degrees = number("min-angle");
  }
  if (options->tau && !options->min_angle_degrees) {
    settings->tau = *options->tau;
  } else {
    if (options->tau) return "give tau or the smallest angle, not both";
    const double degrees = options->min_angle_degrees.value_or(20.7);
    settings->tau = 0.5 / elementary::sin(degrees * (elementary::kPi / 180));
  }
  values.erase("tau");
  values.erase("min-angle");
  const bool encloses = encloses_something(complex);
  if (options->domain == Domain::kDefault) {
    options->domain = info->default_domain == "hull" ? Domain::kHull
                      : encloses                     ? Domain::kClosed
                                                     : Domain::kBox;
  }
  if (options->domain == Domain::kClosed && !encloses) {
    return "the segments enclose nothing, so that the domain `closed` is empty: use `box` or "
           "`hull`";
  }
  settings->domain = options->domain;
  if (options->domain == Domain::kBox && !box_fits(complex, number("box-scale"))) {
    return "the box cannot be represented: its corners would be beyond 1e55, or too near to the "
           "input for double precision; move or scale the input, or use the domain `hull`";
  }
  if (info->id == "chew" && settings->size == 0) {
    settings->size = default_division_length(complex);
    if (!std::isfinite(settings->size)) settings->size = 1;  // a single vertex
  }
  if (info->id == "fem-size" && settings->size == 0 && !settings->sizing) {
    settings->size = 0.1 * diameter(complex);
    if (settings->size == 0) settings->size = 1;  // a single vertex
  }
  if (settings->sizing) {
    settings->size = 0;
    return "";
  }
  options->size.clear();
  if (settings->size > 0) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", settings->size);
    values["size"] = options->size = text;
  }
  return "";
}

const char* limit_word(Reason reason) {
  switch (reason) {
    case Reason::kNone:
      return "not-reached";
    default:
      return name(reason);
  }
}

}  // namespace

struct Run::Impl {
  Impl(Complex input, Options o, Settings s, TraceSink* sink)
      : options(std::move(o)),
        settings(std::move(s)),
        input_vertices(static_cast<std::uint32_t>(input.vertices.size())),
        complex(std::move(input)),
        live(boxed(), settings.domain),
        recorder(live, sink),
        work{live, recorder, options.limits, cancelled},
        stages(plan(settings)) {
    if (sink) live.track_labels();
    for (const auto& stage : stages) names.push_back(stage->name);
    steps.reserve(stages.size());
  }

  const Complex& boxed() {
    if (settings.domain == Domain::kBox) {
      double scale = 3;
      parse_number(options.parameters["box-scale"], &scale);
      complex = with_box(complex, scale);
    }
    return complex;
  }

  void begin_step() {
    StepReport step;
    step.name = stages[current]->name;
    step.title = stages[current]->title;
    steps.push_back(step);
    work.inserted = work.refused = work.yielded = 0;
    recorder.step_began(static_cast<std::uint8_t>(current));
    stages[current]->begin(work);
  }

  void update_step(double spent) {
    StepReport& step = steps.back();
    step.vertices = live.triangulation().vertex_count();
    step.inserted = work.inserted;
    step.refused = work.refused;
    step.yielded = work.yielded;
    step.seconds += spent;
    seconds += spent;
    peak_bytes = std::max<std::uint64_t>(peak_bytes, live.bytes());
  }

  void end_step() { recorder.step_ended(work.inserted, work.refused); }

  /// The domain is settled, and traced, whatever stopped the run; before the end of the last step
  /// is told, so that this is the last event of a run that is complete.
  void settle_domain() {
    if (std::exchange(settled, true)) return;
    // Floods leak where subsegments are missing: a run that ends so counts levels once more.
    if (!live.classified() || (live.domain() == Domain::kClosed && !live.conforms())) {
      live.classify();
    }
    const Delaunay2& dt = live.triangulation();
    for (TriangleId t = 0; t < dt.slot_count(); ++t) {
      if (dt.alive(t)) live.in_domain(t);
    }
    recorder.relabeled(live.take_relabeled());
  }

  void finish(Reason why) {
    settle_domain();
    if (why == Reason::kCancelled) {
      status = Status::kCancelled;
    } else {
      status = why == Reason::kNone ? Status::kComplete : Status::kLimit;
      limit = why;
    }
    if (why != Reason::kNone) recorder.limit(why);
  }

  Options options;
  Settings settings;
  std::uint32_t input_vertices;
  Complex complex;
  Live2 live;
  Recorder recorder;
  std::atomic<bool> cancelled{false};
  Workspace work;
  std::vector<std::unique_ptr<Stage>> stages;
  std::vector<std::string> names;
  std::vector<StepReport> steps;
  std::size_t current = 0;
  bool settled = false;
  Status status = Status::kRunning;
  Reason limit = Reason::kNone;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
};

Run::Run() = default;
Run::~Run() = default;

std::unique_ptr<Run> Run::create(const Complex& complex, const Options& options, TraceSink* sink,
                                 std::vector<Defect>* defects, std::string* error) {
  if (complex.dimension != 2) {
    *error = "there is no algorithm for dimension " + std::to_string(complex.dimension);
    return nullptr;
  }
  for (Defect& d : check(complex)) {
    if (!d.warning) defects->push_back(std::move(d));
  }
  if (!defects->empty()) return nullptr;
  Options settled = options;
  Settings settings;
  *error = settle(complex, &settled, &settings);
  if (!error->empty()) return nullptr;
  std::unique_ptr<Run> run(new Run);
  run->impl_ = std::make_unique<Impl>(complex, std::move(settled), std::move(settings), sink);
  return run;
}

Status Run::advance(std::uint64_t iterations, double seconds) {
  Impl& m = *impl_;
  const double allowed = m.options.limits.max_seconds;
  double slice = seconds;
  if (allowed > 0) {
    const double left = std::max(allowed - m.seconds, 1e-9);
    slice = slice > 0 ? std::min(slice, left) : left;
  }
  Budget budget(iterations, slice);
  while (m.status == Status::kRunning) {
    const auto start = Budget::Clock::now();
    if (m.steps.size() == m.current) m.begin_step();
    const bool done = m.stages[m.current]->advance(m.work, budget);
    m.update_step(std::chrono::duration<double>(Budget::Clock::now() - start).count());
    if (m.work.limit != Reason::kNone) {
      m.finish(m.work.limit);
    } else if (done) {
      if (m.current + 1 == m.stages.size()) m.settle_domain();
      m.end_step();
      if (++m.current == m.stages.size()) m.finish(m.work.refusal_limit);
    } else if (allowed > 0 && m.seconds >= allowed) {
      m.finish(Reason::kLimitSeconds);
    } else {
      break;
    }
  }
  return m.status;
}

void Run::cancel() { impl_->cancelled.store(true, std::memory_order_relaxed); }
Status Run::status() const { return impl_->status; }
Reason Run::limit() const { return impl_->limit; }

Progress Run::progress() const {
  const Impl& m = *impl_;
  Progress p;
  p.step = m.names[std::min(m.current, m.names.size() - 1)];
  p.vertices = m.live.triangulation().vertex_count();
  p.queued = m.work.queued;
  p.iterations = m.work.iterations;
  p.seconds = m.seconds;
  return p;
}

const std::vector<std::string>& Run::step_names() const { return impl_->names; }
const std::vector<StepReport>& Run::steps() const { return impl_->steps; }

Mesh Run::mesh() const { return export_mesh(&impl_->live, impl_->input_vertices); }

std::vector<Unresolved> Run::unresolved(std::size_t max) const {
  std::vector<Unresolved> list;
  const Reason stop = impl_->status == Status::kCancelled ? Reason::kCancelled : impl_->limit;
  // The last rules are the strictest.
  for (auto stage = impl_->stages.rbegin(); stage != impl_->stages.rend(); ++stage) {
    if (!(*stage)->has_rules()) continue;
    (*stage)->unresolved(impl_->work, limit_word(stop), max, &list);
    break;
  }
  return list;
}

const Complex& Run::complex() const { return impl_->complex; }
const Options& Run::options() const { return impl_->options; }
double Run::tau() const { return impl_->settings.tau; }
Domain Run::domain() const { return impl_->settings.domain; }
std::uint64_t Run::peak_bytes() const { return impl_->peak_bytes; }

}  // namespace circumball
