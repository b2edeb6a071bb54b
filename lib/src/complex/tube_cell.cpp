#include "complex/tube_cell.h"

#include <cmath>

#include "delaunay/constructions.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

/// Cones that are nearer to a cylinder are developed as one: the apex would be too far away for
/// double precision, and the difference is as small.
constexpr double kCylinder = 1e-6;

}  // namespace

TubeCell::TubeCell(const Tube& tube, std::uint32_t gap, const Ring& low, const Ring& high)
    : center_low_(low.center),
      center_high_(high.center),
      first_(tube.bases[gap].direction),
      radius_low_(low.radius),
      radius_high_(high.radius),
      triangulation_(std::make_unique<Delaunay2>()) {
  const Point3 &a = tube.axis, &b = first_;
  second_ = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const double until = gap + 1 < tube.bases.size() ? tube.bases[gap + 1].angle
                                                   : tube.bases[0].angle + 2 * elementary::kPi;
  angle_ = until - tube.bases[gap].angle;
  const double height = distance(center_low_, center_high_), rise = radius_high_ - radius_low_;
  slant_ = std::sqrt(height * height + rise * rise);
  sine_ = std::fabs(rise) < kCylinder * slant_ ? 0 : rise / slant_;
}

Point3 TubeCell::place(double part, double t) const {
  const double c = elementary::cos(part * angle_), s = elementary::sin(part * angle_);
  const double r = radius_low_ + t * (radius_high_ - radius_low_);
  const Point3 m = point_between(center_low_, center_high_, t);
  return {m.x + r * (c * first_.x + s * second_.x), m.y + r * (c * first_.y + s * second_.y),
          m.z + r * (c * first_.z + s * second_.z)};
}

Point2 TubeCell::developed(double part, double t) const {
  if (sine_ == 0) return {radius_low_ * angle_ * part, slant_ * t};
  // From the apex, symmetrically about the middle of the cell. Negative radii where the tube grows
  // thinner: the sector points down.
  const double radius = radius_low_ / sine_ + slant_ * t;
  const double angle = (part - 0.5) * angle_ * sine_;
  return {radius * elementary::sin(angle), radius * elementary::cos(angle)};
}

Point2 TubeCell::undeveloped(const Point2& p) const {
  if (sine_ == 0) return {p.x / (radius_low_ * angle_), p.y / slant_};
  const double sign = sine_ > 0 ? 1 : -1;
  const double radius = sign * std::sqrt(p.x * p.x + p.y * p.y);
  const double angle = elementary::atan2(sign * p.x, sign * p.y);
  return {angle / (angle_ * sine_) + 0.5, (radius - radius_low_ / sine_) / slant_};
}

bool TubeCell::insert(VertexId v, double part, double t) {
  vertices_.push_back(v);
  const VertexId local = triangulation_->add_vertex(developed(part, t));
  if (triangulation_->probe(local, triangulation_->triangle_of(VertexId(0))) !=
      Delaunay2::Probe::kOk) {
    return false;
  }
  triangulation_->commit(local);
  return true;
}

}  // namespace circumball
