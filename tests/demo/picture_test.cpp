// Whether what is drawn shows what is computed, on the pixels of a real OpenGL context.
#include <gtest/gtest.h>

#include "bullet_world.h"
#include "pictures.h"
#include "viewer/image.h"
#include "viewer/offscreen_context.h"
#include "viewer/renderer.h"

namespace drench::demo {
namespace {

constexpr int width = 320, height = 240;

/// Mean of the pixels in the middle half of a picture, 0 to 255.
double middleBrightness(const viewer::Image& image) {
    double sum = 0;
    int counted = 0;
    for (int y = height / 4; y < 3 * height / 4; ++y)
        for (int x = width / 4; x < 3 * width / 4; ++x)
            for (int channel = 0; channel < 3; ++channel, ++counted)
                sum += image.rgb[static_cast<std::size_t>(3 * (y * width + x) + channel)];
    return sum / counted;
}

/// A 2 m sheet that stands still and fills the picture.
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

    /// Takes up this share of saturation more.
    void absorb(double share) { cloth_->presoak(share * fabric_.poreCapacity()); }

    viewer::Picture picture() const {
        viewer::Picture picture;
        picture.sheets.push_back(sheetMesh(*sheet_, *cloth_));
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

TEST(Picture, WetterIsDarkerAtEachOfTheTenSteps) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    for (const char* const name : {"cotton", "denim", "nylon"}) {
        Portrait portrait(fabrics::byName(name));
        double before = middleBrightness(renderer.capture(portrait.picture(), width, height));
        const double dry = before;
        EXPECT_GT(before, 10);
        for (int step = 1; step <= 10; ++step) {
            portrait.absorb(step == 1 ? 0.093 / 0.840 : 0.083 / 0.840);
            const double now = middleBrightness(renderer.capture(portrait.picture(), width, height));
            EXPECT_LT(now, before) << name << ", step " << step;
            before = now;
        }
        EXPECT_LT(before, 0.9 * dry) << name;
    }
    EXPECT_EQ(renderer.glErrors(), 0);
}

TEST(Picture, APngComesBackAsItWasWritten) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    const viewer::Image image = renderer.capture(Portrait(fabrics::linen()).picture(), width, height);
    const auto path = std::filesystem::path(testing::TempDir()) / "drench_picture_test" / "sheet.png";
    viewer::writePng(path, image);
    const viewer::Image back = viewer::readPng(path);
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.rgb, image.rgb);
    std::filesystem::remove_all(path.parent_path());
}

}  // namespace
}  // namespace drench::demo
