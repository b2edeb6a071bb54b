#include "algorithms/equal_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "circumball/predicates.h"
#include "delaunay/constructions.h"
#include "refinement/split_at.h"
#include "refinement/view.h"

namespace circumball {
namespace {

/// How many neighbors on each side a segment of a cluster is compared with in part 3.
constexpr std::ptrdiff_t kWindow = 32;

/// A segment as its end q0 sees it.
struct Spoke {
  std::uint32_t segment;
  int end;  // which of the segment's ends q0 is
  Point2 tip;
};

/// Segments at q0, each less than 90 degrees from the next, in the order of their angles.
struct Cluster {
  Point2 q0;
  std::vector<Spoke> spokes;
  bool closed = false;  // all around q0: the last is next to the first
};

/// Counter-clockwise about q0, from the direction of the x axis. Exact.
void sort_by_angle(const Point2& q0, std::vector<Spoke>* spokes) {
  const auto lower = [&](const Point2& p) { return p.y < q0.y || (p.y == q0.y && p.x < q0.x); };
  std::stable_sort(spokes->begin(), spokes->end(), [&](const Spoke& s, const Spoke& t) {
    const bool a = lower(s.tip), b = lower(t.tip);
    return a != b ? b : orient2d(q0, s.tip, t.tip) == Sign::kPositive;
  });
  // A segment that is given twice is one.
  const auto same = [](const Spoke& s, const Spoke& t) { return s.tip == t.tip; };
  spokes->erase(std::unique(spokes->begin(), spokes->end(), same), spokes->end());
}

/// Appends the clusters of two segments and more at q0.
void append_clusters(const Point2& q0, std::vector<Spoke> spokes, std::vector<Cluster>* clusters) {
  sort_by_angle(q0, &spokes);
  const std::size_t n = spokes.size();
  if (n < 2) return;
  const auto acute = [&](std::size_t i) {  // to the next one
    const Point2 &a = spokes[i].tip, &b = spokes[(i + 1) % n].tip;
    return in_diametral_ball(a, b, q0) == Sign::kNegative &&
           orient2d(q0, a, b) == Sign::kPositive;  // not the long way round
  };
  std::size_t first = 0;
  while (first < n && acute(first)) ++first;
  const bool closed = first == n;
  std::rotate(spokes.begin(), spokes.begin() + static_cast<std::ptrdiff_t>((first + 1) % n),
              spokes.end());
  Cluster cluster{q0, {}, closed};
  for (std::size_t i = 0; i < n; ++i) {
    cluster.spokes.push_back(spokes[i]);
    if (i + 1 < n && acute(i)) continue;
    if (cluster.spokes.size() > 1) clusters->push_back(cluster);
    cluster.spokes.clear();
  }
}

std::vector<Cluster> clusters_of(const Complex& complex) {
  std::vector<std::vector<Spoke>> at(complex.vertices.size());
  for (std::uint32_t s = 0; s < complex.segments.size(); ++s) {
    for (int end = 0; end < 2; ++end) {
      const std::uint32_t far = complex.segments[s][1 - end];
      at[complex.segments[s][end]].push_back({s, end, xy(complex.vertices[far])});
    }
  }
  std::vector<Cluster> clusters;
  for (std::size_t v = 0; v < at.size(); ++v) {
    append_clusters(xy(complex.vertices[v]), std::move(at[v]), &clusters);
  }
  return clusters;
}

class EqualDivision {
 public:
  explicit EqualDivision(const Complex& complex) : clusters_(clusters_of(complex)) {
    const std::size_t n = complex.segments.size();
    length_.resize(n);
    for (std::size_t s = 0; s < n; ++s) {
      length_[s] = distance(xy(complex.vertices[complex.segments[s][0]]),
                            xy(complex.vertices[complex.segments[s][1]]));
    }
    in_cluster_.resize(n, {false, false});
    piece_.resize(n, {0, 0});
    divisions_.resize(n);
    for (const Cluster& c : clusters_) {
      for (const Spoke& s : c.spokes) in_cluster_[s.segment][s.end] = true;
    }
  }

  std::vector<std::vector<Division>> divide() {
    for (const Cluster& c : clusters_) make_equal(c);
    for (std::uint32_t s = 0; s < length_.size(); ++s) divide_segment(s);
    for (const Cluster& c : clusters_) align(c);
    return std::move(divisions_);
  }

 private:
  /// Part 1: the length of the piece at this end, where the segment is not to stay as it is.
  void make_equal(const Cluster& c) {
    double shortest = HUGE_VAL;
    bool equal = true;
    for (const Spoke& s : c.spokes) {
      equal = equal && equal_modulo_powers_of_two(length_[s.segment], length_[c.spokes[0].segment]);
      shortest = std::min(shortest, room(s.segment));
    }
    if (equal) return;
    const bool crumbs = std::any_of(c.spokes.begin(), c.spokes.end(), [&](const Spoke& s) {
      return room(s.segment) < 1.25 * shortest && room(s.segment) > kLengthSlack * shortest;
    });
    const double d = crumbs ? 0.5 * shortest : shortest;
    for (const Spoke& s : c.spokes) {
      if (!equal_modulo_powers_of_two(length_[s.segment], d)) piece_[s.segment][s.end] = d;
    }
  }
  double room(std::uint32_t s) const {
    return in_cluster_[s][0] && in_cluster_[s][1] ? 0.5 * length_[s] : length_[s];
  }

  /// Part 2.
  void divide_segment(std::uint32_t s) {
    auto& piece = piece_[s];
    if (piece[0] == 0 && piece[1] == 0) return;
    for (int end = 0; end < 2; ++end) {
      if (piece[end] == 0 && in_cluster_[s][end]) piece[end] = 0.5 * length_[s];
    }
    if (piece[0] > 0) divisions_[s].push_back({0, piece[0]});
    // Both at half the length: one point.
    if (piece[1] > 0 && (piece[0] + piece[1]) * kLengthSlack < length_[s]) {
      divisions_[s].push_back({1, piece[1]});
    }
  }

  double from_end(std::uint32_t s, int end, const Division& d) const {
    return d.end == end ? d.distance : length_[s] - d.distance;
  }

  /// Part 3, in the order of the distance from q0. A point that is made is looked at like those
  /// that were there: so one distance goes from neighbor to neighbor.
  void align(const Cluster& c) {
    struct Radius {
      double r;
      std::ptrdiff_t spoke;
    };
    std::vector<Radius> radii;
    const auto n = static_cast<std::ptrdiff_t>(c.spokes.size());
    const auto spoke = [&](std::ptrdiff_t i) { return c.spokes[static_cast<std::size_t>(i)]; };
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const Spoke s = spoke(i);
      for (const Division& d : divisions_[s.segment]) {
        radii.push_back({from_end(s.segment, s.end, d), i});
      }
      radii.push_back({length_[s.segment], i});
    }
    std::sort(radii.begin(), radii.end(), [](const Radius& x, const Radius& y) {
      return x.r != y.r ? x.r < y.r : x.spoke < y.spoke;
    });
    std::vector<Radius> waiting;
    for (const Radius& first : radii) {
      waiting.push_back(first);
      while (!waiting.empty()) {
        const Radius x = waiting.back();
        waiting.pop_back();
        for (std::ptrdiff_t step = 1; step < n && step <= kWindow; ++step) {
          for (std::ptrdiff_t j : {x.spoke - step, x.spoke + step}) {
            if (c.closed) j = (j + n) % n;
            if (j < 0 || j >= n || j == x.spoke) continue;
            if (align(c.q0, spoke(x.spoke), x.r, spoke(j))) waiting.push_back({x.r, j});
          }
        }
      }
    }
  }

  /// Splits the piece of t that has r strictly inside, if the point of s at distance r lies in its
  /// disk; but for the pieces at the ends of t that are equal to others.
  bool align(const Point2& q0, const Spoke& s, double r, const Spoke& t) {
    const double length = length_[t.segment];
    if (r >= length) return false;
    const Division made{t.end, r};
    auto& divisions = divisions_[t.segment];
    const auto after =
        std::partition_point(divisions.begin(), divisions.end(), [&](const Division& d) {
          return from_end(t.segment, 0, d) <= from_end(t.segment, 0, made);
        });
    const double before_r = after == divisions.begin() ? (t.end == 0 ? 0 : length)
                                                       : from_end(t.segment, t.end, *(after - 1));
    const double after_r =
        after == divisions.end() ? (t.end == 0 ? length : 0) : from_end(t.segment, t.end, *after);
    const double a = std::min(before_r, after_r), b = std::max(before_r, after_r);  // the piece
    if (a == 0 || (b == length && in_cluster_[t.segment][1 - t.end])) return false;
    if (r < kLengthSlack * a || b < kLengthSlack * r) return false;
    const double ux = s.tip.x - q0.x, uy = s.tip.y - q0.y, vx = t.tip.x - q0.x, vy = t.tip.y - q0.y;
    const double product = length_[s.segment] * length;
    const double cosine = (ux * vx + uy * vy) / product, sine = (ux * vy - uy * vx) / product;
    if (!(cosine > 0)) return false;
    const double versine = sine * sine / (1 + cosine);  // 1 - cosine
    if (!((r - a) * (b - r) > r * (a + b) * versine)) return false;
    divisions.insert(after, made);
    return true;
  }

  std::vector<Cluster> clusters_;
  std::vector<double> length_;                   // by segment
  std::vector<std::array<bool, 2>> in_cluster_;  // by segment and end
  std::vector<std::array<double, 2>> piece_;     // the same; 0: as it is
  std::vector<std::vector<Division>> divisions_;
};

class SplitAtEqualLengths final : public Stage {
 public:
  SplitAtEqualLengths() : Stage("1", "Split adjacent segments at equal lengths") {}

  void begin(Workspace& w) override { divisions_ = equal_division(w.live.complex()); }

  bool advance(Workspace& w, Budget& budget) override {
    for (; segment_ < divisions_.size(); ++segment_, next_ = 0) {
      if (next_ == 0) rest_ = SubsegmentId(segment_);
      if (next_ == 0 && !w.live.subsegment(rest_).alive) continue;  // given twice
      for (; next_ < divisions_[segment_].size(); ++next_) {
        if (!budget.spend() || !w.within_limits()) return false;
        const auto halves =
            split_at(w, rest_, place(w, divisions_[segment_][next_]), Reason::kEqualLength);
        if (halves) rest_ = (*halves)[1];
      }
    }
    return true;
  }

 private:
  /// Rounded: within a few ulp of the larger end in each coordinate.
  Point2 place(const Workspace& w, const Division& d) const {
    const auto& ends = w.live.complex().segments[segment_];
    const Delaunay2& dt = w.live.triangulation();
    const Point2 p = dt.point(VertexId(ends[d.end])), q = dt.point(VertexId(ends[1 - d.end]));
    const double t = d.distance / distance(p, q);
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

  std::vector<std::vector<Division>> divisions_;
  std::uint32_t segment_ = 0;  // what is split next
  std::size_t next_ = 0;
  SubsegmentId rest_;
};

}  // namespace

bool equal_modulo_powers_of_two(double a, double b) {
  double ratio = a > b ? a / b : b / a;
  while (ratio > 2) ratio *= 0.5;
  return ratio <= kLengthSlack || ratio * kLengthSlack >= 2;
}

std::vector<std::vector<Division>> equal_division(const Complex& complex) {
  return EqualDivision(complex).divide();
}

std::unique_ptr<Stage> split_at_equal_lengths() { return std::make_unique<SplitAtEqualLengths>(); }

}  // namespace circumball
