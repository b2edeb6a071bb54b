#include "json_face.h"

#include <nlohmann/json.hpp>

#include "circumball/trace.h"

namespace circumball {

namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const char* name(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kVertex:
      return "vertex";
    case FeatureKind::kSegment:
      return "segment";
    case FeatureKind::kFace:
      return "face";
    case FeatureKind::kFree:
      return "free";
  }
  return "";
}

constexpr EventKind kKinds[] = {EventKind::kStepBegan, EventKind::kStepEnded, EventKind::kQueued,
                                EventKind::kDropped,   EventKind::kRefused,   EventKind::kYielded,
                                EventKind::kInserted,  EventKind::kRelabeled, EventKind::kLimit};
constexpr Reason kReasons[] = {
    Reason::kNone,         Reason::kEncroached,     Reason::kMissing,       Reason::kRadiusEdge,
    Reason::kSize,         Reason::kRegionSize,     Reason::kTooLong,       Reason::kYieldedTo,
    Reason::kReturned,     Reason::kInput,          Reason::kBox,           Reason::kMidpoint,
    Reason::kCircumcenter, Reason::kOffCenter,      Reason::kDivision,      Reason::kOutsideDomain,
    Reason::kProtected,    Reason::kMinEdge,        Reason::kPrecision,     Reason::kFrozen,
    Reason::kDied,         Reason::kAcceptable,     Reason::kLimitVertices, Reason::kLimitMinEdge,
    Reason::kLimitSeconds, Reason::kLimitPrecision, Reason::kLimitMemory,   Reason::kCancelled};

// Reads one option; false, with the sentence, if its type is wrong.
bool read_number(const std::string& key, const Json& value, double* number, std::string* error) {
  if (!value.is_number()) {
    *error = "option '" + key + "' is a number";
    return false;
  }
  *number = value.get<double>();
  return true;
}

bool read_text(const std::string& key, const Json& value, std::string* text, std::string* error) {
  if (!value.is_string()) {
    *error = "option '" + key + "' is a text";
    return false;
  }
  *text = value.get<std::string>();
  return true;
}

bool read_domain(const Json& value, Domain* domain, std::string* error) {
  if (value == "hull")
    *domain = Domain::kHull;
  else if (value == "box")
    *domain = Domain::kBox;
  else if (value == "closed")
    *domain = Domain::kClosed;
  else
    *error = "option 'domain' is hull, box or closed";
  return error->empty();
}

bool read_parameters(const Json& value, Options* options, std::string* error) {
  if (!value.is_object()) {
    *error = "option 'parameters' is an object";
    return false;
  }
  for (const auto& [key, setting] : value.items()) {
    if (!read_text(key, setting, &options->parameters[key], error)) return false;
  }
  return true;
}

bool read_option(const std::string& key, const Json& value, Options* options, std::string* error) {
  double number = 0;
  if (key == "algorithm") return read_text(key, value, &options->algorithm, error);
  if (key == "size") return read_text(key, value, &options->size, error);
  if (key == "domain") return read_domain(value, &options->domain, error);
  if (key == "parameters") return read_parameters(value, options, error);
  const bool known = key == "tau" || key == "minAngle" || key == "maxVertices" ||
                     key == "minEdge" || key == "maxSeconds";
  if (!known) {
    *error = "there is no option '" + key + "'";
    return false;
  }
  if (!read_number(key, value, &number, error)) return false;
  if (key == "tau") options->tau = number;
  if (key == "minAngle") options->min_angle_degrees = number;
  if (key == "minEdge") options->limits.min_edge = number;
  if (key == "maxSeconds") options->limits.max_seconds = number;
  if (key == "maxVertices") {
    if (!(number >= 0 && number <= 4294967295.0)) {
      *error = "option 'maxVertices' is between 0 and 4294967295";
      return false;
    }
    options->limits.max_vertices = static_cast<std::uint64_t>(number);
  }
  return true;
}

}  // namespace

std::string defects_json(const std::vector<Defect>& defects) {
  Json list = Json::array();
  for (const Defect& defect : defects) {
    Json features = Json::array(), places = Json::array();
    for (const Feature& feature : defect.features) {
      features.push_back({{"kind", name(feature.kind)}, {"index", feature.index}});
    }
    for (const Point3& p : defect.at) places.push_back(Json::array({p.x, p.y, p.z}));
    list.push_back({{"name", defect.name},
                    {"features", features},
                    {"at", places},
                    {"message", defect.message},
                    {"warning", defect.warning}});
  }
  return dump(list);
}

std::string trace_names_json() {
  Json kinds = Json::object(), reasons = Json::object();
  for (const EventKind kind : kKinds) {
    kinds[std::to_string(static_cast<int>(kind))] = circumball::name(kind);
  }
  for (const Reason reason : kReasons) {
    reasons[std::to_string(static_cast<int>(reason))] = circumball::name(reason);
  }
  return dump({{"kinds", kinds}, {"reasons", reasons}});
}

bool options_from_json(const std::string& text, Options* options, std::string* error) {
  const Json json = Json::parse(text.empty() ? "{}" : text, nullptr, false);
  if (!json.is_object()) {
    *error = "the options are not a JSON object";
    return false;
  }
  for (const auto& [key, value] : json.items()) {
    if (value.is_null()) continue;  // missing and null mean the same
    if (!read_option(key, value, options, error)) return false;
  }
  return true;
}

}  // namespace circumball
