#include "complex/live2.h"

#include <algorithm>
#include <cmath>

#include "circumball/predicates.h"
#include "delaunay/constructions.h"

namespace circumball {

Live2::Live2(const Complex& complex, Domain domain) : complex_(&complex), domain_(domain) {
  features_.reserve(complex.vertices.size());
  for (std::uint32_t i = 0; i < complex.vertices.size(); ++i) {
    add_vertex(xy(complex.vertices[i]), {FeatureKind::kVertex, i});
  }
  for (const Region& region : complex.regions) {
    if (region.max <= 0) continue;
    if (least_area_bound_ == 0 || region.max < least_area_bound_) least_area_bound_ = region.max;
  }
}

VertexId Live2::add_vertex(const Point2& p, Feature feature) {
  features_.push_back(feature);
  return triangulation_.add_vertex(p);
}

void Live2::pop_vertex() {
  features_.pop_back();
  triangulation_.pop_vertex();
}

void Live2::commit(VertexId v, std::uint32_t splitting) {
  triangulation_.commit(v, splitting);
  if (!classified_) return;
  const auto& died = triangulation_.died();
  if (died.empty()) return;
  bool known = true, alike = true;
  for (const Delaunay2::Triangle& t : died) {
    known = known && t.label != kUnknown;
    alike = alike && t.label == died[0].label;
  }
  if (known && !alike) return;  // inherited, or lost to a swallowed subsegment
  const std::uint32_t label = known ? died[0].label : std::uint32_t{kUnknown};
  for (const TriangleId u : triangulation_.born()) {
    if (!triangulation_.is_ghost(u)) triangulation_.set_label(u, label);
  }
}

void Live2::create_subsegments() {
  const auto& segments = complex_->segments;
  subsegments_.reserve(2 * segments.size());
  // Of segments given twice (a warning of `check`) the first counts.
  std::vector<std::array<std::uint32_t, 3>> missing;  // ends in order, number
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const SubsegmentId s(static_cast<std::uint32_t>(subsegments_.size()));
    subsegments_.push_back({VertexId(segments[i][0]), VertexId(segments[i][1]), SegmentId(i)});
    const HalfEdge h = edge_of(s);
    if (h == kNone) {
      const auto [low, high] = std::minmax(segments[i][0], segments[i][1]);
      missing.push_back({low, high, i});
    } else if (triangulation_.tag(h) != kNone) {
      subsegments_.back().alive = false;
    } else {
      triangulation_.set_tag(h, s.value);
    }
  }
  std::sort(missing.begin(), missing.end());
  for (std::size_t k = 1; k < missing.size(); ++k) {
    const auto &first = missing[k - 1], &second = missing[k];
    if (first[0] == second[0] && first[1] == second[1]) subsegments_[second[2]].alive = false;
  }
}

void Live2::track_incidence() {
  incident_.assign(triangulation_.vertex_count(), {});
  shortest2_.assign(complex_->vertices.size(), HUGE_VAL);
  for (std::uint32_t i = 0; i < subsegment_count(); ++i) {
    if (!subsegments_[i].alive) continue;
    incident_[subsegments_[i].a.value].push_back(SubsegmentId(i));
    incident_[subsegments_[i].b.value].push_back(SubsegmentId(i));
    note_length(subsegments_[i]);
  }
}

void Live2::note_length(const Subsegment& s) {
  const double length2 = squared_distance(triangulation_.point(s.a), triangulation_.point(s.b));
  for (const VertexId end : {s.a, s.b}) {
    if (feature(end).kind != FeatureKind::kVertex) continue;
    shortest2_[end.value] = std::min(shortest2_[end.value], length2);
  }
}

void Live2::protect(VertexId q0, double distance) {
  if (protection_.empty()) protection_.assign(complex_->vertices.size(), 0);
  protection_[q0.value] = distance;
}

SubsegmentId Live2::create_arc(VertexId a, VertexId b, VertexId center) {
  const SubsegmentId s(subsegment_count());
  Subsegment arc{a, b, SegmentId()};
  arc.center = center;
  subsegments_.push_back(arc);
  tag_edge(s);
  return s;
}

bool Live2::tag_edge(SubsegmentId s) {
  const HalfEdge h = edge_of(s);
  if (h == kNone) return false;
  triangulation_.set_tag(h, s.value);
  return true;
}

std::array<SubsegmentId, 2> Live2::split(SubsegmentId s, VertexId m) {
  Subsegment& old = subsegments_[s.value];
  old.alive = false;
  Subsegment first{old.a, m, old.segment}, second{m, old.b, old.segment};
  first.center = second.center = old.center;
  const SubsegmentId left(subsegment_count()), right(subsegment_count() + 1);
  subsegments_.push_back(first);  // `old` dangles from here on
  subsegments_.push_back(second);
  if (shells_.on() && !first.is_arc()) shells_.split(first.a, second.b, first.segment, m);
  if (!incident_.empty()) {
    auto& at_a = incident_[first.a.value];
    auto& at_b = incident_[second.b.value];
    *std::find(at_a.begin(), at_a.end(), s) = left;
    *std::find(at_b.begin(), at_b.end(), s) = right;
    incident_.resize(triangulation_.vertex_count());
    incident_[m.value] = {left, right};
    note_length(first);
    note_length(second);
  }
  tag_edge(left);
  tag_edge(right);
  // m is rounded: where another vertex is as near to the subsegment as m, the old edge may have
  // stayed. The triangle between it and m is on the far side of the new subsegments then.
  if (const HalfEdge h = triangulation_.find_edge(first.a, second.b); h != kNone) {
    triangulation_.set_tag(h, kNone);
    if (first.is_arc()) return {left, right};
    const HalfEdge other = triangulation_.twin(h);
    const bool near = triangulation_.apex(h) == m;
    if (near || triangulation_.apex(other) == m) {
      const TriangleId flat = (near ? h : other) / 4, beyond = (near ? other : h) / 4;
      relabel(flat, triangulation_.triangle(flat).label, triangulation_.triangle(beyond).label);
    }
  }
  return {left, right};
}

void Live2::mark_crossed(SubsegmentId s, std::vector<std::uint8_t>* crossed) const {
  const Delaunay2& dt = triangulation_;
  VertexId from = subsegments_[s.value].a;
  const VertexId to = subsegments_[s.value].b;
  const Point2 b = dt.point(to);
  while (from != to) {
    const Point2 a = dt.point(from);
    // The triangle at `from` that the subsegment enters, or the vertex that it runs into.
    const TriangleId start = dt.triangle_of(from);
    TriangleId t = start;
    HalfEdge exit = kNone;
    VertexId onto;
    do {
      const auto& v = dt.triangle(t).v;
      const unsigned i = v[0] == from ? 0 : v[1] == from ? 1 : 2;
      const VertexId p = v[(i + 1) % 3], q = v[(i + 2) % 3];
      if (!dt.is_ghost(t)) {
        if (p == to || q == to) return;
        const Sign right = orient2d(a, b, dt.point(p)), left = orient2d(a, b, dt.point(q));
        const Point2& pp = dt.point(p);
        if (right == Sign::kZero && (pp.x - a.x) * (b.x - a.x) + (pp.y - a.y) * (b.y - a.y) > 0) {
          onto = p;
        } else if (right == Sign::kNegative && left == Sign::kPositive) {
          exit = 4 * t + i;
        }
      }
      t = dt.twin(4 * t + (i + 1) % 3) / 4;
    } while (t != start && exit == kNone && !onto.valid());
    if (onto.valid()) {
      from = onto;
      continue;
    }
    if (exit == kNone) return;
    (*crossed)[exit / 4] = 1;
    for (;;) {  // cross triangles until the subsegment ends, or runs into a vertex
      const HalfEdge entry = dt.twin(exit);
      const TriangleId next = entry / 4;
      if (dt.is_ghost(next)) return;
      (*crossed)[next] = 1;
      const VertexId w = dt.apex(entry);
      if (w == to) return;
      const Sign side = orient2d(a, b, dt.point(w));
      if (side == Sign::kZero) {
        from = w;
        break;
      }
      // `entry` runs from the left end of `exit` to its right end; leave between w and the end on
      // w's other side.
      const unsigned i = entry % 4;
      exit = 4 * next + (side == Sign::kPositive ? (i + 1) % 3 : (i + 2) % 3);
      const VertexId o = dt.origin(exit), d = dt.target(exit);
      const bool separates = (orient2d(a, b, dt.point(o)) == Sign::kPositive) !=
                             (orient2d(a, b, dt.point(d)) == Sign::kPositive);
      if (!separates) exit = 4 * next + (side == Sign::kPositive ? (i + 2) % 3 : (i + 1) % 3);
    }
  }
}

void Live2::flood_levels(const std::vector<std::uint8_t>& crossed) {
  Delaunay2& dt = triangulation_;
  const std::uint32_t slots = dt.slot_count();
  std::vector<std::uint32_t> level(slots, kNone);
  std::vector<TriangleId> now, next;
  for (TriangleId t = 0; t < slots; ++t) {
    if (dt.alive(t) && dt.is_ghost(t)) {
      level[t] = 0;
      now.push_back(t);
    }
  }
  const bool parity = holes_by_parity(*complex_);
  for (std::uint32_t depth = 0; !now.empty() || !next.empty();) {
    if (now.empty()) {
      ++depth;
      for (const TriangleId t : next) {
        if (level[t] == kNone) {
          level[t] = depth;
          now.push_back(t);
        }
      }
      next.clear();
      continue;
    }
    const TriangleId t = now.back();
    now.pop_back();
    for (unsigned i = 0; i < 3; ++i) {
      const HalfEdge h = 4 * t + i;
      const TriangleId u = dt.twin(h) / 4;
      if (level[u] != kNone || crossed[u]) continue;
      if (on_segment(h)) {
        next.push_back(u);
      } else {
        level[u] = depth;
        now.push_back(u);
      }
    }
  }
  for (TriangleId t = 0; t < slots; ++t) {
    if (!dt.alive(t)) continue;
    if (crossed[t]) {
      dt.set_label(t, kUnknown);
      continue;
    }
    const bool inside = level[t] != kNone && (parity ? level[t] % 2 == 1 : level[t] >= 1);
    dt.set_label(t, inside ? kInside : kOutside);
  }
}

void Live2::label_crossed(const std::vector<std::uint8_t>& crossed) {
  Delaunay2& dt = triangulation_;
  // From the domain first, so that what it reaches is meshed; then from outside; then what nothing
  // reaches: it is enclosed on all sides.
  for (const bool from_inside : {true, false}) {
    stack_.clear();
    for (TriangleId t = 0; t < crossed.size(); ++t) {
      if (crossed[t] || (dt.triangle(t).label == kOutside) == from_inside) continue;
      stack_.push_back(t);
    }
    while (!stack_.empty()) {
      const TriangleId t = stack_.back();
      stack_.pop_back();
      for (unsigned i = 0; i < 3; ++i) {
        const HalfEdge h = 4 * t + i;
        const TriangleId u = dt.twin(h) / 4;
        if (!crossed[u] || dt.triangle(u).label != kUnknown || on_segment(h)) continue;
        dt.set_label(u, dt.triangle(t).label);
        stack_.push_back(u);
      }
    }
  }
  for (TriangleId t = 0; t < crossed.size(); ++t) {
    if (crossed[t] && dt.triangle(t).label == kUnknown) dt.set_label(t, kInside);
  }
}

void Live2::classify() {
  Delaunay2& dt = triangulation_;
  const std::uint32_t slots = dt.slot_count();
  std::vector<std::uint32_t> before;
  for (TriangleId t = 0; tracking_ && t < slots; ++t) {
    before.push_back(dt.alive(t) ? dt.triangle(t).label : kUnknown);
  }
  std::vector<std::uint8_t> crossed(slots, 0);
  if (domain_ == Domain::kClosed) {
    for (std::uint32_t i = 0; i < subsegment_count(); ++i) {
      const SubsegmentId s(i);
      const Subsegment& u = subsegment(s);
      if (u.alive && !u.is_arc() && edge_of(s) == kNone) mark_crossed(s, &crossed);
    }
    flood_levels(crossed);
  } else {
    stack_.clear();
    for (TriangleId t = 0; t < slots; ++t) {
      if (!dt.alive(t)) continue;
      dt.set_label(t, dt.is_ghost(t) ? kOutside : kInside);
      if (dt.is_ghost(t)) stack_.push_back(t);
    }
    while (!stack_.empty()) {  // pockets between the hull and the subsegments on it
      const TriangleId t = stack_.back();
      stack_.pop_back();
      for (unsigned i = 0; i < 3; ++i) {
        const HalfEdge h = 4 * t + i;
        const TriangleId u = dt.twin(h) / 4;
        if (on_segment(h) || dt.triangle(u).label != kInside || !is_pocket(u)) continue;
        dt.set_label(u, kOutside);
        stack_.push_back(u);
      }
    }
  }
  const auto flood = [&](const Point3& seed, std::uint32_t label) {
    if (dt.dimension() < 2) return;
    const TriangleId start = dt.locate(xy(seed), kNone);
    if (start == kNone || dt.triangle(start).label != kInside) return;
    for (unsigned i = 0; i < 3; ++i) {  // a seed on a segment means neither side (see `check`)
      const HalfEdge h = 4 * start + i;
      if (on_segment(h) &&
          orient2d(dt.point(dt.origin(h)), dt.point(dt.target(h)), xy(seed)) == Sign::kZero) {
        return;
      }
    }
    dt.set_label(start, label);
    stack_.assign(1, start);
    while (!stack_.empty()) {
      const TriangleId t = stack_.back();
      stack_.pop_back();
      for (unsigned i = 0; i < 3; ++i) {
        const HalfEdge h = 4 * t + i;
        const TriangleId u = dt.twin(h) / 4;
        if (on_segment(h) || dt.triangle(u).label != kInside) continue;
        dt.set_label(u, label);
        stack_.push_back(u);
      }
    }
  };
  if (domain_ == Domain::kClosed) {
    for (const Point3& hole : complex_->holes) flood(hole, kOutside);
  }
  for (std::uint32_t i = 0; i < complex_->regions.size(); ++i) {
    flood(complex_->regions[i].at, kFirstRegion + i);
  }
  label_crossed(crossed);
  classified_ = true;
  for (TriangleId t = 0; t < before.size(); ++t) {
    if (!dt.alive(t) || dt.is_ghost(t) || dt.triangle(t).label == before[t]) continue;
    relabeled_.push_back({t, before[t] == kVisited ? std::uint32_t{kUnknown} : before[t]});
  }
}

bool Live2::is_pocket(TriangleId t) const {
  const auto& corners = triangulation_.triangle(t).v;
  std::uint32_t segment = kNoIndex;
  for (const VertexId v : corners) {
    if (feature(v).kind == FeatureKind::kSegment) segment = feature(v).index;
  }
  if (segment == kNoIndex) return false;
  const auto& ends = complex_->segments[segment];
  return std::all_of(std::begin(corners), std::end(corners), [&](VertexId v) {
    const Feature& f = feature(v);
    return f.kind == FeatureKind::kSegment ? f.index == segment
                                           : v.value == ends[0] || v.value == ends[1];
  });
}

void Live2::relabel(TriangleId t, std::uint32_t before, std::uint32_t label) {
  triangulation_.set_label(t, label);
  if (tracking_) relabeled_.push_back({t, before});
}

std::vector<Live2::Relabeled> Live2::take_relabeled() {
  std::vector<Relabeled> all = std::exchange(relabeled_, {});
  const auto by_triangle = [](const Relabeled& p, const Relabeled& q) {
    return p.triangle < q.triangle;
  };
  std::stable_sort(all.begin(), all.end(), by_triangle);
  const auto same = [](const Relabeled& p, const Relabeled& q) { return p.triangle == q.triangle; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

bool Live2::in_domain(TriangleId t) {
  Delaunay2& dt = triangulation_;
  if (dt.is_ghost(t)) return false;
  if (!classified_) return true;
  if (dt.triangle(t).label != kUnknown) return dt.triangle(t).label != kOutside;
  // Flood the triangles that lost their label until one is met that has it: they are one piece of
  // the domain.
  std::uint32_t label = kUnknown;
  std::vector<TriangleId> piece{t};
  dt.set_label(t, kVisited);
  for (std::size_t next = 0; next < piece.size(); ++next) {
    for (unsigned i = 0; i < 3; ++i) {
      const HalfEdge h = 4 * piece[next] + i;
      if (on_segment(h)) continue;
      const TriangleId u = dt.twin(h) / 4;
      const std::uint32_t other = dt.triangle(u).label;
      if (dt.is_ghost(u)) {
        if (domain_ == Domain::kClosed) label = kOutside;
      } else if (other == kUnknown) {
        dt.set_label(u, kVisited);
        piece.push_back(u);
      } else if (other != kVisited) {
        label = other;
      }
    }
    if (label != kUnknown) break;
  }
  if (label == kUnknown && domain_ != Domain::kClosed && complex_->regions.empty()) {
    for (const TriangleId u : piece) relabel(u, kUnknown, is_pocket(u) ? kOutside : kInside);
    return dt.triangle(t).label != kOutside;
  }
  if (label == kUnknown) {
    // A piece with no labelled triangle in it: count levels again from outside.
    classify();
    label = dt.triangle(t).label;
  } else {
    for (const TriangleId u : piece) relabel(u, kUnknown, label);
  }
  return label != kOutside;
}

bool Live2::conforms() const {
  for (std::uint32_t i = 0; i < subsegment_count(); ++i) {
    const Subsegment& u = subsegments_[i];
    if (u.alive && !u.is_arc() && edge_of(SubsegmentId(i)) == kNone) return false;
  }
  return true;
}

std::size_t Live2::bytes() const {
  return triangulation_.bytes() + features_.capacity() * sizeof(Feature) +
         subsegments_.capacity() * sizeof(Subsegment);
}

bool encloses_something(const Complex& complex) {
  // A graph without a cycle is a forest: joining the ends of a segment that are joined already
  // closes a loop.
  std::vector<std::uint32_t> parent(complex.vertices.size());
  for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  auto segments = complex.segments;
  for (auto& s : segments) {
    if (s[0] > s[1]) std::swap(s[0], s[1]);
  }
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  for (const auto& s : segments) {
    const std::uint32_t a = root(s[0]), b = root(s[1]);
    if (a == b) return true;
    parent[a] = b;
  }
  return false;
}

bool holes_by_parity(const Complex& complex) {
  if (complex.hole_rule == HoleRule::kAuto) return complex.holes.empty() && complex.regions.empty();
  return complex.hole_rule == HoleRule::kParity;
}

}  // namespace circumball
