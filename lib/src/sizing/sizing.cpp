#include "sizing/sizing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace circumball {
namespace {

/// How many boxes are looked at, and how often a piece is halved, before it is given up.
constexpr int kBoxes = 256;
constexpr int kDepth = 40;

/// A corner of a piece: intervals, since midpoints are rounded.
struct Corner {
  Interval x, y;
  bool exact() const { return x.lo == x.hi && y.lo == y.hi; }
};

/// Half of a + b, rounded down or up where it is not exact (Knuth's two-sum tells).
double half_sum(double a, double b, bool up) {
  const double sum = a + b;
  const double t = sum - a;
  const double error = (a - (sum - t)) + (b - t);
  const double half = 0.5 * sum;
  if (error == 0) return half;
  if (up) return error > 0 ? internal::next_up(half) : half;
  return error < 0 ? internal::next_down(half) : half;
}
Interval midpoint(const Interval& a, const Interval& b) {
  return {half_sum(a.lo, b.lo, false), half_sum(a.hi, b.hi, true)};
}
Corner midpoint(const Corner& p, const Corner& q) {
  return {midpoint(p.x, q.x), midpoint(p.y, q.y)};
}

Interval hull(const Interval& a, const Interval& b, const Interval& c) {
  return {std::min(a.lo, std::min(b.lo, c.lo)), std::max(a.hi, std::max(b.hi, c.hi))};
}

using Infimum = Sizing::Infimum;

/// Branch and bound over a triangle: a piece is put by where the lower bound of h on its box is at
/// least `value`, and cut into four else. Where `hasty`, any corner with h < value settles it;
/// else only one that is known exactly, and where h is below for sure.
Infimum over_triangle(const Sizing& h, double value, const Corner& a, const Corner& b,
                      const Corner& c, bool hasty) {
  struct Piece {
    Corner a, b, c;
    int depth;
  };
  std::array<Piece, 3 * kDepth + 4> open;  // depth first: three wait at each depth
  int count = 0;
  open[count++] = {a, b, c, 0};
  bool given_up = false;
  for (int boxes = 0; count > 0; ++boxes) {
    if (boxes == kBoxes) return Infimum::kUnclear;
    const Piece t = open[--count];
    const Interval range = h.over(hull(t.a.x, t.b.x, t.c.x), hull(t.a.y, t.b.y, t.c.y));
    if (range.lo >= value) continue;
    for (const Corner& p : {t.a, t.b, t.c}) {
      if (!(h.at(p.x.lo, p.y.lo) < value)) continue;
      if (hasty || (p.exact() && h.over(p.x, p.y).hi < value)) return Infimum::kBelow;
    }
    if (t.depth == kDepth) {
      given_up = true;
      continue;
    }
    const Corner ab = midpoint(t.a, t.b), bc = midpoint(t.b, t.c), ca = midpoint(t.c, t.a);
    open[count++] = {t.a, ab, ca, t.depth + 1};
    open[count++] = {ab, t.b, bc, t.depth + 1};
    open[count++] = {ca, bc, t.c, t.depth + 1};
    open[count++] = {ab, bc, ca, t.depth + 1};
  }
  return given_up ? Infimum::kUnclear : Infimum::kAtLeast;
}

Corner corner(const Point2& p) { return {p.x, p.y}; }

}  // namespace

bool Sizing::parse(const std::string& text, Sizing* sizing, std::string* error) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  *sizing = Sizing();
  if (first != std::string::npos && text[first] == '{') {
    return SampledGrid::parse(text, &sizing->grid_, error);
  }
  return Expression::parse(text, &sizing->expression_, error);
}

bool Sizing::exceeded_by(double radius, const Point2& a, const Point2& b, const Point2& c) const {
  return over_triangle(*this, radius, corner(a), corner(b), corner(c), true) != Infimum::kAtLeast;
}

Infimum Sizing::compare_over_triangle(double value, const Point2& a, const Point2& b,
                                      const Point2& c) const {
  return over_triangle(*this, value, corner(a), corner(b), corner(c), false);
}

Infimum Sizing::compare_over_disk(double value, const Point2& center, double radius) const {
  struct Square {
    Interval x, y;
    int depth;
  };
  // What rounding can do to the comparison of two squared lengths: at most four units of 2^-53 on
  // either side.
  constexpr double kBorder = 0x1p-50;
  const auto outside = [&](const Square& s) {  // for sure
    const auto away = [](const Interval& i, double c) {
      return std::max(std::max(i.lo - c, c - i.hi), 0.0);
    };
    const double dx = away(s.x, center.x), dy = away(s.y, center.y);
    return dx * dx + dy * dy > radius * radius * (1 + kBorder);
  };
  const auto inside = [&](double x, double y) {
    const double dx = x - center.x, dy = y - center.y;
    return dx * dx + dy * dy <= radius * radius * (1 + kBorder);
  };
  std::array<Square, 3 * kDepth + 4> open;
  int count = 0;
  const Interval side(-radius, radius);
  open[count++] = {Interval(center.x) + side, Interval(center.y) + side, 0};
  bool given_up = false;
  for (int boxes = 0; count > 0; ++boxes) {
    if (boxes == kBoxes) return Infimum::kUnclear;
    const Square s = open[--count];
    if (outside(s) || over(s.x, s.y).lo >= value) continue;
    const double x = 0.5 * (s.x.lo + s.x.hi), y = 0.5 * (s.y.lo + s.y.hi);
    for (const Point2& p : {Point2{x, y}, Point2{s.x.lo, s.y.lo}, Point2{s.x.hi, s.y.lo},
                            Point2{s.x.lo, s.y.hi}, Point2{s.x.hi, s.y.hi}}) {
      if (at(p.x, p.y) < value && inside(p.x, p.y) && over(p.x, p.y).hi < value) {
        return Infimum::kBelow;
      }
    }
    if (s.depth == kDepth) {
      given_up = true;
      continue;
    }
    // Any x and y divide the square: nothing is lost by their rounding.
    for (const Interval& part_x : {Interval(s.x.lo, x), Interval(x, s.x.hi)}) {
      for (const Interval& part_y : {Interval(s.y.lo, y), Interval(y, s.y.hi)}) {
        open[count++] = {part_x, part_y, s.depth + 1};
      }
    }
  }
  return given_up ? Infimum::kUnclear : Infimum::kAtLeast;
}

}  // namespace circumball
