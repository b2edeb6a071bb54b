#ifndef CIRCUMBALL_TESTS_SUPPORT_COMPLEXES3_H_
#define CIRCUMBALL_TESTS_SUPPORT_COMPLEXES3_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "circumball/complex.h"
#include "predicates/elementary.h"
#include "support/complexes.h"

/// Random complexes of space with small angles between segments, faces, and both, and with narrow
/// gaps. Parts stand in balls of radius 1 that do not meet, so that they are valid by construction.
namespace circumball::testing {

inline Point3 sum(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 scaled(double t, const Point3& a) { return {t * a.x, t * a.y, t * a.z}; }
inline Point3 between(const Point3& a, const Point3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}
inline double distance(const Point3& a, const Point3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

/// A rotation about the origin, uniform in the unit quaternions.
class Rotation {
 public:
  explicit Rotation(Random* random) {
    double n2 = 0;
    do {
      n2 = 0;
      for (double& q : q_) {
        q = 2 * random->unit() - 1;
        n2 += q * q;
      }
    } while (n2 > 1 || n2 < 0.01);
    for (double& q : q_) q /= std::sqrt(n2);
  }
  Point3 operator()(const Point3& p) const {
    const double w = q_[0], x = q_[1], y = q_[2], z = q_[3];
    return {
        (1 - 2 * (y * y + z * z)) * p.x + 2 * (x * y - z * w) * p.y + 2 * (x * z + y * w) * p.z,
        2 * (x * y + z * w) * p.x + (1 - 2 * (x * x + z * z)) * p.y + 2 * (y * z - x * w) * p.z,
        2 * (x * z - y * w) * p.x + 2 * (y * z + x * w) * p.y + (1 - 2 * (x * x + y * y)) * p.z};
  }

 private:
  double q_[4];
};

/// Builds a complex; segments are shared, and made for every side of a face.
class Builder3 {
 public:
  Builder3() { complex_.dimension = 3; }

  /// Places what is added next: rotated about the origin (if `turn` is given), then moved.
  void place(const Point3& at, const Rotation* turn) {
    at_ = at;
    turn_ = turn;
  }
  std::uint32_t vertex(const Point3& p) {
    complex_.vertices.push_back(sum(at_, turn_ ? (*turn_)(p) : p));
    return static_cast<std::uint32_t>(complex_.vertices.size() - 1);
  }
  std::uint32_t segment(std::uint32_t a, std::uint32_t b) {
    const auto key = std::minmax(a, b);
    const auto [it, is_new] = segments_.try_emplace(
        {key.first, key.second}, static_cast<std::uint32_t>(complex_.segments.size()));
    if (is_new) complex_.segments.push_back({a, b});
    return it->second;
  }
  /// A face of one loop; more can be done to it.
  Face& face(const std::vector<std::uint32_t>& loop) {
    complex_.faces.emplace_back();
    add_loop(&complex_.faces.back(), loop);
    return complex_.faces.back();
  }
  void add_loop(Face* face, const std::vector<std::uint32_t>& loop) {
    face->loops.push_back(loop);
    for (std::size_t k = 0; k < loop.size(); ++k)
      face->segments.push_back(segment(loop[k], loop[(k + 1) % loop.size()]));
  }
  void replace_last_face(const Face& face) { complex_.faces.back() = face; }
  Point3 placed(const Point3& p) const { return sum(at_, turn_ ? (*turn_)(p) : p); }
  Complex complex() const { return complex_; }

 private:
  Complex complex_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> segments_;
  Point3 at_;
  const Rotation* turn_ = nullptr;
};

/// An angle in degrees: `least` to twice that, or anything up to 60 more.
inline double some_angle(Random* random, double least) {
  return random->below(2) ? least * (1 + random->unit()) : least + 60 * random->unit();
}
inline double uniform(Random* random, double low, double high) {
  return low + (high - low) * random->unit();
}
/// Between `low` and 1, the logarithm uniform.
inline double small(Random* random, double low) {
  return elementary::exp(elementary::log(low) * random->unit());
}
/// At a distance from the z axis and an angle about it, in degrees.
inline Point3 cylinder(double r, double degrees, double z) {
  const Point2 p = polar(0, 0, r, degrees);
  return {p.x, p.y, z};
}

/// Segments from a vertex: in a plane at small angles, or tips on rings about an axis.
inline void add_fan3(Builder3* b, Random* random, double least) {
  const std::uint32_t hub = b->vertex({0, 0, 0}), count = 2 + random->below(6);
  double angle = 0;
  for (std::uint32_t k = 0; k < count && angle < 300; ++k) {
    const double tilt = random->below(2) ? 0.0 : uniform(random, -40, 40);
    const Point2 out = polar(0, 0, uniform(random, 0.1, 0.9), tilt);
    b->segment(hub, b->vertex(cylinder(out.x, angle, out.y)));
    angle += some_angle(random, least);
  }
}

/// A book: faces around an axis, of triangles, quadrilaterals or with a notch, small angles between
/// them; perhaps with a segment at a small angle to the first.
inline void add_book(Builder3* b, Random* random, double least) {
  const double h = uniform(random, 0.2, 0.6);
  const std::uint32_t low = b->vertex({0, 0, -h}), high = b->vertex({0, 0, h});
  const std::uint32_t count = 1 + random->below(4);
  double angle = 0;
  for (std::uint32_t k = 0; k < count && angle < 270; ++k) {
    const double r = uniform(random, 0.15, 0.7);
    const auto at = [&](double x, double z) { return b->vertex(cylinder(x * r, angle, z * h)); };
    switch (random->below(3)) {
      case 0:
        b->face({low, at(1, uniform(random, -1, 1)), high});
        break;
      case 1: {
        const std::uint32_t p = at(1, -1);
        b->face({low, p, at(uniform(random, 0.4, 1), 1), high});
        break;
      }
      default: {
        const std::uint32_t p = at(1, -1), q = at(uniform(random, 0.3, 0.7), 0);
        b->face({low, p, q, at(1, 1), high});
      }
    }
    angle += some_angle(random, least);
  }
  if (random->below(2)) {  // from the lower end, over the gap before the first page
    const Point2 out = polar(0, 0, 0.5, uniform(random, 20, 70));
    b->segment(low, b->vertex(cylinder(out.x, -uniform(random, least, 40), out.y - h)));
  }
}

/// A slender pyramid, with or without its base.
inline void add_spike(Builder3* b, Random* random, double least) {
  const std::uint32_t sides = 3 + random->below(4);
  const double height = uniform(random, 0.4, 0.9);
  const double r = std::max(0.02, height * elementary::tan(least * elementary::kPi / 180)) *
                   uniform(random, 1, 3);
  const double radius = std::min(r, 0.6);
  const std::uint32_t apex =
      b->vertex({uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), height});
  std::vector<std::uint32_t> base;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 360.0 * (k + 0.3 * random->unit()) / sides;
    base.push_back(b->vertex(cylinder(radius, angle, -0.3)));
  }
  for (std::uint32_t k = 0; k < sides; ++k) b->face({apex, base[k], base[(k + 1) % sides]});
  if (random->below(2)) b->face(base);
}

/// Two rectangles one above the other, nearly or exactly parallel.
inline void add_plates(Builder3* b, Random* random, double least) {
  const double gap = std::max(0.01, small(random, 0.002) * 0.5);
  const double slope = random->below(2) ? 0.0 : uniform(random, 0.0, 0.5 * gap);
  const auto plate = [&](double z, double tilt) {
    const double x = uniform(random, 0.2, 0.6), y = uniform(random, 0.2, 0.6);
    const std::uint32_t p = b->vertex({-x, -y, z - tilt * x}), q = b->vertex({x, -y, z + tilt * x});
    const std::uint32_t r = b->vertex({x, y, z + tilt * x}), s = b->vertex({-x, y, z - tilt * x});
    b->face({p, q, r, s});
  };
  static_cast<void>(least);
  plate(0, 0);
  plate(gap, slope);
}

/// A square with vertices, and ends of segments, close above it; some vertices and a segment in it.
inline void add_near_face(Builder3* b, Random* random, double least) {
  const std::uint32_t p = b->vertex({-0.6, -0.6, 0}), q = b->vertex({0.6, -0.6, 0}),
                      r = b->vertex({0.6, 0.6, 0}), s = b->vertex({-0.6, 0.6, 0});
  Face f = b->face({p, q, r, s});
  if (random->below(2)) f.vertices.push_back(b->vertex({-0.3, -0.3, 0}));
  if (random->below(2)) {
    const std::uint32_t u = b->vertex({0.1, 0.35, 0});
    f.segments.push_back(b->segment(u, b->vertex({0.45, 0.3, 0})));
  }
  b->replace_last_face(f);
  const double h = 0.3 * small(random, 0.01);
  b->vertex({uniform(random, -0.2, 0.4), uniform(random, -0.4, 0.1), h});
  if (random->below(2)) {
    const std::uint32_t low = b->vertex({-0.25, 0.1, h * uniform(random, 0.5, 2)});
    b->segment(low, b->vertex({uniform(random, -0.5, 0.1), uniform(random, 0, 0.3), 0.6}));
  }
  if (random->below(2)) {  // from a corner, at a small angle to the face
    const double rise = elementary::tan(some_angle(random, least) * elementary::kPi / 180);
    b->segment(p, b->vertex({-0.35, -0.35, std::min(0.4, 0.35 * rise)}));
  }
}

/// A star-shaped polygon, seldom convex; perhaps with a hole, and a segment through it.
inline void add_star_face(Builder3* b, Random* random, double least) {
  static_cast<void>(least);
  const std::uint32_t corners = 4 + random->below(8);
  std::vector<std::uint32_t> loop;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double angle = 360.0 * (k + 0.4 * random->unit()) / corners;
    loop.push_back(b->vertex(cylinder(uniform(random, 0.4, 0.9), angle, 0)));
  }
  Face f = b->face(loop);
  // The star holds the disk about its center of radius 0.4 cos(1.4 * 45 degrees) at least.
  if (random->below(2)) {
    std::vector<std::uint32_t> hole;
    for (std::uint32_t k = 0; k < 3; ++k)
      hole.push_back(b->vertex(cylinder(0.13, 120.0 * k + 10, 0)));
    b->add_loop(&f, hole);
    f.holes.push_back(b->placed({0, 0, 0}));
    if (random->below(2)) {
      const std::uint32_t low = b->vertex({0.01, 0, -0.3});
      b->segment(low, b->vertex({0, 0.01, 0.5}));
    }
  }
  b->replace_last_face(f);
}

/// A box with six faces, perhaps one through two opposite edges of it, and a vertex inside.
inline void add_cuboid(Builder3* b, Random* random, double least) {
  static_cast<void>(least);
  const double size[3] = {uniform(random, 0.1, 0.5), uniform(random, 0.1, 0.5),
                          uniform(random, 0.02, 0.5)};
  std::uint32_t v[8];
  for (std::uint32_t k = 0; k < 8; ++k)
    v[k] = b->vertex(
        {k & 1 ? size[0] : -size[0], k & 2 ? size[1] : -size[1], k & 4 ? size[2] : -size[2]});
  const bool diagonal = random->below(2) != 0;
  b->face({v[0], v[1], v[3], v[2]});
  b->face({v[4], v[5], v[7], v[6]});
  b->face({v[0], v[1], v[5], v[4]});
  b->face({v[2], v[3], v[7], v[6]});
  Face& left = b->face({v[0], v[2], v[6], v[4]});
  if (diagonal) left.segments.push_back(b->segment(v[0], v[6]));
  Face& right = b->face({v[1], v[3], v[7], v[5]});
  if (diagonal) right.segments.push_back(b->segment(v[1], v[7]));
  if (diagonal) {
    b->face({v[0], v[1], v[7], v[6]});
  } else if (random->below(2)) {
    b->vertex({0.5 * size[0] * random->unit(), 0, 0.5 * size[2] * random->unit()});
  }
}

/// One of the parts above, about the origin.
inline void add_part(Builder3* b, Random* random, double least, std::uint32_t kind) {
  using Add = void (*)(Builder3*, Random*, double);
  constexpr Add kAdd[] = {add_fan3,      add_book,      add_spike, add_plates,
                          add_near_face, add_star_face, add_cuboid};
  kAdd[kind % 7](b, random, least);
}

/// One to `most` parts beside each other, each turned somehow or not at all, and some free
/// vertices. Angles are `least` degrees or more, but for those that come by chance.
inline Complex random_complex3(std::uint64_t seed, double least, std::uint32_t most = 3) {
  Random random(seed);
  Builder3 b;
  const std::uint32_t parts = 1 + random.below(most);
  for (std::uint32_t k = 0; k < parts; ++k) {
    const Rotation turn(&random);
    // Parts reach 1 from their centers.
    b.place({2.05 * k, uniform(&random, -0.3, 0.3), uniform(&random, -0.3, 0.3)},
            random.below(3) ? &turn : nullptr);
    add_part(&b, &random, least, random.below(7));
  }
  b.place({0, 0, 0}, nullptr);
  const std::uint32_t free = random.below(6);
  for (std::uint32_t k = 0; k < free; ++k)
    b.vertex({uniform(&random, -1, 2.05 * parts), uniform(&random, -2, 2),
              (random.below(2) ? 1.0 : -1.0) * uniform(&random, 1.4, 2.5)});
  return b.complex();
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_COMPLEXES3_H_
