// Whatever the bytes: reading, checking, a bounded run and writing never crash, and never take
// gigabytes.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "circumball/io.h"
#include "circumball/refine.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const circumball::ReadResult input = circumball::read(bytes, "input");
  circumball::check(input.complex);
  if (!input.ok() || input.complex.dimension != 2) return 0;
  circumball::Options options;
  options.limits.max_vertices = input.complex.vertices.size() + 200;
  std::vector<circumball::Defect> defects;
  std::string error;
  const auto run = circumball::Run::create(input.complex, options, nullptr, &defects, &error);
  if (!run) return 0;
  run->advance(2000);
  circumball::write_mesh(run->mesh(), run->complex(), ".json", {}, &error);
  return 0;
}
