#include "progress.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace circumball::cli {

namespace {
constexpr const char* kEraseLine = "\r\x1b[K";
}

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (drawn_) std::fputs(kEraseLine, stderr);
}

void ProgressLine::show(const Progress& progress) {
  if (!shown_) return;
  const double rate =
      progress.seconds > 0 ? static_cast<double>(progress.vertices) / progress.seconds : 0;
  std::fputs(fmt::format("{}step {}: {} vertices, {} queued, {:.0f} vertices/s", kEraseLine,
                         progress.step, progress.vertices, progress.queued, rate)
                 .c_str(),
             stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace circumball::cli
