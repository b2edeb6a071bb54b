#include <gtest/gtest.h>

#include "circumball/predicates.h"

namespace circumball::testing {
namespace {

TEST(Counters, ClearCasesPassTheFilterUncounted) {
  reset_predicate_counters();
  orient2d({0, 0}, {1, 0}, {0, 1});
  incircle({0, 0}, {1, 0}, {0, 1}, {3, 3});
  orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  insphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 6, 7});
  in_diametral_ball(Point2{0, 0}, Point2{1, 0}, Point2{3, 1});
  in_diametral_ball(Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{3, 1, 1});
  in_diametral_ball({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 3});
  const AllPredicateCounters c = predicate_counters();
  for (const PredicateCounters& p : {c.orient2d, c.orient3d, c.incircle, c.insphere,
                                     c.segment_ball2, c.segment_ball3, c.triangle_ball}) {
#ifdef CIRCUMBALL_COUNT_FILTER
    EXPECT_EQ(p.filter, 1u);
#else
    EXPECT_EQ(p.filter, 0u);
#endif
    EXPECT_EQ(p.adaptive, 0u);
    EXPECT_EQ(p.exact, 0u);
  }
}

// Zeros of which every product is not zero are never decided by a filter. Coordinates that are
// small integers have exact differences: the adaptive stage. One of them moved by 2^-60, beyond the
// reach of a difference: the exact stage.
TEST(Counters, EveryCallAfterTheFilterCountsOnceInItsStage) {
  const double t = 0x1p-60;
  reset_predicate_counters();
  for (const double e : {0.0, t}) {
    orient2d({e, 0}, {1, 1}, {3, 3});
    incircle({5, e}, {3, 4}, {-4, 3}, {4, -3});
    orient3d({e, 0, 0}, {1, 1, 1}, {1, 2, 3}, {3, 4, 5});
    insphere({5, 0, e}, {3, 4, 0}, {-4, 0, 3}, {0, 4, -3}, {3, 0, -4});
    in_diametral_ball(Point2{5, e}, Point2{-5, 0}, Point2{3, 4});
    in_diametral_ball(Point3{5, 0, e}, Point3{-5, 0, 0}, Point3{3, 0, 4});
    in_diametral_ball({5, 0, e}, {-3, 0, 4}, {-4, 0, 3}, {0, 3, 4});
    const AllPredicateCounters c = predicate_counters();
    int index = 0;
    for (const PredicateCounters& p : {c.orient2d, c.orient3d, c.incircle, c.insphere,
                                       c.segment_ball2, c.segment_ball3, c.triangle_ball}) {
      EXPECT_EQ(p.adaptive, 1u) << index;
      EXPECT_EQ(p.exact, e == 0 ? 0u : 1u) << index;
      ++index;
    }
  }
  reset_predicate_counters();
  EXPECT_EQ(predicate_counters().insphere.adaptive, 0u);
}

}  // namespace
}  // namespace circumball::testing
