#include "messages.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace circumball::cli {

namespace {

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

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : std::string("-");
}

}  // namespace

std::string describe(const Defect& defect, int dimension) {
  std::string line =
      fmt::format("{}: {}: {}", defect.warning ? "warning" : "error", defect.name, defect.message);
  std::string place;
  for (const Feature& feature : defect.features) {
    place += fmt::format("{}{} {}", place.empty() ? "" : ", ", name(feature.kind), feature.index);
  }
  if (!place.empty()) line += fmt::format(" [{}]", place);
  for (std::size_t i = 0; i < defect.at.size(); ++i) {
    const Point3& p = defect.at[i];
    line += i == 0 ? " at " : ", ";
    line += dimension == 2 ? fmt::format("({}, {})", p.x, p.y)
                           : fmt::format("({}, {}, {})", p.x, p.y, p.z);
  }
  // One defect a line, whatever bytes of the file the sentence quotes.
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

bool print_defects(const std::vector<Defect>& defects, int dimension) {
  bool fatal = false;
  for (const Defect& defect : defects) {
    std::fprintf(stderr, "%s\n", describe(defect, dimension).c_str());
    fatal = fatal || !defect.warning;
  }
  return fatal;
}

void print_error(const std::string& message) {
  std::fprintf(stderr, "error: %s\n", message.c_str());
}

std::string table(const std::vector<Check>& checks) {
  std::size_t width = 5;
  for (const Check& check : checks) width = std::max(width, check.name.size());
  std::string text =
      fmt::format("{:6}  {:{}}  {:>10}  {:>10}  {}\n", "", "check", width, "bound", "observed", "");
  for (const Check& check : checks) {
    text += fmt::format("{:6}  {:{}}  {:>10}  {:>10}  {}\n", check.ok ? "ok" : "FAILED", check.name,
                        width, number(check.bound), number(check.observed), check.detail);
  }
  return text;
}

bool all_ok(const std::vector<Check>& checks) {
  return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.ok; });
}

}  // namespace circumball::cli
