#include "complex/matching_region.h"

#include <algorithm>
#include <map>

#include "circumball/predicates.h"
#include "complex/solid_domain.h"

namespace circumball {

MatchingRegion::MatchingRegion(const Live3& live) {
  const Delaunay3& dt = live.triangulation();
  const Intestines& intestine = live.intestine();
  replaced.assign(dt.slot_count(), false);
  dt.for_each_cell([&](CellSlot c) { replaced[c] = live.is_in_tube(c); });
  const auto edge = [](VertexId a, VertexId b) {
    return std::array<VertexId, 2>{std::min(a, b), std::max(a, b)};
  };
  // p1 with every triangle of the surface.
  std::map<std::pair<std::uint32_t, std::array<VertexId, 2>>, std::uint32_t> label_of_chord;
  dt.for_each_cell([&](CellSlot c) {
    if (!replaced[c]) return;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellSlot beyond = dt.twin(4 * c + i) / 4;
      if (!dt.is_ghost(beyond) && replaced[beyond]) continue;
      const VertexId v[3] = {dt.facet_corner(4 * c + i, 0), dt.facet_corner(4 * c + i, 1),
                             dt.facet_corner(4 * c + i, 2)};
      const std::uint32_t piece = intestine.piece_of(v[0], v[1], v[2]);
      if (piece == kNoIndex) {
        // A triangle of the cone from a tip to its ring: the cell beyond is at the input vertex.
        const bool at_tip = std::any_of(
            v, v + 3, [&](VertexId p) { return live.feature(p).kind == FeatureKind::kSegment; });
        matches = matches && at_tip && !dt.is_ghost(beyond);
        continue;
      }
      const std::uint32_t label = dt.is_ghost(beyond)
                                      ? (live.domain() == Domain::kClosed ? kOutside : kInside)
                                      : dt.label(beyond);
      // Seen from the cell that it takes the place of.
      add(live, {intestine.ring(piece).about, v[0], v[1], v[2]}, label);
      for (int k = 0; k < 3; ++k) label_of_chord[{piece, edge(v[k], v[(k + 1) % 3])}] = label;
    }
  });
  // p1, p2 with every chord of the second ring.
  for (std::uint32_t r = 0; r < intestine.ring_count(); ++r) {
    if (intestine.ring(r).next == kNoIndex) continue;
    const Ring& ring = intestine.ring(intestine.ring(r).next);
    const VertexId p1 = intestine.ring(r).about, p2 = ring.about;
    bool in_domain = false;
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
      const VertexId a = ring.vertices[i].vertex,
                     b = ring.vertices[(i + 1) % ring.vertices.size()].vertex;
      const auto found = label_of_chord.find({r, edge(a, b)});
      matches = matches && found != label_of_chord.end();
      if (!matches) return;
      // Keys ascend counter-clockwise about the axis, which points from p1 to p2.
      add(live, {p1, p2, b, a}, found->second);
      in_domain = in_domain || found->second != kOutside;
    }
    if (in_domain) inside_edges.push_back(edge(p1, p2));
    const auto& bases = intestine.tube_of(ring).bases;
    for (std::size_t k = 0; k < bases.size(); ++k) {
      if (bases[k].face == kNoIndex) continue;
      const VertexId v = ring.at(k * kRingGap);
      if (v.valid()) facets.push_back({{p1, p2, v}, bases[k].face});
    }
  }
  for (std::uint32_t i = 0; i < live.subsegment_count(); ++i) {
    const Subsegment& u = live.subsegment(SubsegmentId(i));
    if (!u.alive || !u.is_collar_element() || u.is_arc()) continue;
    const std::uint32_t piece = intestine.piece_of(u.a, u.b, u.b);
    if (piece != kNoIndex) facets.push_back({{intestine.ring(piece).about, u.a, u.b}, u.face});
  }
  std::sort(inside_edges.begin(), inside_edges.end());
  leave_out_facets_outside();
}

/// Corners are given counter-clockwise: turned around, a cell would overlap others.
void MatchingRegion::add(const Live3& live, const std::array<VertexId, 4>& v, std::uint32_t label) {
  const Delaunay3& dt = live.triangulation();
  const Sign sign = orient3d(dt.point(v[0]), dt.point(v[1]), dt.point(v[2]), dt.point(v[3]));
  if (sign != Sign::kPositive) matches = false;
  cells.push_back({v, label});
}

/// Parts of a face may be outside of a closed domain: only facets of cells of the domain count.
void MatchingRegion::leave_out_facets_outside() {
  std::vector<std::array<VertexId, 3>> of_cells;
  for (const Cell& c : cells) {
    if (c.label == kOutside) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<VertexId, 3> f{c.v[(i + 1) % 4], c.v[(i + 2) % 4], c.v[(i + 3) % 4]};
      std::sort(f.begin(), f.end());
      of_cells.push_back(f);
    }
  }
  std::sort(of_cells.begin(), of_cells.end());
  facets.erase(std::remove_if(facets.begin(), facets.end(),
                              [&](const Facet& f) {
                                std::array<VertexId, 3> v = f.v;
                                std::sort(v.begin(), v.end());
                                return !std::binary_search(of_cells.begin(), of_cells.end(), v);
                              }),
               facets.end());
}

}  // namespace circumball
