#ifndef CIRCUMBALL_QUALITY_ENCLOSED_PARTS_H_
#define CIRCUMBALL_QUALITY_ENCLOSED_PARTS_H_

#include <cstdint>
#include <vector>

#include "complex/face_shells.h"

namespace circumball {

/// The parts of space that the faces of a valid 3D complex leave, and which of them the domain
/// `closed` consists of: from the complex alone.
///
/// Borders of parts are shells (FaceShells), of one connected set of faces each; what lies in
/// another is found by rays. Levels count the faces between a part and the outside, at least; by
/// parity (HoleRule) the odd ones are inside, else all but the outside, without those that hole
/// seeds lie in.
class EnclosedParts {
 public:
  explicit EnclosedParts(const Complex& complex);

  /// False if rays did not decide: nothing else means anything then.
  bool known() const { return known_; }
  /// The volume of the parts inside, and the area of all sides toward them.
  double volume() const { return volume_; }
  double area() const { return area_; }

 private:
  std::uint32_t part_of(std::uint32_t side) { return root(shells_.shell(side / 2, side % 2 == 0)); }
  std::uint32_t root(std::uint32_t i);
  void join(std::uint32_t i, std::uint32_t j);
  void nest(const Complex& complex);
  std::uint32_t part_at(const Point3& p);
  void measure(const Complex& complex, const std::vector<bool>& inside);

  FaceShells shells_;
  std::vector<std::uint32_t> parent_;  // of sides; the last one is that of the outside
  std::vector<Point3> centroids_;      // of triangles
  bool known_ = true;
  double volume_ = 0, area_ = 0;
};

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_ENCLOSED_PARTS_H_
