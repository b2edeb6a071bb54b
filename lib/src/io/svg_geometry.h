#ifndef CIRCUMBALL_IO_SVG_GEOMETRY_H_
#define CIRCUMBALL_IO_SVG_GEOMETRY_H_

#include <optional>
#include <string_view>
#include <vector>

#include "circumball/types.h"
#include "io/line_work.h"

/// Affine maps, and the curves of SVG drawn as chords: + - * / and sqrt only, so that every
/// platform gets the same vertices.
namespace circumball::io {

/// Largest distance of a curve from its chords, as a part of the larger side of the drawing's
/// bounding box (that of the control points).
constexpr double kChordTolerance = 1e-3;
/// A subpath whose last point is this near to its first (as a part of the same side) closes onto
/// it: sums of relative coordinates do not quite come back.
constexpr double kClosingTolerance = 1e-9;
/// At most so many chords for a curve, and for each half of an arc.
constexpr int kMaxChords = 64;

/// (x, y) -> (a x + c y + e, b x + d y + f): the matrix of SVG.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Point2 operator()(const Point2& p) const {
    return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
  }
  Point2 vector(const Point2& p) const { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
};
/// First `inner`, then `outer`.
Affine compose(const Affine& outer, const Affine& inner);
/// Cosine and sine of an angle in degrees, to a few ulp; exact at multiples of 90.
Point2 cos_sin_degrees(double degrees);
/// The value of a `transform` attribute; nothing if it is malformed.
std::optional<Affine> parse_transform(std::string_view text);

/// Part of an ellipse: center + axis_x * cos + axis_y * sin, from the unit vector `from` to the
/// unit vector `to`.
struct EllipseArc {
  Point2 center, axis_x, axis_y;
  Point2 from, to;
  bool positive = true;  ///< turns from axis_x towards axis_y
  bool large = false;    ///< spans more than half a turn
  Point2 end;            ///< where the drawing goes on: the end of the arc, not rounded
};

/// Receives the outlines of a drawing, in the coordinates of the complex.
class OutlineSink {
 public:
  virtual ~OutlineSink() = default;
  virtual void begin(const Point2& p) = 0;
  virtual void line(const Point2& p) = 0;
  virtual void quadratic(const Point2& control, const Point2& end) = 0;
  virtual void cubic(const Point2& control1, const Point2& control2, const Point2& end) = 0;
  virtual void arc(const EllipseArc& arc) = 0;
  virtual void end(bool closed) = 0;
};

/// Measures a drawing: the box around its control points.
class Bounds : public OutlineSink {
 public:
  void begin(const Point2& p) override { add(p); }
  void line(const Point2& p) override { add(p); }
  void quadratic(const Point2& control, const Point2& end) override;
  void cubic(const Point2& control1, const Point2& control2, const Point2& end) override;
  void arc(const EllipseArc& arc) override;
  void end(bool) override {}
  /// The larger side; 0 for an empty drawing.
  double extent() const;

 private:
  void add(const Point2& p);
  bool any_ = false;
  Point2 low_, high_;
};

/// Draws outlines as segments of a complex. A subpath that draws nothing but a point is an isolated
/// vertex.
class Flattener : public OutlineSink {
 public:
  /// `budget`: how many points may be drawn before curves are no longer cut.
  Flattener(LineWork* lines, double extent, std::size_t budget)
      : lines_(*lines),
        tolerance_(kChordTolerance * extent),
        closing_(kClosingTolerance * extent),
        budget_(budget) {}
  /// Whether the budget was not enough: then the drawing is not what it should be.
  bool exhausted() const { return drawn_ + points_.size() > budget_; }
  void begin(const Point2& p) override { points_.assign(1, p); }
  void line(const Point2& p) override { points_.push_back(p); }
  void quadratic(const Point2& control, const Point2& end) override;
  void cubic(const Point2& control1, const Point2& control2, const Point2& end) override;
  void arc(const EllipseArc& arc) override;
  void end(bool closed) override;

 private:
  void half_arc(const EllipseArc& arc, double radius, const Point2& from, const Point2& to,
                int chords);
  int chord_count(double second_difference, double factor) const;

  LineWork& lines_;
  double tolerance_, closing_;
  std::size_t budget_, drawn_ = 0;
  std::vector<Point2> points_;  // of the current subpath
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_SVG_GEOMETRY_H_
