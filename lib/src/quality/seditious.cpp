#include <algorithm>
#include <array>
#include <cmath>

#include "quality/context.h"
#include "quality/triangle_measure.h"

namespace circumball {
namespace {

double distance_between(const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Which edges of the mesh are seditious: their ends lie inside two input segments that meet at
/// less than 60 degrees, equally far from where they meet.
class SeditiousEdges {
 public:
  explicit SeditiousEdges(const VerifyContext& context)
      : context_(context), segment_(context.mesh.vertices.size(), kNoIndex) {
    const ChainFinder chains(context);
    for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
      const Chain chain = chains.find(s);
      for (std::size_t i = 1; i + 1 < chain.vertices.size(); ++i) segment_[chain.vertices[i]] = s;
    }
  }

  bool has(std::uint32_t u, std::uint32_t v) const {
    if (segment_[u] == kNoIndex || segment_[v] == kNoIndex || segment_[u] == segment_[v]) {
      return false;
    }
    const auto& s = context_.complex.segments[segment_[u]];
    const auto& r = context_.complex.segments[segment_[v]];
    for (unsigned i = 0; i < 2; ++i) {
      for (unsigned j = 0; j < 2; ++j) {
        if (s[i] == r[j]) return across(s[i], s[1 - i], r[1 - j], u, v);
      }
    }
    return false;
  }

 private:
  /// Whether u and v, on the segments from input vertex w to a and to b, are equally far from w,
  /// as far as rounded coordinates can tell, and the angle at w is below 60 degrees.
  bool across(std::uint32_t w, std::uint32_t a, std::uint32_t b, std::uint32_t u,
              std::uint32_t v) const {
    const auto input = [&](std::uint32_t i) { return xy(context_.complex.vertices[i]); };
    const Point2 p = input(w), pa = input(a), pb = input(b);
    const double du = distance_between(p, context_.point(u));
    const double dv = distance_between(p, context_.point(v));
    if (std::fabs(du - dv) > kOnSegment * du + context_.rounding) return false;
    const double dot = (pa.x - p.x) * (pb.x - p.x) + (pa.y - p.y) * (pb.y - p.y);
    return dot > (0.5 - kOnSegment) * distance_between(p, pa) * distance_between(p, pb);
  }

  const VerifyContext& context_;
  std::vector<std::uint32_t> segment_;  // by mesh vertex: the input segment that it is inside of
};

}  // namespace

/// What the terminator promises: every triangle with RE(t) > tau has a seditious shortest edge.
Check check_seditious(const VerifyContext& context) {
  Check check;
  check.name = "seditious";
  const double tau = context.options.tau.value_or(0);
  const SeditiousEdges edges(context);
  std::size_t allowed = 0, bad = 0;
  for (const auto& cell : context.cells) {
    const std::array<Point2, 3> p{context.point(cell[0]), context.point(cell[1]),
                                  context.point(cell[2])};
    const TriangleMeasure m = measure_triangle(p[0], p[1], p[2]);
    if (m.radius_edge * (1 - 2 * m.error) <= tau) continue;
    std::array<double, 3> length{};
    for (unsigned i = 0; i < 3; ++i) {
      length[i] = distance_between(p[(i + 1) % 3], p[(i + 2) % 3]);
    }
    // Edges that tie for the shortest are told apart by nothing: any of them will do.
    const double shortest = *std::min_element(length.begin(), length.end());
    bool seditious = false;
    for (unsigned i = 0; i < 3; ++i) {
      seditious = seditious || (length[i] <= (1 + kOnSegment) * shortest + context.rounding &&
                                edges.has(cell[(i + 1) % 3], cell[(i + 2) % 3]));
    }
    if (seditious) {
      ++allowed;
    } else if (bad++ == 0) {
      check.worst = {cell[0], cell[1], cell[2]};
    }
  }
  check.ok = bad == 0;
  check.bound = 0;
  check.observed = static_cast<double>(bad);
  check.detail = bad == 0 ? count_text(allowed, "cell") +
                                " above tau, the shortest edge of each between two segments at "
                                "less than 60 degrees, equally far from where they meet"
                          : count_text(bad, "cell") +
                                " above tau whose shortest edge is not seditious, the first is " +
                                vertices_text(check.worst);
  return check;
}

}  // namespace circumball
