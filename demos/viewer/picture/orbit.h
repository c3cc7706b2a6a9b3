// Mouse moves as changes of a camera; plain arithmetic, no window.
#pragma once

#include "viewer/picture/picture.h"

namespace drench::viewer {

// Turns the eye round the target; `right` and `down` are a mouse move as a fraction of the window height.
void orbit(Camera& camera, float right, float down);

// Shifts the target with the mouse, so that it stays under the pointer; move as for orbit.
void pan(Camera& camera, float right, float down);

// Brings the eye closer by 12 % for each wheel notch (further for negative ones), between 0.2 m and 60 m.
void zoom(Camera& camera, float notches);

}  // namespace drench::viewer
