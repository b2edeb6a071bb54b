#include "algorithms/terminator.h"

#include "algorithms/protect.h"

namespace circumball {
namespace {

class MarkShellCenters final : public Stage {
 public:
  MarkShellCenters() : Stage("shells", "Which input vertices have shells about them") {}

  bool advance(Workspace& w, Budget&) override {
    w.live.track_shells(acute_vertices(w.live.complex()));
    return true;
  }
};

}  // namespace

std::unique_ptr<Stage> mark_shell_centers() { return std::make_unique<MarkShellCenters>(); }

}  // namespace circumball
