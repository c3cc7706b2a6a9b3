// Whether sheets look like the cloth that they are, dry and wet, on the pixels of a real OpenGL context.
#include <gtest/gtest.h>

#include "portrait.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/passes/sheet_surface.h"
#include "viewer/passes/sheet_uniforms.h"
#include "viewer/renderer.h"

namespace drench::demo::cloth_look_test {
namespace {

constexpr int width = 320, height = 240;

class ClothLook : public testing::Test {
  protected:
    viewer::Image capture(const viewer::Picture& picture) {
        viewer::Image image = renderer_.capture(picture, width, height);
        EXPECT_EQ(renderer_.glErrors(), 0);
        return image;
    }

  private:
    viewer::OffscreenContext context_;
    viewer::Renderer renderer_;
};

// Red over blue left and right of the middle, which a black and a white ball behind the sheet make differ.
double stripeContrast(const viewer::Image& image) {
    const Part left{width / 2 - 40, height / 2 - 15, 30, 30}, right{width / 2 + 10, height / 2 - 15, 30, 30};
    const double dark = meanLight(image, left)[2], pale = meanLight(image, right)[2];
    return pale / dark;
}

viewer::Picture beforeTwoBalls(const Portrait& portrait) {
    viewer::Picture picture = portrait.picture();
    viewer::Ball ball;
    ball.radius = 0.2f;
    ball.centre = {-0.2f, 1, -0.201f};
    ball.albedo = {0.02f, 0.02f, 0.02f};
    ball.orientation = Eigen::AngleAxisf(1.5707963f, Eigen::Vector3f::UnitX());  // its dark cap in front
    picture.balls.push_back(ball);
    ball.centre.x() = 0.2f;
    ball.albedo = {0.9f, 0.9f, 0.9f};
    picture.balls.push_back(ball);
    picture.camera.distance = 1.2f;
    return picture;
}

TEST_F(ClothLook, WhatTouchesWetClothShowsThroughAndHardlyThroughDry) {
    Portrait portrait(fabrics::polyesterPlain());
    const double dry = stripeContrast(capture(beforeTwoBalls(portrait)));
    portrait.absorb(1);
    const double wet = stripeContrast(capture(beforeTwoBalls(portrait)));
    EXPECT_LT(std::abs(dry - 1), 0.05);
    EXPECT_GT(wet, 1.1);
}

TEST_F(ClothLook, AnotherLayerHidesWhatIsBehindIt) {
    Portrait portrait(fabrics::polyesterPlain());
    portrait.absorb(1);
    viewer::Picture picture = beforeTwoBalls(portrait);
    const double single = stripeContrast(capture(picture));
    picture.sheets.push_back(picture.sheets[0]);
    for (Eigen::Vector3f& position : picture.sheets[1].positions) position.z() += 0.002f;
    const double both = stripeContrast(capture(picture));
    EXPECT_LT(both - 1, 0.75 * (single - 1));
    EXPECT_GT(both, 1.01);
}

TEST_F(ClothLook, ClothWithoutTransmittanceHidesWhatIsBehind) {
    const Portrait portrait(fabrics::polyesterPlain());
    viewer::Picture picture = beforeTwoBalls(portrait);
    picture.sheets[0].transmittance.clear();
    EXPECT_NEAR(stripeContrast(capture(picture)), 1, 0.05);
}

TEST_F(ClothLook, AFilmOfWaterMirrorsTheSun) {
    const Portrait portrait(fabrics::cottonPlain());
    viewer::Picture picture = portrait.picture();
    picture.towardsSun = {0, 0, 1};
    const viewer::Image matt = capture(picture);
    picture.sheets[0].gloss.assign(picture.sheets[0].gloss.size(), 1.0f);
    const viewer::Image shiny = capture(picture);
    const Part centre{width / 2 - 5, height / 2 - 5, 10, 10};
    EXPECT_GT(brightness(shiny, centre), 1.15 * brightness(matt, centre));
    const Part corner{width / 8, height / 8, 10, 10};
    EXPECT_LT(brightness(shiny, corner), 1.08 * brightness(matt, corner));
}

TEST_F(ClothLook, NoClothIsBrighterThanAWhiteOne) {
    Portrait portrait(fabrics::polyesterPlain());
    viewer::Picture picture = portrait.picture();
    const std::size_t nodes = picture.sheets[0].positions.size();
    picture.sheets[0].albedo.assign(nodes, Eigen::Vector3f::Constant(1));
    picture.sheets[0].clothCoordinates.clear();
    picture.sheets[0].transmittance.clear();
    const viewer::Image plain = capture(picture);
    const auto white = meanLight(plain, middle(plain));
    for (const float transmittance : {0.2f, 0.9f})
        for (const float dampness : {0.0f, 1.0f}) {
            picture = portrait.picture();
            picture.sheets[0].albedo.assign(nodes, Eigen::Vector3f::Constant(0.9f));
            picture.sheets[0].transmittance.assign(nodes, transmittance);
            picture.sheets[0].dampness.assign(nodes, dampness);
            const viewer::Image image = capture(picture);
            const auto mean = meanLight(image, middle(image));
            for (std::size_t c = 0; c < 3; ++c)
                // The sky behind is a little brighter than the light on the front.
                EXPECT_LT(mean[c], 1.03 * white[c]) << transmittance << ' ' << dampness << ' ' << c;
        }
}

TEST_F(ClothLook, ThreadsShowCloseByAndMeltIntoTheSameColourFarAway) {
    const Portrait portrait(fabrics::denim());
    viewer::Picture picture = portrait.picture();
    picture.camera.distance = 0.05f;  // the height of the picture is 40 mm
    const viewer::Image close = capture(picture);
    picture.sheets[0].clothCoordinates.clear();
    const viewer::Image smooth = capture(picture);
    EXPECT_GT(unevenness(close, middle(close)), 8);
    EXPECT_LT(unevenness(smooth, middle(smooth)), 2);
    EXPECT_NEAR(brightness(close, middle(close)), brightness(smooth, middle(smooth)), 12);

    picture = portrait.picture();
    picture.camera.distance = 60;
    const viewer::Image far = capture(picture);
    const Part sheet{width / 2 - 3, height / 2 - 3, 6, 6};
    EXPECT_LT(unevenness(far, sheet), 2);
}

TEST_F(ClothLook, EachWeaveHasItsOwnThreads) {
    const Portrait portrait(fabrics::cottonPlain());
    viewer::Picture picture = portrait.picture();
    picture.camera.distance = 0.03f;
    std::vector<viewer::Image> images;
    for (const viewer::Weave weave : {viewer::Weave::plain, viewer::Weave::twill, viewer::Weave::knit}) {
        picture.sheets[0].weave = weave;
        images.push_back(capture(picture));
    }
    EXPECT_NE(images[0].rgb, images[1].rgb);
    EXPECT_NE(images[1].rgb, images[2].rgb);
    EXPECT_NE(images[2].rgb, images[0].rgb);
}

TEST_F(ClothLook, TheShadowOfWetClothIsLighter) {
    Portrait portrait(fabrics::polyesterPlain());
    const auto shadowOf = [&] {
        viewer::Picture picture = portrait.picture();
        picture.towardsSun = {0, 1, 1};
        picture.camera.target = {0, 0, -1};  // where the shadow of its middle falls
        picture.camera.distance = 1;
        picture.camera.pitch = 1.2f;
        picture.camera.yaw = 3.1415926f;
        const viewer::Image image = capture(picture);
        return brightness(image, middle(image));
    };
    const double dry = shadowOf();
    portrait.absorb(1);
    EXPECT_GT(shadowOf(), 1.05 * dry);
}

TEST(SheetUniforms, OnlyRectanglesHaveAHem) {
    viewer::SheetMesh sheet;
    sheet.positions.assign(4, Eigen::Vector3f::Zero());
    sheet.clothCoordinates = {{0, 0}, {1, 0}, {1, 2}, {0, 2}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_FLOAT_EQ(viewer::sheetUniforms(sheet, std::nullopt).threading[2], 0.015f);
    for (Eigen::Vector2f& at : sheet.clothCoordinates) at.x() *= 0.1f;
    EXPECT_EQ(viewer::sheetUniforms(sheet, std::nullopt).threading[2], 0.0f);
    for (Eigen::Vector2f& at : sheet.clothCoordinates) at.x() *= 10.0f;
    sheet.triangles.pop_back();
    EXPECT_EQ(viewer::sheetUniforms(sheet, std::nullopt).threading[2], 0.0f);
    sheet.clothCoordinates.clear();
    EXPECT_EQ(viewer::sheetUniforms(sheet, std::nullopt).threading[0], 0.0f);
}

// Two strips of triangles that meet in a line of three nodes, one turned out of the plane of the other.
viewer::SheetMesh folded(float angle) {
    viewer::SheetMesh sheet;
    for (const float z : {0.0f, 1.0f, 2.0f}) {
        sheet.positions.emplace_back(-1.0f, 0.0f, z);
        sheet.positions.emplace_back(0.0f, 0.0f, z);
        sheet.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
    for (const std::uint32_t corner : {0u, 1u, 3u, 4u}) {
        sheet.triangles.push_back({corner, corner + 3, corner + 1});
        sheet.triangles.push_back({corner + 1, corner + 3, corner + 4});
    }
    sheet.albedo.assign(9, Eigen::Vector3f::Ones());
    sheet.gloss.assign(9, 0.0f);
    return sheet;
}

TEST(SheetSurface, IsRoundedWhereItIsSmoothAndNotInASharpFold) {
    constexpr std::size_t onTheLine = 4;
    EXPECT_EQ((*viewer::sheetSurface(folded(0)))[onTheLine].roundness, 1.0f);
    EXPECT_EQ((*viewer::sheetSurface(folded(0.5f)))[onTheLine].roundness, 1.0f);
    EXPECT_EQ((*viewer::sheetSurface(folded(2.5f)))[onTheLine].roundness, 0.0f);
}

// The middle of a dome, a piece of a sphere, seen from both sides.
TEST(SheetSurface, KnowsItsNormalsAndItsCurvature) {
    constexpr float radius = 0.5f, spacing = 0.02f;
    viewer::SheetMesh dome;
    for (const float y : {-spacing, 0.0f, spacing})
        for (const float x : {-spacing, 0.0f, spacing})
            dome.positions.emplace_back(x, y, std::sqrt(radius * radius - x * x - y * y));
    for (const std::uint32_t corner : {0u, 1u, 3u, 4u}) {
        dome.triangles.push_back({corner, corner + 1, corner + 4});
        dome.triangles.push_back({corner, corner + 4, corner + 3});
    }
    dome.albedo.assign(9, Eigen::Vector3f::Ones());
    dome.gloss.assign(9, 0.0f);
    for (const float side : {1.0f, -1.0f}) {
        const viewer::SheetVertex top = (*viewer::sheetSurface(dome))[4];
        EXPECT_NEAR(top.normal.z(), side, 1e-5f);
        EXPECT_NEAR(top.hollow, -side / radius, 0.02f / radius);
        for (auto& triangle : dome.triangles) std::swap(triangle[0], triangle[1]);
    }
}

TEST_F(ClothLook, ListsOfTheWrongLengthAreRefusedByName) {
    const Portrait portrait(fabrics::cottonPlain());
    viewer::Picture picture = portrait.picture();
    picture.sheets[0].dampness.pop_back();
    try {
        capture(picture);
        FAIL() << "drew a sheet with a node that has no dampness";
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("dampness"), std::string::npos) << problem.what();
    }
}

}  // namespace
}  // namespace drench::demo::cloth_look_test
