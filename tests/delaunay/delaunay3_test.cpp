// What the triangulation of space is: Delaunay by brute force, unique, and the same from
// everywhere.
#include "delaunay/delaunay3.h"

#include <gtest/gtest.h>

#include <numeric>

#include "circumball/predicates.h"
#include "delaunay/delaunay_check.h"
#include "point_sets3.h"

namespace circumball::testing {
namespace {

/// Whether the fifth point is in the ball of the first four (positively oriented) after vertex i
/// has been lifted by epsilon_i, epsilon_0 << epsilon_1 << ... The determinant is linear in the
/// lifts: without them, or else the first coefficient that does not vanish decides. A point without
/// number is not lifted.
struct Numbered {
  Point3 p;
  std::uint32_t number;
};
bool in_perturbed_ball(const std::array<Numbered, 5>& c) {
  const Sign in = insphere(c[0].p, c[1].p, c[2].p, c[3].p, c[4].p);
  if (in != Sign::kZero) return in == Sign::kPositive;
  std::vector<std::pair<std::uint32_t, int>> coefficients;
  for (int i = 0; i < 5; ++i) {
    std::array<Point3, 4> t{c[0].p, c[1].p, c[2].p, c[3].p};
    if (i < 4) t[i] = c[4].p;
    const int sign = static_cast<int>(orient3d(t[0], t[1], t[2], t[3]));
    if (c[i].number != kNone) coefficients.emplace_back(c[i].number, i < 4 ? sign : -sign);
  }
  std::sort(coefficients.rbegin(), coefficients.rend());
  for (const auto& [number, sign] : coefficients)
    if (sign != 0) return sign > 0;
  ADD_FAILURE() << "a tie that the perturbation leaves open";
  return false;
}

/// Every set of four vertices (of three and the point off their plane, if they are coplanar) whose
/// ball holds no other: by definition, the triangulation.
std::multiset<Corners4> by_brute_force(const std::vector<Point3>& points, const Point3* off_plane) {
  const auto n = static_cast<std::uint32_t>(points.size());
  const auto at = [&](std::uint32_t i) {
    return i == n ? Numbered{*off_plane, kNone} : Numbered{points[i], i};
  };
  std::multiset<Corners4> all;
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b)
      for (std::uint32_t c = b + 1; c < n; ++c)
        for (std::uint32_t d = off_plane ? n : c + 1; d < (off_plane ? n + 1 : n); ++d) {
          Corners4 t{a, b, c, d};
          Sign sign = orient3d(at(a).p, at(b).p, at(c).p, at(d).p);
          if (sign == Sign::kZero) continue;
          if (sign == Sign::kNegative) {
            if (off_plane)
              std::swap(t[0], t[1]);
            else
              std::swap(t[2], t[3]);
          }
          bool empty = true;
          for (std::uint32_t e = 0; e < n && empty; ++e)
            empty = e == a || e == b || e == c || e == d ||
                    !in_perturbed_ball({at(t[0]), at(t[1]), at(t[2]), at(t[3]), at(e)});
          if (!empty) continue;
          if (off_plane) t = {a, b, c, 0};
          all.insert(t);
        }
  return all;
}

TEST(Delaunay3, CellsAreExactlyTheSimplicesWhoseBallsAreEmpty) {
  for (const Kind3 kind : kAllKinds3)
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const std::vector<Point3> points = without_duplicates(random_points(kind, 5 + seed, seed));
      for (const Delaunay3& d : {in_number_order(points), in_a_batch(points)}) {
        std::string why;
        ASSERT_TRUE(is_valid(d, &why)) << name(kind) << ": " << why;
        std::multiset<Corners4> found, expected;
        if (d.dimension() == 3) {
          d.for_each_cell([&](CellSlot c) { found.insert(corners(d.cell(c))); });
          expected = by_brute_force(points, nullptr);
        } else if (d.dimension() == 2) {
          const Delaunay3::Cell first = d.cell(d.some_ghost());
          Point3 off{0, 0, 0};
          for (const Point3& p : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}})
            if (orient3d(d.point(first.v[0]), d.point(first.v[1]), d.point(first.v[2]), off) ==
                Sign::kZero)
              off = p;
          for (CellSlot c = 0; c < d.slot_count(); ++c) {
            if (!d.alive(c)) continue;
            Corners4 t{d.corner(c, 0).value, d.corner(c, 1).value, d.corner(c, 2).value, 0};
            std::sort(t.begin(), t.begin() + 3);
            found.insert(t);
          }
          for (const Corners4& t : by_brute_force(points, &off))
            for (int side = 0; side < 2; ++side) expected.insert(t);
        }
        ASSERT_EQ(found, expected) << name(kind) << ", seed " << seed;
      }
    }
}

TEST(Delaunay3, IsValidAfterEveryInsertion) {
  for (const Kind3 kind : kAllKinds3) {
    Delaunay3 d;
    Random random(5);
    for (const Point3& p : random_points(kind, 60, 1)) {
      const VertexId v = d.add_vertex(p);
      if (d.probe(v, random.below(200)) == Delaunay3::Probe::kOk) d.commit(v);
      std::string why;
      ASSERT_TRUE(is_valid(d, &why)) << name(kind) << ", vertex " << v.value << ": " << why;
    }
  }
}

TEST(Delaunay3, IsUniqueForNumberedPointsWhateverTheOrderOfInsertion) {
  for (const Kind3 kind : kAllKinds3)
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      // Distinct points: which of two equal ones stays does depend on the order, one by one.
      const std::vector<Point3> points = without_duplicates(random_points(kind, 50, seed));
      const std::multiset<Corners4> expected = cells(in_number_order(points));
      EXPECT_EQ(cells(in_a_batch(points)), expected) << name(kind);
      Random random(seed);
      for (int trial = 0; trial < 4; ++trial) {
        Delaunay3 d;
        std::vector<std::uint32_t> order;
        for (const Point3& p : points) order.push_back(d.add_vertex(p).value);
        for (std::size_t i = order.size(); i > 1; --i)
          std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
        insert_all(&d, order, &random);
        EXPECT_EQ(cells(d), expected) << name(kind);
      }
    }
}

TEST(Delaunay3, ScaledByAPowerOfTwoHasTheSameCells) {
  for (const Kind3 kind : {Kind3::kRandom, Kind3::kLattice, Kind3::kCospherical,
                           Kind3::kNearlyCoplanar, Kind3::kTwoLines, Kind3::kPlane}) {
    const std::vector<Point3> points = without_duplicates(random_points(kind, 80, 3));
    const auto expected = cells(in_a_batch(points));
    for (const double scale : {0x1p-90, 0x1p-7, 0x1p80}) {
      std::vector<Point3> scaled = points;
      for (Point3& p : scaled) p = {scale * p.x, scale * p.y, scale * p.z};
      EXPECT_EQ(cells(in_a_batch(scaled)), expected) << name(kind);
      EXPECT_EQ(cells(in_number_order(scaled)), expected) << name(kind);
    }
  }
}

TEST(Delaunay3, LargeLatticeIsTheSameInABatchAsInNumberOrder) {
  std::vector<Point3> points;
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    const int k = i * 715 % 1728;  // in mixed order
    points.push_back({double(k / 144), double(k / 12 % 12), double(k % 12)});
  }
  const Delaunay3 d = in_a_batch(points);
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  EXPECT_EQ(cells(d), cells(in_number_order(points)));
  // A cube has five cells or six.
  std::size_t count = 0;
  d.for_each_cell([&](CellSlot) { ++count; });
  EXPECT_GE(count, 5u * 11 * 11 * 11);
  EXPECT_LE(count, 6u * 11 * 11 * 11);
}

TEST(Delaunay3, LatticeFarFromTheOriginIsTheSameAsNearIt) {
  for (const Kind3 kind : {Kind3::kLattice, Kind3::kSheared, Kind3::kCospherical, Kind3::kTwoPlanes,
                           Kind3::kPlaneLattice}) {
    const std::vector<Point3> points = without_duplicates(random_points(kind, 150, 3));
    std::vector<Point3> moved = points;
    for (Point3& p : moved) p = {1e6 + p.x, p.y - 1e6, 3e6 + p.z};
    EXPECT_EQ(cells(in_a_batch(moved)), cells(in_a_batch(points))) << name(kind);
  }
}

TEST(Delaunay3, DimensionGrowsWithThePoints) {
  Delaunay3 d;
  const auto insert = [&](double x, double y, double z) {
    const VertexId v = d.add_vertex({x, y, z});
    EXPECT_EQ(d.probe(v, kNone), Delaunay3::Probe::kOk);
    d.commit(v);
    std::string why;
    EXPECT_TRUE(is_valid(d, &why)) << why;
    return d.dimension();
  };
  EXPECT_EQ(d.dimension(), -1);
  EXPECT_EQ(d.locate({0, 0, 0}, 0), kNone);
  EXPECT_EQ(insert(0, 0, 0), 0);
  EXPECT_EQ(d.cell_of(VertexId(0)), kNone);
  EXPECT_TRUE(d.inserted(VertexId(0)));
  EXPECT_EQ(insert(4, 4, 4), 1);
  EXPECT_EQ(insert(2, 2, 2), 1);
  EXPECT_EQ(insert(9, 9, 9), 1);
  EXPECT_EQ(d.slot_count(), 0u);
  EXPECT_EQ(insert(3, 2, 2), 2);  // three triangles
  EXPECT_EQ(d.slot_count(), 6u);
  EXPECT_EQ(insert(9, 1, 1), 2);
  EXPECT_EQ(insert(2.5, 1.75, 1.75), 2);
  EXPECT_EQ(insert(0, 0, 1), 3);
  EXPECT_EQ(insert(0, 0, -1), 3);
}

TEST(Delaunay3, ManyCoplanarVerticesAndOneOffTheirPlane) {
  std::vector<Point3> lattice, tilted;
  for (int i = 0; i < 900; ++i) {
    const int k = i * 7 % 900, x = k / 30, y = k % 30;  // in mixed order
    lattice.push_back({double(x), -3, double(y)});
    tilted.push_back({double(x), double(y), 2.0 * x - 3.0 * y});
  }
  for (std::vector<Point3> points : {random_points(Kind3::kPlane, 1000, 3), lattice, tilted}) {
    for (const Point3& last : {points[0], Point3{0.5, 0.5, 100}}) {
      if (last != points[0]) points.push_back(last);
      std::string why;
      const Delaunay3 d = in_number_order(points), batch = in_a_batch(points);
      EXPECT_TRUE(is_valid(d, &why)) << why;
      EXPECT_EQ(cells(d), cells(batch));
      EXPECT_EQ(d.dimension(), last != points[0] ? 3 : 2);
    }
  }
}

TEST(Delaunay3, ProbeSaysTheSameFromEveryHint) {
  for (const Kind3 kind : kAllKinds3) {
    Delaunay3 d = in_a_batch(random_points(kind, 25, 3));
    Random random(9);
    for (int trial = 0; trial < 10; ++trial) {
      const Point3 p = random_point(kind, &random);
      std::multiset<Corners4> expected;
      for (CellSlot hint = 0; hint < d.slot_count() + 3; hint += 1 + hint / 20) {
        const Delaunay3::Probe result = d.probe(p, hint);
        std::multiset<Corners4> cavity;
        for (const CellSlot c : d.cavity()) cavity.insert(corners(d.cell(c)));
        if (hint == 0) expected = cavity;
        ASSERT_EQ(cavity, expected) << name(kind);
        ASSERT_EQ(result == Delaunay3::Probe::kDuplicate, d.duplicate_of().valid());
        if (d.duplicate_of().valid()) {
          ASSERT_EQ(d.point(d.duplicate_of()), p);
        }
      }
    }
  }
}

TEST(Delaunay3, LocateFindsACellThatContainsThePoint) {
  for (const Kind3 kind : {Kind3::kRandom, Kind3::kLattice, Kind3::kTwoPlanes}) {
    const Delaunay3 d = in_a_batch(random_points(kind, 60, 4));
    Random random(2);
    for (int trial = 0; trial < 300; ++trial) {
      const double x = random.below(40) / 4.0 - 4;
      const double y = random.below(40) / 4.0 - 4;
      const double z = random.below(40) / 4.0 - 4;
      const CellSlot c = d.locate({x, y, z}, random.below(300));
      for (CellFacet f = 4 * c; f < 4 * c + 4; ++f) {
        if (d.is_ghost(c) && d.apex(f) != Delaunay3::kGhost) continue;
        const Sign side = orient3d(d.point(d.facet_corner(f, 0)), d.point(d.facet_corner(f, 1)),
                                   d.point(d.facet_corner(f, 2)), Point3{x, y, z});
        // The apex is on the negative side, that of a ghost too.
        EXPECT_TRUE(side == Sign::kNegative || (side == Sign::kZero && !d.is_ghost(c)));
      }
    }
  }
}

TEST(Delaunay3, CheckNamesWhatIsWrong) {
  Delaunay3 d = in_a_batch(random_points(Kind3::kRandom, 10, 1));
  std::string why;
  EXPECT_TRUE(is_valid(d, &why)) << why;
  d.pop_vertex();  // against its precondition: vertex 9 is inserted
  EXPECT_FALSE(is_valid(d, &why));
  EXPECT_NE(why, "");
  EXPECT_FALSE(is_valid(d, nullptr));
}

}  // namespace
}  // namespace circumball::testing
