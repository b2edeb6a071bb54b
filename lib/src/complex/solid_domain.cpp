#include "complex/solid_domain.h"

#include <algorithm>

#include "circumball/predicates.h"
#include "complex/live2.h"

namespace circumball {
namespace {

/// The face that the triangle abc lies in; kNone if there is none.
std::uint32_t face_of(const Live3& live, VertexId a, VertexId b, VertexId c) {
  for (const std::uint32_t f : live.faces_of(live.feature(a))) {
    if (live.is_in_face(f, a, b, c)) return f;
  }
  return kNone;
}

bool can_lie_in_face(const Live3& live, VertexId v) {
  return v != Delaunay3::kGhost && live.feature(v).kind != FeatureKind::kFree;
}

}  // namespace

bool has_one_group(const Live3& live, CellSlot c) {
  const Delaunay3& dt = live.triangulation();
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (!can_lie_in_face(live, dt.corner(c, i))) return false;
  }
  for (const std::uint32_t f : live.faces_of(live.feature(dt.corner(c, 0)))) {
    const std::uint32_t group = live.group_of_face(f);
    bool all = true;
    for (std::uint32_t i = 1; i < 4 && all; ++i) all = live.lies_in_group(dt.corner(c, i), group);
    if (all) return true;
  }
  return false;
}

FaceFacets::FaceFacets(const Live3& live) {
  const Delaunay3& dt = live.triangulation();
  faces_.assign(4 * std::size_t{dt.slot_count()}, kNone);
  barrier_.assign(faces_.size(), false);
  flat_.assign(dt.slot_count(), false);
  if (live.face_count() == 0 || dt.dimension() < 3) return;
  dt.for_each_cell([&](CellSlot c) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellFacet f = 4 * c + i, twin = dt.twin(f);
      if (twin < f && !dt.is_ghost(twin / 4)) continue;  // done from its other side
      const VertexId p = dt.facet_corner(f, 0), q = dt.facet_corner(f, 1),
                     r = dt.facet_corner(f, 2);
      if (!can_lie_in_face(live, p) || !can_lie_in_face(live, q) || !can_lie_in_face(live, r)) {
        continue;
      }
      faces_[f] = faces_[twin] = face_of(live, p, q, r);
      barrier_[f] = barrier_[twin] = faces_[f] != kNone || live.is_in_group(p, q, r);
    }
  });
  dt.for_each_cell([&](CellSlot c) {
    bool flat = false;
    for (std::uint32_t i = 0; i < 4; ++i) flat = flat || barrier_[4 * c + i];
    flat_[c] = flat && has_one_group(live, c);
  });
}

namespace {

/// Labels cells; see classify.
class Classification {
 public:
  explicit Classification(Live3* live) : live_(*live), dt_(live->triangulation()), facets_(*live) {}

  void run() {
    const Complex& complex = live_.complex();
    // A vertex that rounding put outside of the hull makes cells that inherit from ghosts.
    const bool closed = live_.domain() == Domain::kClosed;
    for (CellSlot c = 0; c < dt_.slot_count(); ++c) {
      if (dt_.alive(c) && dt_.is_ghost(c)) dt_.set_label(c, closed ? kOutside : kInside);
    }
    if (closed) {
      flood_levels();
    } else {
      dt_.for_each_cell([&](CellSlot c) { dt_.set_label(c, kInside); });
    }
    if (closed) {
      for (const Point3& hole : complex.holes) flood(hole, kOutside);
    }
    for (std::uint32_t i = 0; i < complex.regions.size(); ++i) {
      flood(complex.regions[i].at, kFirstRegion + i);
    }
    if (!complex.regions.empty() || !complex.holes.empty()) label_flat();
  }

 private:
  /// Level: how many faces are between a cell and the outside, at least.
  void flood_levels() {
    std::vector<std::uint32_t> level(dt_.slot_count(), kNone);
    std::vector<CellSlot> now, next;
    for (CellSlot c = 0; c < dt_.slot_count(); ++c) {
      if (!dt_.alive(c) || !dt_.is_ghost(c)) continue;
      level[c] = 0;
      now.push_back(c);
    }
    for (std::uint32_t depth = 0; !now.empty() || !next.empty();) {
      if (now.empty()) {
        ++depth;
        for (const CellSlot c : next) {
          if (level[c] != kNone) continue;
          level[c] = depth;
          now.push_back(c);
        }
        next.clear();
        continue;
      }
      const CellSlot c = now.back();
      now.pop_back();
      for (std::uint32_t i = 0; i < 4; ++i) {
        const CellSlot d = dt_.twin(4 * c + i) / 4;
        if (level[d] != kNone || is_replaced(d)) continue;
        // A flat cell is part of the face: to enter it is free, to leave it is to cross the face.
        if (facets_.is_barrier(4 * c + i) && !facets_.is_flat(d)) {
          next.push_back(d);
        } else {
          level[d] = depth;
          now.push_back(d);
        }
      }
    }
    const bool parity = holes_by_parity(live_.complex());
    dt_.for_each_cell([&](CellSlot c) {
      const bool inside = level[c] != kNone && (parity ? level[c] % 2 == 1 : level[c] >= 1);
      dt_.set_label(c, inside ? kInside : kOutside);
    });
    // Cells that floods go around go with those beside them, so that what inherits from them is
    // hardly ever wrong.
    std::vector<CellSlot> beside;
    dt_.for_each_cell([&](CellSlot c) {
      if (level[c] != kNone || !is_replaced(c)) return;
      for (std::uint32_t i = 0; i < 4; ++i) {
        const CellSlot d = dt_.twin(4 * c + i) / 4;
        if (level[d] == kNone || dt_.is_ghost(d) || dt_.label(d) != kInside) continue;
        beside.push_back(c);
        return;
      }
    });
    for (const CellSlot c : beside) dt_.set_label(c, kInside);
  }

  void flood(const Point3& seed, std::uint32_t label) {
    if (dt_.dimension() < 3) return;
    const CellSlot start = dt_.locate(seed, kNone);
    if (start == kNone || dt_.is_ghost(start) || dt_.label(start) != kInside) return;
    for (std::uint32_t i = 0; i < 4; ++i) {  // a seed in a face means neither side (see `check`)
      const CellFacet f = 4 * start + i;
      if (facets_.is_barrier(f) &&
          orient3d(dt_.point(dt_.facet_corner(f, 0)), dt_.point(dt_.facet_corner(f, 1)),
                   dt_.point(dt_.facet_corner(f, 2)), seed) == Sign::kZero) {
        return;
      }
    }
    dt_.set_label(start, label);
    stack_.assign(1, start);
    while (!stack_.empty()) {
      const CellSlot c = stack_.back();
      stack_.pop_back();
      for (std::uint32_t i = 0; i < 4; ++i) {
        const CellSlot d = dt_.twin(4 * c + i) / 4;
        if (facets_.is_barrier(4 * c + i) || dt_.is_ghost(d) || dt_.label(d) != kInside) continue;
        if (is_replaced(d)) continue;
        dt_.set_label(d, label);
        stack_.push_back(d);
      }
    }
  }

  /// Flat cells that seeds did not reach, as facets of the face are all around: outside where
  /// something beside them is, else of the first region beside them.
  void label_flat() {
    std::vector<CellSlot> flat;
    dt_.for_each_cell([&](CellSlot c) {
      if (facets_.is_flat(c) && dt_.label(c) == kInside) flat.push_back(c);
    });
    for (bool changed = true; changed;) {
      changed = false;
      for (const CellSlot c : flat) {
        std::uint32_t label = dt_.label(c);
        for (std::uint32_t i = 0; i < 4; ++i) {
          const CellSlot d = dt_.twin(4 * c + i) / 4;
          const std::uint32_t other = dt_.is_ghost(d) ? std::uint32_t{kOutside} : dt_.label(d);
          if (other == kOutside || (label == kInside && other >= kFirstRegion)) label = other;
        }
        changed = changed || label != dt_.label(c);
        dt_.set_label(c, label);
      }
    }
  }

  /// Cells in tubes of Algorithm 6.3 need not conform: floods go around them.
  bool is_replaced(CellSlot c) const {
    return live_.has_intestine() && !live_.intestine().structured() && !dt_.is_ghost(c) &&
           live_.is_in_tube(c);
  }

  Live3& live_;
  Delaunay3& dt_;
  const FaceFacets facets_;
  std::vector<CellSlot> stack_;
};

}  // namespace

std::vector<RelabeledCell> classify(Live3* live) {
  Delaunay3& dt = live->triangulation();
  std::vector<std::uint32_t> before(dt.slot_count(), kUnknown);
  dt.for_each_cell([&](CellSlot c) { before[c] = dt.label(c); });
  Classification(live).run();
  const bool first = !live->classified();
  live->set_classified();
  std::vector<RelabeledCell> changed;
  dt.for_each_cell([&](CellSlot c) {
    if (dt.label(c) != before[c])
      changed.push_back({c, first ? std::uint32_t{kUnknown} : before[c]});
  });
  return changed;
}

}  // namespace circumball
