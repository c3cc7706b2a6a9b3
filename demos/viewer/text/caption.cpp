#include "viewer/text/caption.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>

#include "viewer/text/caption_text.h"
#include "viewer/text/fonts.h"
#include "viewer/text/legend_bar.h"

namespace drench::viewer {

namespace {

constexpr float lineSpacing = 1.12f;

float heightOf(const std::string& line, float width) {
    const float size = ImGui::GetFont()->FontSize;
    return lineSpacing * std::max(textSize(line, size, width).y, size);
}

float heightOf(const std::vector<std::string>& lines, float width) {
    float height = 0.0f;
    for (const std::string& line : lines) height += heightOf(line, width);
    return height;
}

// So that a line of about thirty letters fits.
float fontPixels(const Area& area) {
    const float pixels =
        std::min(static_cast<float>(area.height) / 22.0f, static_cast<float>(area.width) / 24.0f);
    return std::clamp(std::round(pixels), 15.0f, 96.0f);
}

}  // namespace

void Caption::loadFont(float pixels) {
    if (pixels == fontPixels_) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    addReadableFont(fonts, pixels);
    ImGui_ImplOpenGL3_CreateFontsTexture();
    fontPixels_ = pixels;
}

void Caption::draw(const Picture& picture, const Area& area) {
    if (picture.caption.empty() && !picture.legend) return;
    const ImGuiSession::Use use(session_);
    loadFont(fontPixels(area));
    // ImGui counts from the top of the area, if its drawing area ends there.
    const ImVec2 min(static_cast<float>(area.x), 0.0f);
    const ImVec2 max(static_cast<float>(area.x + area.width), static_cast<float>(area.height));
    ImGui::GetIO().DisplaySize = ImVec2(max.x, static_cast<float>(area.y + area.height));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ImDrawList& canvas = *ImGui::GetForegroundDrawList();
    canvas.PushClipRect(min, max);
    const float margin = std::round(0.7f * fontPixels_);
    const float room = std::max(max.x - min.x - 2.0f * margin, fontPixels_);
    float top = picture.captionBelow ? max.y - margin - heightOf(picture.caption, room) : margin;
    for (const std::string& line : picture.caption) {
        writeText(canvas, line, ImVec2(min.x + margin, top), fontPixels_, room);
        top += heightOf(line, room);
    }
    if (picture.legend) drawLegend(canvas, *picture.legend, min, max, margin, picture.captionBelow);
    canvas.PopClipRect();
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace drench::viewer
