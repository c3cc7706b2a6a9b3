// A sheet that has its picture taken, and what to read off pictures.
#pragma once

#include <drench/drench.h>

#include <array>
#include <cmath>
#include <memory>

#include "stage/pictures.h"
#include "viewer/gl/image.h"
#include "world/bullet_world.h"

namespace drench::demo {

// A 2 m sheet that stands still and fills the picture.
class Portrait {
  public:
    explicit Portrait(const Fabric& fabric)
        : fabric_(fabric),
          sheet_(makeSheet(bullet_.world().getWorldInfo(), fabric,
                           flatCorners({-1, 2, 0}, {2, 0, 0}, {0, -2, 0}), 21, 21)) {
        bullet_.world().addSoftBody(sheet_.get());
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;  // water without mechanics
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, fabric, settings);
    }
    ~Portrait() { bullet_.world().removeSoftBody(sheet_.get()); }

    // Takes up this share of saturation more.
    void absorb(double fraction) { cloth_->soakPores(fraction * fabric_.poreCapacity()); }

    btSoftBody& body() { return *sheet_; }
    WetCloth& cloth() { return *cloth_; }

    viewer::Picture picture(View view = View::beauty) const {
        viewer::Picture picture;
        picture.sheets.push_back(sheetMesh(*sheet_, *cloth_, view));
        picture.legend = legend(view, {cloth_.get()});
        picture.camera.target = {0, 1, 0};
        picture.camera.distance = 2;
        picture.camera.pitch = 0;
        return picture;
    }

  private:
    Fabric fabric_;
    BulletWorld bullet_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

// A part of an image in pixels, from its upper left corner.
struct Part {
    int left, top, width, height;
};

// The middle half of an image each way.
inline Part middle(const viewer::Image& image) {
    return {image.width / 4, image.height / 4, image.width / 2, image.height / 2};
}

// One channel of a pixel, 0 to 255.
inline double channel(const viewer::Image& image, int x, int y, int which) {
    return image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + which)];
}

// The light that a channel shows, 0 to 1: without the curve of sRGB and that of the tones.
inline double light(double shown) {
    constexpr double knee = 0.5, exposure = 1.14;
    const double encoded = shown / 255;
    const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    if (linear <= knee) return linear / exposure;
    return (knee - (1 - knee) * std::log(1 - std::min((linear - knee) / (1 - knee), 0.999))) / exposure;
}

// Mean light of each channel in a part of an image.
inline std::array<double, 3> meanLight(const viewer::Image& image, const Part& part) {
    std::array<double, 3> sum{};
    for (int y = part.top; y < part.top + part.height; ++y)
        for (int x = part.left; x < part.left + part.width; ++x)
            for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c)] += light(channel(image, x, y, c));
    for (double& value : sum) value /= part.width * part.height;
    return sum;
}

// Mean of the pixels in a part of an image, all channels alike, 0 to 255.
inline double brightness(const viewer::Image& image, const Part& part) {
    double sum = 0;
    for (int y = part.top; y < part.top + part.height; ++y)
        for (int x = part.left; x < part.left + part.width; ++x)
            for (int c = 0; c < 3; ++c) sum += channel(image, x, y, c);
    return sum / (3 * part.width * part.height);
}

// Root mean square of how far green lies from its mean in a part of an image, 0 to 255.
inline double unevenness(const viewer::Image& image, const Part& part) {
    double sum = 0, squares = 0;
    for (int y = part.top; y < part.top + part.height; ++y)
        for (int x = part.left; x < part.left + part.width; ++x) {
            const double green = channel(image, x, y, 1);
            sum += green;
            squares += green * green;
        }
    const double count = part.width * part.height;
    return std::sqrt(std::max(squares / count - sum * sum / count / count, 0.0));
}

}  // namespace drench::demo
