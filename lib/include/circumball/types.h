#ifndef CIRCUMBALL_TYPES_H_
#define CIRCUMBALL_TYPES_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// The small types that everything shares: points, typed indices, references to input features, and
/// defects.
namespace circumball {

/// A point of the plane. Coordinates are finite doubles, zero or of magnitude 1e-45 to 1e55.
struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2& a, const Point2& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(const Point2& a, const Point2& b) { return !(a == b); }
};

/// A point of space. In complexes and meshes of dimension 2, z is 0.
struct Point3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point3& a, const Point3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
  friend bool operator!=(const Point3& a, const Point3& b) { return !(a == b); }
};

inline Point2 xy(const Point3& p) { return {p.x, p.y}; }
inline Point3 xyz(const Point2& p) { return {p.x, p.y, 0}; }

/// An index that cannot be mistaken for an index of another kind. The default is invalid.
template <class Tag>
struct Id {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t value = kNone;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t v) : value(v) {}
  constexpr bool valid() const { return value != kNone; }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

using VertexId =
    Id<struct VertexTag>;  ///< a vertex of a complex, of its refinement, and of the mesh
using SegmentId = Id<struct SegmentTag>;  ///< an input segment
using FaceId = Id<struct FaceTag>;        ///< an input face (3D)
using CellId = Id<struct CellTag>;        ///< a triangle (2D) or tetrahedron (3D) of a mesh

constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// The dimension-tagged name of an input feature, e.g. {kSegment, 12}.
enum class FeatureKind : std::uint8_t { kVertex = 0, kSegment = 1, kFace = 2, kFree = 3 };
struct Feature {
  FeatureKind kind = FeatureKind::kFree;
  std::uint32_t index = kNoIndex;
  friend bool operator==(const Feature& a, const Feature& b) {
    return a.kind == b.kind && a.index == b.index;
  }
};

/// Something wrong (or, as a warning, remarkable) in an input: a name, where, which features, and
/// what to do.
struct Defect {
  std::string name;  ///< stable, kebab-case: "segments-cross", "duplicate-vertices", …
  std::vector<Feature> features;  ///< the input features involved, 0-based
  std::vector<Point3> at;  ///< coordinates of the place or of the features' ends; may be empty
  std::string message;     ///< one sentence for a person, with numbers, saying what to do
  bool warning = false;    ///< a warning does not make the complex invalid
};

}  // namespace circumball

#endif  // CIRCUMBALL_TYPES_H_
