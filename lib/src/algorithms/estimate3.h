#ifndef CIRCUMBALL_ALGORITHMS_ESTIMATE3_H_
#define CIRCUMBALL_ALGORITHMS_ESTIMATE3_H_

#include <memory>
#include <vector>

#include "refinement/stage3.h"

namespace circumball {

/// Algorithm 4.1 on a refinement of its own, of which only the vertices on segments are of use.
class SizeEstimate3 {
 public:
  explicit SizeEstimate3(const Workspace3& w);
  /// Goes on; true when it is done.
  bool advance(Budget& budget);
  Reason limit() const { return work_.limit; }

  /// After it is done: the vertices on each input segment, from its first end to its second.
  std::vector<std::vector<Point3>> on_segments() const;

 private:
  Live3 live_;
  Recorder3 recorder_;
  Workspace3 work_;
  std::vector<std::unique_ptr<Stage3>> stages_;
  std::size_t at_ = 0;
  bool begun_ = false;
};

}  // namespace circumball

#endif  // CIRCUMBALL_ALGORITHMS_ESTIMATE3_H_
