#include "complex/face_shells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "circumball/predicates.h"
#include "complex/box_filters.h"
#include "complex/planar_sweep.h"
#include "complex/space_contacts.h"

namespace circumball {
namespace {

std::uint32_t root(std::vector<std::uint32_t>* parent, std::uint32_t i) {
  while ((*parent)[i] != i) i = (*parent)[i] = (*parent)[(*parent)[i]];
  return i;
}
void join(std::vector<std::uint32_t>* parent, std::uint32_t i, std::uint32_t j) {
  i = root(parent, i), j = root(parent, j);
  (*parent)[std::max(i, j)] = std::min(i, j);
}

}  // namespace

FaceShells::FaceShells(const Complex& complex, std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), points_(complex.vertices) {
  shell_.resize(2 * triangles_.size());
  std::iota(shell_.begin(), shell_.end(), 0u);
  component_.resize(triangles_.size());
  std::iota(component_.begin(), component_.end(), 0u);
  std::vector<Wing> wings;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles_[t][(i + 1) % 3], b = triangles_[t][(i + 2) % 3];
      wings.push_back({std::min(a, b), std::max(a, b), t, triangles_[t][i], a < b});
    }
  std::sort(wings.begin(), wings.end(), [](const Wing& p, const Wing& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.triangle < q.triangle;
  });
  for (std::size_t i = 0, j; i < wings.size(); i = j) {
    for (j = i; j < wings.size() && wings[j].a == wings[i].a && wings[j].b == wings[i].b; ++j) {
    }
    link_around(&wings[i], j - i);
  }
  for (std::uint32_t i = 0; i < shell_.size(); ++i) shell_[i] = root(&shell_, i);
  for (std::uint32_t i = 0; i < component_.size(); ++i) component_[i] = root(&component_, i);
  std::vector<Box3> boxes;
  for (const Triangle& t : triangles_)
    boxes.push_back(Box3::of(points_[t[0]], points_[t[1]], points_[t[2]]));
  if (!boxes.empty()) {
    all_ = boxes[0];
    for (const Box3& box : boxes) all_.extend(box);
  }
  tree_ = BoxTree3(std::move(boxes));
  points_.resize(points_.size() + 2);
}

/// Wings at one edge, in their order around it, exactly.
void FaceShells::link_around(Wing* wings, std::size_t count) {
  const auto turn = [&](const Wing& p, const Wing& q) {  // positive: q is up to 180 degrees on
    if (p.apex == q.apex) return 0;
    const auto& v = points_;
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
    join(&shell_, 2 * p.triangle + !p.forward, 2 * q.triangle + q.forward);
    join(&component_, p.triangle, q.triangle);
  }
}

Point3 FaceShells::end_of_ray(const Point3& p, int attempt) const {
  const double dx = all_.extent(0), dy = all_.extent(1), dz = all_.extent(2);
  const double reach = 2 * std::sqrt(dx * dx + dy * dy + dz * dz);
  std::uint64_t state = 1 + 3 * static_cast<std::uint64_t>(attempt);
  const auto random = [&] {  // -1 to 1, by a linear congruence (Knuth's MMIX)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
  };
  double x = 0, y = 0, z = 0, length = 0;
  while (length < 0.1) {
    x = random(), y = random(), z = random();
    length = std::sqrt(x * x + y * y + z * z);
  }
  const double f = reach / length;
  return {p.x + f * x, p.y + f * y, p.z + f * z};
}

bool FaceShells::cast(const Point3& p, int attempt, std::vector<Hit>* hits,
                      std::uint32_t skip) const {
  hits->clear();
  const auto from = static_cast<std::uint32_t>(points_.size() - 2), to = from + 1;
  const Point3 q = end_of_ray(p, attempt);
  if (!usable(q.x) || !usable(q.y) || !usable(q.z)) return false;
  points_[from] = p;
  points_[to] = q;
  const SpaceContacts contacts(points_);
  const SegmentFilter filter(p, q);
  bool general = true;
  tree_.query([&](const Box3& box) { return filter.may_meet(box); },
              [&](std::uint32_t k) {
                if (k == skip) return true;
                const Triangle& t = triangles_[k];
                const auto meeting = contacts.segment_triangle(from, to, t);
                if (meeting == SpaceContacts::Meeting::kCross) {
                  const TriangleFilter plane(points_[t[0]], points_[t[1]], points_[t[2]]);
                  const auto height = [&](const Point3& at) {
                    return plane.n.x * (at.x - plane.a.x) + plane.n.y * (at.y - plane.a.y) +
                           plane.n.z * (at.z - plane.a.z);
                  };
                  const double h = height(p);
                  hits->push_back({h / (h - height(q)), k, contacts.side(t, from) < 0});
                  return true;
                }
                for (unsigned i = 0; i < 3; ++i)
                  general = general && !contacts.on_segment(t[i], from, to) &&
                            contacts.segments(from, to, t[i], t[(i + 1) % 3]) ==
                                SpaceContacts::Meeting::kNone;
                return general;
              });
  std::sort(hits->begin(), hits->end(), [](const Hit& a, const Hit& b) {
    return a.at != b.at ? a.at < b.at : a.triangle < b.triangle;
  });
  return general;
}

}  // namespace circumball
