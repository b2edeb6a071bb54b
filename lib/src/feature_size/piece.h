#ifndef CIRCUMBALL_FEATURE_SIZE_PIECE_H_
#define CIRCUMBALL_FEATURE_SIZE_PIECE_H_

#include <algorithm>

#include "complex/box_tree.h"
#include "feature_size/vectors.h"

namespace circumball {

/// The points p(t) = a + t (b - a), 0 <= t <= 1, rounded.
template <class Point>
struct Piece {
  Point a, b;

  Point at(double t) const {
    if (t <= 0) return a;
    if (t >= 1) return b;
    return along(a, t, b - a);
  }
};

/// A place on a piece, and how near an item is there.
struct Approach {
  double t, distance2;
};

/// Where on a piece the larger of the distances to two items is least. `Table` is a FeatureTable,
/// `nearest_f` and `nearest_g` are where the piece is nearest to each.
///
/// Both squared distances are convex functions of t, for their items are convex; so is the larger
/// of the two. Let t_f and t_g be where each is least. If f is not nearer than g at t_f, then the
/// larger of the two is nowhere less than it is there: that is the minimum. Likewise at t_g.
/// Otherwise, from t_f to t_g, the distance to f increases from below that to g, which decreases:
/// the minimum is where they are equal. That is found by bisection down to neighboring points, in
/// which nothing can cancel, whatever the pieces of the two functions are.
template <class Table, class Point>
Approach least_larger(const Table& table, const Piece<Point>& piece, const typename Table::Item& f,
                      const Approach& nearest_f, const typename Table::Item& g,
                      const Approach& nearest_g) {
  if (table.distance2(piece.at(nearest_f.t), g) <= nearest_f.distance2) return nearest_f;
  if (table.distance2(piece.at(nearest_g.t), f) <= nearest_g.distance2) return nearest_g;
  double f_nearer = nearest_f.t, g_nearer = nearest_g.t;
  const auto larger = [&](double t) {
    const Point x = piece.at(t);
    return Approach{t, std::max(table.distance2(x, f), table.distance2(x, g))};
  };
  for (;;) {
    const double t = 0.5 * (f_nearer + g_nearer);
    const Point x = piece.at(t);
    if (x == piece.at(f_nearer) || x == piece.at(g_nearer)) break;
    const double f2 = table.distance2(x, f), g2 = table.distance2(x, g);
    if (f2 == g2) return {t, f2};
    (f2 < g2 ? f_nearer : g_nearer) = t;
  }
  const Approach one = larger(f_nearer), other = larger(g_nearer);
  return one.distance2 <= other.distance2 ? one : other;
}

/// A lower bound of the squared distance of a box from a piece: along the axes, and across the
/// piece (in space: beyond the ball around the box).
double box_bound2(const Piece<Point2>& piece, const Box2& box);
double box_bound2(const Piece<Point3>& piece, const Box3& box);

}  // namespace circumball

#endif  // CIRCUMBALL_FEATURE_SIZE_PIECE_H_
