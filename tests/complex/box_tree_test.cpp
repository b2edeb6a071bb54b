#include "complex/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/complexes.h"

namespace circumball {
namespace {

using testing::Random;

void make(Random* random, double size, Box2* box) {
  const auto x = [&] { return random->unit(); };
  const Point2 p{x(), x()};
  *box = Box2::of(p, {p.x + size * x(), p.y + size * x()});
}
void make(Random* random, double size, Box3* box) {
  const auto x = [&] { return random->unit(); };
  const Point3 p{x(), x(), x()};
  *box = Box3::of(p, {p.x + size * x(), p.y, p.z + size * x()},
                  {p.x, p.y + size * x(), p.z - size * x()});
}
void make(Random* random, Point2* p) { *p = {random->unit(), random->unit()}; }
void make(Random* random, Point3* p) { *p = {random->unit(), random->unit(), random->unit()}; }

template <class Box>
class BoxTreeIn : public ::testing::Test {};
using Boxes = ::testing::Types<Box2, Box3>;
TYPED_TEST_SUITE(BoxTreeIn, Boxes);

TYPED_TEST(BoxTreeIn, VisitsExactlyTheBoxesThatMeetAnother) {
  Random random(1);
  for (const std::uint32_t n : {0u, 1u, 6u, 7u, 500u}) {
    std::vector<TypeParam> boxes(n);
    for (TypeParam& box : boxes) make(&random, 0.1, &box);
    if (n > 20) std::fill(boxes.begin() + 10, boxes.begin() + 20, boxes[9]);  // equal boxes
    const BoxTreeOf<TypeParam> tree(boxes);
    EXPECT_EQ(tree.size(), n);
    for (int k = 0; k < 20; ++k) {
      TypeParam query;
      make(&random, 0.5, &query);
      std::vector<std::uint32_t> found, expected;
      tree.query([&](const TypeParam& box) { return box.meets(query); },
                 [&](std::uint32_t i) {
                   found.push_back(i);
                   return true;
                 });
      std::sort(found.begin(), found.end());
      for (std::uint32_t i = 0; i < n; ++i)
        if (boxes[i].meets(query)) expected.push_back(i);
      EXPECT_EQ(found, expected);
    }
  }
}

TYPED_TEST(BoxTreeIn, VisitsByDistanceAndTiesByNumber) {
  Random random(2);
  std::vector<TypeParam> boxes(300);
  for (TypeParam& box : boxes) make(&random, 0.2, &box);  // many of them hold the point: distance 0
  const BoxTreeOf<TypeParam> tree(boxes);
  for (int k = 0; k < 10; ++k) {
    typename TypeParam::Point p;
    make(&random, &p);
    std::vector<std::pair<double, std::uint32_t>> found, expected;
    tree.nearest(
        p, [&](std::uint32_t i) { return boxes[i].distance2(p); },
        [&](std::uint32_t i, double distance2) {
          found.push_back({distance2, i});
          return true;
        });
    for (std::uint32_t i = 0; i < boxes.size(); ++i) expected.push_back({boxes[i].distance2(p), i});
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace circumball
