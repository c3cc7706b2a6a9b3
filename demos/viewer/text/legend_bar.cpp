#include "viewer/text/legend_bar.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "viewer/picture/colour_map.h"
#include "viewer/text/caption_text.h"

namespace drench::viewer {

namespace {

constexpr int parts = 4;

// As many decimals as the step needs, or two digits of it if that takes more than three.
int decimalsFor(float step) {
    float scaled = step;
    for (int decimals = 0; decimals <= 3; ++decimals, scaled *= 10.0f)
        if (scaled >= 1.0f && std::abs(scaled - std::round(scaled)) < 1e-4f * scaled) return decimals;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(step))), 0, 6);
}

ImU32 screenColour(float fraction) {
    const Eigen::Vector3f light = mappedColour(fraction).cwiseMax(0.0f).cwiseMin(1.0f);
    const auto encoded = [](float channel) {
        return channel <= 0.0031308f ? 12.92f * channel : 1.055f * std::pow(channel, 1.0f / 2.4f) - 0.055f;
    };
    return ImGui::ColorConvertFloat4ToU32(
        ImVec4(encoded(light.x()), encoded(light.y()), encoded(light.z()), 1.0f));
}

void drawBar(ImDrawList& canvas, ImVec2 min, ImVec2 max) {
    constexpr int steps = 64;
    const float step = (max.x - min.x) / steps;
    const float rim = std::max(1.0f, (max.y - min.y) / 16.0f);
    canvas.AddRectFilled(ImVec2(min.x - rim, min.y - rim), ImVec2(max.x + rim, max.y + rim),
                         IM_COL32(10, 14, 20, 160));
    for (int i = 0; i < steps; ++i) {
        const float left = min.x + step * static_cast<float>(i);
        const ImU32 from = screenColour(static_cast<float>(i) / steps);
        const ImU32 to = screenColour(static_cast<float>(i + 1) / steps);
        canvas.AddRectFilledMultiColor(ImVec2(left, min.y), ImVec2(left + step, max.y), from, to, to, from);
    }
}

}  // namespace

std::vector<std::string> legendTicks(const Legend& legend) {
    const float step = (legend.to - legend.from) / parts;
    const int decimals = decimalsFor(step);
    std::vector<std::string> ticks;
    for (int i = 0; i <= parts; ++i) {
        std::ostringstream text;
        text << std::fixed << std::setprecision(decimals) << legend.from + step * static_cast<float>(i);
        ticks.push_back(text.str());
    }
    return ticks;
}

void drawLegend(ImDrawList& canvas, const Legend& legend, ImVec2 min, ImVec2 max, float margin, bool above) {
    const float room = max.x - min.x - 2.0f * margin;
    const float size = ImGui::GetFont()->FontSize * 0.8f;
    const float width = std::min(room, 15.0f * size);
    const float height = 3.1f * size;
    const float left = max.x - margin - width;
    const float top = above ? min.y + margin : max.y - margin - height;
    const float inset = size;  // half of the widest tick reaches beyond the bar
    writeText(canvas, legend.title, ImVec2(left + inset, top), size, width);
    const ImVec2 barMin(left + inset, top + 1.25f * size);
    const ImVec2 barMax(left + width - inset, top + 1.95f * size);
    drawBar(canvas, barMin, barMax);
    const std::vector<std::string> ticks = legendTicks(legend);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float x = barMin.x + (barMax.x - barMin.x) * static_cast<float>(i) / parts;
        canvas.AddLine(ImVec2(x, barMax.y), ImVec2(x, barMax.y + 0.2f * size), IM_COL32(255, 255, 255, 255),
                       std::max(1.0f, size / 14.0f));
        const float half = 0.5f * textSize(ticks[i], 0.85f * size, 0.0f).x;
        writeText(canvas, ticks[i], ImVec2(x - half, barMax.y + 0.22f * size), 0.85f * size, 0.0f);
    }
}

}  // namespace drench::viewer
