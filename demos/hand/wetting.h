// Adds water to cloth, or removes it, all at once.
#pragma once

#include <drench/drench.h>

#include <vector>

#include "stage/scene.h"

namespace drench::demo {

// Sets the saturation of each node, 0 to 1, and removes the film; the difference is recorded in an account
// named "by hand".
void wetTo(WetCloth& cloth, double saturation);

// The sheets of a scene that can be wetted.
std::vector<WetCloth*> wettable(Scene& scene);

// The same for all of these sheets.
void wetTo(Scene& scene, double saturation);

}  // namespace drench::demo
