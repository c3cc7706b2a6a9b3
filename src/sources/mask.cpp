// Compiled into this file with no names outside it: an application may have another build of stb_image, with fewer
// formats.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "checks/checks.h"
#include "drench/soak.h"

namespace drench {

namespace {

template <typename... Parts>
std::runtime_error unreadable(const std::filesystem::path& path, const Parts&... why) {
    return std::runtime_error(textOf("drench: cannot read the picture ", path.string(), ": ", why...));
}

std::runtime_error noPicture(const std::filesystem::path& path) {
    const char* reason = stbi_failure_reason();
    return unreadable(path, "it is no picture that can be read here (", reason ? reason : "unknown",
                      "); give a PNG");
}

std::vector<char> readBytes(const std::filesystem::path& path) {
    // On some systems a folder can be opened like a file, and reading fails later with a message without its
    // name.
    if (std::filesystem::is_directory(path)) throw unreadable(path, "it is a folder; give a file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw unreadable(path, "no such file, or not readable");
    std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (bytes.empty()) throw unreadable(path, "it is empty");
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw unreadable(path, "it is larger than 2 GB; make it smaller");
    return bytes;
}

// Luminance with the weights of Rec. 709, so that grey values are not changed; multiplied by the alpha value.
float greyOf(const stbi_us* rgba) {
    const double luminance = 0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2];
    return static_cast<float>(std::min(luminance * rgba[3] / (65535.0 * 65535.0), 1.0));
}

// The two pixels on either side of a position along one axis, and the weight of the second.
struct Between {
    std::size_t first;
    std::size_t second;
    double towardsSecond;
};

// @param place  0 at the outer edge of the first pixel, 1 at that of the last
Between between(double position, int pixels) {
    const double last = pixels - 1;
    const double centred = std::clamp(position * pixels - 0.5, 0.0, last);
    const double first = std::floor(centred);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + 1, last)),
            centred - first};
}

// stb_image supports more formats, but in some of them it writes beyond its buffers.
void checkFormat(const std::filesystem::path& path, const std::vector<char>& bytes) {
    using namespace std::string_view_literals;
    const std::string_view start(bytes.data(), bytes.size());
    for (const std::string_view format : {"\x89PNG\r\n\x1a\n"sv, "\xff\xd8\xff"sv, "BM"sv})
        if (start.substr(0, format.size()) == format) return;
    throw unreadable(path, "it is no picture that can be read here; give a PNG, JPEG or BMP");
}

// stb_image allocates as many bytes as the header of a PNG chunk states; here they are checked to exist.
void checkParts(const std::filesystem::path& path, const std::vector<char>& bytes) {
    constexpr std::size_t signature = 8, around = 12;  // bytes: before the chunks, and around each one
    if (bytes[0] == 'B' || bytes[0] == '\xff') return;
    const auto byte = [&](std::size_t position) {
        return std::size_t(static_cast<unsigned char>(bytes[position]));
    };
    for (std::size_t position = signature; position + around <= bytes.size();) {
        const std::size_t length =
            byte(position) << 24 | byte(position + 1) << 16 | byte(position + 2) << 8 | byte(position + 3);
        if (length > bytes.size() - position - around)
            throw unreadable(path,
                             "it is no picture that can be read here (it ends too early); give a whole PNG");
        position += length + around;
    }
}

// Checked before decompression: a small file may declare more pixels than fit into memory.
void checkSize(const std::filesystem::path& path, const std::vector<char>& bytes) {
    constexpr std::int64_t max = 1 << 25;
    int width = 0, height = 0, channels = 0;
    const bool isKnown =
        stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &width, &height, &channels) != 0;
    if (!isKnown) throw noPicture(path);
    if (width < 1 || height < 1 || std::int64_t(width) * height > max)
        throw unreadable(path, "it is ", width, " x ", height, " pixels; give at least one and at most ", max,
                         " in all");
}

}  // namespace

double Mask::at(double right, double up) const {
    const std::size_t columns = static_cast<std::size_t>(std::max(width, 0));
    if (width < 1 || height < 1 || values.size() != columns * static_cast<std::size_t>(height))
        refuse("a mask needs at least one pixel and a value for each; this one is ", width, " x ", height,
               " with ", values.size(), " values");
    if (std::isnan(right) || std::isnan(up))
        refuse("the position in a mask is (", right, ", ", up, "); give numbers from 0 to 1");
    const Between column = between(right, width);
    const Between row = between(1 - up, height);
    const auto along = [&](std::size_t line) {
        const double left = values[line * columns + column.first];
        return left + column.towardsSecond * (values[line * columns + column.second] - left);
    };
    const double upper = along(row.first);
    return upper + row.towardsSecond * (along(row.second) - upper);
}

Mask readMask(const std::filesystem::path& path) {
    const std::vector<char> bytes = readBytes(path);
    checkFormat(path, bytes);
    checkParts(path, bytes);
    checkSize(path, bytes);
    Mask mask;
    int channels = 0;
    // Sixteen bits keep the full depth of the picture; 8-bit pictures are not changed by this.
    const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
        stbi_load_16_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                 static_cast<int>(bytes.size()), &mask.width, &mask.height, &channels, 4),
        stbi_image_free);
    if (!pixels) throw noPicture(path);
    mask.values.resize(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
    for (std::size_t pixel = 0; pixel < mask.values.size(); ++pixel)
        mask.values[pixel] = greyOf(pixels.get() + 4 * pixel);
    return mask;
}

}  // namespace drench
