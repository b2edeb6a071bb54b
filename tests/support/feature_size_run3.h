#ifndef CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN3_H_
#define CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN3_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "circumball/feature_size.h"
#include "circumball/refine.h"
#include "support/complexes3.h"
#include "support/segment_history.h"

namespace circumball::testing {

/// What chapter 4 states, held against a run of `feature-size` in space after each step that a
/// statement speaks of, and the lower bound of Theorem 4.1 at every subsegment's birth. Sizes are
/// those of the oracle, lengths those of the trace.
class Chapter4Watch {
 public:
  struct Range {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    void add(double x) {
      least = std::min(least, x);
      most = std::max(most, x);
    }
  };

  Chapter4Watch(const Complex& complex, std::vector<std::string> steps)
      : complex_(complex), sizes_(complex), steps_(std::move(steps)), history_(complex) {
    for (const Point3& p : complex.vertices)
      largest_ = std::max({largest_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    history_.on_born = [&](const Piece3& s) {
      expect(!(length(s) < std::min(fs(s) / 16, lfs(s) / 4) - slack(length(s))),
             "Theorem 4.1, throughout", s);
    };
    history_.on_step_end = [&](std::size_t step) { look(steps_.at(step)); };
  }

  TraceSink* sink() { return &history_; }
  const SegmentHistory& history() const { return history_; }
  /// The first few statements that failed, and where.
  const std::vector<std::string>& failures() const { return failures_; }
  /// Of |s| / fs_1 after 1b, |s| / lfs_1 after 2a, and |s| over each side of 4.1 and 4.2 after 2b.
  Range after_1b, after_2a, lower, upper;
  std::size_t looked_at = 0;

 private:
  double length(const Piece3& s) const {
    return distance(history_.point(s.a), history_.point(s.b));
  }
  double fs(const Piece3& s) const {
    return sizes_.of_subsegment(history_.point(s.a), history_.point(s.b), 1).radius;
  }
  double lfs(const Piece3& s, int i = 2) const {
    return sizes_.local(history_.point(s.a), history_.point(s.b), i).radius;
  }
  /// Positions are rounded: relative 1e-10, and what rounding of coordinates moves a vertex by.
  double slack(double length) const {
    return 1e-10 * length + 16 * std::numeric_limits<double>::epsilon() * largest_;
  }
  void expect(bool holds, const char* statement, const Piece3& s) {
    ++looked_at;
    if (holds || failures_.size() > 20) return;
    failures_.push_back(std::string(statement) + " at the subsegment " + std::to_string(s.a) + " " +
                        std::to_string(s.b) + ": |s| = " + std::to_string(length(s)) +
                        ", fs_1 = " + std::to_string(fs(s)) + ", lfs = " + std::to_string(lfs(s)));
  }
  bool is_input(std::uint32_t v) const { return v < complex_.vertices.size(); }
  bool is_end(const Piece3& s) const { return is_input(s.a) || is_input(s.b); }
  static bool share(const Piece3& s, const Piece3& t) {
    return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
  }

  void look(const std::string& step) {
    const std::vector<Piece3> live = history_.live();
    if (step == "1a") look_at_proposition_4_4(live);
    for (const Piece3& s : live) {
      const double l = length(s);
      if (step == "1b") {
        after_1b.add(l / fs(s));
        expect(l >= fs(s) / 4 - slack(l), "Lemma 4.5", s);
        expect(l <= std::sqrt(2.0) * fs(s) + slack(l), "Lemma 4.9", s);
      } else if (step == "2a") {
        after_2a.add(l / lfs(s, 1));
        expect(l <= lfs(s, 1) / (2 * std::sqrt(2.0)) + slack(l), "Lemma 4.10", s);
        expect(l >= fs(s) / 16 - slack(l), "Lemma 4.11", s);
      } else if (step == "2b") {
        lower.add(l / std::min(fs(s) / 16, lfs(s) / 4));
        upper.add(l / std::min(std::sqrt(2.0) * fs(s), 5.0 / 3 * lfs(s)));
        expect(l <= std::sqrt(2.0) * fs(s) + slack(l), "Theorem 4.2 (fs_1)", s);
        expect(l <= 5.0 / 3 * lfs(s) + slack(l), "Theorem 4.2 (lfs)", s);
      }
    }
  }

  /// (I) N(q0) = lfs_0(q0) / 3 (for vertices with segments: what is alone is split by nobody);
  /// (II) adjacent subsegments do not encroach each other; (III) a non-end segment is not shorter
  /// than an adjacent end segment; (IV) end segments of different spindles are farther from each
  /// other than they are long.
  void look_at_proposition_4_4(const std::vector<Piece3>& live) {
    std::vector<double> nearest(complex_.vertices.size(), std::numeric_limits<double>::infinity());
    for (std::uint32_t q = 0; q < nearest.size(); ++q)
      for (std::uint32_t p = 0; p < history_.vertex_count(); ++p)
        if (p != q) nearest[q] = std::min(nearest[q], distance(point(p), point(q)));
    for (const Piece3& s : live) {
      for (const std::uint32_t q : {s.a, s.b}) {
        if (!is_input(q)) continue;
        const double third = sizes_.local(point(q), 0).radius / 3;
        expect(std::fabs(nearest[q] - third) <= slack(third), "Proposition 4.4 (I)", s);
      }
      for (const Piece3& t : live) {
        if (&s == &t) continue;
        if (share(s, t)) {
          for (const std::uint32_t p : {t.a, t.b}) {
            if (p == s.a || p == s.b) continue;
            const Point3 middle = between(point(s.a), point(s.b), 0.5);
            expect(distance(middle, point(p)) >= length(s) / 2 - slack(length(s)),
                   "Proposition 4.4 (II)", s);
          }
          if (is_end(s) && !is_end(t))
            expect(length(t) >= length(s) - slack(length(s)), "Proposition 4.4 (III)", s);
        } else if (is_end(s) && is_end(t)) {
          // The distance of the two is that between some end of one and the other, or of crossing
          // lines; the oracle knows it as a clearance of a complex of one segment.
          Complex one;
          one.dimension = 3;
          one.vertices = {point(t.a), point(t.b)};
          one.segments = {{0, 1}};
          const double between_them =
              FeatureSizes3(one).clearance(point(s.a), point(s.b), kNoIndex, 1).radius;
          expect(between_them >= std::max(length(s), length(t)) - slack(between_them),
                 "Proposition 4.4 (IV)", s);
        }
      }
    }
  }
  const Point3& point(std::uint32_t v) const { return history_.point(v); }

  const Complex& complex_;
  FeatureSizes3 sizes_;
  std::vector<std::string> steps_;
  SegmentHistory history_;
  double largest_ = 0;
  std::vector<std::string> failures_;
};

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_FEATURE_SIZE_RUN3_H_
