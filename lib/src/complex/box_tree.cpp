#include "complex/box_tree.h"

#include <numeric>

namespace circumball {

template <class Box>
BoxTreeOf<Box>::BoxTreeOf(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  items_.resize(boxes_.size());
  std::iota(items_.begin(), items_.end(), 0u);
  nodes_.reserve(boxes_.size() / 2 + 2);
  build(0, static_cast<std::uint32_t>(items_.size()));
}

template <class Box>
void BoxTreeOf<Box>::build(std::uint32_t first, std::uint32_t last) {
  const std::uint32_t me = static_cast<std::uint32_t>(nodes_.size());
  Box box = boxes_[items_[first]];
  for (std::uint32_t i = first + 1; i < last; ++i) box.extend(boxes_[items_[i]]);
  nodes_.push_back({box, first, last - first});
  if (last - first <= kLeafSize) {
    std::sort(items_.begin() + first, items_.begin() + last);
    return;
  }
  const int axis = box.longest_axis();
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double u = boxes_[a].middle2(axis), v = boxes_[b].middle2(axis);
                     return u != v ? u < v : a < b;  // a total order: the halves are unique
                   });
  build(first, middle);
  const std::uint32_t second = static_cast<std::uint32_t>(nodes_.size());
  build(middle, last);
  nodes_[me].link = second;
  nodes_[me].count = 0;
}

template class BoxTreeOf<Box2>;
template class BoxTreeOf<Box3>;

}  // namespace circumball
