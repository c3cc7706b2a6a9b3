// The bar that says what colours mean.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// The values written along a bar: its two ends and three between.
std::vector<std::string> legendTicks(const Legend& legend);

// Draws the bar, its ticks and its title so that they end `margin` pixels inside the lower right corner of the
// rectangle from `least` to `most`, or the upper right one.
void drawLegend(ImDrawList& canvas, const Legend& legend, ImVec2 min, ImVec2 max, float margin, bool above);

}  // namespace drench::viewer
