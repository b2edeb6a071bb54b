#include <algorithm>
#include <cmath>
#include <vector>

#include "complex/box_tree.h"
#include "feature_size/vectors.h"
#include "quality/context3.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {
namespace {

/// Vertices on spheres and tubes are rounded: they count as on them within this, relative to the
/// radius, and what rounding does to coordinates.
constexpr double kOnSurface = 1e-8;

/// Heights of rings, in lengths of subsegments (docs/algorithms.md).
constexpr double kHeight = 0.6;

/// The tube about an input segment: distances along it, and radii, of its first rings.
struct TubeProfile {
  Point3 origin, axis;
  std::vector<double> along, radius;

  /// Distance of p from the axis less the radius of the tube there; infinite beyond its ends.
  double outside(const Point3& p, double slack) const {
    const Point3 d = p - origin;
    const double t = dot(d, axis);
    if (t < along.front() - slack || t > along.back() + slack) return HUGE_VAL;
    const Point3 across = d - Point3{t * axis.x, t * axis.y, t * axis.z};
    std::size_t k = 1;
    while (k + 1 < along.size() && along[k] < t) ++k;
    const double part = (t - along[k - 1]) / (along[k] - along[k - 1]);
    return std::sqrt(dot(across, across)) - (radius[k - 1] + part * (radius[k] - radius[k - 1]));
  }
};

/// Spheres and tubes, read off the mesh. About an input vertex there is a sphere if all of its
/// neighbors are equally far from it. About an input segment there is a tube if three neighbors at
/// least of a vertex on it, off the segment, are as far from it as a ring would be, in the plane
/// across.
class Surfaces {
 public:
  explicit Surfaces(const VerifyContext3& context) : context_(context) {
    const std::size_t n = context.mesh.vertices.size();
    sphere_.assign(n, kNoIndex);
    tube_.assign(n, kNoIndex);
    inner_.assign(n, 0);
    find_spheres();
    const ChainFinder<VerifyContext3> chains(context);
    for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
      if (context.segment_wanted[s]) find_tube(chains.find(s).vertices);
    }
    find_vertices_on_tubes();
  }

  std::size_t spheres() const { return spheres_; }
  std::size_t tubes() const { return tubes_.size(); }

  /// Whether a cell belongs to the inside of spheres and tubes: a corner of it is the center of a
  /// sphere or on a segment with a tube, or all four are on one sphere, or all four on one tube
  /// with their centroid not outside of it.
  bool holds(const VerifyContext3::Cell& c) const {
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
  template <class Corners>
  bool on_one_surface(const Corners& corners) const {
    return on_one(sphere_, corners) || on_one(tube_, corners);
  }

 private:
  double tolerance(double radius) const { return kOnSurface * radius + 4 * context_.rounding; }
  template <class Corners>
  static bool on_one(const std::vector<std::uint32_t>& surface, const Corners& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      return surface[v] != kNoIndex && surface[v] == surface[corners[0]];
    });
  }
  double distance(std::uint32_t a, std::uint32_t b) const {
    const Point3 d = context_.point(a) - context_.point(b);
    return std::sqrt(dot(d, d));
  }

  void find_spheres() {
    for (std::uint32_t i = 0; i < context_.complex.vertices.size(); ++i) {
      const std::uint32_t q0 = context_.mesh_vertex[i];
      if (q0 == kNoIndex || q0 >= context_.used.size() || !context_.used[q0]) continue;
      double low = HUGE_VAL, high = 0;
      for (std::uint32_t k = context_.neighbor_first[q0]; k < context_.neighbor_first[q0 + 1];
           ++k) {
        const double d = distance(q0, context_.neighbor[k]);
        low = std::min(low, d);
        high = std::max(high, d);
      }
      if (!(high - low <= tolerance(high))) continue;
      ++spheres_;
      inner_[q0] = 1;
      for (std::uint32_t k = context_.neighbor_first[q0]; k < context_.neighbor_first[q0 + 1]; ++k)
        sphere_[context_.neighbor[k]] = q0;
    }
  }

  void find_tube(const std::vector<std::uint32_t>& v) {
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
      if (std::fabs(tube.outside(context_.point(context_.neighbor[k]),
                                 tolerance(tube.radius[0]))) <= tolerance(tube.radius[0])) {
        ++on_ring;
      }
    }
    if (on_ring < 2) return;  // of a closed domain, perhaps only those in the two faces
    for (std::size_t i = 1; i < last; ++i) inner_[v[i]] = 1;
    tubes_.push_back(std::move(tube));
  }

  void find_vertices_on_tubes() {
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

  const VerifyContext3& context_;
  std::size_t spheres_ = 0;
  std::vector<TubeProfile> tubes_;
  std::vector<std::uint32_t> sphere_, tube_;  // by vertex
  std::vector<std::uint8_t> inner_;
};

}  // namespace

/// Theorems 6.14 and 6.15, of quality: outside of spheres and tubes, RE(t) <= tau, without
/// exception; and the surface between is a union of facets, each with its corners on one sphere or
/// tube.
Check check_intestine(const VerifyContext3& context) {
  Check check;
  check.name = "intestine";
  check.bound = 0;
  const double tau = context.options.tau.value_or(0);
  const Surfaces surfaces(context);
  std::vector<std::uint8_t> inside(context.cells.size(), 0);
  for (std::uint32_t i = 0; i < context.cells.size(); ++i)
    inside[i] = surfaces.holds(context.cells[i]);
  std::size_t within = 0, allowed = 0, bad = 0, excused = 0, torn = 0, facets = 0;
  for (std::uint32_t i = 0; i < context.cells.size(); ++i) {
    const auto& c = context.cells[i];
    within += inside[i];
    const TetrahedronMeasure m = measure_tetrahedron(context.point(c[0]), context.point(c[1]),
                                                     context.point(c[2]), context.point(c[3]));
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    if (inside[i]) {
      ++allowed;
    } else if (context.excused(c)) {
      ++excused;
    } else if (bad++ == 0) {
      check.worst = {c[0], c[1], c[2], c[3]};
    }
  }
  for (std::uint32_t f = 0; f < context.twin.size(); ++f) {
    const std::uint32_t t = context.twin[f];
    if (t == kNoIndex || !inside[f / 4] || inside[t / 4]) continue;
    ++facets;
    const auto corners = context.corners(f);
    if (!surfaces.on_one_surface(corners) && torn++ == 0 && bad == 0) {
      check.worst = {corners[0], corners[1], corners[2]};
    }
  }
  check.ok = bad + torn == 0;
  check.observed = static_cast<double>(bad + torn);
  if (bad > 0) {
    check.detail = count_text(bad, "cell") +
                   " above tau outside of spheres and tubes, the first is " +
                   vertices_text(check.worst);
  } else if (torn > 0) {
    check.detail = count_text(torn, "facet") +
                   " between inside and outside with corners on more than one surface, the first "
                   "is " +
                   vertices_text(check.worst);
  } else {
    check.detail = "of " + count_text(within, "cell") + " inside of " +
                   count_text(surfaces.spheres(), "sphere") + " and " +
                   count_text(surfaces.tubes(), "tube") + " " + std::to_string(allowed) +
                   " above tau, of the others none (thesis, Theorems 6.14 and 6.15); " +
                   count_text(facets, "facet") + " between, each on one sphere or tube";
  }
  if (excused > 0)
    check.detail += "; " + count_text(excused, "cell") + " above it excused as refused by Safety";
  return check;
}

}  // namespace circumball
