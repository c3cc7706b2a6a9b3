#include "viewer/text/fonts.h"

#include <array>
#include <filesystem>

namespace drench::viewer {

namespace {

// The first of these files that exists is used, or ImGui's own small font if there is none.
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

}  // namespace

void addReadableFont(ImFontAtlas& fonts, float pixels) {
    std::error_code ignored;
    for (const char* file : fontFiles)
        if (std::filesystem::exists(file, ignored) &&
            fonts.AddFontFromFileTTF(file, pixels, nullptr, glyphRanges.data()) != nullptr)
            return;
    ImFontConfig config;
    config.SizePixels = pixels;
    fonts.AddFontDefault(&config);
}

}  // namespace drench::viewer
