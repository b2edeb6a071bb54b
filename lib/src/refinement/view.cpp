#include "refinement/view.h"

#include <cmath>
#include <utility>

namespace circumball {

Point2 View::outward(const Point2& p, SubsegmentId s) const {
  HalfEdge h = live_.edge_of(s);
  if (h == kNone) return p;
  if (dt_.apex(h) == Delaunay2::kGhost) h = dt_.twin(h);
  if (dt_.apex(h) == Delaunay2::kGhost || dt_.apex(dt_.twin(h)) != Delaunay2::kGhost) return p;
  const Point2 a = dt_.point(dt_.origin(h)), b = dt_.point(dt_.target(h));  // inside on the left
  const auto inside = [&](const Point2& q) { return orient2d(a, b, q) == Sign::kPositive; };
  if (!inside(p)) return p;
  const auto step = [](double x, double direction) {
    return direction == 0 ? x : std::nextafter(x, direction > 0 ? HUGE_VAL : -HUGE_VAL);
  };
  // p is within half an ulp of the line in each coordinate, so that a whole ulp in both is enough.
  const Point2 q{step(p.x, b.y - a.y), step(p.y, a.x - b.x)};
  if (const Point2 only_x{q.x, p.y}; !inside(only_x)) return only_x;
  if (const Point2 only_y{p.x, q.y}; !inside(only_y)) return only_y;
  return q;
}

Point2 View::shell_point(SubsegmentId s, const Shells::Shell& shell) const {
  const Subsegment& u = live_.subsegment(s);
  const Point2 a = dt_.point(shell.center), b = dt_.point(shell.center == u.a ? u.b : u.a);
  const double t = shell.radius / shell.length;
  return outward({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, s);
}

Point2 View::off_center(TriangleRef t, double tau) const {
  const auto& v = dt_.triangle(t.id).v;
  unsigned shortest = 0;
  double shortest2 = HUGE_VAL;
  for (unsigned i = 0; i < 3; ++i) {
    const double length2 = squared_distance(dt_.point(v[(i + 1) % 3]), dt_.point(v[(i + 2) % 3]));
    if (length2 < shortest2) {
      shortest = i;
      shortest2 = length2;
    }
  }
  return circumball::off_center(dt_.point(v[(shortest + 1) % 3]), dt_.point(v[(shortest + 2) % 3]),
                                tau);
}

bool View::shortest_edge_is_seditious(TriangleRef t) const {
  const auto& v = dt_.triangle(t.id).v;
  double length2[3];
  for (unsigned i = 0; i < 3; ++i) {
    length2[i] = squared_distance(dt_.point(v[(i + 1) % 3]), dt_.point(v[(i + 2) % 3]));
  }
  const double shortest2 = std::min({length2[0], length2[1], length2[2]});
  for (unsigned i = 0; i < 3; ++i) {
    // Ties are the norm between shells: any of the shortest counts.
    if (length2[i] > kLengthSlack * kLengthSlack * shortest2) continue;
    if (is_seditious(v[(i + 1) % 3], v[(i + 2) % 3])) return true;
  }
  return false;
}

bool View::is_seditious(VertexId u, VertexId v) const {
  const Feature &f = live_.feature(u), &g = live_.feature(v);
  if (f.kind != FeatureKind::kSegment || g.kind != FeatureKind::kSegment) return false;
  const auto& segments = live_.complex().segments;
  const auto &s = segments[f.index], &r = segments[g.index];
  const Shells::Position p = live_.shells().position(u, SegmentId(f.index));
  const Shells::Position q = live_.shells().position(v, SegmentId(g.index));
  for (unsigned i = 0; i < 2; ++i) {
    for (unsigned j = 0; j < 2; ++j) {
      if (s[i] != r[j] || s[1 - i] == r[1 - j]) continue;
      const double d = i == 0 ? p.from_first : p.from_second;
      const double e = j == 0 ? q.from_first : q.from_second;
      if (d > kLengthSlack * e || e > kLengthSlack * d) continue;
      const Point2 w = dt_.point(VertexId(s[i]));
      const Point2 a = dt_.point(VertexId(s[1 - i])), b = dt_.point(VertexId(r[1 - j]));
      const double dot = (a.x - w.x) * (b.x - w.x) + (a.y - w.y) * (b.y - w.y);
      return 2 * dot > kLengthSlack * (distance(w, a) * distance(w, b));  // below 60 degrees
    }
  }
  return false;
}

double View::shortest2_of_spindle(SubsegmentId s) const {
  double shortest2 = squared_length(s);
  const Subsegment& u = live_.subsegment(s);
  for (const VertexId end : {u.a, u.b}) {
    if (is_input_vertex(end)) shortest2 = std::min(shortest2, live_.shortest2_at(end));
  }
  return shortest2;
}

bool View::is_witness(VertexId p, SubsegmentId s) const {
  const Subsegment& u = live_.subsegment(s);
  const Feature& carrier = live_.feature(p);
  if (carrier.kind == FeatureKind::kVertex) return p != u.a && p != u.b;
  if (carrier.kind != FeatureKind::kSegment || carrier.index == u.segment.value) return false;
  for (const std::uint32_t end : live_.complex().segments[carrier.index]) {
    if (VertexId(end) == u.a || VertexId(end) == u.b) return false;
  }
  return true;
}

Verdict View::too_large_an_estimate(SubsegmentId s) const {
  const Subsegment& u = live_.subsegment(s);
  const Point2 a = dt_.point(u.a), b = dt_.point(u.b);
  marks_.resize(dt_.vertex_count(), 0);
  ++mark_;
  const auto mark = [&](VertexId v) { return std::exchange(marks_[v.value], mark_) != mark_; };
  mark(u.a);
  mark(u.b);
  Verdict verdict;
  inside_.clear();
  const auto collect = [&](VertexId v) {
    dt_.for_each_neighbor(v, [&](VertexId p) {
      if (!mark(p) || in_diametral_ball(a, b, dt_.point(p)) != Sign::kPositive) return true;
      inside_.push_back(p);
      if (is_witness(p, s)) verdict = {Reason::kWitness, p, 0};
      return !verdict;
    });
  };
  // A vertex in the disk has one in it that is a neighbor of a, and one that is a neighbor of b
  // (shrink the disk towards that end). So one end is enough: the other may be the hub of a fan.
  collect(dt_.of_lesser_degree(u.a, u.b));
  if (verdict || inside_.empty()) return verdict;
  if (const Verdict long_one = too_long_for_spindle(s, inside_.front())) return long_one;
  // The vertices in a disk are connected by Delaunay edges in it: go on until a witness is met.
  for (std::size_t i = 0; i < inside_.size() && !verdict; ++i) collect(inside_[i]);
  return verdict;
}

Outlook View::look(Point2& c, TriangleRef t) {
  encroached_.clear();
  if (!std::isfinite(c.x) || !std::isfinite(c.y)) return Outlook::kCoincides;
  if (dt_.probe(c, t.id) == Delaunay2::Probe::kDuplicate) return Outlook::kCoincides;
  if (!cavity_holds(t.id)) {
    // Rounding threw the circumcentre of a needle out of its own circumdisk: compute it with more
    // digits.
    const auto& v = dt_.triangle(t.id).v;
    c = circumcenter_extended(dt_.point(v[0]), dt_.point(v[1]), dt_.point(v[2]));
    if (!std::isfinite(c.x) || !std::isfinite(c.y)) return Outlook::kCoincides;
    if (dt_.probe(c, t.id) == Delaunay2::Probe::kDuplicate) return Outlook::kCoincides;
    if (!cavity_holds(t.id)) return Outlook::kCoincides;
  }
  return outlook(c);
}

Outlook View::look_exactly(const Point2& p, TriangleRef t) {
  encroached_.clear();
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return Outlook::kCoincides;
  if (dt_.probe(p, t.id) == Delaunay2::Probe::kDuplicate) return Outlook::kCoincides;
  return cavity_holds(t.id) ? outlook(p) : Outlook::kCoincides;
}

/// Of the point just probed.
Outlook View::outlook(const Point2& c) {
  // An edge whose open diametral disk holds c lies inside the cavity of c or on its boundary.
  for (const HalfEdge h : dt_.cavity_boundary()) {
    const std::uint32_t tag = dt_.tag(h);
    if (tag == kNone) continue;
    if (disk_holds(live_.subsegment(SubsegmentId(tag)), c)) {
      encroached_.push_back(SubsegmentId(tag));
    }
  }
  for (const HalfEdge h : dt_.cavity_tagged_inside()) {
    encroached_.push_back(SubsegmentId(dt_.tag(h)));
  }
  if (!encroached_.empty()) return Outlook::kEncroaches;
  // The first triangle of a cavity is the one that holds the point.
  return live_.in_domain(dt_.cavity()[0]) ? Outlook::kFree : Outlook::kOutside;
}

Outlook View::look_at_midpoint(const Point2& m, SubsegmentId s) {
  encroached_.clear();
  const HalfEdge h = live_.edge_of(s);
  const TriangleId start = h != kNone ? h / 4 : dt_.triangle_of(live_.subsegment(s).a);
  const bool duplicate = dt_.probe(m, start) == Delaunay2::Probe::kDuplicate;
  return duplicate ? Outlook::kCoincides : Outlook::kFree;
}

double View::insertion_radius(const Point2& p) const {
  double nearest2 = HUGE_VAL;
  for (const HalfEdge h : dt_.cavity_boundary()) {
    const VertexId v = dt_.origin(h);
    if (v != Delaunay2::kGhost) nearest2 = std::min(nearest2, squared_distance(dt_.point(v), p));
  }
  return std::sqrt(nearest2);
}

}  // namespace circumball
