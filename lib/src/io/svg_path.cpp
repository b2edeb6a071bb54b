#include "io/svg_path.h"

#include <algorithm>
#include <cmath>

#include "io/numbers.h"

namespace circumball::io {
namespace {

Point2 operator+(const Point2& a, const Point2& b) { return {a.x + b.x, a.y + b.y}; }
Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }

/// Numbers and commands, parted by white space and commas, or by nothing where that is not
/// ambiguous.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) { skip(); }
  bool at_end() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  char take() {
    const char c = text_[position_++];
    skip();
    return c;
  }
  bool at_number() const { return number_length(text_.substr(position_)) > 0; }
  bool number(double* value) {
    const std::size_t n = at_end() ? 0 : number_length(text_.substr(position_));
    if (n == 0) return false;
    *value = *parse_double(text_.substr(position_, n));
    position_ += n;
    skip();
    return true;
  }
  bool point(Point2* p) { return number(&p->x) && number(&p->y); }
  /// A flag of an arc: one digit, which the next number may follow at once.
  bool flag(bool* value) {
    if (peek() != '0' && peek() != '1') return false;
    *value = take() == '1';
    return true;
  }

 private:
  void skip() {
    while (!at_end() &&
           std::string_view(" \t\r\n\f,").find(text_[position_]) != std::string_view::npos)
      ++position_;
  }
  std::string_view text_;
  std::size_t position_ = 0;
};

/// An arc from endpoints to center, as SVG 1.1 says in appendix F.6.5 and F.6.6.
void draw_arc(const Point2& from, double rx, double ry, double degrees, bool large, bool sweep,
              const Point2& to, const Affine& map, OutlineSink& sink) {
  rx = std::fabs(rx);
  ry = std::fabs(ry);
  if (from == to) return;
  if (!(rx > 0 && ry > 0)) return sink.line(map(to));
  const Point2 r = cos_sin_degrees(degrees);
  const double hx = (from.x - to.x) / 2, hy = (from.y - to.y) / 2;
  // On the unit circle: half of the way from `to` to `from`, in the ellipse's own axes.
  Point2 h{(r.x * hx + r.y * hy) / rx, (r.x * hy - r.y * hx) / ry};
  const double square = h.x * h.x + h.y * h.y;
  double offset = 0;
  if (square > 1) {  // the ends are too far apart: the ellipse grows until it just reaches them
    const double scale = std::sqrt(square);
    rx *= scale;
    ry *= scale;
    h = {h.x / scale, h.y / scale};
  } else {
    offset = std::sqrt((1 - square) / square);
    if (large == sweep) offset = -offset;
  }
  const Point2 center{offset * h.y, -offset * h.x};
  const Point2 axis_x{rx * r.x, rx * r.y}, axis_y{-ry * r.y, ry * r.x};
  const Point2 middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  EllipseArc arc;
  arc.center = map({middle.x + axis_x.x * center.x + axis_y.x * center.y,
                    middle.y + axis_x.y * center.x + axis_y.y * center.y});
  arc.axis_x = map.vector(axis_x);
  arc.axis_y = map.vector(axis_y);
  arc.from = {h.x - center.x, h.y - center.y};
  arc.to = {-h.x - center.x, -h.y - center.y};
  arc.positive = sweep;
  arc.large = large;
  arc.end = map(to);
  sink.arc(arc);
}

/// Path data, command by command.
class Path {
 public:
  Path(std::string_view data, const Affine& map, OutlineSink& sink)
      : tokens_(data), map_(map), sink_(sink) {}

  std::size_t draw() {
    char command = 0;
    while (!tokens_.at_end()) {
      const std::size_t place = tokens_.position();
      if (tokens_.at_number()) {  // the last command again; after a move, lines
        if (command == 0 || (command | 0x20) == 'z') return stop(place);
        if (command == 'M') command = 'L';
        if (command == 'm') command = 'l';
      } else {
        command = tokens_.take();
        if (!started_ && (command | 0x20) != 'm') return stop(place);
      }
      if (!run(command)) return stop(place);
    }
    return stop(tokens_.position());
  }

 private:
  std::size_t stop(std::size_t place) {
    if (open_) sink_.end(false);
    open_ = false;
    return place;
  }

  /// A point, relative to the current one for small letters.
  bool point(bool relative, Point2* p) {
    if (!tokens_.point(p)) return false;
    if (relative) *p = here_ + *p;
    return true;
  }
  bool number(bool relative, double origin, double* value) {
    if (!tokens_.number(value)) return false;
    if (relative) *value += origin;
    return true;
  }

  void ensure_open() {
    if (!open_) sink_.begin(map_(here_));
    open_ = true;
  }

  bool run(char command) {
    const bool relative = command >= 'a';
    Point2 c = here_, d, to = here_;
    const Point2 smooth = here_ + (here_ - control_);  // reflection of the last control point
    const char kind = static_cast<char>(command | 0x20);
    if (kind == 'm') {
      if (!point(relative, &to)) return false;
      if (open_) sink_.end(false);
      open_ = false;
      started_ = true;
      here_ = start_ = to;
      ensure_open();
      last_ = kind;
      return true;
    }
    if (kind == 'z') {
      ensure_open();
      sink_.line(map_(start_));
      sink_.end(true);
      open_ = false;
      here_ = start_;
      last_ = kind;
      return true;
    }
    ensure_open();
    switch (kind) {
      case 'l':
        if (!point(relative, &to)) return false;
        sink_.line(map_(to));
        break;
      case 'h':
        if (!number(relative, here_.x, &to.x)) return false;
        sink_.line(map_(to));
        break;
      case 'v':
        if (!number(relative, here_.y, &to.y)) return false;
        sink_.line(map_(to));
        break;
      case 'c':
      case 's':
        if (kind == 'c' ? !point(relative, &c) : false) return false;
        if (kind == 's' && (last_ == 'c' || last_ == 's')) c = smooth;
        if (!point(relative, &d) || !point(relative, &to)) return false;
        sink_.cubic(map_(c), map_(d), map_(to));
        control_ = d;
        break;
      case 'q':
      case 't':
        if (kind == 'q' ? !point(relative, &c) : false) return false;
        if (kind == 't' && (last_ == 'q' || last_ == 't')) c = smooth;
        if (!point(relative, &to)) return false;
        sink_.quadratic(map_(c), map_(to));
        control_ = c;
        break;
      case 'a': {
        Point2 radii;
        double degrees = 0;
        bool large = false, sweep = false;
        if (!tokens_.point(&radii) || !tokens_.number(&degrees) || !tokens_.flag(&large) ||
            !tokens_.flag(&sweep) || !point(relative, &to))
          return false;
        draw_arc(here_, radii.x, radii.y, degrees, large, sweep, to, map_, sink_);
        break;
      }
      default:
        return false;
    }
    here_ = to;
    last_ = kind;
    return true;
  }

  Tokens tokens_;
  Affine map_;
  OutlineSink& sink_;
  Point2 here_, start_, control_;
  char last_ = 0;
  bool started_ = false, open_ = false;
};

/// A quarter of an ellipse from unit vector `from` to `to`, in the positive sense, which ends at
/// `end`.
void draw_quarter(const Point2& center, double rx, double ry, const Point2& from, const Point2& to,
                  const Point2& end, const Affine& map, OutlineSink& sink) {
  EllipseArc arc;
  arc.center = map(center);
  arc.axis_x = map.vector({rx, 0});
  arc.axis_y = map.vector({0, ry});
  arc.from = from;
  arc.to = to;
  arc.end = map(end);
  sink.arc(arc);
}

}  // namespace

std::size_t draw_path(std::string_view data, const Affine& map, OutlineSink& sink) {
  return Path(data, map, sink).draw();
}

std::size_t draw_points(std::string_view points, bool closed, const Affine& map,
                        OutlineSink& sink) {
  Tokens tokens(points);
  Point2 p;
  bool any = false;
  std::size_t understood = tokens.position();
  for (; !tokens.at_end(); understood = tokens.position()) {
    if (!tokens.point(&p)) break;
    if (any)
      sink.line(map(p));
    else
      sink.begin(map(p));
    any = true;
  }
  if (any) sink.end(closed);
  return understood;
}

void draw_ellipse(const Point2& c, double rx, double ry, const Affine& map, OutlineSink& sink) {
  const Point2 right{c.x + rx, c.y}, below{c.x, c.y + ry}, left{c.x - rx, c.y},
      above{c.x, c.y - ry};
  sink.begin(map(right));
  draw_quarter(c, rx, ry, {1, 0}, {0, 1}, below, map, sink);
  draw_quarter(c, rx, ry, {0, 1}, {-1, 0}, left, map, sink);
  draw_quarter(c, rx, ry, {-1, 0}, {0, -1}, above, map, sink);
  draw_quarter(c, rx, ry, {0, -1}, {1, 0}, right, map, sink);
  sink.end(true);
}

void draw_rectangle(const Point2& p, double width, double height, double rx, double ry,
                    const Affine& map, OutlineSink& sink) {
  const double left = p.x, top = p.y, right = p.x + width, bottom = p.y + height;
  if (!(rx > 0 && ry > 0)) {
    sink.begin(map({left, top}));
    sink.line(map({right, top}));
    sink.line(map({right, bottom}));
    sink.line(map({left, bottom}));
    sink.end(true);
    return;
  }
  rx = std::min(rx, width / 2);
  ry = std::min(ry, height / 2);
  sink.begin(map({left + rx, top}));
  sink.line(map({right - rx, top}));
  draw_quarter({right - rx, top + ry}, rx, ry, {0, -1}, {1, 0}, {right, top + ry}, map, sink);
  sink.line(map({right, bottom - ry}));
  draw_quarter({right - rx, bottom - ry}, rx, ry, {1, 0}, {0, 1}, {right - rx, bottom}, map, sink);
  sink.line(map({left + rx, bottom}));
  draw_quarter({left + rx, bottom - ry}, rx, ry, {0, 1}, {-1, 0}, {left, bottom - ry}, map, sink);
  sink.line(map({left, top + ry}));
  draw_quarter({left + rx, top + ry}, rx, ry, {-1, 0}, {0, -1}, {left + rx, top}, map, sink);
  sink.end(true);
}

}  // namespace circumball::io
