#include <vector>

#include "circumball/feature_size.h"
#include "feature_size/feature_table.h"

namespace circumball {

FeatureSizes::FeatureSizes(const Complex& complex, const Filter& filter)
    : table_(std::make_unique<const Table>(complex, filter)) {}
FeatureSizes::~FeatureSizes() = default;
FeatureSizes::FeatureSizes(FeatureSizes&&) noexcept = default;
FeatureSizes& FeatureSizes::operator=(FeatureSizes&&) noexcept = default;

FeatureBall FeatureSizes::local(const Point2& x, int i) const {
  using Item = Table::Item;
  const Table& table = *table_;
  const std::vector<Item>& items = table.items(i);
  // Items so far: any two of them meet. Four or more that meet pairwise have a point in common
  // (three may be a triangle), so that a next one need not be compared with all of them.
  std::vector<std::uint32_t> nearer;
  FeatureBall result;
  result.center = x;
  if (!Table::measurable(x)) return result;
  table.tree(i).nearest(
      x, [&](std::uint32_t f) { return table.distance2(x, items[f]); },
      [&](std::uint32_t f, double d2) {
        const Item& item = items[f];
        if (nearer.size() >= 4) {
          const Item &g = items[nearer[0]], &h = items[nearer[1]], &k = items[nearer[2]],
                     &l = items[nearer[3]];
          const auto has = [](const Item& it, std::uint32_t p) { return it.a == p || it.b == p; };
          const std::uint32_t hub = has(h, g.a) && has(k, g.a) && has(l, g.a) ? g.a : g.b;
          if (has(item, hub)) {
            nearer.push_back(f);
            return true;
          }
        }
        for (const std::uint32_t g : nearer) {
          if (!Table::disjoint(item, items[g])) continue;
          result = table.ball(x, items[g], item, d2);
          return false;
        }
        nearer.push_back(f);
        return true;
      });
  return result;
}

FeatureBall FeatureSizes::mesh(const Point2& x, int i) const {
  const Table& table = *table_;
  const std::vector<Table::Item>& items = table.items(i);
  std::uint32_t first = kNoIndex;
  FeatureBall result;
  result.center = x;
  if (!Table::measurable(x)) return result;
  table.tree(i).nearest(
      x, [&](std::uint32_t f) { return table.distance2(x, items[f]); },
      [&](std::uint32_t f, double d2) {
        if (first == kNoIndex) {
          first = f;
          return true;
        }
        result = table.ball(x, items[first], items[f], d2);
        return false;
      });
  return result;
}

bool FeatureSizes::is_input_vertex(const Point2& x) const {
  bool found = false;
  table_->vertex_tree.query([&](const Box2& box) { return box.meets(Box2::of(x)); },
                            [&](std::uint32_t) {
                              found = true;
                              return false;
                            });
  return found;
}

FeatureBall FeatureSizes::of_subsegment(const Point2& a, const Point2& b, int i) const {
  return is_input_vertex(a) || is_input_vertex(b) ? local(a, b, i) : mesh(a, b, i);
}

}  // namespace circumball
