#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "circumball/registry.h"
#include "command.h"
#include "files.h"
#include "messages.h"

namespace circumball::cli {

namespace {

std::string summary(const ReadResult& input) {
  const Complex& complex = input.complex;
  std::string text = fmt::format(
      "{}: {} vertices, {} segments, {} faces, {} holes, {} regions, dimension {}\n", input.format,
      complex.vertices.size(), complex.segments.size(), complex.faces.size(), complex.holes.size(),
      complex.regions.size(), complex.dimension);
  Point3 low, high;
  bool any = false;
  for (const Point3& p : complex.vertices) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
    if (!any) low = high = p;
    any = true;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (any) {
    text += complex.dimension == 2
                ? fmt::format("bounds: ({}, {}) to ({}, {})\n", low.x, low.y, high.x, high.y)
                : fmt::format("bounds: ({}, {}, {}) to ({}, {}, {})\n", low.x, low.y, low.z, high.x,
                              high.y, high.z);
  }
  if (input.mesh) {
    text += fmt::format("mesh: {} vertices, {} cells\n", input.mesh->vertices.size(),
                        input.mesh->cell_count());
  }
  return text;
}

}  // namespace

int check_command(const CheckArguments& arguments) {
  const ReadResult input = read_input(arguments.input, arguments.reading);
  if (print_defects(input.defects, input.complex.dimension)) return kInvalidInput;
  std::fputs(summary(input).c_str(), stdout);
  if (print_defects(check(input.complex), input.complex.dimension)) return kInvalidInput;
  // Only now: an angle between segments that are invalid means nothing.
  std::printf("%s",
              fmt::format("smallest angle: {:.6g} degrees\ndefault algorithm: {}\nvalid\n",
                          smallest_angle_degrees(input.complex), default_algorithm(input.complex))
                  .c_str());
  return kDone;
}

}  // namespace circumball::cli
