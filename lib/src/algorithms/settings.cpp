#include "algorithms/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "algorithms/sweeps.h"
#include "circumball/registry.h"
#include "complex/enclosure.h"
#include "complex/live2.h"
#include "delaunay/constructions.h"
#include "predicates/elementary.h"

namespace circumball {
namespace {

/// A finite number that is all of the text.
bool parse_number(const std::string& text, double* value) {
  char* end = nullptr;
  *value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(*value);
}

/// A sizing function that is not a plain number: it must be positive at the input vertices, at
/// least.
std::string settle_sizing(const Complex& complex, const std::string& text, Settings* settings) {
  auto sizing = std::make_shared<Sizing>();
  std::string error;
  if (!Sizing::parse(text, sizing.get(), &error)) return "size: " + error;
  for (const Point3& p : complex.vertices) {
    const double h = sizing->at(p.x, p.y, p.z);
    if (!(h > 0) || std::isinf(h)) {
      return "size: '" + text + "' is not positive and finite at the input vertex (" +
             std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
    }
  }
  settings->sizing = sizing;
  return "";
}

/// Of the bounding box of the vertices.
double diameter(const Complex& complex) {
  if (complex.vertices.empty()) return 0;
  Point3 low = complex.vertices[0], high = low;
  for (const Point3& p : complex.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

/// Whether the box lies strictly around the input, in the range of coordinates.
bool box_fits(const Complex& complex, double scale) {
  const Complex boxed = with_box(complex, scale);
  const bool space = complex.dimension == 3;
  const Point3 &low = *(boxed.vertices.end() - (space ? 8 : 4)),
               &high = *(boxed.vertices.end() - 2);
  for (const Point3& p : complex.vertices) {
    if (!(low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y)) return false;
    if (space && !(low.z < p.z && p.z < high.z)) return false;
  }
  return std::min({low.x, low.y, low.z}) >= -1e55 && std::max({high.x, high.y, high.z}) <= 1e55;
}

}  // namespace

std::string settle(const Complex& complex, Options* options, Settings* settings) {
  if (options->algorithm.empty()) options->algorithm = default_algorithm(complex);
  const AlgorithmInfo* info = find_algorithm(options->algorithm, complex.dimension);
  if (!info) {
    return "there is no algorithm '" + options->algorithm + "' for dimension " +
           std::to_string(complex.dimension) + "; `circumball list` names them";
  }
  // The options with names of their own are parameters of the registry like all others.
  auto& values = options->parameters;
  if (!options->size.empty()) values["size"] = options->size;
  for (const auto& [name, text] : values) {
    const auto known = std::find_if(info->parameters.begin(), info->parameters.end(),
                                    [&n = name](const ParameterInfo& p) { return p.name == n; });
    if (known == info->parameters.end()) {
      return "algorithm '" + info->id + "' has no parameter '" + name + "'";
    }
    double value, low, high;
    if (known->min.find('|') != std::string::npos) {  // a choice
      if (("|" + known->min + "|").find("|" + text + "|") != std::string::npos) continue;
      return "'" + name + "' must be one of " + known->min;
    }
    if (name == "size" && info->id != "chew" && complex.dimension == 2 &&
        !parse_number(text, &value)) {
      const std::string error = settle_sizing(complex, text, settings);
      if (!error.empty()) return error;
      continue;
    }
    if (!parse_number(text, &value)) return "'" + text + "' is not a number for '" + name + "'";
    if (parse_number(known->min, &low) && parse_number(known->max, &high) &&
        !(value >= low && value <= high)) {
      return "'" + name + "' is " + text + ", but must be between " + known->min + " and " +
             known->max;
    }
  }
  for (const ParameterInfo& p : info->parameters) {
    if (p.name != "tau" && p.name != "min-angle") values.emplace(p.name, p.default_value);
  }
  const auto number = [&](const char* name) {
    const auto found = values.find(name);
    double value = 0;
    if (found != values.end()) parse_number(found->second, &value);
    return value;
  };
  settings->algorithm = info->id;
  settings->size = number("size");
  if (values.count("protection")) settings->protection = number("protection");
  settings->off_centers = values.count("steiner") && values["steiner"] == "off-center";
  settings->estimate_sizes = values.count("sizes") && values["sizes"] == "estimate";
  if (values.count("size-factor")) settings->size_factor = number("size-factor");
  if (values.count("height")) settings->height = number("height");
  if (!(settings->size_factor * settings->height < 0.5)) {
    return "'height' times 'size-factor' must be below 1/2: collars of segments at a vertex would "
           "cross";
  }
  settings->protect_all = values.count("protect") && values["protect"] == "all";
  if (options->tau && !(*options->tau >= 0.6 && *options->tau <= 1000)) {
    return "tau must be between 0.6 and 1000";
  }
  if (options->min_angle_degrees &&
      !(*options->min_angle_degrees >= 0.1 && *options->min_angle_degrees <= 56)) {
    return "the smallest angle must be between 0.1 and 56 degrees";
  }
  if (!options->tau && values.count("tau")) options->tau = number("tau");
  if (!options->min_angle_degrees && values.count("min-angle")) {
    options->min_angle_degrees = number("min-angle");
  }
  const bool takes_angle = complex.dimension == 2;
  if (!takes_angle && options->min_angle_degrees) {
    return "in space no dihedral angle follows from a radius-edge threshold: give tau";
  }
  if (!takes_angle && !options->tau) {
    for (const ParameterInfo& p : info->parameters) {
      double value = 0;
      if (p.name == "tau" && parse_number(p.default_value, &value)) options->tau = value;
    }
  }
  if (options->tau && !options->min_angle_degrees) {
    settings->tau = *options->tau;
  } else {
    if (options->tau) return "give tau or the smallest angle, not both";
    const double degrees = options->min_angle_degrees.value_or(20.7);
    settings->tau = 0.5 / elementary::sin(degrees * (elementary::kPi / 180));
  }
  values.erase("tau");
  values.erase("min-angle");
  if (values.count("slivers") && values["slivers"] == "remove") {
    settings->sliver_degrees = number("dihedral");
  } else {
    values.erase("dihedral");
  }
  settings->min_edge = options->limits.min_edge;
  if (values.count("step2a")) settings->step2a = values["step2a"];
  const bool conforms = !(complex.dimension == 3 && info->default_domain == "hull");
  const bool encloses = conforms && (complex.dimension == 2 ? encloses_something(complex)
                                                            : faces_enclose_something(complex));
  if (options->domain == Domain::kDefault) {
    options->domain = info->default_domain == "hull" ? Domain::kHull
                      : encloses                     ? Domain::kClosed
                                                     : Domain::kBox;
  }
  if (options->domain == Domain::kClosed && !conforms) {
    return "in space the domain `closed` needs a mesh that conforms to the faces, which '" +
           info->id + "' does not make: use `hull` or `box`";
  }
  if (options->domain == Domain::kClosed && !encloses) {
    return std::string(complex.dimension == 2 ? "the segments" : "the faces") +
           " enclose nothing, so that the domain `closed` is empty: use `box` or `hull`";
  }
  settings->domain = options->domain;
  if (values.count("box-scale")) settings->box_scale = number("box-scale");
  if (options->domain == Domain::kBox && !box_fits(complex, settings->box_scale)) {
    return "the box cannot be represented: its corners would be beyond 1e55, or too near to the "
           "input for double precision; move or scale the input, or use the domain `hull`";
  }
  if (info->id == "chew" && settings->size == 0) {
    settings->size = default_division_length(complex);
    if (!std::isfinite(settings->size)) settings->size = 1;  // a single vertex
  }
  if (info->id == "fem-size" && settings->size == 0 && !settings->sizing) {
    settings->size = 0.1 * diameter(complex);
    if (settings->size == 0) settings->size = 1;  // a single vertex
  }
  if (settings->sizing) {
    settings->size = 0;
    return "";
  }
  options->size.clear();
  if (settings->size > 0) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", settings->size);
    values["size"] = options->size = text;
  }
  return "";
}

}  // namespace circumball
