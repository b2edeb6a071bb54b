#ifndef CIRCUMBALL_TESTS_SUPPORT_SOLIDS3_H_
#define CIRCUMBALL_TESTS_SUPPORT_SOLIDS3_H_

#include <functional>
#include <string>
#include <vector>

#include "support/complexes3.h"

/// Solids without acute angles, of known volume, anywhere in space.
namespace circumball::testing {

/// Where a solid stands: scaled about the origin, turned, then moved.
struct Placement {
  double scale = 1;
  const Rotation* turn = nullptr;
  Point3 at;
};

/// Builds solids at a placement.
class SolidBuilder {
 public:
  explicit SolidBuilder(const Placement& placement) : scale_(placement.scale) {
    builder_.place(placement.at, placement.turn);
  }
  std::uint32_t vertex(const Point3& p) { return builder_.vertex(scaled(scale_, p)); }
  Point3 placed(const Point3& p) const { return builder_.placed(scaled(scale_, p)); }
  Builder3& builder() { return builder_; }
  Complex complex() const {
    Complex c = builder_.complex();
    c.holes = holes;
    c.regions = regions;
    return c;
  }
  std::vector<Point3> holes;
  std::vector<Region> regions;

  void box(const Point3& low, const Point3& high) {
    std::uint32_t v[8];
    for (std::uint32_t k = 0; k < 8; ++k)
      v[k] = vertex({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    builder_.face({v[0], v[2], v[3], v[1]});
    builder_.face({v[4], v[5], v[7], v[6]});
    builder_.face({v[0], v[1], v[5], v[4]});
    builder_.face({v[2], v[6], v[7], v[3]});
    builder_.face({v[0], v[4], v[6], v[2]});
    builder_.face({v[1], v[3], v[7], v[5]});
  }

  /// Unit cubes side by side, each face that two of them share there once.
  void lattice(int nx, int ny, int nz) {
    std::vector<std::uint32_t> v;
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) v.push_back(vertex({1.0 * i, 1.0 * j, 1.0 * k}));
    const auto at = [&](int i, int j, int k) {
      return v[static_cast<std::size_t>((k * (ny + 1) + j) * (nx + 1) + i)];
    };
    for (int k = 0; k <= nz; ++k) {
      for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
          if (i < nx && j < ny)
            builder_.face({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)});
          if (i < nx && k < nz)
            builder_.face({at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1)});
          if (j < ny && k < nz)
            builder_.face({at(i, j, k), at(i, j + 1, k), at(i, j + 1, k + 1), at(i, j, k + 1)});
        }
      }
    }
  }

  void prism(const std::vector<Point2>& base, double height) {
    std::vector<std::uint32_t> low, high;
    for (const Point2& p : base) low.push_back(vertex({p.x, p.y, 0}));
    for (const Point2& p : base) high.push_back(vertex({p.x, p.y, height}));
    builder_.face({low.rbegin(), low.rend()});
    builder_.face(high);
    for (std::size_t i = 0; i < base.size(); ++i) {
      const std::size_t j = (i + 1) % base.size();
      builder_.face({low[i], low[j], high[j], high[i]});
    }
  }

  /// A regular polygon as a base.
  void regular_prism(int sides, double height) {
    std::vector<Point2> base;
    for (int k = 0; k < sides; ++k) base.push_back(polar(0, 0, 1, 360.0 * k / sides));
    prism(base, height);
  }

  std::vector<std::uint32_t> square(double low, double high, double z) {
    return {vertex({low, low, z}), vertex({high, low, z}), vertex({high, high, z}),
            vertex({low, high, z})};
  }

 private:
  Builder3 builder_;
  double scale_;
};

struct Solid {
  std::string name;
  double volume;
  std::function<void(SolidBuilder*)> build;
};

/// Area of a regular polygon inscribed in the unit circle.
inline double polygon_area(int sides) {
  return 0.5 * sides * elementary::sin(2 * elementary::kPi / sides);
}

inline std::vector<Solid> solids() {
  return {
      {"cube", 1,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {1, 1, 1});
       }},
      {"box with a cavity", 27 - 0.7 * 1.2,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {3, 3, 3});
         b->box({1, 1, 1}, {1.7, 2, 2.2});
       }},
      {"box with a cavity by seed", 27 - 0.7 * 1.2,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {3, 3, 3});
         b->box({1, 1, 1}, {1.7, 2, 2.2});
         b->holes.push_back(b->placed({1.4, 1.5, 1.6}));
       }},
      {"L", 3,
       [](SolidBuilder* b) {
         b->prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
       }},
      {"lattice of boxes", 12, [](SolidBuilder* b) { b->lattice(3, 2, 2); }},
      {"hexagonal prism", 1.5 * polygon_area(6), [](SolidBuilder* b) { b->regular_prism(6, 1.5); }},
      {"prism of forty sides", 0.7 * polygon_area(40),
       [](SolidBuilder* b) { b->regular_prism(40, 0.7); }},
      {"box with a face inside", 27,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {3, 3, 3});
         b->builder().face(b->square(1, 2, 1.5));
       }},
      {"box with a perforated face inside", 27,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {3, 3, 3});
         Face face = b->builder().face(b->square(0.5, 2.5, 1.5));
         b->builder().add_loop(&face, b->square(1, 2, 1.5));
         face.holes.push_back(b->placed({1.5, 1.5, 1.5}));
         b->builder().replace_last_face(face);
       }},
      {"box with a segment and a vertex inside", 27,
       [](SolidBuilder* b) {
         b->box({0, 0, 0}, {3, 3, 3});
         b->builder().segment(b->vertex({1, 1.2, 1}), b->vertex({2, 2, 2.3}));
         b->vertex({0.5, 2.2, 1.1});
       }},
  };
}

}  // namespace circumball::testing

#endif  // CIRCUMBALL_TESTS_SUPPORT_SOLIDS3_H_
