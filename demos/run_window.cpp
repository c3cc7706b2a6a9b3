#include "runners.h"
#include "window_run.h"

namespace drench::demo {

int runInWindow(const RunOptions& options) {
    return WindowRun(options).loop();
}

}  // namespace drench::demo
