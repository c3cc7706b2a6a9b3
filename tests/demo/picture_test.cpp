// Whether what is drawn shows what is computed, on the pixels of a real OpenGL context.
#include <gtest/gtest.h>

#include "portrait.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/renderer.h"

namespace drench::demo::picture_test {
namespace {

constexpr int width = 320, height = 240;

// The picture with a dark wall behind the sheet, since light from behind gets through the more the wetter it is.
viewer::Picture beforeAWall(viewer::Picture picture) {
    viewer::Box wall;
    wall.centre = {0, 1, -0.5f};
    wall.halfExtents = {2, 2, 0.1f};
    wall.albedo = {0.05f, 0.05f, 0.05f};
    picture.boxes.push_back(wall);
    return picture;
}

TEST(Picture, WetterIsDarkerAtEachOfTheTenSteps) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    for (const char* const name : {"cotton", "denim", "nylon"}) {
        Portrait portrait(fabrics::byName(name));
        const auto brightnessNow = [&] {
            const viewer::Image image = renderer.capture(beforeAWall(portrait.picture()), width, height);
            return brightness(image, middle(image));
        };
        double before = brightnessNow();
        const double dry = before;
        EXPECT_GT(before, 10);
        for (int step = 1; step <= 10; ++step) {
            portrait.absorb(step == 1 ? 0.093 / 0.840 : 0.083 / 0.840);
            const double now = brightnessNow();
            EXPECT_LT(now, before) << name << ", step " << step;
            before = now;
        }
        EXPECT_LT(before, 0.93 * dry) << name;
    }
    EXPECT_EQ(renderer.glErrors(), 0);
}

// The same sheet as its colour alone makes it look: no threads, no film, nothing behind it.
viewer::Picture colourAlone(viewer::Picture picture) {
    for (viewer::SheetMesh& sheet : picture.sheets) {
        sheet.clothCoordinates.clear();
        sheet.dampness.clear();
        sheet.transmittance.clear();
        sheet.gloss.assign(sheet.positions.size(), 0.0f);
    }
    return picture;
}

TEST(Picture, ClothDarkensByTheLawOfItsAlbedo) {
    viewer::OffscreenContext context;
    viewer::Renderer renderer;
    for (const char* const name : {"cotton", "polyester", "linen", "denim"}) {
        Portrait portrait(fabrics::byName(name));
        const auto lightNow = [&] {
            const viewer::Image image = renderer.capture(colourAlone(portrait.picture()), width, height);
            return meanLight(image, middle(image));
        };
        const WetLaws laws(fabrics::byName(name));
        const std::array<double, 3> dry = lightNow();
        for (const double saturation : {0.5, 1.0}) {
            portrait.absorb(0.5);
            const std::array<double, 3> wet = lightNow();
            for (std::size_t c = 0; c < 3; ++c) {
                const double expected = laws.albedo(saturation)[c] / laws.albedo(0)[c];
                EXPECT_NEAR(wet[c] / dry[c], expected, 0.02 * expected)
                    << name << ' ' << saturation << ' ' << c;
            }
        }
    }
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
}  // namespace drench::demo::picture_test
