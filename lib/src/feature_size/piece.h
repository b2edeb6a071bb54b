#ifndef CIRCUMBALL_FEATURE_SIZE_PIECE_H_
#define CIRCUMBALL_FEATURE_SIZE_PIECE_H_

#include "feature_size/feature_table.h"

namespace circumball {

/// The points p(t) = a + t (b - a), 0 <= t <= 1, rounded.
struct Piece {
  Point2 a, b;

  Point2 at(double t) const {
    if (t <= 0) return a;
    if (t >= 1) return b;
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  }
};

/// Where on a piece an item is nearest, and how near.
struct Approach {
  double t, distance2;
};
Approach approach(const FeatureSizes::Table& table, const Piece& piece,
                  const FeatureSizes::Table::Item& item);

/// Where on a piece the larger of the distances to two items is least.
///
/// Both squared distances are convex functions of t, for their items are convex; so is the larger
/// of the two. Let t_f and t_g be where each is least. If f is not nearer than g at t_f, then the
/// larger of the two is nowhere less than it is there: that is the minimum. Likewise at t_g.
/// Otherwise, from t_f to t_g, the distance to f increases from below that to g, which decreases:
/// the minimum is where they are equal. That is found by bisection down to neighboring points, in
/// which nothing can cancel, whatever the pieces of the two functions are.
Approach least_larger(const FeatureSizes::Table& table, const Piece& piece,
                      const FeatureSizes::Table::Item& f, const Approach& nearest_f,
                      const FeatureSizes::Table::Item& g, const Approach& nearest_g);

/// A lower bound of the squared distance of a box from a piece: along the axes and across the
/// piece.
double box_bound2(const Piece& piece, const Box2& box);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_PIECE_H_
