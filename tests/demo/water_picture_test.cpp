// Whether drops, streaks, mist and wet patches change the pixels that they should, and no others.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "viewer/gl/image.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/renderer.h"

namespace drench::viewer::water_picture_test {
namespace {

constexpr int width = 320, height = 240;

// Ground, sky and a box, with the camera on a point in front of it.
Picture stage() {
    Picture picture;
    picture.camera.target = {0, 0.5f, 0};
    picture.camera.distance = 2;
    picture.camera.pitch = 0.2f;
    Box box;
    box.centre = {0, 0.5f, -1};
    box.halfExtents = {0.4f, 0.5f, 0.1f};
    picture.boxes.push_back(box);
    return picture;
}

int channel(const Image& image, int x, int y, int which) {
    return image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + which)];
}

double brightness(const Image& image, int x, int y) {
    return (channel(image, x, y, 0) + channel(image, x, y, 1) + channel(image, x, y, 2)) / 3.0;
}

// Which pixels of two pictures differ by more than dither does.
struct Change {
    int inside = 0;   // of the middle, as far as `radius` pixels
    int outside = 0;  // beyond
};

Change change(const Image& before, const Image& after, int radiusX, int radiusY) {
    Change result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int max = 0;
            for (int which = 0; which < 3; ++which)
                max = std::max(max, std::abs(channel(before, x, y, which) - channel(after, x, y, which)));
            if (max <= 1) continue;
            const bool middle = std::abs(x - width / 2) <= radiusX && std::abs(y - height / 2) <= radiusY;
            ++(middle ? result.inside : result.outside);
        }
    return result;
}

class WaterPicture : public testing::Test {
  protected:
    // What `add` changes of a picture.
    Change changeBy(Picture picture, const std::function<void(Picture&)>& add, int radiusX, int radiusY) {
        const Image before = renderer_.capture(picture, width, height);
        add(picture);
        return change(before, renderer_.capture(picture, width, height), radiusX, radiusY);
    }
    void TearDown() override { EXPECT_EQ(renderer_.glErrors(), 0); }

    OffscreenContext context_;
    Renderer renderer_;
};

TEST_F(WaterPicture, ADropChangesThePixelsItCovers) {
    // 0.05 m at 2 m are 7.6 pixels.
    const auto drop = [](Picture& picture) { picture.drops.push_back({{0, 0.5f, 0}, {0, 0, 0}, 0.05f}); };
    const Change seen = changeBy(stage(), drop, 9, 9);
    EXPECT_GT(seen.inside, 100);
    EXPECT_EQ(seen.outside, 0);
}

TEST_F(WaterPicture, ADropIsDrawnOutAlongItsWay) {
    const auto drop = [](Picture& picture) { picture.drops.push_back({{0, 0.5f, 0}, {24, 0, 0}, 0.02f}); };
    EXPECT_EQ(changeBy(stage(), drop, 21, 5).outside, 0);
    EXPECT_GT(changeBy(stage(), drop, 12, 5).outside, 0);
}

TEST_F(WaterPicture, ADropShowsTheWorldUpsideDown) {
    Picture picture = stage();
    picture.boxes.clear();
    picture.camera.pitch = 0;
    picture.camera.target = {0, 1.5f, 0};
    picture.drops.push_back({{0, 1.5f, 0}, {0, 0, 0}, 0.3f});
    const Image image = renderer_.capture(picture, width, height);
    // Above there is sky and below ground; in the drop the other way round.
    EXPECT_GT(brightness(image, 30, 20), brightness(image, 30, 220) + 20);
    EXPECT_LT(brightness(image, width / 2, height / 2 - 25),
              brightness(image, width / 2, height / 2 + 25) - 20);
}

TEST_F(WaterPicture, ADropTooSmallForAPixelIsStillSeenButFaintly) {
    const auto total = [&](float radius) {
        Picture picture = stage();
        const Image before = renderer_.capture(picture, width, height);
        picture.drops.push_back({{0, 0.5f, 0}, {0, 0, 0}, radius});
        const Image after = renderer_.capture(picture, width, height);
        double sum = 0;
        for (std::size_t i = 0; i < before.rgb.size(); ++i) sum += std::abs(before.rgb[i] - after.rgb[i]);
        return sum;
    };
    const double small = total(0.002f), smaller = total(0.001f);
    EXPECT_GT(smaller, 0);
    EXPECT_LT(smaller, small);
}

TEST_F(WaterPicture, AStreakChangesThePixelsOnItsLine) {
    const auto streak = [](Picture& picture) {
        picture.streaks.push_back({{0, 0.6f, 0}, {0, 0.4f, 0}, 0.002f, 1.0f});
    };
    const Change seen = changeBy(stage(), streak, 3, 17);
    EXPECT_GT(seen.inside, 20);
    EXPECT_EQ(seen.outside, 0);
}

TEST_F(WaterPicture, MistCoversABallAndFadesInFrontOfSolids) {
    const auto puff = [](Picture& picture) { picture.mist.push_back({{0, 0.5f, 0}, 0.2f, 0.6f}); };
    const Change seen = changeBy(stage(), puff, 32, 32);
    EXPECT_GT(seen.inside, 800);
    EXPECT_EQ(seen.outside, 0);
    const auto atBox = [](Picture& picture) { picture.mist.push_back({{0, 0.5f, -0.85f}, 0.2f, 0.6f}); };
    const auto inFront = [](Picture& picture) { picture.mist.push_back({{0, 0.5f, -0.6f}, 0.2f, 0.6f}); };
    const Image bare = renderer_.capture(stage(), width, height);
    const auto effect = [&](const std::function<void(Picture&)>& add) {
        Picture picture = stage();
        add(picture);
        const Image image = renderer_.capture(picture, width, height);
        double sum = 0;
        for (std::size_t i = 0; i < bare.rgb.size(); ++i) sum += std::abs(bare.rgb[i] - image.rgb[i]);
        return sum;
    };
    // Its square stands clear of the box, so that depth alone would hide none of it.
    EXPECT_LT(effect(atBox), 0.68 * effect(inFront));
}

TEST_F(WaterPicture, NothingIsSeenBehindASolid) {
    const auto behind = [](Picture& picture) {
        picture.drops.push_back({{0, 0.5f, -1.5f}, {0, 0, 0}, 0.05f});
        picture.streaks.push_back({{0, 0.6f, -1.5f}, {0, 0.4f, -1.5f}, 0.01f, 1.0f});
        picture.mist.push_back({{0, 0.5f, -1.5f}, 0.1f, 0.8f});
    };
    const Change seen = changeBy(stage(), behind, width, height);
    EXPECT_EQ(seen.inside, 0);
}

TEST_F(WaterPicture, APatchWetsSolidsAndGroundWithinItsRadius) {
    const auto onBox = [](Picture& picture) { picture.patches.push_back({{0, 0.5f, -0.9f}, 0.2f, 1.0f}); };
    Picture box = stage();
    box.camera.target = {0, 0.5f, -0.9f};
    const Change onTheBox = changeBy(box, onBox, 41, 41);
    EXPECT_GT(onTheBox.inside, 300);
    EXPECT_EQ(onTheBox.outside, 0);
    Picture ground = stage();
    ground.boxes.clear();
    ground.camera.target = {0, 0, 0};
    const auto onGround = [](Picture& picture) { picture.patches.push_back({{0, 0, 0}, 0.2f, 1.0f}); };
    const Change seen = changeBy(ground, onGround, 42, 14);
    EXPECT_GT(seen.inside, 200);
    EXPECT_EQ(seen.outside, 0);
}

TEST_F(WaterPicture, APatchInTheAirOrOnASheetChangesNothing) {
    const auto inTheAir = [](Picture& picture) { picture.patches.push_back({{0, 0.5f, 0.5f}, 0.2f, 1.0f}); };
    EXPECT_EQ(changeBy(stage(), inTheAir, width, height).inside, 0);
    Picture picture = stage();
    SheetMesh sheet;
    sheet.positions = {{-2, -1, 0.5f}, {2, -1, 0.5f}, {2, 2, 0.5f}, {-2, 2, 0.5f}};
    sheet.albedo.assign(4, Eigen::Vector3f::Constant(0.4f));
    sheet.gloss.assign(4, 0);
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    picture.sheets.push_back(sheet);
    const auto onSheet = [](Picture& p) {
        p.patches.push_back({{0, 0.5f, 0.5f}, 0.2f, 1.0f});
        p.patches.push_back({{0, 0.5f, -0.9f}, 0.2f, 1.0f});
    };
    EXPECT_EQ(changeBy(picture, onSheet, width, height).inside, 0);
}

// Light of a channel in the middle of a picture, before the curve of the renderer, which is straight in the
// dark.
double lightInTheMiddle(const Image& image, int which) {
    double sum = 0;
    int counted = 0;
    for (int y = height / 4; y < 3 * height / 4; ++y)
        for (int x = width / 4; x < 3 * width / 4; ++x, ++counted) {
            const double encoded = channel(image, x, y, which) / 255.0;
            sum += encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        }
    constexpr double exposed = 1.14, knee = 0.5;
    const double mean = sum / counted;
    const double excess = mean > knee ? -(1 - knee) * std::log(1 - (mean - knee) / (1 - knee)) : 0;
    return (std::min(mean, knee) + excess) / exposed;
}

TEST_F(WaterPicture, WetGroundIsDarkerByAngstromsRatio) {
    Picture picture;
    picture.camera.target = {0, 0, 0};
    picture.camera.distance = 2;
    picture.camera.pitch = 1.4f;
    // So low that its mirror image is nowhere near.
    picture.towardsSun = {0, 0.02f, -1};
    Picture upwards = picture;
    upwards.camera.pitch = -1.4f;
    upwards.camera.target = {0, 10, 0};
    Picture wet = picture;
    wet.patches.push_back({{0, 0, 0}, 3.0f, 1.0f});
    const Image dryImage = renderer_.capture(picture, width, height);
    const Image wetImage = renderer_.capture(wet, width, height);
    const Image skyImage = renderer_.capture(upwards, width, height);
    const double albedo[] = {0.265, 0.255, 0.230};  // of flagstones, on average
    for (int which = 0; which < 3; ++which) {
        // A film of water mirrors 2 % of the sky, which a mirror shows 1.3 times as bright as the screen can.
        const double mirrored = 0.02 * 1.3 * lightInTheMiddle(skyImage, which);
        const double ratio =
            (lightInTheMiddle(wetImage, which) - mirrored) / lightInTheMiddle(dryImage, which);
        const double expected = 1 / (1.33 * 1.33 * (1 - albedo[which]) + albedo[which]);
        EXPECT_NEAR(ratio / expected, 1, 0.05) << "channel " << which;
    }
}

TEST_F(WaterPicture, OpenGroundIsDarkerBeyondItsRectangle) {
    const auto light = [&](float covered, float halfSide) {
        Picture picture;
        picture.camera.target = {0, 0, 0};
        picture.camera.distance = 2;
        picture.camera.pitch = 1.2f;
        picture.openGround.covered = covered;
        picture.openGround.from = {-halfSide, -halfSide};
        picture.openGround.to = {halfSide, halfSide};
        return lightInTheMiddle(renderer_.capture(picture, width, height), 1);
    };
    const double dry = light(0, -5);
    EXPECT_LT(light(1, -5), 0.8 * dry);
    EXPECT_NEAR(light(1, 20), dry, 0.01 * dry);
}

TEST_F(WaterPicture, ShadowsAreFaintUnderAnOvercastSky) {
    const auto shadow = [&](float sunshine) {
        Picture picture;
        picture.camera.target = {0, 0, 0};
        picture.camera.distance = 2;
        picture.camera.pitch = 1.2f;
        picture.sunshine = sunshine;
        const double lit = lightInTheMiddle(renderer_.capture(picture, width, height), 1);
        Ball ball;
        ball.radius = 1;
        ball.centre = 4 * picture.towardsSun;
        picture.balls.push_back(ball);
        return lightInTheMiddle(renderer_.capture(picture, width, height), 1) / lit;
    };
    EXPECT_LT(shadow(1), 0.75);
    EXPECT_GT(shadow(0), 0.9);
    EXPECT_THROW(shadow(1.5f), std::runtime_error);
}

TEST_F(WaterPicture, APoolMirrorsWhatStandsOverIt) {
    Picture picture;
    Water water;
    water.centre = {0, 0.3f, 0};
    water.halfExtents = {1, 0.3f, 1};
    picture.waters.push_back(water);
    Box box;
    box.centre = {0, 0.9f, -0.5f};
    box.halfExtents = {0.5f, 0.25f, 0.05f};
    box.material = Material::paint;
    picture.boxes.push_back(box);
    picture.camera.target = {0, 0.6f, 0};
    picture.camera.pitch = 0.2f;
    picture.camera.distance = 3;
    picture.boxes[0].albedo = {0.02f, 0.02f, 0.02f};
    const Image dark = renderer_.capture(picture, width, height);
    picture.boxes[0].albedo = {0.9f, 0.9f, 0.9f};
    // The middle of the picture is surface in front of the box.
    EXPECT_GT(change(dark, renderer_.capture(picture, width, height), 20, 3).inside, 100);
}

TEST_F(WaterPicture, MaterialsLookDifferent) {
    const auto boxOf = [&](Material material) {
        Picture picture = stage();
        picture.boxes[0].material = material;
        picture.camera.target = {0, 0.5f, -0.9f};
        return renderer_.capture(picture, width, height);
    };
    const Image stone = boxOf(Material::stone);
    for (const Material other : {Material::paint, Material::wood, Material::metal, Material::rope})
        EXPECT_GT(change(stone, boxOf(other), 40, 40).inside, 1000) << int(other);
}

TEST_F(WaterPicture, WhatIsNotFiniteIsLeftOut) {
    const float nan = std::nanf("");
    const auto broken = [&](Picture& picture) {
        picture.drops.push_back({{nan, 0, 0}, {0, 0, 0}, 0.1f});
        picture.drops.push_back({{0, 0.5f, 0}, {0, 0, 0}, 0.0f});
        picture.streaks.push_back({{0, 0, 0}, {0, nan, 0}, 0.1f, 1.0f});
        picture.mist.push_back({{0, 0.5f, 0}, -1.0f, 1.0f});
        picture.patches.push_back({{0, nan, 0}, 1.0f, 1.0f});
        picture.patches.push_back({{0, 0, 0}, 1.0f, 0.0f});
    };
    EXPECT_EQ(changeBy(stage(), broken, width, height).inside, 0);
}

}  // namespace
}  // namespace drench::viewer::water_picture_test
