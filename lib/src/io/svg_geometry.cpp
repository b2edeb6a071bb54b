#include "io/svg_geometry.h"

#include <algorithm>
#include <cmath>

#include "io/numbers.h"
#include "predicates/elementary.h"

namespace circumball::io {
namespace {

double length(const Point2& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

Point2 unit(const Point2& p) {
  const double n = length(p);
  return n > 0 ? Point2{p.x / n, p.y / n} : Point2{1, 0};
}

Point2 on(const EllipseArc& arc, const Point2& u) {
  return {arc.center.x + arc.axis_x.x * u.x + arc.axis_y.x * u.y,
          arc.center.y + arc.axis_x.y * u.x + arc.axis_y.y * u.y};
}

/// Middle of the arc between two unit vectors. Their sum points there, or away from it, and so does
/// the normal of their chord: the longer of the two is the more accurate.
Point2 middle(const EllipseArc& arc) {
  const Point2 sum{arc.from.x + arc.to.x, arc.from.y + arc.to.y};
  const Point2 chord{arc.to.x - arc.from.x, arc.to.y - arc.from.y};
  if (length(sum) > length(chord)) {
    const Point2 u = unit(sum);
    return arc.large ? Point2{-u.x, -u.y} : u;
  }
  return unit(arc.positive ? Point2{chord.y, -chord.x} : Point2{-chord.y, chord.x});
}

}  // namespace

Affine compose(const Affine& o, const Affine& i) {
  return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d,
          o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

Point2 cos_sin_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);  // exact
  if (turn != turn) return {turn, turn};
  const double quarter = std::floor(turn / 90 + 0.5);
  const double x = (turn - 90 * quarter) * (elementary::kPi / 180);
  const double cosine = elementary::cos(x), sine = elementary::sin(x);
  switch ((static_cast<int>(quarter) % 4 + 4) % 4) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

std::optional<Affine> parse_transform(std::string_view text) {
  Affine all;
  constexpr std::string_view kSeparators = " \t\r\n,";
  const auto trim = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
  };
  for (trim(); !text.empty(); trim()) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return std::nullopt;
    std::string_view name = text.substr(0, open), values = text.substr(open + 1, close - open - 1);
    name = name.substr(0, name.find_first_of(kSeparators));
    text.remove_prefix(close + 1);
    double v[6] = {0, 0, 0, 0, 0, 0};
    int n = 0;
    while (true) {
      values.remove_prefix(std::min(values.find_first_not_of(kSeparators), values.size()));
      if (values.empty()) break;
      const std::size_t size = number_length(values);
      if (size == 0 || n == 6) return std::nullopt;
      v[n++] = *parse_double(values.substr(0, size));
      values.remove_prefix(size);
    }
    Affine one;
    if (name == "matrix" && n == 6) {
      one = {v[0], v[1], v[2], v[3], v[4], v[5]};
    } else if (name == "translate" && (n == 1 || n == 2)) {
      one.e = v[0];
      one.f = v[1];
    } else if (name == "scale" && (n == 1 || n == 2)) {
      one.a = v[0];
      one.d = n == 2 ? v[1] : v[0];
    } else if (name == "rotate" && (n == 1 || n == 3)) {
      const Point2 r = cos_sin_degrees(v[0]);
      one = {r.x, r.y, -r.y, r.x, 0, 0};
      if (n == 3) {
        const Point2 moved = one.vector({v[1], v[2]});
        one.e = v[1] - moved.x;
        one.f = v[2] - moved.y;
      }
    } else if ((name == "skewX" || name == "skewY") && n == 1) {
      const Point2 r = cos_sin_degrees(v[0]);
      (name == "skewX" ? one.c : one.b) = r.y / r.x;
    } else {
      return std::nullopt;
    }
    all = compose(all, one);
  }
  return all;
}

void Bounds::add(const Point2& p) {
  if (!any_) low_ = high_ = p;
  any_ = true;
  low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
  high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
}

void Bounds::quadratic(const Point2& control, const Point2& end) {
  add(control);
  add(end);
}

void Bounds::cubic(const Point2& control1, const Point2& control2, const Point2& end) {
  add(control1);
  add(control2);
  add(end);
}

void Bounds::arc(const EllipseArc& arc) {
  add(on(arc, arc.from));
  add(on(arc, middle(arc)));
  add(arc.end);
}

double Bounds::extent() const { return std::max(high_.x - low_.x, high_.y - low_.y); }

/// Chords for a polynomial curve cut at equal steps of its parameter: the distance of a chord is at
/// most factor * second_difference / n^2 (interpolation error with the largest second derivative).
int Flattener::chord_count(double second_difference, double factor) const {
  if (exhausted()) return 1;
  const double n = std::ceil(std::sqrt(factor * second_difference / tolerance_));
  return n >= 1 ? static_cast<int>(std::min<double>(n, kMaxChords)) : 1;  // also for NaN
}

void Flattener::quadratic(const Point2& c, const Point2& e) {
  const Point2 s = points_.back();
  // |B''| = 2 |s - 2c + e|, and a chord of parameter length h is off by at most h^2 / 8 of it.
  const int n = chord_count(length({s.x - 2 * c.x + e.x, s.y - 2 * c.y + e.y}), 0.25);
  for (int i = 1; i < n; ++i) {
    const double t = i / static_cast<double>(n), u = 1 - t;
    points_.push_back(
        {u * u * s.x + 2 * u * t * c.x + t * t * e.x, u * u * s.y + 2 * u * t * c.y + t * t * e.y});
  }
  points_.push_back(e);
}

void Flattener::cubic(const Point2& c, const Point2& d, const Point2& e) {
  const Point2 s = points_.back();
  const double first = length({s.x - 2 * c.x + d.x, s.y - 2 * c.y + d.y});
  const double second = length({c.x - 2 * d.x + e.x, c.y - 2 * d.y + e.y});
  const int n = chord_count(std::max(first, second), 0.75);  // |B''| <= 6 max(first, second)
  for (int i = 1; i < n; ++i) {
    const double t = i / static_cast<double>(n), u = 1 - t;
    const double w0 = u * u * u, w1 = 3 * u * u * t, w2 = 3 * u * t * t, w3 = t * t * t;
    points_.push_back(
        {w0 * s.x + w1 * c.x + w2 * d.x + w3 * e.x, w0 * s.y + w1 * c.y + w2 * d.y + w3 * e.y});
  }
  points_.push_back(e);
}

void Flattener::half_arc(const EllipseArc& arc, double radius, const Point2& from, const Point2& to,
                         int chords) {
  const Point2 sum{from.x + to.x, from.y + to.y};
  // The chord's middle is cos(half the angle) = |sum| / 2 from the center of the unit circle.
  if (radius * (1 - length(sum) / 2) > tolerance_ && 2 * chords <= kMaxChords && !exhausted()) {
    const Point2 between = unit(sum);
    half_arc(arc, radius, from, between, 2 * chords);
    half_arc(arc, radius, between, to, 2 * chords);
    return;
  }
  points_.push_back(on(arc, to));
}

void Flattener::arc(const EllipseArc& arc) {
  const double radius = std::max(length(arc.axis_x), length(arc.axis_y));
  const Point2 between = middle(arc);
  half_arc(arc, radius, arc.from, between, 1);
  half_arc(arc, radius, between, arc.to, 1);
  points_.back() = arc.end;
}

void Flattener::end(bool closed) {
  drawn_ += points_.size();
  if (points_.size() < 2) {  // nothing was drawn
    points_.clear();
    return;
  }
  const Point2 first = points_.front();
  const auto is_back = [&](const Point2& p) {
    return length({p.x - first.x, p.y - first.y}) <= closing_;
  };
  while (closed && points_.size() > 2 && is_back(points_.back())) points_.pop_back();
  const std::uint32_t start = lines_.vertex(first.x, first.y);
  std::uint32_t here = start;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const std::uint32_t next = lines_.vertex(points_[i].x, points_[i].y);
    lines_.segment(here, next);
    here = next;
  }
  if (closed) lines_.segment(here, start);
  points_.clear();
}

}  // namespace circumball::io
