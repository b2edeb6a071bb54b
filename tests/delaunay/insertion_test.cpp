// What one insertion does: the probe, the change record, tags and labels.
#include <gtest/gtest.h>

#include <map>

#include "circumball/predicates.h"
#include "delaunay/delaunay2.h"
#include "delaunay/delaunay_check.h"
#include "point_sets.h"

namespace circumball::testing {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge(VertexId a, VertexId b) { return std::minmax(a.value, b.value); }

/// The tags of all edges between vertices.
std::map<Edge, std::uint32_t> tags(const Delaunay2& d) {
  std::map<Edge, std::uint32_t> all;
  for (HalfEdge h = 0; h < 4 * d.slot_count(); ++h) {
    if ((h & 3) == 3 || d.origin(h) == Delaunay2::kGhost || d.target(h) == Delaunay2::kGhost)
      continue;
    all[edge(d.origin(h), d.target(h))] = d.tag(h);
  }
  return all;
}

TEST(Insertion, ProbeChangesNothing) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d = in_a_batch(random_points(kind, 30, 2));
    const auto before = triangles(d);
    Random random(1);
    for (int i = 0; i < 50; ++i) d.probe(random_point(kind, &random), random.below(60));
    EXPECT_EQ(triangles(d), before);
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
  }
}

TEST(Insertion, CavityOfAPointIsTheTrianglesWhoseOpenDiskHoldsIt) {
  for (const Kind kind : {Kind::kRandom, Kind::kLattice, Kind::kCocircular, Kind::kClusters}) {
    Delaunay2 d = in_a_batch(random_points(kind, 50, 8));
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
      const Point2 p = random_point(kind, &random);
      if (d.probe(p, random.below(100)) == Delaunay2::Probe::kDuplicate) continue;
      std::set<TriangleId> expected, cavity;
      d.for_each_triangle([&](TriangleId t) {
        const auto& at = d.triangle(t);
        if (incircle(d.point(at.v[0]), d.point(at.v[1]), d.point(at.v[2]), p) == Sign::kPositive)
          expected.insert(t);
      });
      for (const TriangleId t : d.cavity())
        if (!d.is_ghost(t)) cavity.insert(t);
      EXPECT_EQ(cavity, expected) << name(kind);
    }
  }
}

TEST(Insertion, BoundaryOfTheCavityIsAClosedCounterClockwiseRing) {
  Delaunay2 d = in_a_batch(random_points(Kind::kRandom, 100, 5));
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Point2 p{3 * random.unit() - 1, 0.5};
    ASSERT_EQ(d.probe(p, 0), Delaunay2::Probe::kOk);
    const std::set<TriangleId> cavity(d.cavity().begin(), d.cavity().end());
    const auto& ring = d.cavity_boundary();
    ASSERT_EQ(ring.size(), cavity.size() + 2);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_EQ(d.target(ring[i]), d.origin(ring[(i + 1) % ring.size()]));
      EXPECT_EQ(cavity.count(ring[i] >> 2), 1u);
      EXPECT_EQ(cavity.count(d.twin(ring[i]) >> 2), 0u);
    }
  }
}

TEST(Insertion, TakingBackAVertexThatIsNotInsertedLeavesNoTrace) {
  Delaunay2 d = in_a_batch(random_points(Kind::kRandom, 20, 2));
  const VertexId v = d.add_vertex({0.5, 0.5});
  EXPECT_EQ(d.probe(v, 0), Delaunay2::Probe::kOk);
  d.pop_vertex();
  EXPECT_EQ(d.vertex_count(), 20u);
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
}

TEST(Insertion, ChangeRecordReplaysToTheTriangulation) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d;
    Random random(11);
    std::map<std::uint32_t, Corners> live;  // by birth
    std::uint32_t births = 0;
    for (const Point2& p : random_points(kind, 60, 4)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(100)) == Delaunay2::Probe::kDuplicate) continue;
      const std::size_t dead = d.cavity().size();
      d.commit(v);
      ASSERT_EQ(d.died().size(), dead);
      for (const auto& t : d.died()) {
        const auto it = live.find(t.birth);
        ASSERT_NE(it, live.end());
        ASSERT_EQ(it->second, corners(t));
        live.erase(it);
      }
      for (const TriangleId t : d.born()) {
        EXPECT_EQ(d.triangle(t).birth, births++);
        live[d.triangle(t).birth] = corners(d.triangle(t));
        EXPECT_EQ(d.triangle(t).v[0], v);
      }
      std::multiset<Corners> replayed;
      for (const auto& [birth, c] : live) replayed.insert(c);
      ASSERT_EQ(replayed, triangles(d)) << name(kind);
    }
  }
}

TEST(Insertion, TagsLiveAsLongAsTheirEdges) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d;
    Random random(12);
    for (const Point2& p : random_points(kind, 50, 7)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(100)) == Delaunay2::Probe::kDuplicate) continue;
      const auto before = tags(d);
      std::map<Edge, std::uint32_t> lost;
      for (const HalfEdge h : d.cavity_tagged_inside()) {
        EXPECT_NE(d.tag(h), kNone);
        EXPECT_TRUE(lost.emplace(edge(d.origin(h), d.target(h)), d.tag(h)).second);
      }
      d.commit(v);
      const auto after = tags(d);
      for (const auto& [e, tag] : before) {
        const auto it = after.find(e);
        if (it == after.end()) {
          EXPECT_EQ(lost.count(e), tag == kNone ? 0u : 1u) << name(kind);
        } else {
          EXPECT_EQ(it->second, tag) << name(kind);
          EXPECT_EQ(lost.count(e), 0u);
        }
      }
      for (const auto& [e, tag] : after)
        if (!before.count(e)) {
          EXPECT_EQ(tag, kNone);
        }
      // Tag some edges, and untag some.
      for (HalfEdge h = 0; h < 4 * d.slot_count(); ++h)
        if ((h & 3) != 3 && d.origin(h) != Delaunay2::kGhost && d.target(h) != Delaunay2::kGhost &&
            random.below(4) == 0)
          d.set_tag(h, random.below(3) == 0 ? kNone : random.below(1000));
      std::string why;
      ASSERT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
    }
  }
}

TEST(Insertion, BornTrianglesInheritTheLabelAtTheirOuterEdgeUnlessATagWasSwallowed) {
  for (const Kind kind : kAllKinds) {
    Delaunay2 d;
    Random random(13);
    constexpr std::uint32_t kSplitting = 5;
    int inherited = 0, reset = 0;
    for (const Point2& p : random_points(kind, 60, 7)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(100)) == Delaunay2::Probe::kDuplicate) continue;
      std::map<Edge, std::uint32_t> label;  // by directed outer edge
      for (const HalfEdge h : d.cavity_boundary())
        label[{d.origin(h).value, d.target(h).value}] = d.triangle(h >> 2).label;
      bool swallowed = false;
      for (const HalfEdge h : d.cavity_tagged_inside())
        if (d.tag(h) != kSplitting) swallowed = true;
      const bool at_end = d.cavity().empty();
      d.commit(v, kSplitting);
      for (const TriangleId t : d.born()) {
        const HalfEdge outer = 4 * t;
        ASSERT_EQ(d.apex(outer), v);
        const std::uint32_t expected =
            swallowed || at_end ? 0 : label.at({d.origin(outer).value, d.target(outer).value});
        EXPECT_EQ(d.triangle(t).label, expected) << name(kind);
        ++(swallowed ? reset : inherited);
        d.set_label(t, 1 + random.below(1000));
      }
      for (const TriangleId t : d.born())
        if (random.below(3) == 0)
          d.set_tag(4 * t + 1, random.below(2) ? kSplitting : kSplitting + 1);
    }
    EXPECT_GT(inherited, 0) << name(kind);
    if (kind == Kind::kRandom) {
      EXPECT_GT(reset, 0);
    }
  }
}

TEST(Insertion, WithoutASplittingTagEverySwallowedTagResetsLabels) {
  Delaunay2 d;
  for (const Point2& p : {Point2{0, 0}, Point2{2, 0}, Point2{2, 2}, Point2{0, 2}}) d.add_vertex(p);
  d.insert_batch(0, 4, nullptr);
  // The diagonal of the square, whichever it is.
  HalfEdge diagonal = d.find_edge(VertexId(0), VertexId(2));
  if (diagonal == kNone) diagonal = d.find_edge(VertexId(1), VertexId(3));
  ASSERT_NE(diagonal, kNone);
  d.set_tag(diagonal, 9);
  for (TriangleId t = 0; t < d.slot_count(); ++t) d.set_label(t, d.is_ghost(t) ? 2 : 1);
  Delaunay2 other = d;
  const VertexId v = d.add_vertex({1, 1});
  other.add_vertex({1, 1});
  ASSERT_EQ(d.probe(v, 0), Delaunay2::Probe::kOk);
  ASSERT_EQ(d.cavity_tagged_inside().size(), 1u);
  d.commit(v);
  for (const TriangleId t : d.born()) EXPECT_EQ(d.triangle(t).label, 0u);
  ASSERT_EQ(other.probe(v, 0), Delaunay2::Probe::kOk);
  other.commit(v, 9);
  for (const TriangleId t : other.born()) EXPECT_EQ(other.triangle(t).label, 1u);
}

TEST(Insertion, DuplicatesAreFoundAndNamed) {
  for (const Kind kind : kAllKinds) {
    const std::vector<Point2> points = random_points(kind, 30, 3);
    Delaunay2 d = in_a_batch(points);
    for (const Point2& p : points) {
      EXPECT_EQ(d.probe(p, 0), Delaunay2::Probe::kDuplicate) << name(kind);
      EXPECT_EQ(d.point(d.duplicate_of()), p);
      EXPECT_TRUE(d.cavity().empty());
    }
  }
}

}  // namespace
}  // namespace circumball::testing
