#include "circumball/refine.h"

#include <algorithm>
#include <utility>

#include "algorithms/plan.h"
#include "algorithms/settings.h"
#include "complex/export2.h"
#include "complex/export3.h"
#include "complex/matching_region.h"
#include "refinement/solid_view.h"

namespace circumball {
namespace {

const char* limit_word(Reason reason) {
  switch (reason) {
    case Reason::kNone:
      return "not-reached";
    default:
      return name(reason);
  }
}

// What a run does differently in the plane and in space.

std::vector<std::unique_ptr<Stage>> plan_for(const Settings& settings, Plane) {
  return plan(settings);
}
std::vector<std::unique_ptr<Stage3>> plan_for(const Settings& settings, Space) {
  return plan_in_space(settings);
}

void follow_labels(Live2* live) { live->track_labels(); }
void follow_labels(Live3*) {}

/// The domain is settled, and traced, whatever stopped the run. Returns whether the mesh is what
/// the algorithm says that it is.
bool settle_domain(Live2* live, Recorder* recorder) {
  // Floods leak where subsegments are missing: a run that ends so counts levels once more.
  if (!live->classified() || (live->domain() == Domain::kClosed && !live->conforms())) {
    live->classify();
  }
  const Delaunay2& dt = live->triangulation();
  for (TriangleId t = 0; t < dt.slot_count(); ++t) {
    if (dt.alive(t)) live->in_domain(t);
  }
  recorder->relabeled(live->take_relabeled());
  return true;
}
bool settle_domain(Live3* live, Recorder3* recorder) {
  // Estimates of feature sizes leave the whole convex hull as it is; so does a run that was stopped
  // before all faces were there, as nothing keeps inside and outside apart yet. Where faces have
  // gaps again as it was stopped later, labels stay as insertions inherited them.
  if (!live->classified()) return true;
  recorder->relabeled(classify_if_conforming(live));
  if (!needs_matching_region(*live)) return true;
  // Theorem 6.15 is an argument about surfaces that rounding may bend: where its tetrahedralization
  // of tubes does not match, the mesh is the Delaunay one.
  const MatchingRegion region(*live);
  if (region.matches && recorder->on()) recorder->replaced(region);
  return region.matches;
}

bool knows_domain(const Live2&) { return true; }
bool knows_domain(const Live3& live) {
  const bool trivial = live.domain() != Domain::kClosed && live.complex().regions.empty();
  return trivial || live.classified();
}

/// With the box where the domain is one.
Complex prepared(const Complex& input, const Settings& settings) {
  return settings.domain == Domain::kBox ? with_box(input, settings.box_scale) : input;
}

}  // namespace

/// The state of a run; what depends on the dimension is in ImplOf.
struct Run::Impl {
  Impl(const Complex& input, Options o, Settings s)
      : options(std::move(o)),
        settings(std::move(s)),
        input_vertices(static_cast<std::uint32_t>(input.vertices.size())),
        complex(prepared(input, settings)) {}
  virtual ~Impl() = default;

  /// Begins the current step if it has not begun, and goes on; true when it is done.
  virtual bool go_on(Budget* budget) = 0;
  virtual void end_step() = 0;
  virtual Reason reached_limit() const = 0;
  virtual Reason refusal_limit() const = 0;
  virtual void settle() = 0;
  virtual void record_limit(Reason why) = 0;
  virtual Mesh mesh() = 0;
  virtual bool domain_known() const = 0;
  virtual void unresolved(const std::string& stop, std::size_t max,
                          std::vector<Unresolved>* list) const = 0;
  virtual std::vector<Unresolved> slivers(const std::string& stop, std::size_t max) const = 0;
  virtual void fill(Progress* progress) const = 0;

  /// Before the end of the last step is told, so that this is the last event of a run that is
  /// complete.
  void settle_once() {
    if (!std::exchange(settled, true)) settle();
  }

  void finish(Reason why) {
    settle_once();
    if (why == Reason::kCancelled) {
      status = Status::kCancelled;
    } else {
      status = why == Reason::kNone ? Status::kComplete : Status::kLimit;
      limit = why;
    }
    if (why != Reason::kNone) record_limit(why);
  }

  Options options;
  Settings settings;
  std::uint32_t input_vertices;
  Complex complex;
  std::atomic<bool> cancelled{false};
  std::vector<std::string> names;
  std::vector<StepReport> steps;
  std::size_t current = 0;
  bool settled = false;
  Status status = Status::kRunning;
  Reason limit = Reason::kNone;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::optional<DihedralHistogram> before_slivers;
};

/// The same in the plane or in space.
template <class World>
struct Run::ImplOf final : Impl {
  ImplOf(const Complex& input, Options o, Settings s, TraceSink* sink)
      : Impl(input, std::move(o), std::move(s)),
        live(complex, settings.domain),
        recorder(live, sink),
        work{live, recorder, options.limits, cancelled},
        stages(plan_for(settings, World{})) {
    if (sink) follow_labels(&live);
    for (const auto& stage : stages) names.push_back(stage->name);
    steps.reserve(stages.size());
  }

  bool go_on(Budget* budget) override {
    if (steps.size() == current && stages[current]->name == kSliverStep) {
      before_slivers = dihedral_histogram(mesh(), settings.sliver_degrees);
    }
    const auto start = Budget::Clock::now();
    if (steps.size() == current) {
      StepReport step;
      step.name = stages[current]->name;
      step.title = stages[current]->title;
      steps.push_back(step);
      work.inserted = work.refused = work.yielded = 0;
      recorder.step_began(static_cast<std::uint8_t>(current));
      stages[current]->begin(work);
    }
    const bool done = stages[current]->advance(work, *budget);
    const double spent = std::chrono::duration<double>(Budget::Clock::now() - start).count();
    StepReport& step = steps.back();
    step.vertices = live.triangulation().vertex_count();
    step.inserted = work.inserted;
    step.refused = work.refused;
    step.yielded = work.yielded;
    step.seconds += spent;
    seconds += spent;
    peak_bytes = std::max<std::uint64_t>(peak_bytes, live.bytes());
    return done;
  }
  void end_step() override { recorder.step_ended(work.inserted, work.refused); }
  Reason reached_limit() const override { return work.limit; }
  Reason refusal_limit() const override { return work.refusal_limit; }
  void settle() override {
    if (!settle_domain(&live, &recorder)) work.refusal_limit = Reason::kLimitPrecision;
  }
  void record_limit(Reason why) override { recorder.limit(why); }
  Mesh mesh() override { return export_mesh(&live, input_vertices); }
  bool domain_known() const override { return knows_domain(live); }

  void unresolved(const std::string& stop, std::size_t max,
                  std::vector<Unresolved>* list) const override {
    // The last rules are the strictest.
    for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage) {
      if ((*stage)->has_rules()) return (*stage)->unresolved(work, stop, max, list);
    }
  }

  std::vector<Unresolved> slivers(const std::string& stop, std::size_t max) const override {
    std::vector<Unresolved> list;
    stages.back()->unresolved(work, stop, max, &list);
    return list;
  }

  void fill(Progress* p) const override {
    p->vertices = live.triangulation().vertex_count();
    p->queued = work.queued;
    p->iterations = work.iterations;
  }

  typename World::Live live;
  typename World::Recorder recorder;
  WorkspaceOf<World> work;
  std::vector<std::unique_ptr<StageOf<World>>> stages;
};

Run::Run() = default;
Run::~Run() = default;

std::unique_ptr<Run> Run::create(const Complex& complex, const Options& options, TraceSink* sink,
                                 std::vector<Defect>* defects, std::string* error) {
  for (Defect& d : check(complex)) {
    if (!d.warning) defects->push_back(std::move(d));
  }
  if (!defects->empty()) return nullptr;
  Options settled = options;
  Settings settings;
  *error = settle(complex, &settled, &settings);
  if (!error->empty()) return nullptr;
  std::unique_ptr<Run> run(new Run);
  if (complex.dimension == 3) {
    run->impl_ = std::make_unique<ImplOf<Space>>(complex, std::move(settled), settings, sink);
  } else {
    run->impl_ = std::make_unique<ImplOf<Plane>>(complex, std::move(settled), settings, sink);
  }
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
    const bool done = m.go_on(&budget);
    if (m.reached_limit() != Reason::kNone) {
      m.finish(m.reached_limit());
    } else if (done) {
      if (m.current + 1 == m.names.size()) m.settle_once();
      m.end_step();
      if (++m.current == m.names.size()) m.finish(m.refusal_limit());
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
  m.fill(&p);
  p.seconds = m.seconds;
  return p;
}

const std::vector<std::string>& Run::step_names() const { return impl_->names; }
const std::vector<StepReport>& Run::steps() const { return impl_->steps; }

Mesh Run::mesh() const { return impl_->mesh(); }

std::vector<Unresolved> Run::unresolved(std::size_t max) const {
  std::vector<Unresolved> list;
  const Reason stop = impl_->status == Status::kCancelled ? Reason::kCancelled : impl_->limit;
  impl_->unresolved(limit_word(stop), max, &list);
  return list;
}

std::optional<SliverRemoval> Run::sliver_removal(std::size_t max) const {
  const Impl& m = *impl_;
  if (!m.before_slivers) return std::nullopt;
  const Reason stop = m.status == Status::kCancelled ? Reason::kCancelled : m.limit;
  return SliverRemoval{m.settings.sliver_degrees, *m.before_slivers,
                       m.slivers(limit_word(stop), max)};
}

const Complex& Run::complex() const { return impl_->complex; }
const Options& Run::options() const { return impl_->options; }
double Run::tau() const { return impl_->settings.tau; }
bool Run::domain_known() const { return impl_->domain_known(); }
Domain Run::domain() const { return impl_->settings.domain; }
std::uint64_t Run::peak_bytes() const { return impl_->peak_bytes; }

}  // namespace circumball
