// The colour bar of a legend.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// The labels of a bar: its two ends and three values between them.
std::vector<std::string> legendTicks(const Legend& legend);

// Draws the bar, its ticks and its title, ending `margin` pixels inside the lower right corner of the
// rectangle from `min` to `max`, or the upper right one if `above`.
void drawLegend(ImDrawList& canvas, const Legend& legend, ImVec2 min, ImVec2 max, float margin, bool above);

}  // namespace drench::viewer
