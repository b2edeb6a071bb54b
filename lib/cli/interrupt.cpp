#include "interrupt.h"

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#include <csignal>
#endif

namespace circumball::cli {

#ifdef __EMSCRIPTEN__

// WebAssembly has no signals: the launcher runs the command in a worker and counts Ctrl-C in shared
// memory.
void catch_interrupts() {}

bool interrupted() {
  return EM_ASM_INT({
           var count = globalThis.circumballInterrupts;
           return count ? Atomics.load(count, 0) : 0;
         }) > 0;
}

#else

namespace {

volatile std::sig_atomic_t interrupts = 0;

void on_interrupt(int signal) {
  interrupts = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() { std::signal(SIGINT, on_interrupt); }

bool interrupted() { return interrupts != 0; }

#endif

}  // namespace circumball::cli
