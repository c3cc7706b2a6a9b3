#include "viewer/caption.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <filesystem>

namespace drench::viewer {

namespace {

// The first of these that exists is used; ImGui's own small font stands in where there is none.
constexpr std::array<const char*, 7> fontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Supplemental/Arial.ttf",
    "C:/Windows/Fonts/segoeui.ttf",
    "C:/Windows/Fonts/arial.ttf",
};

// Latin, Greek, dashes and quotes, superscripts, arrows and the mathematical signs that captions use.
constexpr std::array<ImWchar, 13> glyphRanges{0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2070,
                                              0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};

void addFont(ImFontAtlas& fonts, float pixels) {
    std::error_code ignored;
    for (const char* file : fontFiles) {
        if (std::filesystem::exists(file, ignored) &&
            fonts.AddFontFromFileTTF(file, pixels, nullptr, glyphRanges.data()) != nullptr) {
            return;
        }
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    fonts.AddFontDefault(&config);
}

constexpr float lineSpacing = 1.12f;

float heightOf(const std::string& line, float width) {
    const ImFont* const font = ImGui::GetFont();
    const char* const begin = line.c_str();
    const float height = font->CalcTextSizeA(font->FontSize, FLT_MAX, width, begin, begin + line.size()).y;
    return lineSpacing * std::max(height, font->FontSize);
}

float heightOf(const std::vector<std::string>& lines, float width) {
    float height = 0;
    for (const std::string& line : lines) height += heightOf(line, width);
    return height;
}

float drawLine(ImDrawList& canvas, const std::string& line, float left, float top, float width) {
    const ImFont* const font = ImGui::GetFont();
    const float size = font->FontSize;
    const char* const begin = line.c_str();
    const char* const end = begin + line.size();
    const float rim = std::max(1.0f, size / 16.0f);
    const auto write = [&](float right, float down, ImU32 colour) {
        canvas.AddText(font, size, ImVec2(left + right, top + down), colour, begin, end, width);
    };
    const ImU32 dark = IM_COL32(10, 14, 20, 70);
    for (const float right : {-rim, 0.0f, rim}) {
        for (const float down : {-rim, 0.0f, rim}) {
            write(right, down, dark);
        }
    }
    write(rim, rim, IM_COL32(10, 14, 20, 150));
    write(0.0f, 0.0f, IM_COL32(255, 255, 255, 255));
    return top + heightOf(line, width);
}

}  // namespace

void Caption::loadFont(float pixels) {
    if (pixels == fontPixels_) {
        return;
    }
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    addFont(fonts, pixels);
    ImGui_ImplOpenGL3_CreateFontsTexture();
    fontPixels_ = pixels;
}

void Caption::draw(const std::vector<std::string>& lines, int width, int height, bool below) {
    if (lines.empty()) {
        return;
    }
    const ImGuiSession::Use use(session_);
    loadFont(std::clamp(std::round(static_cast<float>(height) / 22.0f), 15.0f, 96.0f));
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    const float margin = std::round(0.7f * fontPixels_);
    const float room = std::max(io.DisplaySize.x - 2.0f * margin, fontPixels_);
    float top = below ? io.DisplaySize.y - margin - heightOf(lines, room) : margin;
    for (const std::string& line : lines) {
        top = drawLine(*ImGui::GetForegroundDrawList(), line, margin, top, room);
    }
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace drench::viewer
