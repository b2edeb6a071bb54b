#include "quality/acute_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "feature_size/vectors.h"

namespace circumball {
namespace {

constexpr double kNearlyRight = 1e-6;  // as a cosine

struct Direction {
  Point3 to;  // unit
  double length;
};
Direction direction(const Point3& v) {
  const double length = std::sqrt(dot(v, v));
  return {{v.x / length, v.y / length, v.z / length}, length};
}

class Finder {
 public:
  Finder(const VerifyContext3& context, RightAngles right)
      : context_(context), complex_(context.complex), sign_(right == RightAngles::kOpen ? 1 : -1) {
    found_.vertices.assign(complex_.vertices.size(), false);
    found_.segments.assign(complex_.segments.size(), false);
    for (std::uint32_t s = 0; s < complex_.segments.size(); ++s) {
      if (!context.segment_wanted[s]) continue;
      const auto [a, b] = complex_.segments[s];
      segment_[std::minmax(a, b)] = s;
      ends_[a].push_back(b);
      ends_[b].push_back(a);
    }
    for (std::uint32_t f = 0; f < complex_.faces.size(); ++f) {
      for (const auto& t : triangulate_face(complex_, f)) {
        for (std::size_t i = 0; i < 3; ++i) {
          corners_[t[i]].push_back({t[(i + 1) % 3], t[(i + 2) % 3]});
          const auto side = segment_.find(std::minmax(t[i], t[(i + 1) % 3]));
          if (side != segment_.end()) sides_[side->second].push_back(t[(i + 2) % 3]);
        }
      }
    }
  }

  ProtectedFeatures everything() {
    for (const auto& [ends, s] : segment_) protect(s);
    return std::move(found_);
  }
  ProtectedFeatures acute() {
    for (const auto& [s, apexes] : sides_) {
      if (is_acute_segment(s, apexes)) protect(s);
    }
    for (const auto& [v, others] : ends_) {
      if (!found_.vertices[v]) found_.vertices[v] = is_acute_vertex(v, others);
    }
    return std::move(found_);
  }

 private:
  const Point3& point(std::uint32_t v) const { return complex_.vertices[v]; }
  void protect(std::uint32_t s) {
    found_.segments[s] = true;
    for (const std::uint32_t v : complex_.segments[s]) found_.vertices[v] = true;
  }
  bool is_acute(const Direction& a, const Direction& b) const {
    const double slack = kNearlyRight + 2 * context_.rounding * (1 / a.length + 1 / b.length);
    return dot(a.to, b.to) > sign_ * slack;
  }
  /// Perpendicular to the segment, towards a corner of a triangle on it.
  bool is_acute_segment(std::uint32_t s, const std::vector<std::uint32_t>& apexes) const {
    const Point3& origin = point(complex_.segments[s][0]);
    const Point3 axis = direction(point(complex_.segments[s][1]) - origin).to;
    std::vector<Direction> out;
    for (const std::uint32_t apex : apexes) {
      const Point3 to = point(apex) - origin;
      out.push_back(direction(along(to, -dot(to, axis), axis)));
      for (std::size_t k = 0; k + 1 < out.size(); ++k) {
        if (is_acute(out[k], out.back())) return true;
      }
    }
    return false;
  }
  bool is_acute_vertex(std::uint32_t v, const std::vector<std::uint32_t>& others) const {
    std::vector<Direction> out;
    for (const std::uint32_t other : others) {
      out.push_back(direction(point(other) - point(v)));
      for (std::size_t k = 0; k + 1 < out.size(); ++k) {
        if (others[k] != other && is_acute(out[k], out.back())) return true;
      }
    }
    const auto corners = corners_.find(v);
    if (corners == corners_.end()) return false;
    for (std::size_t k = 0; k < out.size(); ++k) {
      for (const auto& [b, c] : corners->second) {
        if (b != others[k] && c != others[k] && is_acute_corner(v, out[k], b, c)) return true;
      }
    }
    return false;
  }
  /// Whether the foot of a segment is between the sides of a corner of a triangle at v, and off v:
  /// it is the nearest point of the corner.
  bool is_acute_corner(std::uint32_t v, const Direction& d, std::uint32_t b,
                       std::uint32_t c) const {
    const Direction p = direction(point(b) - point(v)), q = direction(point(c) - point(v));
    const Point3 n = direction(cross(p.to, q.to)).to;
    const Direction foot = direction(along(d.to, -dot(d.to, n), n));
    const double slack =
        kNearlyRight + 4 * context_.rounding * (1 / p.length + 1 / q.length + 1 / d.length);
    if (foot.length <= slack) return sign_ < 0;
    return dot(cross(p.to, foot.to), n) > sign_ * slack &&
           dot(cross(foot.to, q.to), n) > sign_ * slack;
  }

  const VerifyContext3& context_;
  const Complex& complex_;
  const double sign_;  // of the slack
  ProtectedFeatures found_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> segment_;  // by its ends
  std::map<std::uint32_t, std::vector<std::uint32_t>> ends_;   // of segments, by vertex
  std::map<std::uint32_t, std::vector<std::uint32_t>> sides_;  // corners of faces, by segment
  std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> corners_;
};

}  // namespace

ProtectedFeatures protected_features(const VerifyContext3& context, RightAngles right) {
  Finder finder(context, right);
  return context.options.protect_all ? finder.everything() : finder.acute();
}

}  // namespace circumball
