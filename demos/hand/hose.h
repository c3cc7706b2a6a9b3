// A hose in the user's hand.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <vector>

#include "effects/nozzle.h"
#include "hand/graspable.h"

namespace drench::demo {

// Sprays water at sheets, in the sheets' own time however fast their water runs, in an account named "hose".
class Hose {
  public:
    // Sprays at all of these sheets in the next frame of so many seconds.
    void spray(const std::vector<Graspable>& sheets, const Nozzle& nozzle, double frameTime);

  private:
    struct Stream;
    class StreamSource;

    Stream& streamTo(WetCloth& cloth);

    std::vector<std::weak_ptr<Stream>> streams_;  // end with their sheets
};

}  // namespace drench::demo
