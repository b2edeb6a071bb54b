#ifndef CIRCUMBALL_COMPLEX_BOX_TREE_H_
#define CIRCUMBALL_COMPLEX_BOX_TREE_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "circumball/types.h"

namespace circumball {

/// A closed axis-parallel rectangle.
struct Box2 {
  using Point = Point2;
  double lo_x, lo_y, hi_x, hi_y;

  static Box2 of(const Point2& p) { return {p.x, p.y, p.x, p.y}; }
  static Box2 of(const Point2& a, const Point2& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
  }
  void extend(const Box2& o) {
    lo_x = std::min(lo_x, o.lo_x);
    lo_y = std::min(lo_y, o.lo_y);
    hi_x = std::max(hi_x, o.hi_x);
    hi_y = std::max(hi_y, o.hi_y);
  }
  bool meets(const Box2& o) const {
    return lo_x <= o.hi_x && o.lo_x <= hi_x && lo_y <= o.hi_y && o.lo_y <= hi_y;
  }
  /// Squared distance from a point, rounded; 0 inside.
  double distance2(const Point2& p) const {
    const double dx = std::max(std::max(lo_x - p.x, p.x - hi_x), 0.0);
    const double dy = std::max(std::max(lo_y - p.y, p.y - hi_y), 0.0);
    return dx * dx + dy * dy;
  }
  double extent(int axis) const { return axis == 0 ? hi_x - lo_x : hi_y - lo_y; }
  /// Twice the center's coordinate.
  double middle2(int axis) const { return axis == 0 ? lo_x + hi_x : lo_y + hi_y; }
  int longest_axis() const { return extent(0) >= extent(1) ? 0 : 1; }
};

/// A closed axis-parallel box of space.
struct Box3 {
  using Point = Point3;
  double lo_x, lo_y, lo_z, hi_x, hi_y, hi_z;

  static Box3 of(const Point3& p) { return {p.x, p.y, p.z, p.x, p.y, p.z}; }
  static Box3 of(const Point3& a, const Point3& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z),
            std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  }
  static Box3 of(const Point3& a, const Point3& b, const Point3& c) {
    Box3 box = of(a, b);
    box.extend(of(c));
    return box;
  }
  void extend(const Box3& o) {
    lo_x = std::min(lo_x, o.lo_x);
    lo_y = std::min(lo_y, o.lo_y);
    lo_z = std::min(lo_z, o.lo_z);
    hi_x = std::max(hi_x, o.hi_x);
    hi_y = std::max(hi_y, o.hi_y);
    hi_z = std::max(hi_z, o.hi_z);
  }
  /// With a margin on all sides.
  Box3 grown(double by) const {
    return {lo_x - by, lo_y - by, lo_z - by, hi_x + by, hi_y + by, hi_z + by};
  }
  bool meets(const Box3& o) const {
    return lo_x <= o.hi_x && o.lo_x <= hi_x && lo_y <= o.hi_y && o.lo_y <= hi_y && lo_z <= o.hi_z &&
           o.lo_z <= hi_z;
  }
  /// Squared distance from a point, rounded; 0 inside.
  double distance2(const Point3& p) const {
    const double dx = std::max(std::max(lo_x - p.x, p.x - hi_x), 0.0);
    const double dy = std::max(std::max(lo_y - p.y, p.y - hi_y), 0.0);
    const double dz = std::max(std::max(lo_z - p.z, p.z - hi_z), 0.0);
    return dx * dx + dy * dy + dz * dz;
  }
  double extent(int axis) const {
    return axis == 0 ? hi_x - lo_x : axis == 1 ? hi_y - lo_y : hi_z - lo_z;
  }
  /// Twice the center's coordinate.
  double middle2(int axis) const {
    return axis == 0 ? lo_x + hi_x : axis == 1 ? lo_y + hi_y : lo_z + hi_z;
  }
  int longest_axis() const {
    const int axis = extent(0) >= extent(1) ? 0 : 1;
    return extent(axis) >= extent(2) ? axis : 2;
  }
};

/// A static tree of bounding boxes: items are split at the median of their centers along the
/// longest side, so that its depth is logarithmic whatever the input, clusters and equal boxes
/// included. Linear memory. Queries filter only: what decides is the caller's exact test at the
/// items. `Box` is Box2 or Box3.
template <class Box>
class BoxTreeOf {
 public:
  using Point = typename Box::Point;

  BoxTreeOf() = default;
  /// One box for each item; items are named by their place in `boxes`. O(n log n).
  explicit BoxTreeOf(std::vector<Box> boxes);

  std::size_t size() const { return boxes_.size(); }
  const Box& box(std::uint32_t item) const { return boxes_[item]; }

  /// Calls visit(item) for the items of all leaves that can be reached through boxes for which
  /// enter(box) is true, until it returns false. Items of such leaves whose own box is not entered
  /// are left out.
  template <class Enter, class Visit>
  void query(Enter enter, Visit visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[kMaxDepth];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const std::uint32_t at = stack[--top];
      const Node& node = nodes_[at];
      if (!enter(node.box)) continue;
      if (node.count > 0) {
        for (std::uint32_t i = 0; i < node.count; ++i) {
          const std::uint32_t item = items_[node.link + i];
          if (enter(boxes_[item]) && !visit(item)) return;
        }
      } else {
        stack[top++] = node.link;
        stack[top++] = at + 1;
      }
    }
  }

  /// Calls visit(item, squared distance) in the order of distance(item) (squared), until it returns
  /// false; equal distances in the order of items. `distance` must not be less than the distance of
  /// the item's box.
  template <class Distance, class Visit>
  void nearest(const Point& p, Distance distance, Visit visit) const {
    nearest_by([&](const Box& box) { return box.distance2(p); }, distance, visit);
  }

  /// The same for any distance: bound(box) is at most distance(item) for each item in the box.
  template <class Bound, class Distance, class Visit>
  void nearest_by(Bound bound, Distance distance, Visit visit) const {
    if (nodes_.empty()) return;
    std::priority_queue<Candidate, std::vector<Candidate>, Later> queue;
    queue.push({bound(nodes_[0].box), false, 0});
    while (!queue.empty()) {
      const Candidate c = queue.top();
      queue.pop();
      if (c.is_item) {
        if (!visit(c.index, c.distance2)) return;
        continue;
      }
      const Node& node = nodes_[c.index];
      if (node.count > 0) {
        for (std::uint32_t i = 0; i < node.count; ++i) {
          const std::uint32_t item = items_[node.link + i];
          queue.push({distance(item), true, item});
        }
      } else {
        queue.push({bound(nodes_[c.index + 1].box), false, c.index + 1});
        queue.push({bound(nodes_[node.link].box), false, node.link});
      }
    }
  }

 private:
  static constexpr std::uint32_t kLeafSize = 6;
  static constexpr int kMaxDepth = 80;  // two a level of a halving tree over at most 2^32 items
  struct Node {
    Box box;
    std::uint32_t link;   // leaf: first of its items in items_; else: second child (the first
                          // follows the node)
    std::uint32_t count;  // leaf: number of items; else 0
  };
  struct Candidate {
    double distance2;
    bool is_item;
    std::uint32_t index;
  };
  struct Later {  // nodes before items at equal distance, so that ties come out in the order of
                  // items
    bool operator()(const Candidate& a, const Candidate& b) const {
      if (a.distance2 != b.distance2) return a.distance2 > b.distance2;
      if (a.is_item != b.is_item) return a.is_item;
      return a.index > b.index;
    }
  };
  void build(std::uint32_t first, std::uint32_t last);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

extern template class BoxTreeOf<Box2>;
extern template class BoxTreeOf<Box3>;
using BoxTree = BoxTreeOf<Box2>;
using BoxTree3 = BoxTreeOf<Box3>;

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_BOX_TREE_H_
