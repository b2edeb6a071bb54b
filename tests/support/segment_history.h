#ifndef CIRCUMBALL_TESTS_SUPPORT_SEGMENT_HISTORY_H_
#define CIRCUMBALL_TESTS_SUPPORT_SEGMENT_HISTORY_H_

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "circumball/complex.h"
#include "circumball/trace.h"

namespace circumball::testing {

/// A subsegment: its ends, as vertices of the mesh, and the input segment.
struct Piece3 {
  std::uint32_t a, b, segment;
};

/// Watches a run in space with nothing but its trace: the subsegments that exist after every
/// insertion. The complex is the one that is refined (Run::complex).
class SegmentHistory final : public TraceSink {
 public:
  explicit SegmentHistory(const Complex& complex) : points_(complex.vertices) {
    for (std::uint32_t s = 0; s < complex.segments.size(); ++s)
      add({complex.segments[s][0], complex.segments[s][1], s});
  }

  /// Called for every subsegment that is born by a split, and at the end of each step (by its
  /// number in the trace).
  std::function<void(const Piece3&)> on_born;
  std::function<void(std::size_t)> on_step_end;

  void event(const Event& e, const std::uint32_t*, std::size_t) override {
    if (e.kind == EventKind::kStepEnded && on_step_end) on_step_end(e.step);
    if (e.kind != EventKind::kInserted) return;
    if (e.subject >= points_.size()) points_.resize(e.subject + 1);
    points_[e.subject] = {e.at[0], e.at[1], e.at[2]};
    if (e.dimension != 1) return;
    const Piece3 parent{e.simplex[0], e.simplex[1], e.simplex[3]};
    if (live_.erase(key(parent)) != 1) ++unknown_;
    for (const std::uint32_t end : {parent.a, parent.b}) {
      const Piece3 born{end, e.subject, parent.segment};
      add(born);
      if (on_born) on_born(born);
    }
  }

  std::vector<Piece3> live() const {
    std::vector<Piece3> all;
    for (const auto& entry : live_) all.push_back(entry.second);
    return all;
  }
  const Point3& point(std::uint32_t v) const { return points_[v]; }
  std::size_t vertex_count() const { return points_.size(); }
  /// Splits of what was not there: none, if the trace is right.
  std::size_t unknown() const { return unknown_; }

 private:
  static std::pair<std::uint32_t, std::uint32_t> key(const Piece3& s) {
    return std::minmax(s.a, s.b);
  }
  void add(const Piece3& s) { live_.insert({key(s), s}); }

  std::vector<Point3> points_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Piece3> live_;
  std::size_t unknown_ = 0;
};

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_SEGMENT_HISTORY_H_
