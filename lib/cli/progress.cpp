#include "progress.h"

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#include <unistd.h>
#endif

#include <cstdio>

#include <fmt/format.h>

namespace circumball::cli {

namespace {

constexpr const char* kEraseLine = "\r\x1b[K";

bool stderr_is_terminal() {
#ifdef __EMSCRIPTEN__
  // Emscripten's own isatty says yes to whatever Node has for standard error.
  return EM_ASM_INT({ return require('tty').isatty(2) ? 1 : 0; }) != 0;
#else
  return ::isatty(STDERR_FILENO) != 0;
#endif
}

}  // namespace

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && stderr_is_terminal()) {}

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
