// The oracle of feature sizes for JavaScript; see bindings.cpp for what may cross.
#include <emscripten/bind.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "circumball/complex.h"
#include "circumball/feature_size.h"
#include "circumball/io.h"
#include "session.h"

namespace circumball {

namespace {

// The oracle of the last complex that was asked about: picking asks at every move of the pointer.
// One of the two, by dimension.
struct Oracle {
  std::string text;
  std::string error;  // why there is none
  std::unique_ptr<FeatureSizes> plane;
  std::unique_ptr<FeatureSizes3> space;
};

const Oracle& oracle_of(const std::string& text) {
  static Oracle last;
  if (!last.text.empty() && last.text == text) return last;
  last = Oracle();  // if what follows throws, nothing is left to be taken for an answer
  Oracle oracle;
  oracle.text = text;
  const ReadResult input = read(text, "input.json");
  std::vector<Defect> defects = input.defects;
  if (input.ok()) {
    for (Defect& defect : check(input.complex)) defects.push_back(std::move(defect));
  }
  for (const Defect& defect : defects) {
    if (!defect.warning && oracle.error.empty()) oracle.error = defect.message;
  }
  if (oracle.error.empty()) {
    if (input.complex.dimension == 3)
      oracle.space = std::make_unique<FeatureSizes3>(input.complex);
    else
      oracle.plane = std::make_unique<FeatureSizes>(input.complex);
  }
  last = std::move(oracle);
  return last;
}

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

void push(const Point2& p, std::vector<double>* out) { out->insert(out->end(), {p.x, p.y}); }
void push(const Point3& p, std::vector<double>* out) { out->insert(out->end(), {p.x, p.y, p.z}); }
void take(const double* numbers, Point2* p) { *p = {numbers[0], numbers[1]}; }
void take(const double* numbers, Point3* p) { *p = {numbers[0], numbers[1], numbers[2]}; }
constexpr std::size_t size_of(const Point2&) { return 2; }
constexpr std::size_t size_of(const Point3&) { return 3; }
void spoil(Point2* p) { *p = {kNowhere, kNowhere}; }
void spoil(Point3* p) { *p = {kNowhere, kNowhere, kNowhere}; }

// Radii, centers and witnesses of balls, in arrays.
struct Balls {
  std::vector<double> radius, center, at;
  std::vector<std::uint32_t> witnesses;

  template <class Point>
  void add(const BasicFeatureBall<Point>& ball) {
    radius.push_back(ball.radius);
    Point place = ball.center;
    if (!ball.found()) spoil(&place);
    push(place, &center);
    for (const BasicFeatureWitness<Point>& witness : ball.witness) {
      witnesses.push_back(static_cast<std::uint32_t>(witness.feature.kind));
      witnesses.push_back(witness.feature.index);
      place = witness.at;
      if (!ball.found()) spoil(&place);
      push(place, &at);
    }
  }
  val arrays() const {
    val result = val::object();
    result.set("radius", copied(radius));
    result.set("center", copied(center));
    result.set("witnesses", copied(witnesses));
    result.set("at", copied(at));
    return result;
  }
};

val sizes_answer(const std::string& error, const Balls& lfs, const std::vector<double>& mfs) {
  val result = val::object();
  result.set("ok", error.empty());
  result.set("error", error);
  result.set("lfs", copied(lfs.radius));
  result.set("mfs", copied(mfs));
  result.set("witnesses", copied(lfs.witnesses));
  result.set("at", copied(lfs.at));
  return result;
}

template <class Point>
val sizes_at(const BasicFeatureSizes<Point>& sizes, const std::vector<double>& numbers) {
  Balls lfs;
  std::vector<double> mfs;
  Point x;
  for (std::size_t k = 0; k + size_of(x) <= numbers.size(); k += size_of(x)) {
    take(&numbers[k], &x);
    lfs.add(sizes.local(x));
    mfs.push_back(sizes.mesh(x).radius);
  }
  return sizes_answer("", lfs, mfs);
}

val feature_sizes(const std::string& text, val points) {
  try {
    const Oracle& oracle = oracle_of(text);
    if (!oracle.error.empty()) return sizes_answer(oracle.error, {}, {});
    const auto numbers = emscripten::convertJSArrayToNumberVector<double>(points);
    return oracle.space ? sizes_at(*oracle.space, numbers) : sizes_at(*oracle.plane, numbers);
  } catch (const std::exception& error) {
    return sizes_answer(error.what(), {}, {});
  }
}

val subsegments_answer(const std::string& error, const Balls& fs1, const Balls& lfs1,
                       const Balls& lfs) {
  val result = val::object();
  result.set("ok", error.empty());
  result.set("error", error);
  result.set("fs1", fs1.arrays());
  result.set("lfs1", lfs1.arrays());
  result.set("lfs", lfs.arrays());
  return result;
}

template <class Point>
val subsegments_at(const BasicFeatureSizes<Point>& sizes, const std::vector<double>& numbers) {
  Balls fs1, lfs1, lfs;
  Point a, b;
  const std::size_t stride = 2 * size_of(a);
  for (std::size_t k = 0; k + stride <= numbers.size(); k += stride) {
    take(&numbers[k], &a);
    take(&numbers[k + size_of(a)], &b);
    fs1.add(sizes.of_subsegment(a, b, 1));
    lfs1.add(sizes.local(a, b, 1));
    lfs.add(sizes.local(a, b));
  }
  return subsegments_answer("", fs1, lfs1, lfs);
}

val subsegment_sizes(const std::string& text, val ends) {
  try {
    const Oracle& oracle = oracle_of(text);
    if (!oracle.error.empty()) return subsegments_answer(oracle.error, {}, {}, {});
    const auto numbers = emscripten::convertJSArrayToNumberVector<double>(ends);
    return oracle.space ? subsegments_at(*oracle.space, numbers)
                        : subsegments_at(*oracle.plane, numbers);
  } catch (const std::exception& error) {
    return subsegments_answer(error.what(), {}, {}, {});
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(circumball_feature_sizes) {
  emscripten::function("featureSizes", &feature_sizes);
  emscripten::function("subsegmentSizes", &subsegment_sizes);
}

}  // namespace circumball
