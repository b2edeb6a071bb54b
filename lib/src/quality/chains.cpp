#include <algorithm>
#include <cmath>

#include "feature_size/vectors.h"
#include "quality/chains.h"
#include "quality/context.h"
#include "quality/context3.h"

namespace circumball {
namespace {

/// Where a point lies with respect to a segment: how far along (0 at the first end, 1 at the
/// second), how far off.
struct Place {
  double along, off;
};
template <class Point>
Place place(const Point& a, const Point& b, const Point& p) {
  const Point d = b - a, u = p - a;
  const double length2 = dot(d, d);
  return {dot(u, d) / length2, std::sqrt(cross2(u, d) / length2)};
}

}  // namespace

template <class Context>
ChainFinder<Context>::ChainFinder(const Context& context) : context_(context) {
  const std::size_t n = context.complex.segments.size();
  label_first_.assign(n + 1, 0);
  for (const MeshEdge& e : context.mesh.edges)
    if (e.segment < n) ++label_first_[e.segment + 1];
  for (std::size_t i = 0; i < n; ++i) label_first_[i + 1] += label_first_[i];
  label_edge_.resize(label_first_[n]);
  std::vector<std::uint32_t> next(label_first_.begin(), label_first_.end() - 1);
  for (std::uint32_t i = 0; i < context.mesh.edges.size(); ++i)
    if (context.mesh.edges[i].segment < n) label_edge_[next[context.mesh.edges[i].segment]++] = i;
}

template <class Context>
Chain ChainFinder<Context>::find(std::uint32_t segment) const {
  Chain chain;
  const auto& s = context_.complex.segments[segment];
  const std::size_t n = context_.complex.vertices.size();
  const std::uint32_t a = s[0] < n ? context_.mesh_vertex[s[0]] : kNoIndex;
  const std::uint32_t b = s[1] < n ? context_.mesh_vertex[s[1]] : kNoIndex;
  if (a == kNoIndex || b == kNoIndex || a == b) {
    chain.problem =
        a != kNoIndex && a == b ? "its ends are one vertex" : "an end of it is not in the mesh";
    if (a != kNoIndex) chain.at.push_back(a);
    if (b != kNoIndex && b != a) chain.at.push_back(b);
    return chain;
  }
  return label_first_[segment] < label_first_[segment + 1] ? find_labeled(segment, a, b)
                                                           : between(a, b);
}

template <class Context>
Chain ChainFinder<Context>::find_labeled(std::uint32_t segment, std::uint32_t a,
                                         std::uint32_t b) const {
  const Mesh& mesh = context_.mesh;
  const auto pa = context_.point(a), pb = context_.point(b);
  Chain chain;
  chain.labeled = true;
  const auto broken = [&](std::string why, std::vector<std::uint32_t> at) {
    chain.vertices.clear();
    chain.problem = std::move(why);
    chain.at = std::move(at);
    return chain;
  };
  struct Piece {
    double along;
    std::uint32_t from, to;
  };
  std::vector<Piece> pieces;
  for (std::uint32_t i = label_first_[segment]; i < label_first_[segment + 1]; ++i) {
    MeshEdge e = mesh.edges[label_edge_[i]];
    if (e.a >= mesh.vertices.size() || e.b >= mesh.vertices.size())
      return broken("a subsegment of it names a vertex that is not there", {});
    const Place p = place(pa, pb, context_.point(e.a)), q = place(pa, pb, context_.point(e.b));
    if (!(std::max(p.off, q.off) <= context_.on_segment()))
      return broken("a subsegment of it leaves it", {e.a, e.b});
    if (q.along < p.along) std::swap(e.a, e.b);
    pieces.push_back({std::min(p.along, q.along), e.a, e.b});
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
    if (p.along != q.along) return p.along < q.along;
    return p.from != q.from ? p.from < q.from : p.to < q.to;
  });
  chain.vertices.push_back(a);
  for (const Piece& p : pieces) {
    const std::uint32_t last = chain.vertices.back();
    if (p.from != last) return broken("it has a gap or an overlap", {last, p.from});
    // Where all vertices are collinear there are no cells, and the edges stand for themselves.
    if (!context_.cells.empty() && !context_.has_edge(p.from, p.to))
      return broken("a subsegment of it is not an edge of a cell", {p.from, p.to});
    if (p.to != b && p.to < mesh.vertex_features.size() &&
        !(mesh.vertex_features[p.to] == Feature{FeatureKind::kSegment, segment}))
      return broken("a vertex on it is labeled as lying elsewhere", {p.to});
    chain.vertices.push_back(p.to);
  }
  if (chain.vertices.back() != b) return broken("it has a gap", {chain.vertices.back(), b});
  return chain;
}

template <class Context>
Chain ChainFinder<Context>::between(std::uint32_t a, std::uint32_t b) const {
  const auto pa = context_.point(a), pb = context_.point(b);
  Chain chain;
  chain.vertices.push_back(a);
  double along = 0;
  for (std::uint32_t at = a; at != b;) {
    std::uint32_t best = kNoIndex;
    double best_along = 0;
    for (std::uint32_t k = context_.neighbor_first[at]; k < context_.neighbor_first[at + 1]; ++k) {
      const std::uint32_t v = context_.neighbor[k];
      if (v == a) continue;
      const Place p = v == b ? Place{1, 0} : place(pa, pb, context_.point(v));
      if (!(p.off <= context_.on_segment()) || !(p.along > along) || p.along > 1) continue;
      if (best == kNoIndex || p.along < best_along) {
        best = v;
        best_along = p.along;
      }
    }
    if (best == kNoIndex) {
      chain.vertices.clear();
      chain.problem = "no edge goes on along it";
      chain.at = {at, b};
      return chain;
    }
    chain.vertices.push_back(best);
    at = best;
    along = best_along;
  }
  return chain;
}

template class ChainFinder<VerifyContext>;
template class ChainFinder<VerifyContext3>;

}  // namespace circumball
