// The mouse tools of a scene: drag, hose and towel.
#pragma once

#include <optional>
#include <vector>

#include "hand/grasp.h"
#include "hand/graspable.h"
#include "hand/hose.h"
#include "hand/pointer.h"

namespace drench::demo {

// Drags cloth, sprays water on it, or dabs it dry, frame by frame. While the button is up it changes nothing
// in the scene.
class Hand {
  public:
    // Applies the pointer to the next frame, s.
    // @param sheets  all sheets that exist now; those of earlier frames may have been destroyed
    void act(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);

    // Releases what it holds, until the button is pressed again.
    void letGo();

    // The nozzle that sprays in this frame; none while the hose is off.
    const std::optional<Nozzle>& nozzle() const { return nozzle_; }
    // Adds the hose to a picture, while it is on.
    void show(viewer::Picture& picture) const;

  private:
    void drag(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);
    void spray(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime);

    std::optional<Grasp> grasp_;
    bool pressed_ = false;  // in the previous frame
    Hose hose_;
    std::optional<Nozzle> nozzle_;
};

// Removes water from a sheet within 6 cm of a point for `time` s, as an absorbent towel does: film with a
// time constant of about a tenth of a second, pore water of half a second. The water is recorded as returned
// in an account named "towel".
void dabDry(WetCloth& cloth, const btSoftBody& body, const btVector3& point, double time);

}  // namespace drench::demo
