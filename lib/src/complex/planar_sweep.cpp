#include "complex/planar_sweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "circumball/predicates.h"

namespace circumball {

bool usable(double c) {
  const double m = std::fabs(c);
  return c == 0 || (m >= 1e-45 && m <= 1e55);  // false for NaN and infinities
}

PlanarView::PlanarView(const Complex& complex, const std::vector<Point2>& seeds) {
  struct Entry {
    Point2 p;
    std::uint32_t source;  // vertex number, or vertex count + seed number
  };
  const std::uint32_t n = static_cast<std::uint32_t>(complex.vertices.size());
  const std::uint32_t m = static_cast<std::uint32_t>(seeds.size());
  std::vector<Entry> entries;
  entries.reserve(std::size_t{n} + m);
  for (std::uint32_t i = 0; i < n + m; ++i) {
    const Point2 p = i < n ? xy(complex.vertices[i]) : seeds[i - n];
    if (usable(p.x) && usable(p.y)) entries.push_back({p, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (a.p.x != b.p.x) return a.p.x < b.p.x;
    if (a.p.y != b.p.y) return a.p.y < b.p.y;
    return a.source < b.source;
  });
  point_of_vertex.assign(n, kNoIndex);
  point_of_seed.assign(m, kNoIndex);
  for (const Entry& e : entries) {
    if (points.empty() || points.back() != e.p) {
      points.push_back(e.p);
      vertex.push_back(e.source < n ? e.source : kNoIndex);
    }
    const std::uint32_t point = static_cast<std::uint32_t>(points.size() - 1);
    if (e.source < n)
      point_of_vertex[e.source] = point;
    else
      point_of_seed[e.source - n] = point;
  }

  std::vector<Segment> all;
  for (std::uint32_t i = 0; i < complex.segments.size(); ++i) {
    const auto& s = complex.segments[i];
    if (s[0] >= n || s[1] >= n) continue;
    const std::uint32_t a = point_of_vertex[s[0]], b = point_of_vertex[s[1]];
    if (a == kNoIndex || b == kNoIndex || a == b) continue;
    all.push_back({std::min(a, b), std::max(a, b), i});
  }
  std::sort(all.begin(), all.end(), [](const Segment& a, const Segment& b) {
    if (a.lo != b.lo) return a.lo < b.lo;
    if (a.hi != b.hi) return a.hi < b.hi;
    return a.segment < b.segment;
  });
  for (const Segment& s : all) {
    if (!segments.empty() && segments.back().lo == s.lo && segments.back().hi == s.hi)
      duplicate_segments.push_back({s.segment, segments.back().segment});
    else
      segments.push_back(s);
  }
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return a.segment < b.segment; });
  std::sort(duplicate_segments.begin(), duplicate_segments.end());
}

namespace {

class Sweep {
 public:
  explicit Sweep(const PlanarView& view) : view_(view), status_(Order{this}) {
    const std::size_t n = view.segments.size();
    result_.suspect.assign(n, 0);
    result_.below.assign(view.points.size(), kNoIndex);
    result_.through.assign(view.points.size(), kNoIndex);
    where_.assign(n, status_.end());
    active_.assign(n, 0);
    starting_at_.assign(view.points.size() + 1, 0);
    for (const auto& s : view.segments) ++starting_at_[s.lo + 1];
    for (std::size_t i = 1; i < starting_at_.size(); ++i) starting_at_[i] += starting_at_[i - 1];
    starting_.resize(n);
    std::vector<std::uint32_t> next(starting_at_.begin(), starting_at_.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i) starting_[next[view.segments[i].lo]++] = i;
  }

  SweepResult run() {
    for (std::uint32_t p = 0; p < view_.points.size(); ++p) visit(p);
    return std::move(result_);
  }

 private:
  struct AtPoint {};  // stands for the present point in searches
  /// Below-to-above order of active segments at the present point. A segment that is being inserted
  /// has the point on it.
  struct Order {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(std::uint32_t s, AtPoint) const { return sweep->side(s) == Sign::kPositive; }
    bool operator()(AtPoint, std::uint32_t s) const { return sweep->side(s) == Sign::kNegative; }
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      const Sign sa = sweep->side(a);
      if (sa != Sign::kZero) return sa == Sign::kPositive;
      const Sign sb = sweep->side(b);
      if (sb != Sign::kZero) return sb == Sign::kNegative;
      return sweep->turn(a, b) == Sign::kPositive;
    }
  };
  using Status = std::set<std::uint32_t, Order>;

  const Point2& point(std::uint32_t p) const { return view_.points[p]; }
  /// Positive if the present point is above the segment.
  Sign side(std::uint32_t s) const {
    const auto& seg = view_.segments[s];
    return orient2d(point(seg.lo), point(seg.hi), point(now_));
  }
  /// Positive if b leaves the present point above a; both have it on them.
  Sign turn(std::uint32_t a, std::uint32_t b) const {
    return orient2d(point(now_), point(view_.segments[a].hi), point(view_.segments[b].hi));
  }
  bool cross(std::uint32_t s, std::uint32_t t) const {
    const Point2 &a = point(view_.segments[s].lo), &b = point(view_.segments[s].hi);
    const Point2 &c = point(view_.segments[t].lo), &d = point(view_.segments[t].hi);
    const int c1 = static_cast<int>(orient2d(a, b, c)) * static_cast<int>(orient2d(a, b, d));
    if (c1 >= 0) return false;
    return static_cast<int>(orient2d(c, d, a)) * static_cast<int>(orient2d(c, d, b)) < 0;
  }
  /// Which of two leaves the sweep: a short one is cheap to look at once more.
  bool shorter(std::uint32_t s, std::uint32_t t) const {
    const double a = length2(s), b = length2(t);
    return a != b ? a < b : s > t;
  }
  double length2(std::uint32_t s) const {
    const Point2 &a = point(view_.segments[s].lo), &b = point(view_.segments[s].hi);
    const double dx = b.x - a.x, dy = b.y - a.y;
    return dx * dx + dy * dy;
  }

  void drop(Status::iterator it) {
    const std::uint32_t s = *it;
    active_[s] = 0;
    result_.suspect[s] = 1;
    status_.erase(it);
  }

  /// Takes out segments until the one at `right` does not cross the one below it.
  void settle(Status::iterator right) {
    while (right != status_.end() && right != status_.begin()) {
      const auto left = std::prev(right);
      if (!cross(*left, *right)) return;
      if (shorter(*left, *right)) {
        drop(left);
      } else {
        const auto next = std::next(right);
        drop(right);
        right = next;
      }
    }
  }

  void visit(std::uint32_t p) {
    now_ = p;
    const bool is_vertex = view_.vertex[p] != kNoIndex;
    auto above = status_.lower_bound(AtPoint{});
    if (above != status_.begin()) result_.below[p] = *std::prev(above);
    leaving_.clear();
    while (above != status_.end() && side(*above) == Sign::kZero) {
      const std::uint32_t s = *above;
      above = status_.erase(above);
      active_[s] = 0;
      if (view_.segments[s].hi == p) continue;
      result_.through[p] = s;
      if (is_vertex) result_.suspect[s] = 1;
      leaving_.push_back(s);  // goes on behind the point, which is exactly on it
    }
    leaving_.insert(leaving_.end(), starting_.begin() + starting_at_[p],
                    starting_.begin() + starting_at_[p + 1]);
    std::sort(leaving_.begin(), leaving_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Sign t = turn(a, b);
      if (t != Sign::kZero) return t == Sign::kPositive;
      const std::uint32_t ha = view_.segments[a].hi, hb = view_.segments[b].hi;
      return ha != hb ? ha > hb : a < b;
    });
    std::uint32_t first = kNoIndex, previous = kNoIndex;
    for (const std::uint32_t s : leaving_) {
      if (previous != kNoIndex && turn(previous, s) == Sign::kZero) {
        result_.suspect[s] = 1;  // overlaps `previous`, which reaches at least as far
        continue;
      }
      where_[s] = status_.emplace_hint(above, s);
      active_[s] = 1;
      if (first == kNoIndex) first = s;
      previous = s;
    }
    settle(above);
    if (first != kNoIndex && active_[first]) settle(where_[first]);
  }

  const PlanarView& view_;
  SweepResult result_;
  Status status_;
  std::vector<Status::iterator> where_;
  std::vector<std::uint8_t> active_;
  std::vector<std::uint32_t> starting_at_, starting_, leaving_;
  std::uint32_t now_ = 0;
};

}  // namespace

SweepResult sweep(const PlanarView& view) { return Sweep(view).run(); }

}  // namespace circumball
