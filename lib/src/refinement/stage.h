#ifndef CIRCUMBALL_REFINEMENT_STAGE_H_
#define CIRCUMBALL_REFINEMENT_STAGE_H_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "circumball/refine.h"
#include "complex/live2.h"
#include "refinement/recorder.h"

namespace circumball {

/// How far a run may go before it hands back control, and where it must stop.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;
  Budget(std::uint64_t iterations, double seconds)
      : left_(iterations ? iterations : ~std::uint64_t{0}), timed_(seconds > 0) {
    if (timed_) {
      deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(seconds));
    }
  }
  /// Called before each iteration. The clock is read at every 64th.
  bool spend() {
    if (left_ == 0) return false;
    if (timed_ && (++ticks_ & 63) == 0 && Clock::now() >= deadline_) return false;
    --left_;
    return true;
  }

 private:
  std::uint64_t left_;
  std::uint32_t ticks_ = 0;
  bool timed_;
  Clock::time_point deadline_;
};

/// The plane, as the loop and the steps see it; `Space` (stage3.h) is its sibling. `Agenda` says
/// which simplices there are, in which order they wait, and which an insertion concerns.
template <class Rules>
class Agenda2;
struct Plane {
  using Live = Live2;
  using View = circumball::View;
  using Recorder = circumball::Recorder;
  using Point = Point2;
  template <class Rules>
  using Agenda = Agenda2<Rules>;
};

/// What all steps of a run share.
template <class World>
struct WorkspaceOf {
  typename World::Live& live;
  typename World::Recorder& recorder;
  const Limits& limits;
  const std::atomic<bool>& cancelled;
  std::uint64_t iterations = 0;
  std::uint64_t inserted = 0, refused = 0, yielded = 0;  // in the current step
  Reason limit = Reason::kNone;                          ///< a limit that ends the run
  Reason refusal_limit =
      Reason::kNone;  ///< kLimitMinEdge or kLimitPrecision: something was refused for it
  std::uint64_t queued = 0;

  /// Vertices, memory and cancellation; seconds are the run's.
  bool within_limits() {
    if (limits.max_vertices && live.triangulation().vertex_count() >= limits.max_vertices) {
      limit = Reason::kLimitVertices;
    } else if (cancelled.load(std::memory_order_relaxed)) {
      limit = Reason::kCancelled;
    } else if (limits.max_bytes && (++ticks & 1023) == 0 && live.bytes() > limits.max_bytes) {
      limit = Reason::kLimitMemory;
    }
    return limit == Reason::kNone;
  }
  std::uint32_t ticks = 0;
};

using Workspace = WorkspaceOf<Plane>;

/// One step of an algorithm: a run of the loop, or a single sweep.
template <class World>
class StageOf {
 public:
  using Workspace = WorkspaceOf<World>;
  StageOf(std::string name, std::string title) : name(std::move(name)), title(std::move(title)) {}
  virtual ~StageOf() = default;
  virtual void begin(Workspace&) {}
  /// Goes on; true when the step is done. A limit in the workspace ends it, too.
  virtual bool advance(Workspace&, Budget&) = 0;
  /// Whether it can call a simplex unacceptable.
  virtual bool has_rules() const { return false; }
  /// Appends what its rules still call unacceptable, at most `max` in all, and why it was not
  /// split; `stop` is the reason for all that was never refused.
  virtual void unresolved(const Workspace&, const std::string& /*stop*/, std::size_t /*max*/,
                          std::vector<Unresolved>*) const {}

  const std::string name, title;
};
using Stage = StageOf<Plane>;

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_STAGE_H_
