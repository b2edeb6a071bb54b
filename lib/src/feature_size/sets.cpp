#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/feature_table.h"
#include "feature_size/piece.h"

// Feature sizes of sets: the infimum over pieces, by looking at features in the order of their
// distance from the piece.
namespace circumball {
namespace {

using Table = FeatureSizes::Table;
using Item = Table::Item;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Finds the least ball over some pieces, one after the other.
class Infimum {
 public:
  /// `sizes` answers at points; of disjoint features, or of any two.
  Infimum(const FeatureSizes& sizes, const Table& table, bool disjoint, int i)
      : sizes_(sizes), table_(table), items_(table.items(i)), disjoint_(disjoint), i_(i) {}

  void include(const Point2& x) { take(at_point(x)); }

  /// A feature nearer to the piece than the ball found so far is paired with each nearer one.
  /// Where that becomes much work (long pieces across many features) the piece is halved: lfs and
  /// mfs are Lipschitz with constant 1, so that most of the smaller pieces need not be looked at.
  void include(const Piece& piece, int depth = 0) {
    std::vector<Near> nearer;
    int pairs = 0;
    bool too_much = false;
    table_.tree(i_).nearest_by(
        [&](const Box2& box) { return box_bound2(piece, box); },
        [&](std::uint32_t f) { return approach(table_, piece, items_[f]).distance2; },
        [&](std::uint32_t f, double d2) {
          if (!(d2 < best2_)) return false;
          const Near near{f, approach(table_, piece, items_[f])};
          if (!(disjoint_ && shares_the_hub(nearer, items_[f]))) {
            for (const Near& other : nearer) {
              if (disjoint_ && !Table::disjoint(items_[f], items_[other.item])) continue;
              pair(piece, other, near);
              if (++pairs > kManyPairs && depth < kMaxDepth) too_much = true;
            }
          }
          nearer.push_back(near);
          return !too_much;
        });
    if (!too_much) return;
    const Point2 middle = piece.at(0.5);
    include_unless_far({piece.a, middle}, depth + 1);
    include_unless_far({middle, piece.b}, depth + 1);
  }

  FeatureBall result(const Point2& somewhere) const {
    FeatureBall ball = best_;
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

  FeatureBall at_point(const Point2& x) const {
    return disjoint_ ? sizes_.local(x, i_) : sizes_.mesh(x, i_);
  }
  void take(const FeatureBall& ball) {
    if (!(ball.radius < best_.radius)) return;
    best_ = ball;
    best2_ = ball.radius * ball.radius;
  }
  void include_unless_far(const Piece& piece, int depth) {
    const FeatureBall ball = at_point(piece.at(0.5));
    take(ball);
    const double dx = piece.b.x - piece.a.x, dy = piece.b.y - piece.a.y;
    if (ball.radius - 0.5 * std::sqrt(dx * dx + dy * dy) < best_.radius) include(piece, depth);
  }
  void pair(const Piece& piece, const Near& f, const Near& g) {
    const Approach least =
        least_larger(table_, piece, items_[f.item], f.approach, items_[g.item], g.approach);
    if (!(least.distance2 < best2_)) return;
    const Point2 x = piece.at(least.t);
    const Item *nearer = &items_[f.item], *farther = &items_[g.item];
    if (table_.distance2(x, *farther) < table_.distance2(x, *nearer)) std::swap(nearer, farther);
    best2_ = least.distance2;
    best_ = table_.ball(x, *nearer, *farther, best2_);
  }
  /// The end segments of a hub of many: four items that meet pairwise have a point in common, and
  /// if all have it there is no pair in it.
  bool shares_the_hub(const std::vector<Near>& nearer, const Item& item) {
    if (nearer.size() < 4) {
      hub_ = kNoIndex;
      return false;
    }
    const auto has = [&](const Near& n, std::uint32_t p) {
      return items_[n.item].a == p || items_[n.item].b == p;
    };
    if (nearer.size() == 4) {
      const Item& first = items_[nearer[0].item];
      for (const std::uint32_t p : {first.a, first.b})
        if (has(nearer[1], p) && has(nearer[2], p) && has(nearer[3], p)) hub_ = p;
    }
    if (hub_ == kNoIndex) return false;
    if (item.a == hub_ || item.b == hub_) return true;
    hub_ = kNoIndex;  // not all of them have it any more
    return false;
  }

  const FeatureSizes& sizes_;
  const Table& table_;
  const std::vector<Item>& items_;
  const bool disjoint_;
  const int i_;
  FeatureBall best_;
  double best2_ = kInfinity;
  std::uint32_t hub_ = kNoIndex;
};

FeatureBall infimum(const FeatureSizes& sizes, const Table& table, bool disjoint,
                    const std::vector<Point2>& polyline, int i) {
  Infimum least(sizes, table, disjoint, i);
  if (polyline.size() == 1) least.include(polyline[0]);
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    if (Table::measurable(polyline[k]) && Table::measurable(polyline[k + 1]))
      least.include(Piece{polyline[k], polyline[k + 1]});
  }
  return least.result(polyline.empty() ? Point2() : polyline[0]);
}

/// Over all pairs of features, the least over the piece of the farther of the two.
FeatureBall by_brute_force(const Table& table, bool disjoint, const Piece& piece, int i) {
  const std::vector<Item>& items = table.items(i);
  double best2 = kInfinity;
  FeatureBall best;
  best.center = piece.a;
  for (std::size_t f = 0; f < items.size(); ++f) {
    const Approach nearest_f = approach(table, piece, items[f]);
    for (std::size_t g = 0; g < f; ++g) {
      if (disjoint && !Table::disjoint(items[f], items[g])) continue;
      const Approach least = least_larger(table, piece, items[f], nearest_f, items[g],
                                          approach(table, piece, items[g]));
      if (!(least.distance2 < best2)) continue;
      best2 = least.distance2;
      const Point2 x = piece.at(least.t);
      const bool f_first = table.distance2(x, items[f]) < table.distance2(x, items[g]);
      best = table.ball(x, items[f_first ? f : g], items[f_first ? g : f], best2);
    }
  }
  return best;
}

}  // namespace

FeatureBall FeatureSizes::local(const std::vector<Point2>& polyline, int i) const {
  return infimum(*this, *table_, true, polyline, i);
}
FeatureBall FeatureSizes::mesh(const std::vector<Point2>& polyline, int i) const {
  return infimum(*this, *table_, false, polyline, i);
}
FeatureBall FeatureSizes::local(const Point2& a, const Point2& b, int i) const {
  return local({a, b}, i);
}
FeatureBall FeatureSizes::mesh(const Point2& a, const Point2& b, int i) const {
  return mesh({a, b}, i);
}

FeatureBall FeatureSizes::local_by_brute_force(const Point2& a, const Point2& b, int i) const {
  return by_brute_force(*table_, true, {a, b}, i);
}
FeatureBall FeatureSizes::mesh_by_brute_force(const Point2& a, const Point2& b, int i) const {
  return by_brute_force(*table_, false, {a, b}, i);
}

}  // namespace circumball
