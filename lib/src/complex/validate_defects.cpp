#include "complex/validate_defects.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace circumball {

void DefectList::add(std::vector<Feature> features, std::vector<Point3> at, std::string message) {
  if (!has_room()) {
    ++rest_;
    return;
  }
  Defect d;
  d.name = name_;
  d.features = std::move(features);
  d.at = std::move(at);
  d.message = std::move(message);
  d.warning = warning_;
  defects_.push_back(std::move(d));
}

void DefectList::append_to(std::vector<Defect>* all, bool sorted) {
  if (sorted) {
    std::stable_sort(defects_.begin(), defects_.end(), [](const Defect& a, const Defect& b) {
      return std::lexicographical_compare(a.features.begin(), a.features.end(), b.features.begin(),
                                          b.features.end(), [](const Feature& f, const Feature& g) {
                                            return f.kind != g.kind ? f.kind < g.kind
                                                                    : f.index < g.index;
                                          });
    });
  }
  const bool more = rest_ > 0 || (incomplete_ && !defects_.empty());
  for (Defect& d : defects_) all->push_back(std::move(d));
  if (more) {
    Defect d;
    d.name = name_;
    d.warning = warning_;
    d.message = rest_ == 0 ? std::string("there may be more of this kind")
                : incomplete_
                    ? "at least " + std::to_string(rest_) + " more of this kind, not listed"
                    : std::to_string(rest_) + " more of this kind, not listed";
    if (incomplete_) d.message += "; the search was ended: correct those that are listed first";
    all->push_back(std::move(d));
  }
  defects_.clear();
  rest_ = 0;
}

std::string number_text(double value) {
  char buffer[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    if (std::strtod(buffer, nullptr) == value) break;  // never for NaN: 17 digits of it
  }
  return buffer;
}

std::string point_text(const Point3& p, int dimension) {
  std::string text = "(" + number_text(p.x) + ", " + number_text(p.y);
  if (dimension == 3) text += ", " + number_text(p.z);
  return text + ")";
}

}  // namespace circumball
