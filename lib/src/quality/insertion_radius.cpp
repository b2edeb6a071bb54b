#include "quality/insertion_radius.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "complex/box_tree.h"

namespace circumball {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance2(const Point2& p, const Point2& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

/// Points halved at the median along the longer side of their box, each part with the lowest number
/// in it: parts that hold later points only are left out of a search.
class NumberedTree {
 public:
  explicit NumberedTree(const std::vector<Point2>& points) : points_(points) {
    items_.resize(points.size());
    std::iota(items_.begin(), items_.end(), 0u);
    if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
  }

  std::uint32_t nearest_before(std::uint32_t q) const {
    const Point2& p = points_[q];
    std::uint32_t nearest = kNoIndex;
    double best2 = kInfinity;
    struct Waiting {
      std::uint32_t node;
      double bound2;
    };
    Waiting stack[80];  // two a level of a halving tree over at most 2^32 points
    int top = 0;
    stack[top++] = {0, 0};
    while (top > 0) {
      const Waiting w = stack[--top];
      if (w.bound2 > best2) continue;
      const Node& node = nodes_[w.node];
      if (node.lowest >= q) continue;
      if (node.count == 0) {
        const Waiting first{w.node + 1, nodes_[w.node + 1].box.distance2(p)};
        const Waiting second{node.link, nodes_[node.link].box.distance2(p)};
        const bool in_order = first.bound2 <= second.bound2;
        stack[top++] = in_order ? second : first;
        stack[top++] = in_order ? first : second;
        continue;
      }
      for (std::uint32_t i = node.link; i < node.link + node.count && items_[i] < q; ++i) {
        const double d2 = distance2(p, points_[items_[i]]);
        if (d2 < best2 || (d2 == best2 && items_[i] < nearest)) {
          best2 = d2;
          nearest = items_[i];
        }
      }
    }
    return nearest;
  }

 private:
  static constexpr std::uint32_t kLeafSize = 8;
  struct Node {
    Box2 box;
    std::uint32_t lowest;
    std::uint32_t link;   // leaf: first of its points; else: second child (the first follows)
    std::uint32_t count;  // leaf: how many points; else 0
  };

  void build(std::uint32_t first, std::uint32_t last) {
    const std::size_t me = nodes_.size();
    Node node{Box2::of(points_[items_[first]]), items_[first], first, last - first};
    for (std::uint32_t i = first + 1; i < last; ++i) {
      node.box.extend(Box2::of(points_[items_[i]]));
      node.lowest = std::min(node.lowest, items_[i]);
    }
    nodes_.push_back(node);
    if (last - first <= kLeafSize) {
      std::sort(items_.begin() + first, items_.begin() + last);
      return;
    }
    const bool along_x = node.box.hi_x - node.box.lo_x >= node.box.hi_y - node.box.lo_y;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double u = along_x ? points_[a].x : points_[a].y;
                       const double v = along_x ? points_[b].x : points_[b].y;
                       return u != v ? u < v : a < b;
                     });
    build(first, middle);
    nodes_[me].link = static_cast<std::uint32_t>(nodes_.size());
    nodes_[me].count = 0;
    build(middle, last);
  }

  const std::vector<Point2>& points_;
  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::uint32_t> nearest_of_lower_number(const std::vector<Point2>& points) {
  const NumberedTree tree(points);
  std::vector<std::uint32_t> nearest(points.size(), kNoIndex);
  for (std::uint32_t q = 1; q < points.size(); ++q) nearest[q] = tree.nearest_before(q);
  return nearest;
}

std::vector<double> insertion_radii(const std::vector<Point2>& points) {
  const std::vector<std::uint32_t> nearest = nearest_of_lower_number(points);
  std::vector<double> radii(points.size(), kInfinity);
  for (std::size_t q = 1; q < points.size(); ++q)
    radii[q] = std::sqrt(distance2(points[q], points[nearest[q]]));
  return radii;
}

}  // namespace circumball
