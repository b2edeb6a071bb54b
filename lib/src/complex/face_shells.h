#ifndef CIRCUMBALL_COMPLEX_FACE_SHELLS_H_
#define CIRCUMBALL_COMPLEX_FACE_SHELLS_H_

#include <array>
#include <cstdint>
#include <vector>

#include "circumball/complex.h"
#include "complex/box_tree.h"

namespace circumball {

/// The sides of the triangles of all faces, linked where one comes from one to the other without
/// crossing a face: around each edge from a triangle to the next. Each class of linked sides, a
/// shell, is the border of one part of space, as far as edges connect it.
class FaceShells {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  /// Triangles of faces that meet in shared features only. O(n log n).
  FaceShells(const Complex& complex, std::vector<Triangle> triangles);

  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The shell of a side: of the front (counter-clockwise from there) or the back. Named by one of
  /// its sides: 2 t is the front of triangle t, 2 t + 1 its back.
  std::uint32_t shell(std::uint32_t triangle, bool front) const {
    return shell_[2 * triangle + !front];
  }
  /// The triangles that edges connect, named by one of them.
  std::uint32_t component(std::uint32_t triangle) const { return component_[triangle]; }

  /// Where a ray crosses a triangle: front if it comes from there.
  struct Hit {
    double at;
    std::uint32_t triangle;
    bool front;
  };
  /// What a ray from p crosses on its way out of everything, in order; every attempt (0 to
  /// kAttempts - 1) is another direction. `skip`: a triangle that p is in. False if it touches an
  /// edge or a vertex of a triangle, or p is on one: it does not decide anything then.
  static constexpr int kAttempts = 64;
  bool cast(const Point3& p, int attempt, std::vector<Hit>* hits,
            std::uint32_t skip = kNoIndex) const;
  /// The other end of that ray.
  Point3 end_of_ray(const Point3& p, int attempt) const;
  /// Whether the place of a hit in its list is beyond doubt: others are farther from it than
  /// rounding.
  static bool is_first(const std::vector<Hit>& hits) {
    return hits.size() < 2 || hits[1].at - hits[0].at > kApart;
  }
  static bool is_last(const std::vector<Hit>& hits) {
    return hits.size() < 2 || hits.back().at - hits[hits.size() - 2].at > kApart;
  }
  /// Whether p is in the box around all triangles.
  bool is_near(const Point3& p) const { return !triangles_.empty() && Box3::of(p).meets(all_); }
  const BoxTree3& tree() const { return tree_; }

 private:
  struct Wing {
    std::uint32_t a, b, triangle, apex;
    bool forward;  // from a to b, counter-clockwise in the triangle: its front faces the turn
  };
  static constexpr double kApart = 1e-12;  // far above rounding, which another ray avoids
  void link_around(Wing* wings, std::size_t count);

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> shell_, component_;
  mutable std::vector<Point3> points_;  // of the complex, and the two ends of a ray
  BoxTree3 tree_;
  Box3 all_{};
};

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_FACE_SHELLS_H_
