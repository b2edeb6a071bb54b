#ifndef CIRCUMBALL_CLI_PROGRESS_H_
#define CIRCUMBALL_CLI_PROGRESS_H_

#include "circumball/refine.h"

namespace circumball::cli {

/// The progress line: step, vertices, queue length, rate; redrawn in place on a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  void show(const Progress& progress);

 private:
  bool shown_;
  bool drawn_ = false;
};

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_PROGRESS_H_
