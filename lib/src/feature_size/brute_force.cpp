#include <limits>
#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/feature_table.h"

// Feature sizes word for word from the definition: over all features, or all pairs of them.
namespace circumball {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

FeatureBall FeatureSizes::local_by_brute_force(const Point2& x, int i) const {
  const Table& table = *table_;
  const std::vector<Table::Item>& items = table.items(i);
  double best2 = kInfinity;
  const Table::Item *nearer = nullptr, *farther = nullptr;
  for (const Table::Item& f : items) {
    const double f2 = table.distance2(x, f);
    if (!(f2 < best2)) continue;
    for (const Table::Item& g : items) {
      if (!Table::disjoint(f, g)) continue;
      const double g2 = table.distance2(x, g);
      if (g2 < f2 || g2 >= best2) continue;  // f is the nearer one
      best2 = g2;
      nearer = &f;
      farther = &g;
    }
  }
  if (nearer != nullptr) return table.ball(x, *nearer, *farther, best2);
  FeatureBall none;
  none.center = x;
  return none;
}

FeatureBall FeatureSizes::mesh_by_brute_force(const Point2& x, int i) const {
  const Table& table = *table_;
  double first2 = kInfinity, second2 = kInfinity;
  const Table::Item *first = nullptr, *second = nullptr;
  for (const Table::Item& item : table.items(i)) {
    const double d2 = table.distance2(x, item);
    if (d2 < first2) {
      second2 = first2;
      second = first;
      first2 = d2;
      first = &item;
    } else if (d2 < second2) {
      second2 = d2;
      second = &item;
    }
  }
  if (second != nullptr) return table.ball(x, *first, *second, second2);
  FeatureBall none;
  none.center = x;
  return none;
}

}  // namespace circumball
