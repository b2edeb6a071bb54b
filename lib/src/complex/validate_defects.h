#ifndef CIRCUMBALL_COMPLEX_VALIDATE_DEFECTS_H_
#define CIRCUMBALL_COMPLEX_VALIDATE_DEFECTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "complex/planar_sweep.h"

namespace circumball {

/// The defects of one name: keeps the first `max`, counts the rest.
class DefectList {
 public:
  DefectList(std::string name, bool warning, std::size_t max)
      : name_(std::move(name)), warning_(warning), max_(max) {}

  /// True if the next defect would still be listed: spares the work of wording one that is only
  /// counted.
  bool has_room() const { return defects_.size() < max_; }
  void add(std::vector<Feature> features, std::vector<Point3> at, std::string message);
  void count_only() { ++rest_; }
  /// The search for more was ended: the count is a lower bound.
  void set_incomplete() { incomplete_ = true; }
  /// Appends the defects, sorted by features where `sorted`, and one that counts the rest.
  void append_to(std::vector<Defect>* all, bool sorted = false);

 private:
  std::string name_;
  bool warning_;
  std::size_t max_;
  std::vector<Defect> defects_;
  std::uint64_t rest_ = 0;
  bool incomplete_ = false;
};

/// Shortest decimal that reads back the same, for messages.
std::string number_text(double value);
/// "(1, 2.5)", or "(1, 2.5, 3)" in space.
std::string point_text(const Point3& p, int dimension = 2);

// The parts of check(), by what they look at.

/// "magnitude", "duplicate-vertices", "near-duplicate-vertices", "too-few-vertices".
void check_vertices(const Complex& complex, std::size_t max, std::vector<Defect>* defects);
/// "zero-length-segment", and "duplicate-segments": pairs (duplicate, first with the same ends).
void check_segments(const Complex& complex,
                    const std::vector<std::array<std::uint32_t, 2>>& duplicates, std::size_t max,
                    std::vector<Defect>* defects);
/// "vertex-on-segment", "segments-cross", "segments-overlap": of the suspects of a sweep.
void check_crossings(const PlanarView& view, const SweepResult& swept, std::size_t max,
                     std::vector<Defect>* defects);
/// "magnitude" of hole and region seeds.
void check_seed_coordinates(const Complex& complex, std::size_t max, std::vector<Defect>* defects);
/// "hole-outside", "region-outside". Seeds of the view are the holes, then the regions. Needs a
/// sweep without suspects.
void check_seed_places(const Complex& complex, const PlanarView& view, const SweepResult& swept,
                       std::size_t max, std::vector<Defect>* defects);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_VALIDATE_DEFECTS_H_
