#include "sizing/grid.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace circumball {
namespace {

constexpr std::size_t kMaxValues = 10'000'000;
constexpr double kLargest = 1e55;  // as coordinates

using Json = nlohmann::json;

bool fail(std::string* error, const std::string& sentence) {
  *error = sentence;
  return false;
}

/// Two finite numbers in the range of coordinates.
bool read_pair(const Json& grid, const char* key, bool positive, double out[2],
               std::string* error) {
  const auto found = grid.find(key);
  bool ok = found != grid.end() && found->is_array() && found->size() == 2;
  for (std::size_t k = 0; ok && k < 2; ++k) {
    ok = (*found)[k].is_number();
    if (!ok) break;
    out[k] = (*found)[k].get<double>();
    ok = std::fabs(out[k]) <= kLargest && (!positive || out[k] >= 1 / kLargest);
  }
  if (ok) return true;
  return fail(error, std::string("the grid needs \"") + key + "\": two " +
                         (positive ? "positive numbers" : "numbers"));
}

Interval joined(const Interval& a, const Interval& b) {
  return {internal::least(a.lo, b.lo), internal::greatest(a.hi, b.hi)};
}

/// Bilinear: sums of products that are not negative, so that each rounding is relative.
template <class Number>
Number blend(const Number& u, const Number& v, double a, double b, double c, double d) {
  const Number one(1);
  const Number below = (one - u) * Number(a) + u * Number(b);
  const Number above = (one - u) * Number(c) + u * Number(d);
  return (one - v) * below + v * above;
}

/// Where x lies, in samples from the first, kept between the first and the last.
double place(double x, double origin, double spacing, std::size_t samples) {
  const double last = static_cast<double>(samples - 1);
  return std::min(std::max((x - origin) / spacing, 0.0), last);
}
Interval place(const Interval& x, double origin, double spacing, std::size_t samples) {
  const double last = static_cast<double>(samples - 1);
  const Interval at = (x - Interval(origin)) / Interval(spacing);
  return min(max(at, Interval(0)), Interval(last));
}

/// The cell that a place is in: the last one holds its upper end, too.
std::size_t cell_of(double place, std::size_t samples) {
  if (samples == 1) return 0;
  return std::min(static_cast<std::size_t>(place), samples - 2);
}

}  // namespace

bool SampledGrid::parse(const std::string& text, SampledGrid* out, std::string* error) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(error, "the grid is not valid JSON");
  const auto found = json.is_object() ? json.find("grid") : json.end();
  if (found == json.end() || !found->is_object()) {
    return fail(error, "a sampled sizing function is {\"grid\": {…}}");
  }
  SampledGrid grid;
  if (!read_pair(*found, "origin", false, grid.origin_, error) ||
      !read_pair(*found, "spacing", true, grid.spacing_, error)) {
    return false;
  }
  const auto columns = found->find("columns"), values = found->find("values");
  if (columns == found->end() || !columns->is_number_unsigned() ||
      columns->get<std::uint64_t>() == 0) {
    return fail(error, "the grid needs \"columns\": how many values a row has");
  }
  if (values == found->end() || !values->is_array() || values->empty()) {
    return fail(error, "the grid needs \"values\": numbers, row by row");
  }
  if (values->size() > kMaxValues) return fail(error, "the grid has more than 10^7 values");
  if (columns->get<std::uint64_t>() > values->size() ||
      values->size() % columns->get<std::size_t>() != 0) {
    return fail(error, "the grid has " + std::to_string(values->size()) +
                           " values, which is no multiple of its " +
                           std::to_string(columns->get<std::uint64_t>()) + " columns");
  }
  grid.columns_ = columns->get<std::size_t>();
  grid.rows_ = values->size() / grid.columns_;
  grid.values_.reserve(values->size());
  for (const Json& v : *values) {
    const double value = v.is_number() ? v.get<double>() : 0;
    if (!(value >= 1 / kLargest && value <= kLargest)) {
      return fail(error, "value " + std::to_string(grid.values_.size()) + " of the grid (" +
                             v.dump() + ") is not a positive number");
    }
    grid.values_.push_back(value);
  }
  grid.build();
  *out = std::move(grid);
  return true;
}

void SampledGrid::build() {
  std::vector<Interval> last(values_.begin(), values_.end());
  std::size_t columns = columns_, rows = rows_;
  while (columns > 1 || rows > 1) {
    Level level{(columns + 1) / 2, (rows + 1) / 2, {}};
    level.range.resize(level.columns * level.rows);
    for (std::size_t j = 0; j < level.rows; ++j) {
      for (std::size_t i = 0; i < level.columns; ++i) {
        const std::size_t i1 = std::min(2 * i + 1, columns - 1), j1 = std::min(2 * j + 1, rows - 1);
        level.range[j * level.columns + i] =
            joined(joined(last[2 * j * columns + 2 * i], last[2 * j * columns + i1]),
                   joined(last[j1 * columns + 2 * i], last[j1 * columns + i1]));
      }
    }
    columns = level.columns;
    rows = level.rows;
    last = level.range;
    levels_.push_back(std::move(level));
  }
}

Interval SampledGrid::samples_between(std::size_t i0, std::size_t i1, std::size_t j0,
                                      std::size_t j1) const {
  std::size_t k = 0;  // blocks so large that there are few
  while (k < levels_.size() && ((i1 >> k) - (i0 >> k) > 2 || (j1 >> k) - (j0 >> k) > 2)) ++k;
  Interval range = sample(i0, j0);
  for (std::size_t j = j0 >> k; j <= j1 >> k; ++j) {
    for (std::size_t i = i0 >> k; i <= i1 >> k; ++i) {
      range = joined(range, k == 0 ? Interval(sample(i, j))
                                   : levels_[k - 1].range[j * levels_[k - 1].columns + i]);
    }
  }
  return range;
}

double SampledGrid::at(double x, double y) const {
  if (!(x == x && y == y)) return internal::kNaN;
  const double u = place(x, origin_[0], spacing_[0], columns_);
  const double v = place(y, origin_[1], spacing_[1], rows_);
  const std::size_t i = cell_of(u, columns_), j = cell_of(v, rows_);
  const std::size_t i1 = std::min(i + 1, columns_ - 1), j1 = std::min(j + 1, rows_ - 1);
  return blend(u - static_cast<double>(i), v - static_cast<double>(j), sample(i, j), sample(i1, j),
               sample(i, j1), sample(i1, j1));
}

/// Over a part of one cell; u and v are places.
Interval SampledGrid::over_cell(std::size_t i, std::size_t j, const Interval& u,
                                const Interval& v) const {
  const auto inside = [](const Interval& place, std::size_t cell) {
    const double first = static_cast<double>(cell);
    return Interval(std::max(place.lo - first, 0.0), std::min(place.hi - first, 1.0));
  };
  const std::size_t i1 = std::min(i + 1, columns_ - 1), j1 = std::min(j + 1, rows_ - 1);
  const Interval s = inside(u, i), t = inside(v, j);
  const auto corner = [&](double x, double y) {
    return blend(Interval(x), Interval(y), sample(i, j), sample(i1, j), sample(i, j1),
                 sample(i1, j1));
  };
  return joined(joined(corner(s.lo, t.lo), corner(s.hi, t.lo)),
                joined(corner(s.lo, t.hi), corner(s.hi, t.hi)));
}

Interval SampledGrid::over(const Interval& x, const Interval& y) const {
  if (x.is_empty() || y.is_empty()) return Interval::empty();
  const Interval u = place(x, origin_[0], spacing_[0], columns_);
  const Interval v = place(y, origin_[1], spacing_[1], rows_);
  const std::size_t i0 = cell_of(u.lo, columns_), i1 = cell_of(u.hi, columns_);
  const std::size_t j0 = cell_of(v.lo, rows_), j1 = cell_of(v.hi, rows_);
  // `at` rounds each of its seven operations, and its place: what that can do between the corners.
  constexpr int kRounding = 16;
  if (i1 - i0 > 3 || j1 - j0 > 3) {
    return samples_between(i0, std::min(i1 + 1, columns_ - 1), j0, std::min(j1 + 1, rows_ - 1))
        .widened(kRounding);
  }
  Interval range = over_cell(i0, j0, u, v);
  for (std::size_t j = j0; j <= j1; ++j) {
    for (std::size_t i = i0; i <= i1; ++i) range = joined(range, over_cell(i, j, u, v));
  }
  return range.widened(kRounding);
}

}  // namespace circumball
