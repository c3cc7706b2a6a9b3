// A hose that the user aims with the mouse.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <vector>

#include "effects/nozzle.h"
#include "hand/graspable.h"

namespace drench::demo {

// Sprays water on sheets, in the sheets' own time at any water speed, in an account named "hose".
class Hose {
  public:
    // Sprays on all of these sheets in the next frame, of `frameTime` seconds.
    void spray(const std::vector<Graspable>& sheets, const Nozzle& nozzle, double frameTime);

  private:
    struct Stream;
    class StreamSource;

    Stream& streamTo(WetCloth& cloth);

    std::vector<std::weak_ptr<Stream>> streams_;  // destroyed with their sheets
};

}  // namespace drench::demo
