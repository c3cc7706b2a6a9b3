#include "viewer/text/caption_text.h"

#include <algorithm>
#include <cfloat>

namespace drench::viewer {

void writeText(ImDrawList& canvas, const std::string& line, ImVec2 at, float size, float width) {
    const char* const begin = line.c_str();
    const char* const end = begin + line.size();
    const float rim = std::max(1.0f, size / 16.0f);
    const auto write = [&](float right, float down, ImU32 colour) {
        canvas.AddText(ImGui::GetFont(), size, ImVec2(at.x + right, at.y + down), colour, begin, end, width);
    };
    const ImU32 dark = IM_COL32(10, 14, 20, 70);
    for (const float right : {-rim, 0.0f, rim})
        for (const float down : {-rim, 0.0f, rim}) write(right, down, dark);
    write(rim, rim, IM_COL32(10, 14, 20, 150));
    write(0.0f, 0.0f, IM_COL32(255, 255, 255, 255));
}

ImVec2 textSize(const std::string& line, float size, float width) {
    const char* const begin = line.c_str();
    return ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, width, begin, begin + line.size());
}

}  // namespace drench::viewer
