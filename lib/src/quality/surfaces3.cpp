#include "quality/surfaces3.h"

#include <cmath>
#include <utility>

#include "complex/box_tree.h"
#include "feature_size/vectors.h"

namespace circumball {
namespace {

/// Vertices on spheres and tubes are rounded: they count as on them within this, relative to the
/// radius, and what rounding does to coordinates.
constexpr double kOnSurface = 1e-8;

/// Heights of rings, in lengths of subsegments (docs/algorithms.md).
constexpr double kHeight = 0.6;

}  // namespace

double TubeProfile::outside(const Point3& p, double slack) const {
  const Point3 d = p - origin;
  const double t = dot(d, axis);
  if (t < along.front() - slack || t > along.back() + slack) return HUGE_VAL;
  const Point3 across = d - Point3{t * axis.x, t * axis.y, t * axis.z};
  std::size_t k = 1;
  while (k + 1 < along.size() && along[k] < t) ++k;
  const double part = (t - along[k - 1]) / (along[k] - along[k - 1]);
  return std::sqrt(dot(across, across)) - (radius[k - 1] + part * (radius[k] - radius[k - 1]));
}

Surfaces3::Surfaces3(const VerifyContext3& context) : context_(context) {
  const std::size_t n = context.mesh.vertices.size();
  sphere_.assign(n, kNoIndex);
  tube_.assign(n, kNoIndex);
  center_.assign(n, 0);
  inner_.assign(n, 0);
  find_spheres();
  const ChainFinder<VerifyContext3> chains(context);
  for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
    if (context.segment_wanted[s]) find_tube(chains.find(s).vertices);
  }
  find_vertices_on_tubes();
}

bool Surfaces3::holds(const VerifyContext3::Cell& c) const {
  for (const std::uint32_t v : c) {
    if (inner_[v]) return true;
  }
  if (on_one(sphere_, c)) return true;
  if (!on_one(tube_, c)) return false;
  Point3 m{0, 0, 0};
  for (const std::uint32_t v : c) {
    const Point3& p = context_.point(v);
    m = {m.x + 0.25 * p.x, m.y + 0.25 * p.y, m.z + 0.25 * p.z};
  }
  const TubeProfile& tube = tubes_[tube_[c[0]]];
  return tube.outside(m, context_.rounding) < tolerance(tube.radius[0]);
}

double Surfaces3::tolerance(double radius) const {
  return kOnSurface * radius + 4 * context_.rounding;
}

double Surfaces3::distance(std::uint32_t a, std::uint32_t b) const {
  const Point3 d = context_.point(a) - context_.point(b);
  return std::sqrt(dot(d, d));
}

void Surfaces3::find_spheres() {
  for (std::uint32_t i = 0; i < context_.complex.vertices.size(); ++i) {
    const std::uint32_t q0 = context_.mesh_vertex[i];
    if (q0 == kNoIndex || q0 >= context_.used.size() || !context_.used[q0]) continue;
    double low = HUGE_VAL, high = 0;
    for (std::uint32_t k = context_.neighbor_first[q0]; k < context_.neighbor_first[q0 + 1]; ++k) {
      const double d = distance(q0, context_.neighbor[k]);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    if (!(high - low <= tolerance(high))) continue;
    ++spheres_;
    inner_[q0] = center_[q0] = 1;
    for (std::uint32_t k = context_.neighbor_first[q0]; k < context_.neighbor_first[q0 + 1]; ++k)
      sphere_[context_.neighbor[k]] = q0;
  }
}

void Surfaces3::find_tube(const std::vector<std::uint32_t>& v) {
  if (v.size() < 4) return;
  const std::size_t last = v.size() - 1;
  TubeProfile tube;
  tube.origin = context_.point(v[0]);
  const Point3 whole = context_.point(v[last]) - tube.origin;
  const double length = std::sqrt(dot(whole, whole));
  tube.axis = {whole.x / length, whole.y / length, whole.z / length};
  for (std::size_t i = 1; i < last; ++i) {
    double along = dot(context_.point(v[i]) - tube.origin, tube.axis);
    double radius = kHeight * std::max(distance(v[i - 1], v[i]), distance(v[i], v[i + 1]));
    if (i == 1 || i + 1 == last) {
      const double d = i == 1 ? distance(v[0], v[1]) : distance(v[last - 1], v[last]);
      radius = kHeight * (i == 1 ? distance(v[1], v[2]) : distance(v[last - 2], v[last - 1]));
      if (!(radius < d)) return;
      const double x = std::sqrt(d * d - radius * radius);
      along = i == 1 ? x : length - x;
    }
    if (!tube.along.empty() && !(along > tube.along.back())) return;
    tube.along.push_back(along);
    tube.radius.push_back(radius);
  }
  // Is there a ring?
  int on_ring = 0;
  for (std::uint32_t k = context_.neighbor_first[v[1]]; k < context_.neighbor_first[v[1] + 1];
       ++k) {
    const Point3 d = context_.point(context_.neighbor[k]) - tube.origin;
    if (std::fabs(dot(d, tube.axis) - tube.along[0]) > tolerance(tube.radius[0])) continue;
    if (std::fabs(tube.outside(context_.point(context_.neighbor[k]), tolerance(tube.radius[0]))) <=
        tolerance(tube.radius[0])) {
      ++on_ring;
    }
  }
  if (on_ring < 2) return;  // of a closed domain, perhaps only those in the two faces
  for (std::size_t i = 1; i < last; ++i) inner_[v[i]] = 1;
  tubes_.push_back(std::move(tube));
}

void Surfaces3::find_vertices_on_tubes() {
  std::vector<Box3> boxes;
  for (const TubeProfile& tube : tubes_) {
    const double r = 1.01 * *std::max_element(tube.radius.begin(), tube.radius.end());
    const auto at = [&](double t) {
      return Point3{tube.origin.x + t * tube.axis.x, tube.origin.y + t * tube.axis.y,
                    tube.origin.z + t * tube.axis.z};
    };
    Box3 box = Box3::of(at(tube.along.front()), at(tube.along.back()), at(tube.along.back()));
    box.extend(Box3::of({box.lo_x - r, box.lo_y - r, box.lo_z - r},
                        {box.hi_x + r, box.hi_y + r, box.hi_z + r}));
    boxes.push_back(box);
  }
  const BoxTree3 tree(std::move(boxes));
  for (std::uint32_t v = 0; v < context_.used.size(); ++v) {
    if (!context_.used[v] || inner_[v]) continue;
    const Point3& p = context_.point(v);
    tree.query([&](const Box3& box) { return box.meets(Box3::of(p)); },
               [&](std::uint32_t i) {
                 const double slack = tolerance(tubes_[i].radius[0]);
                 if (std::fabs(tubes_[i].outside(p, slack)) > slack) return true;
                 tube_[v] = i;
                 return false;
               });
  }
}

}  // namespace circumball
