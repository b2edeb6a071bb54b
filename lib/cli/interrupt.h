#ifndef CIRCUMBALL_CLI_INTERRUPT_H_
#define CIRCUMBALL_CLI_INTERRUPT_H_

namespace circumball::cli {

/// From the first call on, Ctrl-C no longer ends the process at once: it is remembered. A second
/// one does end it.
void catch_interrupts();
/// Whether Ctrl-C was pressed.
bool interrupted();

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_INTERRUPT_H_
