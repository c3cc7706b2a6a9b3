// Camera motion from mouse motion; no window.
#pragma once

#include "viewer/picture/picture.h"

namespace drench::viewer {

// Rotates the camera around the target; `right` and `down` are a mouse motion as a fraction of the window
// height.
void orbit(Camera& camera, float right, float down);

// Moves the target with the mouse, so that it stays under the pointer; arguments as for orbit.
void pan(Camera& camera, float right, float down);

// Moves the camera closer by 12 % per wheel notch (away for negative ones), between 0.2 m and 60 m.
void zoom(Camera& camera, float notches);

}  // namespace drench::viewer
