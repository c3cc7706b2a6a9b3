// Water that is put into cloth, or taken out of it, at a stroke.
#pragma once

#include <drench/drench.h>

#include <vector>

#include "stage/scene.h"

namespace drench::demo {

// Gives the pores of each node so much of what they hold, 0 to 1, and wipes off the film; the difference is
// in an account named "by hand".
void wetTo(WetCloth& cloth, double saturation);

// The cloths of a scene that water may be brought to.
std::vector<WetCloth*> wettable(Scene& scene);

// The same for all of these in a scene.
void wetTo(Scene& scene, double saturation);

}  // namespace drench::demo
