// Parts of a framebuffer.
#pragma once

namespace drench::viewer {

// A rectangle of pixels; x and y count from the lower left corner of the framebuffer.
struct Area {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// Two areas of the same size side by side with a line of two or three pixels between them.
struct AreaPair {
    Area left;
    Area right;
};

// Splits a framebuffer of width x height pixels; both areas are empty when there is no room for them.
constexpr AreaPair sideBySide(int width, int height) {
    const int half = width > 3 && height > 0 ? (width - 2) / 2 : 0;
    return {{0, 0, half, height}, {width - half, 0, half, height}};
}

}  // namespace drench::viewer
