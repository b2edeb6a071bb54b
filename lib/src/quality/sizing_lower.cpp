#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "circumball/feature_size.h"
#include "circumball/predicates.h"
#include "complex/box_tree.h"
#include "quality/context.h"
#include "quality/triangle_measure.h"
#include "sizing/sizing.h"

namespace circumball {
namespace {

/// The complex that Theorem 7.13 speaks of, "in which adjacent segments are split at equal
/// lengths", as the mesh tells it, and what the theorem says of its vertices.
class EquallySplit {
 public:
  explicit EquallySplit(const VerifyContext& context)
      : context_(context),
        first_(context.mesh.input_vertices + context.mesh.box_vertices),
        end_(first_ + context.options.divisions),
        features_(split()) {
    std::vector<Box2> boxes;
    for (std::uint32_t v = 0; v < context.mesh.vertices.size(); ++v) {
      boxes.push_back(Box2::of(context.point(v)));
    }
    tree_ = BoxTree(std::move(boxes));
    find_pieces();
  }

  /// Of this complex: its vertices are inputs of the theorem.
  bool given(std::uint32_t v) const { return v < end_; }
  double local_feature_size(const Point2& x) const { return features_.local(x).radius; }

  /// Radius of the ball over which h is taken for a triangle whose last vertex is q. As printed, (1
  /// + sqrt 2) r_q: it holds the triangle that q was inserted for. But q may halve a piece because
  /// a vertex of an adjacent piece is in its disk, that one because of a third, and so on around
  /// their common vertex q0; all of them are as far from q0 as q is, so that the triangle that
  /// began it is in the ball of radius (1 + sqrt 2) rho + 2 |q - q0| about q, where rho is half the
  /// length of the piece that q halved.
  double radius(std::uint32_t q) const {
    const Piece& piece = pieces_[q];
    const double factor = 1 + std::sqrt(2.0);
    if (piece.about < 0) return factor * insertion_radius(q);
    return factor * std::max(insertion_radius(q), piece.half) + 2 * piece.about;
  }

 private:
  struct Piece {
    double half = 0;    // of the length of the subsegment that the vertex halved
    double about = -1;  // distance to the end q0 of its piece, where that is acute; else -1
  };
  struct OnSegment {
    double at;  // along the segment
    std::uint32_t vertex;
  };

  /// Distance to the nearest vertex that was there before.
  double insertion_radius(std::uint32_t q) const {
    double r = std::numeric_limits<double>::infinity();
    const Point2 x = context_.point(q);
    tree_.nearest(
        x, [&](std::uint32_t p) { return tree_.box(p).distance2(x); },
        [&](std::uint32_t p, double d2) {
          if (p >= q) return true;
          r = std::sqrt(d2);
          return false;
        });
    return r;
  }

  Complex split() {
    const Mesh& mesh = context_.mesh;
    Complex complex;
    complex.vertices.assign(mesh.vertices.begin(), mesh.vertices.begin() + end_);
    const auto& segments = context_.complex.segments;
    on_.resize(segments.size());
    for (std::uint32_t v = first_; v < mesh.vertices.size(); ++v) {
      const Feature& f = mesh.vertex_features[v];
      if (f.kind != FeatureKind::kSegment || f.index >= segments.size()) continue;
      const Point2 a = context_.point(segments[f.index][0]), p = context_.point(v);
      on_[f.index].push_back({distance(a, p), v});
    }
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      std::sort(on_[s].begin(), on_[s].end(),
                [](const OnSegment& p, const OnSegment& q) { return p.at < q.at; });
      std::uint32_t last = segments[s][0];
      for (const OnSegment& p : on_[s]) {
        if (!given(p.vertex)) continue;
        complex.segments.push_back({last, p.vertex});
        last = p.vertex;
      }
      complex.segments.push_back({last, segments[s][1]});
    }
    return complex;
  }

  /// Walks along each segment: for each of its later vertices the ends of its piece, and of what it
  /// halved.
  void find_pieces() {
    pieces_.resize(context_.mesh.vertices.size());
    const auto& segments = context_.complex.segments;
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      const double length =
          distance(context_.point(segments[s][0]), context_.point(segments[s][1]));
      std::vector<OnSegment> all{{0, segments[s][0]}};
      all.insert(all.end(), on_[s].begin(), on_[s].end());
      all.push_back({length, segments[s][1]});
      // The nearest vertex on each side that is older: what is on the stack is in order of age.
      std::vector<double> before(all.size()), after(all.size());
      std::vector<std::size_t> stack;
      const auto walk = [&](std::size_t i, std::vector<double>* nearest) {
        while (!stack.empty() && all[stack.back()].vertex > all[i].vertex) stack.pop_back();
        (*nearest)[i] = stack.empty() ? all[i].at : all[stack.back()].at;
        stack.push_back(i);
      };
      for (std::size_t i = 0; i < all.size(); ++i) walk(i, &before);
      stack.clear();
      for (std::size_t i = all.size(); i-- > 0;) walk(i, &after);
      const bool acute[2] = {is_acute(s, 0), is_acute(s, 1)};
      std::size_t first = 0;  // where the piece that i is in begins, and the last one of all
      std::size_t last = all.size() - 2;
      while (last > 0 && !given(all[last].vertex)) --last;
      for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        if (given(all[i].vertex)) {
          first = i;
          continue;
        }
        Piece& piece = pieces_[all[i].vertex];
        piece.half = std::min(all[i].at - before[i], after[i] - all[i].at);
        if (first == 0 && acute[0]) piece.about = all[i].at;
        if (first == last && acute[1]) piece.about = std::max(piece.about, length - all[i].at);
      }
    }
  }

  /// Whether another segment meets s at its end at less than 90 degrees.
  bool is_acute(std::uint32_t s, int end) {
    const auto& segments = context_.complex.segments;
    if (at_vertex_.empty()) {
      at_vertex_.resize(context_.complex.vertices.size());
      for (std::uint32_t k = 0; k < segments.size(); ++k) {
        at_vertex_[segments[k][0]].push_back(segments[k][1]);
        at_vertex_[segments[k][1]].push_back(segments[k][0]);
      }
    }
    const std::uint32_t v = segments[s][end], far = segments[s][1 - end];
    const Point2 q0 = xy(context_.complex.vertices[v]), tip = xy(context_.complex.vertices[far]);
    return std::any_of(at_vertex_[v].begin(), at_vertex_[v].end(), [&](std::uint32_t other) {
      return other != far &&
             in_diametral_ball(tip, xy(context_.complex.vertices[other]), q0) == Sign::kNegative;
    });
  }

  static double distance(const Point2& a, const Point2& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  }

  const VerifyContext& context_;
  const std::uint32_t first_, end_;
  std::vector<std::vector<OnSegment>> on_;  // by segment, in order: later vertices
  FeatureSizes features_;
  BoxTree tree_;
  std::vector<Piece> pieces_;  // by vertex
  std::vector<std::vector<std::uint32_t>> at_vertex_;
};

/// Whether lfs is at most `value` somewhere on the triangle. "No" is certain: lfs is Lipschitz with
/// constant 1, and a piece of the triangle is in a disk about its centroid.
Sizing::Infimum local_feature_size_over(const EquallySplit& split, double value, const Point2& a,
                                        const Point2& b, const Point2& c) {
  constexpr int kPieces = 512;
  struct Piece {
    Point2 a, b, c;
  };
  std::vector<Piece> open{{a, b, c}};
  for (int pieces = 0; !open.empty(); ++pieces) {
    if (pieces == kPieces) return Sizing::Infimum::kUnclear;
    const Piece t = open.back();
    open.pop_back();
    const Point2 g{(t.a.x + t.b.x + t.c.x) / 3, (t.a.y + t.b.y + t.c.y) / 3};
    double reach2 = 0;
    for (const Point2& p : {t.a, t.b, t.c}) {
      reach2 = std::max(reach2, (p.x - g.x) * (p.x - g.x) + (p.y - g.y) * (p.y - g.y));
    }
    const double size = split.local_feature_size(g);
    if (size <= value) return Sizing::Infimum::kBelow;
    if (size - std::sqrt(reach2) > value) continue;
    const auto mid = [](const Point2& p, const Point2& q) {
      return Point2{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
    };
    const Point2 ab = mid(t.a, t.b), bc = mid(t.b, t.c), ca = mid(t.c, t.a);
    open.insert(open.end(), {{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}});
  }
  return Sizing::Infimum::kAtLeast;
}

/// Meshes of this library know which vertex is on which segment.
bool labeled(const VerifyContext& context) {
  const Mesh& mesh = context.mesh;
  const std::size_t n = context.complex.vertices.size();
  for (const auto& s : context.complex.segments) {
    if (s[0] >= n || s[1] >= n) return false;
  }
  for (const Point3& p : mesh.vertices) {
    if (!usable(p.x) || !usable(p.y)) return false;
  }
  return context.arrangement && mesh.vertex_features.size() == mesh.vertices.size() &&
         std::size_t{mesh.input_vertices} + mesh.box_vertices == context.complex.vertices.size() &&
         context.complex.vertices.size() + context.options.divisions <= mesh.vertices.size() &&
         context.cells.size() == mesh.cell_count();
}

}  // namespace

/// The lower side of Theorem 7.13, as far as it holds: R_t >= 1/2 min(h(t), lfs(t)) where the last
/// vertex q of t is a circumcenter, and R_t >= 1/2 min(h(t) / sqrt 2, lfs(t)) where it lies on a
/// segment; see EquallySplit::radius for h(t), and docs/algorithms.md for why. A bound A on the
/// area of a region counts as a size: a triangle of a larger area has R^2 > 4 A / (3 sqrt 3).
Check check_sizing_lower(const VerifyContext& context) {
  Check check;
  check.name = "sizing-lower";
  check.bound = 0;
  Sizing h;
  std::string error;
  if (!Sizing::parse(context.options.sizing, &h, &error)) {
    check.detail = "the sizing function cannot be read: " + error;
    return check;
  }
  check.ok = true;
  if (!labeled(context)) {
    check.detail = "not looked at: the mesh does not say in which order it was made";
    return check;
  }
  double of_regions = std::numeric_limits<double>::infinity();
  for (const Region& r : context.complex.regions) {
    if (r.max > 0) of_regions = std::min(of_regions, std::sqrt(4 * r.max / (3 * std::sqrt(3.0))));
  }
  const EquallySplit split(context);
  std::size_t bad = 0, unclear = 0, by_size = 0;
  for (const auto& c : context.cells) {
    const Point2 p[3] = {context.point(c[0]), context.point(c[1]), context.point(c[2])};
    const std::uint32_t q = *std::max_element(c.begin(), c.end());
    const double diameter =
        2 * measure_triangle(p[0], p[1], p[2]).circumradius * (1 + kRoundedPosition) +
        context.rounding;
    Sizing::Infimum size = Sizing::Infimum::kAtLeast;
    if (!split.given(q)) {  // else lfs is at most the shortest edge
      const bool free = context.mesh.vertex_features[q].kind == FeatureKind::kFree;
      const double most = diameter * (free ? 1 : std::sqrt(2.0));
      size = of_regions <= most ? Sizing::Infimum::kBelow
                                : h.compare_over_disk(most, context.point(q),
                                                      split.radius(q) * (1 + kRoundedPosition));
    }
    if (size == Sizing::Infimum::kBelow) {
      ++by_size;
      continue;
    }
    const Sizing::Infimum feature = local_feature_size_over(split, diameter, p[0], p[1], p[2]);
    if (feature == Sizing::Infimum::kBelow) continue;
    if (size == Sizing::Infimum::kUnclear || feature == Sizing::Infimum::kUnclear) {
      ++unclear;
    } else if (bad++ == 0) {
      check.worst = {c[0], c[1], c[2]};
    }
  }
  check.ok = bad == 0;
  check.observed = static_cast<double>(bad);
  check.detail =
      bad == 0
          ? "no cell is smaller than half of the sizing function (on segments: of it over sqrt 2) "
            "and of the local feature size around it (thesis, Theorem 7.13, mended): " +
                std::to_string(by_size) + " because of the former"
          : count_text(bad, "cell") +
                " with a circumradius below half of the sizing function (on segments: of it over "
                "sqrt 2) and of the local feature size, the first is " +
                vertices_text(check.worst);
  if (unclear > 0) {
    check.detail += "; of " + count_text(unclear, "cell") + " 256 boxes could not decide it";
  }
  return check;
}

}  // namespace circumball
