#ifndef CIRCUMBALL_FEATURE_SIZE_BY_DEFINITION_H_
#define CIRCUMBALL_FEATURE_SIZE_BY_DEFINITION_H_

#include <limits>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/feature_table.h"
#include "feature_size/piece.h"

// Feature sizes word for word from the definition: over all features, or all pairs of them.
namespace circumball::by_definition {

template <class Point>
BasicFeatureBall<Point> none_at(const Point& x) {
  BasicFeatureBall<Point> none;
  none.center = x;
  return none;
}

template <class Point>
BasicFeatureBall<Point> local(const FeatureTable<Point>& table, const Point& x, int i) {
  using Item = typename FeatureTable<Point>::Item;
  const std::vector<Item>& items = table.items(i);
  double best2 = std::numeric_limits<double>::infinity();
  const Item *nearer = nullptr, *farther = nullptr;
  for (const Item& f : items) {
    const double f2 = table.distance2(x, f);
    if (!(f2 < best2)) continue;
    for (const Item& g : items) {
      if (!table.disjoint(f, g)) continue;
      const double g2 = table.distance2(x, g);
      if (g2 < f2 || g2 >= best2) continue;  // f is the nearer one
      best2 = g2;
      nearer = &f;
      farther = &g;
    }
  }
  if (nearer == nullptr) return none_at(x);
  return ball_at(table, x, *nearer, *farther, best2);
}

template <class Point>
BasicFeatureBall<Point> mesh(const FeatureTable<Point>& table, const Point& x, int i) {
  using Item = typename FeatureTable<Point>::Item;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double first2 = kInfinity, second2 = kInfinity;
  const Item *first = nullptr, *second = nullptr;
  for (const Item& item : table.items(i)) {
    const double d2 = table.distance2(x, item);
    if (d2 < first2) {
      if (first != nullptr && !table.same(item, *first)) {
        second2 = first2;
        second = first;
      }
      first2 = d2;
      first = &item;
    } else if (d2 < second2 && first != nullptr && !table.same(item, *first)) {
      second2 = d2;
      second = &item;
    }
  }
  if (second == nullptr) return none_at(x);
  return ball_at(table, x, *first, *second, second2);
}

/// Over all pairs of features, the least over the piece of the farther of the two.
template <class Point>
BasicFeatureBall<Point> of_piece(const FeatureTable<Point>& table, bool disjoint,
                                 const Piece<Point>& piece, int i) {
  using Item = typename FeatureTable<Point>::Item;
  const std::vector<Item>& items = table.items(i);
  double best2 = std::numeric_limits<double>::infinity();
  BasicFeatureBall<Point> best = none_at(piece.a);
  for (std::size_t f = 0; f < items.size(); ++f) {
    const Approach nearest_f = table.approach(piece, items[f]);
    for (std::size_t g = 0; g < f; ++g) {
      if (disjoint ? !table.disjoint(items[f], items[g]) : table.same(items[f], items[g])) continue;
      const Approach least = least_larger(table, piece, items[f], nearest_f, items[g],
                                          table.approach(piece, items[g]));
      if (!(least.distance2 < best2)) continue;
      best2 = least.distance2;
      const Point x = piece.at(least.t);
      const bool f_first = table.distance2(x, items[f]) < table.distance2(x, items[g]);
      best = ball_at(table, x, items[f_first ? f : g], items[f_first ? g : f], best2);
    }
  }
  return best;
}

}  // namespace circumball::by_definition

#endif  // CIRCUMBALL_FEATURE_SIZE_BY_DEFINITION_H_
