#ifndef CIRCUMBALL_FEATURE_SIZE_INFIMUM_H_
#define CIRCUMBALL_FEATURE_SIZE_INFIMUM_H_

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/common_points.h"
#include "feature_size/feature_table.h"
#include "feature_size/piece.h"

// Feature sizes of sets: the infimum over pieces, by looking at features in the order of their
// distance from the piece.
namespace circumball {

/// Finds the least ball over some pieces, one after the other.
template <class Point>
class Infimum {
 public:
  using Table = FeatureTable<Point>;
  using Item = typename Table::Item;
  using Ball = BasicFeatureBall<Point>;

  /// `sizes` answers at points; of disjoint features, or of any two.
  Infimum(const BasicFeatureSizes<Point>& sizes, const Table& table, bool disjoint, int i)
      : sizes_(sizes), table_(table), items_(table.items(i)), disjoint_(disjoint), i_(i) {}

  void include(const Point& x) { take(at_point(x)); }

  /// A feature nearer to the piece than the ball found so far is paired with each nearer one.
  /// Where that becomes much work (long pieces across many features) the piece is halved: lfs and
  /// mfs are Lipschitz with constant 1, so that most of the smaller pieces need not be looked at.
  void include(const Piece<Point>& piece, int depth = 0) {
    std::vector<Near> nearer;
    CommonPoints common;
    int pairs = 0;
    bool too_much = false;
    table_.tree(i_).nearest_by(
        [&](const typename Table::Box& box) { return box_bound2(piece, box); },
        [&](std::uint32_t f) { return table_.approach(piece, items_[f]).distance2; },
        [&](std::uint32_t f, double d2) {
          if (!(d2 < best2_)) return false;
          const Near near{f, table_.approach(piece, items_[f])};
          if (!disjoint_ || common.add(table_.points_of(items_[f]))) {
            for (const Near& other : nearer) {
              if (!paired(items_[f], items_[other.item])) continue;
              pair(piece, other, near);
              if (++pairs > kManyPairs && depth < kMaxDepth) too_much = true;
            }
          }
          nearer.push_back(near);
          return !too_much;
        });
    if (!too_much) return;
    const Point middle = piece.at(0.5);
    include_unless_far({piece.a, middle}, depth + 1);
    include_unless_far({middle, piece.b}, depth + 1);
  }

  Ball result(const Point& somewhere) const {
    Ball ball = best_;
    if (!ball.found()) ball.center = somewhere;
    return ball;
  }

 private:
  /// Pairs looked at before a piece is halved; and how often: then it is as short as rounding.
  static constexpr int kManyPairs = 1000;
  static constexpr int kMaxDepth = 60;

  struct Near {
    std::uint32_t item;
    Approach approach;
  };

  bool paired(const Item& f, const Item& g) const {
    return disjoint_ ? table_.disjoint(f, g) : !Table::same(f, g);
  }
  Ball at_point(const Point& x) const {
    return disjoint_ ? sizes_.local(x, i_) : sizes_.mesh(x, i_);
  }
  void take(const Ball& ball) {
    if (!(ball.radius < best_.radius)) return;
    best_ = ball;
    best2_ = ball.radius * ball.radius;
  }
  void include_unless_far(const Piece<Point>& piece, int depth) {
    const Ball ball = at_point(piece.at(0.5));
    take(ball);
    const Point d = piece.b - piece.a;
    if (ball.radius - 0.5 * std::sqrt(dot(d, d)) < best_.radius) include(piece, depth);
  }
  void pair(const Piece<Point>& piece, const Near& f, const Near& g) {
    const Approach least =
        least_larger(table_, piece, items_[f.item], f.approach, items_[g.item], g.approach);
    if (!(least.distance2 < best2_)) return;
    const Point x = piece.at(least.t);
    const Item *nearer = &items_[f.item], *farther = &items_[g.item];
    if (table_.distance2(x, *farther) < table_.distance2(x, *nearer)) std::swap(nearer, farther);
    best2_ = least.distance2;
    best_ = ball_at(table_, x, *nearer, *farther, best2_);
  }

  const BasicFeatureSizes<Point>& sizes_;
  const Table& table_;
  const std::vector<Item>& items_;
  const bool disjoint_;
  const int i_;
  Ball best_;
  double best2_ = std::numeric_limits<double>::infinity();
};

/// Of a polyline; of one point: of the point; of none: infinite.
template <class Point>
BasicFeatureBall<Point> infimum(const BasicFeatureSizes<Point>& sizes,
                                const FeatureTable<Point>& table, bool disjoint,
                                const std::vector<Point>& polyline, int i) {
  Infimum<Point> least(sizes, table, disjoint, i);
  if (polyline.size() == 1) least.include(polyline[0]);
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    if (table.measurable(polyline[k]) && table.measurable(polyline[k + 1]))
      least.include(Piece<Point>{polyline[k], polyline[k + 1]});
  }
  return least.result(polyline.empty() ? Point() : polyline[0]);
}

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_INFIMUM_H_
