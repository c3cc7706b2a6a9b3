#include "viewer/gl/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "checks/text.h"
#include "state/whole_file.h"

namespace drench::viewer {

namespace {

std::runtime_error fileError(const std::string& what, const std::filesystem::path& path,
                             const std::string& why) {
    return std::runtime_error("viewer: cannot " + what + " " + path.string() + ": " + why);
}

std::size_t byteCount(int width, int height) {
    return 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void requireWhole(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.rgb.size() != byteCount(image.width, image.height)) {
        throw std::runtime_error(
            textOf("viewer: an image must be at least 1 x 1 and hold 3 bytes a pixel; this one is ",
                   image.width, " x ", image.height, " with ", image.rgb.size(), " bytes"));
    }
}

void append(void* context, void* data, int size) {
    const auto* bytes = static_cast<const char*>(data);
    static_cast<std::vector<char>*>(context)->insert(static_cast<std::vector<char>*>(context)->end(), bytes,
                                                     bytes + size);
}

// Light grey, for areas without an image.
constexpr std::uint8_t backdrop = 235;

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image) {
    requireWhole(image);
    std::vector<char> bytes;
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.rgb.data(),
                               3 * image.width) == 0)
        throw fileError("write", path, "the PNG encoder ran out of memory");
    files::writeWhole(path, {bytes.data(), bytes.size()});
}

Image readPng(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw fileError("read", path, "no such file, or not readable");
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &image.width, &image.height, &channels, 3),
        stbi_image_free);
    if (!pixels) throw fileError("read", path, "not a PNG file");
    image.rgb.assign(pixels.get(), pixels.get() + byteCount(image.width, image.height));
    return image;
}

Image contactSheet(const std::vector<Image>& images, int columns, int gap) {
    if (images.empty() || columns < 1 || gap < 0)
        throw std::runtime_error("viewer: a contact sheet needs an image, a column and a gap of 0 or more");
    const Image& first = images.front();
    for (const Image& image : images) {
        requireWhole(image);
        if (image.width != first.width || image.height != first.height)
            throw std::runtime_error("viewer: the images of a contact sheet must all have the same size");
    }
    const int count = static_cast<int>(images.size());
    columns = std::min(columns, count);
    const int rows = (count + columns - 1) / columns;
    Image sheet{columns * first.width + (columns - 1) * gap, rows * first.height + (rows - 1) * gap, {}};
    sheet.rgb.assign(byteCount(sheet.width, sheet.height), backdrop);
    for (int i = 0; i < count; ++i) {
        const int left = (i % columns) * (first.width + gap);
        const int top = (i / columns) * (first.height + gap);
        for (int y = 0; y < first.height; ++y) {
            const auto from = images[static_cast<std::size_t>(i)].rgb.begin() +
                              static_cast<std::ptrdiff_t>(byteCount(first.width, y));
            std::copy_n(from, 3 * first.width,
                        sheet.rgb.begin() + static_cast<std::ptrdiff_t>(byteCount(sheet.width, top + y) +
                                                                        byteCount(left, 1)));
        }
    }
    return sheet;
}

}  // namespace drench::viewer
