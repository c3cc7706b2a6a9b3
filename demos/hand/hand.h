// The user's hand in a scene: what the mouse does to cloth.
#pragma once

#include <optional>
#include <vector>

#include "hand/grasp.h"
#include "hand/graspable.h"
#include "hand/hose.h"
#include "hand/pointer.h"

namespace drench::demo {

// Drags cloth, sprays water at it, or dabs it dry, frame by frame. It does nothing to a scene while the
// button is up.
class Hand {
  public:
    // Does what the pointer says in the frame that comes, s.
    // @param sheets  all there are now; those of earlier frames may be gone
    void act(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);

    // Lets go of what it holds, until the button is pressed again.
    void letGo();

    // What sprays water in this frame; none while the hose is off.
    const std::optional<Nozzle>& nozzle() const { return nozzle_; }
    // Adds the hose to a picture, while it is on.
    void show(viewer::Picture& picture) const;

  private:
    void drag(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);
    void spray(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);

    std::optional<Grasp> grasp_;
    bool pressed_ = false;  // in the frame before
    Hose hose_;
    std::optional<Nozzle> nozzle_;
};

// Takes water off a sheet within 6 cm of a point for `time` s, as an absorbent towel does: film within a
// tenth of a second or so, pore water in half a second. The water is returned in an account named "towel".
void dabDry(WetCloth& cloth, const btSoftBody& body, const btVector3& point, double time);

}  // namespace drench::demo
