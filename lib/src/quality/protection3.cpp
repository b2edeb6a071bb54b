#include <algorithm>
#include <cmath>
#include <utility>

#include "circumball/feature_size.h"
#include "complex/box_tree.h"
#include "feature_size/vectors.h"
#include "quality/acute_features.h"

// What the proofs of 6.2 rest on: (H2) and (H3) for protected segments, and Lemma 6.9 I.
namespace circumball {
namespace {

/// Balls are compared with this slack when they are made.
constexpr double kRoundedPower = 1e-9;

/// A piece of an input segment that is never split: of a protected one, or at a protected vertex.
struct Piece {
  std::uint32_t a, b, segment;
  bool end;  // it touches an input vertex
};

class ProtectionCheck {
 public:
  explicit ProtectionCheck(const VerifyContext3& context)
      : context_(context), features_(protected_features(context, RightAngles::kOpen)) {
    check_.name = "protection";
    check_.ok = true;
    if (promises("intestine")) leave_out_box();
  }

  Check run() {
    list_pieces();
    check_sizes();
    check_end_segments();
    check_balls();
    if (check_.ok) {
      check_.detail = count_text(pieces_.size(), "protected subsegment") +
                      ": |s| < c min(fs_1(s), lfs(s)) with c = " + value_text(factor()) +
                      ", feature sizes by definition, the largest ratio is " + value_text(worst_) +
                      lower_bound_text() +
                      " (thesis, H2); end segments at a vertex are equal (H3); the balls of these "
                      "and of " +
                      count_text(facets_, "facet") + " at them hold no vertex (Lemma 6.9 I)";
      check_.worst = worst_piece_;
    }
    check_.bound = factor();
    check_.observed = worst_;
    return check_;
  }

 private:
  /// The b of (H2) that the mesh has: the thesis asks for one above 0, and names none.
  std::string lower_bound_text() const {
    if (std::isinf(least_)) return "";
    return ", the smallest of |s| and min(fs_1(s), lfs(s)), b, is " + value_text(least_);
  }
  bool promises(const char* check) const {
    const auto& checks = context_.options.checks;
    return std::find(checks.begin(), checks.end(), check) != checks.end();
  }
  /// Intestines never protect the box, whose vertices are the last of the complex.
  void leave_out_box() {
    const std::size_t n = context_.complex.vertices.size();
    const std::size_t first = n - std::min<std::size_t>(n, context_.mesh.box_vertices);
    for (std::size_t v = first; v < features_.vertices.size(); ++v) features_.vertices[v] = false;
    for (std::size_t s = 0; s < features_.segments.size(); ++s) {
      const auto& ends = context_.complex.segments[s];
      if (ends[0] >= first && ends[1] >= first) features_.segments[s] = false;
    }
  }

  double factor() const { return context_.options.size_factor.value_or(1); }
  void fail(const std::string& detail, std::vector<std::uint32_t> worst) {
    if (!std::exchange(check_.ok, false)) return;
    check_.detail = detail;
    check_.worst = std::move(worst);
  }
  bool is_protected_vertex(std::uint32_t v) const {  // of the mesh
    return v < at_protected_.size() && at_protected_[v];
  }
  double length(const Piece& p) const {
    const Point3 d = context_.point(p.b) - context_.point(p.a);
    return std::sqrt(dot(d, d));
  }

  void list_pieces() {
    at_protected_.assign(context_.mesh.vertices.size(), false);
    on_protected_.assign(context_.mesh.vertices.size(), false);
    for (std::size_t v = 0; v < features_.vertices.size(); ++v) {
      const std::uint32_t m = context_.mesh_vertex[v];
      if (features_.vertices[v] && m != kNoIndex) at_protected_[m] = on_protected_[m] = true;
    }
    const ChainFinder finder(context_);
    for (std::uint32_t s = 0; s < context_.complex.segments.size(); ++s) {
      const auto& ends = context_.complex.segments[s];
      if (!context_.segment_wanted[s]) continue;
      if (!features_.vertices[ends[0]] && !features_.vertices[ends[1]]) continue;
      const auto chain = finder.find(s).vertices;  // where it is broken, `input-segments` tells
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const std::uint32_t a = chain[k], b = chain[k + 1];
        const bool end = k == 0 || k + 2 == chain.size();
        const bool guarded =
            features_.segments[s] || is_protected_vertex(a) || is_protected_vertex(b);
        if (features_.segments[s]) on_protected_[a] = on_protected_[b] = true;
        if (guarded) pieces_.push_back({a, b, s, end});
      }
    }
  }

  /// (H2). Of a piece that is no end segment also the distance to what does not contain its
  /// segment, which the collars need beyond mfs_1 (docs/algorithms.md).
  void check_sizes() {
    const FeatureSizes3 sizes(context_.complex);
    for (const Piece& p : pieces_) {
      const Point3 &a = context_.point(p.a), &b = context_.point(p.b);
      double bound = std::min(sizes.of_subsegment(a, b, 1).radius, sizes.local(a, b, 2).radius);
      if (std::isfinite(bound)) least_ = std::min(least_, length(p) / bound);
      if (!p.end) bound = std::min(bound, sizes.clearance(a, b, p.segment, 2).radius);
      if (std::isinf(bound)) continue;
      const double ratio = length(p) / bound;
      if (ratio > worst_) {
        worst_ = ratio;
        worst_piece_ = {p.a, p.b};
      }
      if (length(p) > factor() * bound * (1 + kRoundedPosition) + context_.rounding) {
        fail("|s| < c min(fs_1(s), lfs(s)) (thesis, H2) fails for " + vertices_text({p.a, p.b}) +
                 ": |s| = " + value_text(length(p)) + ", the feature size is " + value_text(bound),
             {p.a, p.b});
      }
    }
  }

  void check_end_segments() {
    std::vector<double> shortest(context_.mesh.vertices.size(), HUGE_VAL);
    for (const Piece& p : pieces_) {
      for (const std::uint32_t v : {p.a, p.b}) {
        if (is_protected_vertex(v)) shortest[v] = std::min(shortest[v], length(p));
      }
    }
    for (const Piece& p : pieces_) {
      for (const std::uint32_t v : {p.a, p.b}) {
        if (!is_protected_vertex(v)) continue;
        if (length(p) > shortest[v] * (1 + kRoundedPosition) + 2 * context_.rounding) {
          fail("end segments at vertex " + std::to_string(v) + " differ (thesis, H3): " +
                   value_text(shortest[v]) + " and " + value_text(length(p)),
               {p.a, p.b});
        }
      }
    }
  }

  /// Lemma 6.9 I: of protected subsegments, and of facets in faces that have a corner on a
  /// protected segment or at a protected vertex. What lies in the face itself does not count: there
  /// the Delaunay triangulation in the plane decides.
  void check_balls() {
    const Mesh& mesh = context_.mesh;
    std::vector<Box3> boxes;
    for (const Point3& p : mesh.vertices) boxes.push_back(Box3::of(p));
    const BoxTree3 tree(std::move(boxes));
    const auto look = [&](const Point3& center, double radius2,
                          const std::vector<std::uint32_t>& corners, std::uint32_t face) {
      const double r = std::sqrt(radius2);
      const Box3 box = Box3::of({center.x - r, center.y - r, center.z - r},
                                {center.x + r, center.y + r, center.z + r});
      const double most = radius2 * (1 - kRoundedPower) - 2 * context_.rounding * r;
      tree.query([&](const Box3& other) { return box.meets(other); },
                 [&](std::uint32_t v) {
                   if (!context_.used[v]) return true;
                   const Point3 d = context_.point(v) - center;
                   if (dot(d, d) >= most) return true;
                   if (std::find(corners.begin(), corners.end(), v) != corners.end()) return true;
                   if (face != kNoIndex && context_.lies_in_face(v, face)) return true;
                   fail("the ball of " + vertices_text(corners) + " holds vertex " +
                            std::to_string(v) + " (thesis, Lemma 6.9 I)",
                        corners);
                   return true;
                 });
    };
    for (const Piece& p : pieces_) {
      const Point3 &a = context_.point(p.a), d = context_.point(p.b) - a;
      look(along(a, 0.5, d), 0.25 * dot(d, d), {p.a, p.b}, kNoIndex);
    }
    // In tubes of Algorithm 6.3 facets of faces are not Delaunay (Theorem 6.15).
    if (promises("delaunay-outside")) return;
    for (const MeshFacet& f : mesh.facets) {
      const std::vector<std::uint32_t> corners{f.a, f.b, f.c};
      bool usable = true, beside = false;
      for (const std::uint32_t v : corners) {
        usable = usable && v < context_.used.size() && context_.used[v];
        beside = beside || (usable && on_protected_[v]);
      }
      if (!usable || !beside || context_.is_between_layers(f)) continue;
      ++facets_;
      const Point3 &a = context_.point(f.a), u = context_.point(f.b) - a,
                   v = context_.point(f.c) - a, n = cross(u, v);
      const double uu = dot(u, u), vv = dot(v, v), t = 0.5 / dot(n, n);
      if (!std::isfinite(t)) continue;
      const Point3 vn = cross(v, n), nu = cross(n, u);
      const Point3 o{(uu * vn.x + vv * nu.x) * t, (uu * vn.y + vv * nu.y) * t,
                     (uu * vn.z + vv * nu.z) * t};
      look(along(a, 1, o), dot(o, o), corners, f.face);
    }
  }

  const VerifyContext3& context_;
  ProtectedFeatures features_;
  Check check_;
  std::vector<Piece> pieces_;
  std::vector<bool> at_protected_, on_protected_;  // by mesh vertex
  std::size_t facets_ = 0;
  double worst_ = 0, least_ = HUGE_VAL;
  std::vector<std::uint32_t> worst_piece_;
};

}  // namespace

Check check_protection(const VerifyContext3& context) { return ProtectionCheck(context).run(); }

}  // namespace circumball
