// Images in memory and in files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace drench::viewer {

// An sRGB image; rgb holds 3 * width * height bytes, top row first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

// Writes a PNG file atomically; missing parent folders are made.
// Throws std::runtime_error, naming the path, when the image is empty or cannot be written.
void writePng(const std::filesystem::path& path, const Image& image);

// Reads a PNG file as RGB; throws std::runtime_error, naming the path, when that fails.
Image readPng(const std::filesystem::path& path);

// Tiles images of one size row by row, `gap` pixels apart, on light grey; throws std::runtime_error on unequal sizes,
// no image, columns below 1 or a negative gap.
Image contactSheet(const std::vector<Image>& images, int columns, int gap);

}  // namespace drench::viewer
