#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "circumball/predicates.h"
#include "complex/box_filters.h"
#include "complex/space_contacts.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

using Triangle = SpaceContacts::Triangle;

/// The sides of the triangles of all faces, linked where one comes from one to the other without
/// crossing a face: around each edge from a triangle to the next. Each class of linked sides, a
/// shell, is the border of one part of space, as far as edges connect it.
class Shells3 {
 public:
  Shells3(const Complex& complex, const std::vector<FaceSurface>& surfaces) : complex_(complex) {
    for (const FaceSurface& s : surfaces)
      triangles.insert(triangles.end(), s.triangles.begin(), s.triangles.end());
    parent_.resize(2 * triangles.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    component_.resize(triangles.size());
    std::iota(component_.begin(), component_.end(), 0u);
    std::vector<Wing> wings;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
        wings.push_back({std::min(a, b), std::max(a, b), t, triangles[t][i], a < b});
      }
    std::sort(wings.begin(), wings.end(), [](const Wing& p, const Wing& q) {
      return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.triangle < q.triangle;
    });
    for (std::size_t i = 0, j; i < wings.size(); i = j) {
      for (j = i; j < wings.size() && wings[j].a == wings[i].a && wings[j].b == wings[i].b; ++j) {
      }
      link_around(&wings[i], j - i);
    }
  }
  /// The shell of a side: of the front (counter-clockwise from there) or the back.
  std::uint32_t shell(std::uint32_t triangle, bool front) {
    return root(&parent_, 2 * triangle + !front);
  }
  std::uint32_t component(std::uint32_t triangle) { return root(&component_, triangle); }

  std::vector<Triangle> triangles;

 private:
  struct Wing {
    std::uint32_t a, b, triangle, apex;
    bool forward;  // from a to b, counter-clockwise in the triangle: its front faces the turn
  };
  static std::uint32_t root(std::vector<std::uint32_t>* parent, std::uint32_t i) {
    while ((*parent)[i] != i) i = (*parent)[i] = (*parent)[(*parent)[i]];
    return i;
  }
  static void join(std::vector<std::uint32_t>* parent, std::uint32_t i, std::uint32_t j) {
    i = root(parent, i), j = root(parent, j);
    (*parent)[std::max(i, j)] = std::min(i, j);
  }

  /// Wings at one edge, in their order around it, exactly.
  void link_around(Wing* wings, std::size_t count) {
    const auto turn = [&](const Wing& p, const Wing& q) {  // positive: q is up to 180 degrees on
      if (p.apex == q.apex) return 0;
      const auto& v = complex_.vertices;
      return -static_cast<int>(orient3d(v[p.a], v[p.b], v[p.apex], v[q.apex]));
    };
    const Wing first = wings[0];
    const auto beyond = [&](const Wing& p) {
      const int s = turn(first, p);
      return s < 0 || (s == 0 && p.triangle != first.triangle);
    };
    std::stable_sort(wings, wings + count, [&](const Wing& p, const Wing& q) {
      if (p.triangle == first.triangle || q.triangle == first.triangle)
        return p.triangle == first.triangle && q.triangle != first.triangle;
      const bool bp = beyond(p), bq = beyond(q);
      return bp != bq ? bq : turn(p, q) > 0;
    });
    for (std::size_t i = 0; i < count; ++i) {
      const Wing &p = wings[i], &q = wings[i + 1 < count ? i + 1 : 0];
      join(&parent_, 2 * p.triangle + !p.forward, 2 * q.triangle + q.forward);
      join(&component_, p.triangle, q.triangle);
    }
  }

  const Complex& complex_;
  std::vector<std::uint32_t> parent_, component_;
};

class SeedCheck {
 public:
  SeedCheck(const Complex& complex, const SpaceView& view, const std::vector<FaceSurface>& surfaces)
      : complex_(complex), shells_(complex, surfaces), points_(complex.vertices) {
    for (std::uint32_t f = 0; f < surfaces.size(); ++f)
      face_of_.insert(face_of_.end(), surfaces[f].triangles.size(), f);
    points_.resize(points_.size() + 2);  // the seed, and a point far away
    std::vector<Box3> boxes;
    for (const Triangle& t : shells_.triangles)
      boxes.push_back(Box3::of(points_[t[0]], points_[t[1]], points_[t[2]]));
    if (!boxes.empty()) {
      all_ = boxes[0];
      for (const Box3& box : boxes) all_.extend(box);
    }
    triangles_ = BoxTree3(std::move(boxes));
    boxes.clear();
    for (const std::uint32_t s : view.segments) {
      segment_of_.push_back(s);
      boxes.push_back(Box3::of(points_[complex.segments[s][0]], points_[complex.segments[s][1]]));
    }
    segments_ = BoxTree3(std::move(boxes));
  }

  /// The face, segment, or vertex of a face or segment that a point is on; kFree without.
  Feature on(const Point3& p) {
    points_[seed()] = p;
    const SpaceContacts contacts(points_);
    Feature found;
    const Box3 at = Box3::of(p);
    const auto enter = [&](const Box3& box) { return box.meets(at); };
    segments_.query(enter, [&](std::uint32_t i) {
      const auto& s = complex_.segments[segment_of_[i]];
      for (const std::uint32_t v : s)
        if (points_[v] == p) found = {FeatureKind::kVertex, v};
      if (found.kind == FeatureKind::kFree && contacts.on_segment(seed(), s[0], s[1]))
        found = {FeatureKind::kSegment, segment_of_[i]};
      return found.kind == FeatureKind::kFree;
    });
    if (found.kind != FeatureKind::kFree) return found;
    triangles_.query(enter, [&](std::uint32_t k) {
      const Triangle& t = shells_.triangles[k];
      bool in = contacts.in_triangle(seed(), t);
      for (int i = 0; i < 3; ++i)
        in = in || points_[t[i]] == p || contacts.on_segment(seed(), t[i], t[(i + 1) % 3]);
      if (in) found = {FeatureKind::kFace, face_of_[k]};
      return !in;
    });
    return found;
  }

  /// Whether faces enclose a point that is on none of them. A ray that passes no edge decides for
  /// each connected part of the faces: the point is outside of it if the side that is met first and
  /// the side that is left last belong to one shell. Parts that share no edge enclose nothing
  /// together that none encloses alone (their intersection is finite: Alexander duality). True if
  /// rays do not decide.
  bool enclosed(const Point3& p) {
    if (face_of_.empty() || !Box3::of(p).meets(all_)) return false;
    const double dx = all_.extent(0), dy = all_.extent(1), dz = all_.extent(2);
    const double reach = 2 * std::sqrt(dx * dx + dy * dy + dz * dz);
    points_[seed()] = p;
    std::uint64_t state = 1;
    const auto random = [&] {  // -1 to 1, by a linear congruence (Knuth's MMIX)
      state = state * 6364136223846793005u + 1442695040888963407u;
      return static_cast<double>(state >> 11) * 0x1p-52 - 1;
    };
    for (int attempt = 0; attempt < 64; ++attempt) {
      const double x = random(), y = random(), z = random();
      const double length = std::sqrt(x * x + y * y + z * z);
      if (length < 0.1) continue;
      const double f = reach / length;
      points_[far()] = {p.x + f * x, p.y + f * y, p.z + f * z};
      if (!usable(points_[far()].x) || !usable(points_[far()].y) || !usable(points_[far()].z))
        continue;
      bool inside = false;
      if (cast(&inside)) return inside;
    }
    return true;
  }

 private:
  struct Hit {
    double at;
    std::uint32_t triangle;
    bool front;  // the ray comes from the front
  };
  std::uint32_t seed() const { return static_cast<std::uint32_t>(complex_.vertices.size()); }
  std::uint32_t far() const { return seed() + 1; }

  /// False if the ray passes an edge, or hits are too close to each other to be told apart.
  bool cast(bool* inside) {
    const SpaceContacts contacts(points_);
    const Point3 &p = points_[seed()], &q = points_[far()];
    const SegmentFilter filter(p, q);
    bool general = true;
    std::map<std::uint32_t, std::vector<Hit>> hits;  // by component
    triangles_.query([&](const Box3& box) { return filter.may_meet(box); },
                     [&](std::uint32_t k) {
                       const Triangle& t = shells_.triangles[k];
                       const auto meeting = contacts.segment_triangle(seed(), far(), t);
                       if (meeting == SpaceContacts::Meeting::kCross) {
                         const TriangleFilter plane(points_[t[0]], points_[t[1]], points_[t[2]]);
                         const auto height = [&](const Point3& x) {
                           return plane.n.x * (x.x - plane.a.x) + plane.n.y * (x.y - plane.a.y) +
                                  plane.n.z * (x.z - plane.a.z);
                         };
                         const double h = height(p);
                         hits[shells_.component(k)].push_back(
                             {h / (h - height(q)), k, contacts.side(t, seed()) < 0});
                         return true;
                       }
                       for (int i = 0; i < 3; ++i)
                         general = general && !contacts.on_segment(t[i], seed(), far()) &&
                                   contacts.segments(seed(), far(), t[i], t[(i + 1) % 3]) ==
                                       SpaceContacts::Meeting::kNone;
                       return general;
                     });
    if (!general) return false;
    for (auto& part : hits) {
      std::vector<Hit>& list = part.second;
      std::sort(list.begin(), list.end(), [](const Hit& a, const Hit& b) {
        return a.at != b.at ? a.at < b.at : a.triangle < b.triangle;
      });
      constexpr double kApart = 1e-12;  // far above rounding, which another ray avoids
      const std::size_t n = list.size();
      if (n > 1 &&
          (!(list[1].at - list[0].at > kApart) || !(list[n - 1].at - list[n - 2].at > kApart)))
        return false;
      const Hit &first = list[0], &last = list[n - 1];
      if (shells_.shell(first.triangle, first.front) != shells_.shell(last.triangle, !last.front))
        *inside = true;
    }
    return true;
  }

  const Complex& complex_;
  Shells3 shells_;
  std::vector<Point3> points_;
  std::vector<std::uint32_t> face_of_, segment_of_;
  BoxTree3 triangles_, segments_;
  Box3 all_{};
};

std::string kind_text(FeatureKind kind) {
  return kind == FeatureKind::kVertex    ? "vertex "
         : kind == FeatureKind::kSegment ? "segment "
                                         : "face ";
}

}  // namespace

void check_seeds_in_space(const Complex& complex, const SpaceView& view,
                          const std::vector<FaceSurface>& surfaces, std::size_t max,
                          std::vector<Defect>* defects) {
  if (complex.holes.empty() && complex.regions.empty()) return;
  SeedCheck seeds(complex, view, surfaces);
  DefectList hole("hole-outside", true, max), region("region-outside", true, max);
  const auto look = [&](const Point3& p, const std::string& name, const std::string& effect,
                        DefectList* list) {
    if (!usable(p.x) || !usable(p.y) || !usable(p.z)) return;
    const Feature on = seeds.on(p);
    if (on.kind != FeatureKind::kFree)
      list->add({on}, {p},
                name + " at " + point_text(p, 3) + " lies on " + kind_text(on.kind) +
                    std::to_string(on.index) + ", between the parts that it might mean: " + effect +
                    "; move it off");
    else if (!seeds.enclosed(p))
      list->add({}, {p},
                name + " at " + point_text(p, 3) + " lies outside everything that faces enclose: " +
                    effect + "; move it inside a closed boundary");
  };
  for (std::size_t i = 0; i < complex.holes.size(); ++i)
    look(complex.holes[i], "hole seed " + std::to_string(i), "it removes nothing", &hole);
  for (std::size_t i = 0; i < complex.regions.size(); ++i)
    look(complex.regions[i].at, "region seed " + std::to_string(i), "it labels nothing", &region);
  hole.append_to(defects);
  region.append_to(defects);
}

}  // namespace circumball
