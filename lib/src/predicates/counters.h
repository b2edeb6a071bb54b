#ifndef CIRCUMBALL_PREDICATES_COUNTERS_H_
#define CIRCUMBALL_PREDICATES_COUNTERS_H_

#include <atomic>
#include <cstdint>

/// The counters behind `predicate_counters()`: one cell for each predicate and stage.
namespace circumball::internal {

/// A counter that costs a load and a store. Threads do not tear it, though they may lose counts to
/// each other: the counters are statistics, and a locked add would cost more than the filter that
/// it counts.
class Counter {
 public:
  void add_one() {
    value_.store(value_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  std::uint64_t value() const { return value_.load(std::memory_order_relaxed); }
  void reset() { value_.store(0, std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

struct StageCounters {
  Counter filter, adaptive, exact;
};

enum class Predicate : int {
  kOrient2d,
  kOrient3d,
  kIncircle,
  kInsphere,
  kSegmentBall2,
  kSegmentBall3,
  kTriangleBall,
};
constexpr int kPredicateCount = 7;

extern StageCounters stage_counters[kPredicateCount];

inline StageCounters& counters_of(Predicate p) { return stage_counters[static_cast<int>(p)]; }

/// Counts a decision of the filter in builds that ask for it, and is nothing in all others.
inline void count_filter([[maybe_unused]] Predicate p) {
#ifdef CIRCUMBALL_COUNT_FILTER
  counters_of(p).filter.add_one();
#endif
}

}  // namespace circumball::internal

#endif  // CIRCUMBALL_PREDICATES_COUNTERS_H_
